# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight moves (G0, G1) and arcs (G2, G3), offset from their path by cutter compensation.

Both functions take the block, the motion and the one that was modal before.
"""

from __future__ import annotations

from math import isnan

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.block import Block, check_feed
from CNCStepper.gcode.interpreter.cutter_compensation import compensated_path, compensation_codes
from CNCStepper.gcode.interpreter.motion.arcs import arc_of
from CNCStepper.gcode.interpreter.motion.end_points import end_point, further_end, machine_end_point
from CNCStepper.gcode.interpreter.state.interpreter_state import rpm_at
from CNCStepper.toolpath import LINE


def straight(block: Block, motion: int, before: int) -> None:
    """G0 and G1."""
    model, plan = block.model, block.plan
    model.arc_allowed = True
    if motion == LINE:
        check_feed(model, motion, plan, block.values)
    if plan.machine:
        block_machine(block)
        end = machine_end_point(model, plan, block.values, block.dialect)
    else:
        end = end_point(model, plan, block.values)
    further = further_end(model, plan, block.values)
    feed = block.feed_of(motion, end, None, further) if motion == LINE else 0.0
    follow_surface(block, end)
    if compensation_codes.active(block):
        block.next_further = further
        compensated_path.straight(block, motion, end_in_work(block), feed)
        model.further = further
    else:
        block.move(motion, end, None, feed, further, row=plan.moves)
    model.look()


def block_machine(block: Block) -> None:
    """Refuse G53 under compensation."""
    if compensation_codes.active(block):
        block.uncompensated("G53 may not be used", "G53")


def end_in_work(block: Block) -> tuple[float, float, float]:
    """Return where the words lead in work mm, as the text has it: without the rounding of machine coordinates."""
    return end_point(block.model.local(), block.plan, block.values)


def follow_surface(block: Block, end: tuple[float, float, float]) -> None:
    """Let the spindle's speed follow X under G96."""
    model = block.model
    if model.state.surface_m_min and not isnan(end[0]):
        model.change(spindle_rpm=rpm_at(model, end))


def arc(block: Block, motion: int, before: int) -> None:
    """G2 and G3."""
    model, plan = block.model, block.plan
    if not model.arc_allowed:
        what = "the move after the end of a compensation must be a line"
        raise ProgramError("compensation", what, value=MOTION_NAMES[motion], advice="write a G0 or G1 before")
    check_feed(model, motion, plan, block.values)
    further = further_end(model, plan, block.values)
    if not model.compensation:
        end = end_point(model, plan, block.values)
        arc = arc_of(model, plan, block.values, end, motion, block.dialect)
        feed = block.feed_of(motion, end, arc, further)
        follow_surface(block, end)
        block.move(motion, end, arc, feed, further, row=plan.moves)
        return
    work = end_in_work(block)
    arc = arc_of(model.local(), plan, block.values, work, motion, block.dialect)
    placed = arc._replace(centre=model.machine(arc.centre))
    feed = block.feed_of(motion, model.machine(work), placed, further)
    follow_surface(block, model.machine(work))
    if compensation_codes.active(block):
        block.next_further = further
        compensated_path.arc(block, motion, work, arc, feed)
        model.further = further
    else:
        block.move(motion, model.machine(work), placed, feed, further, row=plan.moves)
