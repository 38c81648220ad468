# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restores a controller's settings: what is written in which order, what it answered, the proof by reading back.

now, wanted ──► lines: those that differ and that it has ──► one by one, each answered ──► $$ ──► as wanted?

Soft limits need the homing cycle (error 10), so that is switched on first, and off last: it takes them along.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from CNCStepper.control.protocol.grbl.firmware import FLUIDNC, OWN_FIRMWARES, Firmware
from CNCStepper.control.settings.setting_names import HOMING
from CNCStepper.control.settings.settings_comparison import compare_settings, same_value
from CNCStepper.control.settings.settings_file import setting_line
from CNCStepper.errors import MachineRefusal, Text

ASK_SETTINGS, ASK_IDENTITY = "$$", "$I"
OK = "ok"


def check_takes_settings(firmware: Firmware) -> None:
    """Raise MachineRefusal where a controller's settings are not kept by itself."""
    if firmware is FLUIDNC:
        raise MachineRefusal(
            "settings-fluidnc",
            "FluidNC keeps its settings in its configuration file, not by $ numbers",
            advice="change config.yaml on the controller, or its page in the browser, then read the settings again",
        )
    if firmware in OWN_FIRMWARES:
        raise MachineRefusal(
            "settings-own",
            Text("{controller} has no settings of its own: the profile has them", controller=firmware.name),
            advice="change the machine's profile",
        )


def restore_lines(now: Mapping[int, float], wanted: Mapping[int, float]) -> list[str]:
    """Return the lines that make the settings those wanted; what the controller does not have is left out."""
    changed = {one.number: one.right for one in compare_settings(now, wanted) if one.differs and one.right is not None}
    homing = changed.pop(HOMING, None)
    lines = [setting_line(number, value) for number, value in changed.items()]
    if homing is None:
        return lines
    line = setting_line(HOMING, homing)
    return [line, *lines] if homing else [*lines, line]


def check_answer(lines: Sequence[str], done: int, answer: str) -> None:
    """Raise MachineRefusal where the answer to the line behind the first `done` ones is not `ok`."""
    if answer != OK:
        raise MachineRefusal(
            "restore-stopped",
            Text("the controller refused {line}: {answer}", line=lines[done], answer=answer),
            value=Text("{done} of {count} settings written", done=done, count=len(lines)),
            advice="compare again to see what it holds now; correct that setting, or leave it out",
        )


def not_restored(read_back: Mapping[int, float], lines: Sequence[str], wanted: Mapping[int, float]) -> list[int]:
    """Return the numbers of the settings that were written and are not as wanted when read back."""
    written = [int(line[1:].partition("=")[0]) for line in lines]
    return [
        number for number in written if number not in read_back or not same_value(read_back[number], wanted[number])
    ]


def check_restored(read_back: Mapping[int, float], lines: Sequence[str], wanted: Mapping[int, float]) -> None:
    """Raise MachineRefusal naming the settings that the controller answered `ok` to and does not hold."""
    if wrong := not_restored(read_back, lines, wanted):
        raise MachineRefusal(
            "restore-differs",
            "the controller took the settings, but holds others when they are read back",
            value=", ".join(setting_line(number, read_back[number]) for number in wrong if number in read_back)
            or "none",
            limit=", ".join(setting_line(number, wanted[number]) for number in wrong),
            advice="look at its memory and its supply, then write them again",
        )
