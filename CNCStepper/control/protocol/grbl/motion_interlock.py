# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motion interlock: while the machine's position is lost, nothing that moves it to a place is written.

program line, absolute jog ──► `check_line`     ┐
cycle start                ──► `check_realtime` ┴──► the driver writes it, or MachineRefusal "position-unknown"

It is a part of the protocol driver (`Grbl`), through which every line and every real-time byte passes, so that whoever
sends cannot leave it out. It lists the lines that pass while it is locked: a line that it does not know is refused.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from CNCStepper.errors import MachineRefusal
from CNCStepper.gcode.syntax.words import code_pattern, packed_wire
from CNCStepper.machine.pulse_letters import COMMAND as LETTERS

UNKNOWN = "position-unknown"
WHAT = "the machine's position is unknown"
HOME_OR_ZERO = "home it, or set the zero of all axes; only jogging works until then"
STOP_FIRST = "stop it, then home it, or set the zero of all axes"
CYCLE_STARTS = (b"~", b"\xa3")  # resume, and "tool changed" of grblHAL
SHOWN = 40  # characters of a refused line

_NUMBER = r"[-+]?\d*\.?\d*"
_RELATIVE_JOG = re.compile(rf"\$J=(?:G2[01]|G91|[A-CU-Z]{_NUMBER}|F{_NUMBER})*")
_RELATIVE = re.compile(code_pattern("G", "91"))
_SET_ZERO = re.compile(rf"G10L20P\d(?:[A-CU-Z]{_NUMBER})*")
_OUTPUTS = re.compile(rf"(?:N\d+|{code_pattern('M', '[3-57-9]')}|S{_NUMBER}|{code_pattern('G', '4')}|P{_NUMBER})*")


class MotionInterlock:
    """Refuses what moves a machine whose position is lost.

    position_lost: asked each time, so that it holds from the moment at which the position is lost; without it the
    interlock is locked for good.
    """

    def __init__(self, position_lost: Callable[[], bool] = lambda: True):
        self._position_lost = position_lost

    def check_line(self, text: str) -> None:
        """Raise MachineRefusal for a line that moves the machine to a place while its position is lost."""
        if self._position_lost() and moves(text):
            raise position_unknown(text[:SHOWN])

    def check_realtime(self, byte: bytes) -> None:
        """Raise MachineRefusal for a cycle start while the position is lost."""
        if byte in CYCLE_STARTS and self._position_lost():
            raise position_unknown(advice=STOP_FIRST)


def moves(text: str) -> bool:
    """Return whether a line may move a machine otherwise than by a relative jog or by homing."""
    plain = packed_wire(text)
    if plain.startswith("$J="):
        return not (_RELATIVE_JOG.fullmatch(plain) and _RELATIVE.search(plain))
    if plain.startswith(LETTERS):
        return True
    return not (plain.startswith("$") or _SET_ZERO.fullmatch(plain) or _OUTPUTS.fullmatch(plain))


def position_unknown(value: str = "", advice: str = HOME_OR_ZERO) -> MachineRefusal:
    """Return the refusal of whatever would move a machine whose position is lost."""
    return MachineRefusal(UNKNOWN, WHAT, value=value, advice=advice)
