# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drilling cycles of grblHAL, G73 and G81 to G83, as its `mc_canned_drill` makes them.

initial ----.  .----   G98: back to here, G99: only to R
            |  ^
R       ----v--|----   pecks of Q: G83 goes back to R after each, G73 up by $28
bottom  ----v--'       G82 waits P seconds there
"""

from __future__ import annotations

from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.board import Board, Waiting
from CNCStepper.virtual.grbl.gcode.block import AXES, CHIP_BREAK, DRILL_DWELL, PECKING, PLANES, Block, Drilling, Parser
from CNCStepper.virtual.grbl.gcode.words import f32

CHIP_BREAK_MM = 0.1  # $28 as delivered
RELATIVE, TO_INITIAL = 91, 98


def complete(block: Block, parser: Parser, zero_mm: float, unit_mm: float) -> None:
    """Fill in the cycle of a block and where it ends; words that lack are those of the same cycle before.

    zero_mm: the height of Z0 in machine coordinates. Raises MachineRefusal.
    """
    axis = PLANES[block.modal.plane][2]
    initial = parser.drilling.initial if parser.drilling else parser.position[axis]
    before = parser.drilling if block.modal.motion == parser.modal.motion else None
    relative = block.modal.distance == RELATIVE
    retract, bottom = before.retract if before else None, before.bottom if before else None
    if "R" in block.words:
        retract = f32(block.words["R"] * unit_mm + (initial if relative else zero_mm))
    if AXES[axis] in block.words:
        bottom = f32((retract or 0.0) + block.words[AXES[axis]]) if relative else block.target[axis]
    if retract is None or bottom is None:
        raise refused(28)
    if retract < bottom:
        raise refused(54)
    peck, dwell_s = _own(block, before, unit_mm)
    block.drilling = Drilling(initial, retract, bottom, peck, dwell_s)
    block.repeats = max(int(block.words.get("L", 1)), 1)
    block.unused -= set("RLPQ")
    block.target[axis] = max(initial, retract) if block.modal.retract == TO_INITIAL else retract


def _own(block: Block, before: Drilling | None, unit_mm: float) -> tuple[float, float]:
    """Return the peck in mm, 0 for none, and the dwell in s."""
    peck = block.words["Q"] * unit_mm if "Q" in block.words else before.peck if before else 0.0
    dwell_s = block.words.get("P", before.dwell_s if before else 0.0)
    if block.modal.motion in PECKING and peck <= 0:
        raise refused(28)
    return (peck if block.modal.motion in PECKING else 0.0), (dwell_s if block.modal.motion == DRILL_DWELL else 0.0)


def run(machine: Board, block: Block) -> Waiting:
    """Queue the moves of all holes of a block; its target is where the last one ends."""
    cycle, (first, second, axis) = block.drilling, PLANES[block.modal.plane]
    assert cycle
    here, clear = list(machine.parser.position), block.target[axis]
    ways = [block.target[side] - here[side] if block.modal.distance == RELATIVE else 0.0 for side in (first, second)]
    if here[axis] < cycle.retract:
        here[axis] = cycle.retract
        yield from machine.queue(list(here), 0.0, rapid=True)
    here[first], here[second] = block.target[first], block.target[second]
    for _ in range(block.repeats):
        yield from machine.queue(list(here), 0.0, rapid=True)
        yield from _hole(machine, block, here)
        here[axis] = clear
        yield from machine.queue(list(here), 0.0, rapid=True)
        block.target = list(here)
        here[first], here[second] = here[first] + ways[0], here[second] + ways[1]


def _hole(machine: Board, block: Block, here: list[float]) -> Waiting:
    cycle, axis = block.drilling, PLANES[block.modal.plane][2]
    assert cycle
    depth, up = cycle.retract, CHIP_BREAK_MM if block.modal.motion == CHIP_BREAK else float("inf")
    yield from _to(machine, here, axis, depth)
    while depth > cycle.bottom:
        depth = max(depth - cycle.peck, cycle.bottom) if cycle.peck else cycle.bottom
        yield from _to(machine, here, axis, depth, block.feed)
        if cycle.dwell_s:
            yield from machine.wait_for_stop()
            yield from machine.wait(cycle.dwell_s)
        yield from _to(machine, here, axis, min(depth + up, cycle.retract))


def _to(machine: Board, here: list[float], axis: int, height: float, feed: float = 0.0) -> Waiting:
    """Go straight along an axis, rapidly where no feed is given."""
    here[axis] = height
    yield from machine.queue(list(here), feed, rapid=not feed)
