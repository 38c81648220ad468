# SPDX-License-Identifier: LGPL-2.1-or-later
"""The short way through a line that is a move and nothing else, in plain modes: no block, no copy of the model.

It is the one of the compiled runs (`compiled_reader.py`) too, so that they are tried against it line by line.
"""

from __future__ import annotations

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.block import check_feed
from CNCStepper.gcode.interpreter.motion.arcs import arc_of
from CNCStepper.gcode.interpreter.motion.end_points import end_point
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.toolpath import LINE, RAPID, TableBuilder


def is_short(model: Model, plan: Plan, values: list[float], largest_number: int) -> bool:
    """Whether a simple line only moves: its N is in range, and its F is the feed in force."""
    if plan.number >= 0 and not 0 <= values[plan.number] <= largest_number:
        return False
    return plan.feed < 0 or values[plan.feed] * model.scale == model.state.feed_mm_min


def move(model: Model, table: TableBuilder, plan: Plan, values: list[float], dialect: Dialect, line: int) -> None:
    """Make the move; raises ProgramError, and then nothing has changed."""
    end, motion = end_point(model, plan, values), plan.motion
    if motion == RAPID:
        table.rapid(end, line)
    else:
        check_feed(model, motion)
        feed = model.state.feed_mm_min
        if motion == LINE:
            table.feed(end, feed, line)
        else:
            arc = arc_of(model, plan, values, end, motion, dialect)
            table.arc(motion, end, arc.centre, feed, arc.plane, arc.turns, line)
    model.position, model.motion = end, motion
    if plan.feed >= 0:
        model.feed_number = values[plan.feed]
