# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a program to its wire text, and back to the paths of motors and tool: one chain for proofs and pictures."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back
from CNCStepper.gcode.wire.wire_text import WireText
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.backlash_moves import tool_moves
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath, require_straight_axes


class WireRoundTrip(NamedTuple):
    """wire: the lines sent. motors: the path of the motors. toolpath: the path of the tool, with the same rows."""

    wire: WireText
    motors: Toolpath
    toolpath: Toolpath


def translated_to(machine: Machine | None, dialect: str | Dialect) -> str | None:
    """Return the language into which a program is translated for a machine's controller; None where it is sent as it
    is."""
    if machine is None:
        return None
    own = machine.language(dialect if isinstance(dialect, str) else dialect.name)
    target = machine.wire_language(own)
    return None if target.partition(":")[0] == own.partition(":")[0] else target


def wire_of(
    text: str, machine: Machine | None, dialect: str, file: str, start: Start | None, play: Backlash | None = None
) -> WireText:
    """Return the wire text of a program on a machine, with this backlash compensated; raises ProgramError."""
    if (target := translated_to(machine, dialect)) is not None:
        from CNCStepper.gcode.wire.translation import translate

        return translate(text, dialect, target, file, start, play=play).wire
    return prepare(text, dialect, file, start, play)


def wire_round_trip(
    text: str,
    machine: Machine | None,
    dialect: str | Dialect,
    file: str = "",
    start: Start | None = None,
    share: Callable[[float], None] = lambda share: None,
) -> WireRoundTrip:
    """Return the wire text of a program on a machine, and the ways that are read back from it.

    share: called with the share that is read, from 0 to 1. Raises ProgramError for a text that cannot be read or sent.
    """
    play = backlash_of(machine, dialect)
    if (target := translated_to(machine, dialect)) is not None:
        from CNCStepper.gcode.wire.translation import translate

        wire, motors = translate(text, dialect, target, file, start, share, play)
    else:
        wire = prepare(text, dialect, file, start, play)
        motors = read_back(wire, text, start, dialect, file, share)
    if play is None:
        return WireRoundTrip(wire, motors, motors)
    return WireRoundTrip(wire, motors, tool_moves(require_straight_axes(motors, file), play))
