# SPDX-License-Identifier: LGPL-2.1-or-later
"""Probing: G38.2 to G38.5."""

from __future__ import annotations

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.motion.end_points import end_point, further_end
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.gcode.interpreter.state.parameters import length_scale
from CNCStepper.state import UNKNOWN
from CNCStepper.toolpath import LINE

PROBED = 5061  # first parameter of where a probe tripped, in coordinates and units of the text
PROBE_TRIPPED = 5070


def probe(block: Block, motion: int, before: int) -> None:
    """G38.2 to G38.5: towards the end until the probe trips, or clears; where that will be is not known."""
    model, name = block.model, MOTION_NAMES[motion]
    block.uncompensated("nothing may be probed", name)
    if model.state.feed_mode == "per_turn":
        raise ProgramError("feed-mode", "a probe takes no feed per turn", value=name, advice="write G94 before")
    if model.state.feed_mm_min <= 0:
        raise ProgramError(
            "no-feed", Text("{name} has no feed", name=name), value=name, advice="write an F word above 0 before"
        )
    end = end_point(model, block.plan, block.values)
    further = further_end(model, block.plan, block.values)
    if name in ("G38.2", "G38.4") and (end, further) == (model.position, model.further):
        raise ProgramError("no-move", "the probe is at its target already", value=name, advice="correct the end")
    block.event("probe", text=name)
    block.call("TURN_PROBE_ON()")
    begin = model.position
    block.unheard = True
    block.move(LINE, end, None, model.state.feed_mm_min, further)
    block.unheard = False
    numbers = [value / length_scale(axis, model.scale) for axis, value in enumerate(_work_point(block))]
    block.call(f"STRAIGHT_PROBE({', '.join(f'{value:.4f}' for value in numbers[:6])})")
    block.call("TURN_PROBE_OFF()")
    if model.bare:
        model.position = stand_alone_position.backed_off(model, begin)
    else:
        x, y, z = (there if there == here else UNKNOWN for here, there in zip(begin, end, strict=True))
        model.position = (x, y, z)
        numbers = [UNKNOWN] * len(numbers)
    for axis, value in enumerate(numbers):
        model.parameters.set(PROBED + axis, value)
    model.parameters.set(PROBE_TRIPPED, 0.0 if model.bare else UNKNOWN)


def _work_point(block: Block) -> tuple[float, ...]:
    model = block.model
    return (*model.work(model.position), *model.further_work())
