# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the board answers to `$` lines and `?`, and its work zero: those of grbl 1.1 for a machine of X and Z.

`$G` names the work system alone: the language has its own modes, which a program sets or finds as switched on.
"""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.controllers.lathe.chunk_sender import MOST_LINES
from CNCStepper.machine.profile import Machine
from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.firmware import Firmware
from CNCStepper.virtual.grbl.gcode.words import read_words
from CNCStepper.virtual.grbl.report import coordinates, fixed, rate
from CNCStepper.virtual.grbl.settings import Settings

CANNOT = ("hold", "stop", "resume", "override", "back", "home", "position", "axis-y")
RECEIVE_BYTES = 1024
FIRMWARE = Firmware(
    "lathe",
    "Grbl 1.1h ['$' for help]",
    (
        "[VER:1.1h.20190830:]",
        f"[OPT:V,{MOST_LINES},{RECEIVE_BYTES}]",
        "[FIRMWARE:CNCStepper lathe]",
        *(f"[CANNOT:{what}]" for what in CANNOT),
    ),
    receive_bytes=RECEIVE_BYTES,
    line_characters=RECEIVE_BYTES - 24,
)
HELP = "[HLP:$$ $# $G $I $N $J=line ~ ! ? ctrl-x]"
SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G28", "G30", "G92")
NOT_KNOWN, NOT_IDLE, NO_HOMING, UNSUPPORTED, NOT_THERE = 3, 8, 5, 20, 29
AXES = "XYZ"


class Answers:
    """The answers of one board; zero_mm: the work zero G54 in machine coordinates, of X, Y and Z."""

    def __init__(self, machine: Machine):
        self.zero_mm = [0.0, 0.0, 0.0]
        self._settings = Settings(machine)

    def command(self, line: str, state: str) -> list[str]:
        """Return the answer to a `$` line, without its "ok"; raises MachineRefusal."""
        if line == "$":
            return [HELP]
        if line == "$G":
            return ["[GC:G54 T0 F0 S0]"]
        if state not in ("Idle", "Alarm"):
            raise refused(NOT_IDLE)
        if line == "$H":
            raise refused(NO_HOMING)
        lists = {"$$": self._settings.lines, "$#": self._offsets, "$I": lambda: list(FIRMWARE.build), "$N": _startup}
        if line not in lists:
            raise refused(NOT_KNOWN)
        return lists[line]()

    def status(
        self,
        state: str,
        place_mm: Sequence[float],
        speed_mm_min: float,
        free_bytes: int,
        left_s: float,
        queued_lines: int | None,
    ) -> str:
        """Return the answer to `?`.

        left_s: how long the lathe still works on what it has. queued_lines: answered and not done, None: not known.
        """
        fields = [
            state,
            f"MPos:{coordinates(place_mm, self._settings)}",
            f"Bf:{MOST_LINES},{free_bytes}",
            f"FS:{rate(speed_mm_min, self._settings)},0",
            f"WCO:{coordinates(self.zero_mm, self._settings)}",
            *([f"Left:{fixed(left_s, 1)}"] if left_s > 0 else []),
            *([] if queued_lines is None else [f"Queue:{queued_lines}"]),
        ]
        return f"<{'|'.join(fields)}>"

    def set_zero(self, line: str, place_mm: Sequence[float]) -> None:
        """Carry out `G10 L20 P1 X0 Z0`, P0 and P1 both being G54; raises MachineRefusal for any other line."""
        words = dict(read_words(line))
        if (words.pop("G", None), words.pop("L", None)) != (10.0, 20.0):
            raise refused(UNSUPPORTED)
        if words.pop("P", 0.0) not in (0.0, 1.0):
            raise refused(NOT_THERE)
        if not words or words.keys() - set(AXES):
            raise refused(UNSUPPORTED)
        for letter, value in words.items():
            axis = AXES.index(letter)
            self.zero_mm[axis] = place_mm[axis] - value

    def _offsets(self) -> list[str]:
        none = coordinates((0.0, 0.0, 0.0), self._settings)
        zeros = [f"[{name}:{none}]" for name in SYSTEMS[1:]]
        return [
            f"[G54:{coordinates(self.zero_mm, self._settings)}]",
            *zeros,
            f"[TLO:{coordinates((0.0,), self._settings)}]",
            f"[PRB:{none}:0]",
        ]


def _startup() -> list[str]:
    return ["$N0=", "$N1="]
