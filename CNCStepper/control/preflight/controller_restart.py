# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller that restarted when its port was opened: its position is unknown, and a word for its zero seldom counts.

It counts from where it stands: that place is its machine position 0, wherever it was before, while its work offsets are
the stored ones. So the work zero is where it was set only if the tool stands on it and all offsets are 0, as they are
when it was set right after a restart like this one (`cncstepper zero`). That nothing has moved the machine since only a
person can say; whether the numbers fit that word is seen here.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import filterfalse

from CNCStepper.control.program.wire_line import is_move
from CNCStepper.control.protocol.grbl.connect import ControllerInfo
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.motion_interlock import UNKNOWN
from CNCStepper.control.protocol.grbl.readiness import OFFSET_TOLERANCE_MM
from CNCStepper.control.protocol.grbl.report import Vector
from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.state import WORK_SYSTEMS

_SYSTEM = re.compile(r"G(5[4-8]|59(?:\.[123])?)(?![\d.])")
_MACHINE_PLACE = re.compile(r"G(28|30|53)(?![\d.])")
WHAT_TO_DO = (
    "home the machine; or move the tool to the work zero, set the zero of all axes there, and send without moving it "
    "in between"
)


def counts_from_here(driver: Grbl) -> bool:
    """Return whether a freshly greeted controller has machine position 0 at its present place."""
    return driver.mpos_mm is not None and _is_zero(driver.mpos_mm)


def check_counts_from_here(driver: Grbl) -> None:
    """Refuse a controller whose reset kept its count: its zero is unknown; raises MachineRefusal."""
    if not counts_from_here(driver):
        raise _refusal("its machine position is not 0", _words(driver.mpos_mm or ()))


def check_zero_here(lines: Iterable[str], driver: Grbl, found: ControllerInfo) -> None:
    """Refuse a program whose work zero was not where the machine stood at the restart; raises MachineRefusal."""
    in_force = next((word for word in found.modes.split() if word in WORK_SYSTEMS), "G54")
    systems = {in_force, *_systems(lines)}
    for name in sorted(systems | {"G92", "TLO"}):
        offset = driver.mm(found.offsets.get(name))
        if offset is None and name in systems:
            raise _refusal(Text("{name} is not reported", name=name), "")
        if offset and not _is_zero(offset):
            raise _refusal(Text("{name} was set before", name=name), _words(offset))


def _systems(lines: Iterable[str]) -> Iterator[str]:
    """Yield the work systems that a program names; raises MachineRefusal where it goes to a place of the machine."""
    for line in filterfalse(is_move, lines):
        plain = line.replace(" ", "").upper()
        if place := _MACHINE_PLACE.search(plain):
            raise _refusal(
                Text("the program has {place}, which goes by the machine's own zero", place=place[0]), line[:40]
            )
        yield from (f"G{number}" for number in _SYSTEM.findall(plain))


def _is_zero(vector: Vector) -> bool:
    return all(abs(value) <= OFFSET_TOLERANCE_MM for value in vector)


def _words(vector: Vector) -> str:
    return ",".join(f"{value:.3f}" for value in vector)


def _refusal(why: str, value: str) -> MachineRefusal:
    what = Text(
        "the controller restarted when its port was opened, so the machine's position is unknown: {why}", why=why
    )
    return MachineRefusal(UNKNOWN, what, value=value, advice=WHAT_TO_DO)
