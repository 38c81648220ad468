# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each motion code does: lines and arcs here, all others in modules of their own; `MOTIONS` has all.

Each function takes the block, the motion and the one that was modal before.
"""

from __future__ import annotations

from collections.abc import Callable
from math import isnan
from typing import TYPE_CHECKING

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.canned.canned_cycles import run_block
from CNCStepper.gcode.dialects.codes import CYCLES, MOTION_NAMES, PROBES, PROFILE_CYCLES, SPLINES
from CNCStepper.gcode.interpreter.cutter_compensation import compensated_path, compensation_codes
from CNCStepper.gcode.interpreter.functions.spindle import rpm_at
from CNCStepper.gcode.interpreter.motion.moves import arc_of, check_feed, end_point, further_end, machine_end_point
from CNCStepper.gcode.interpreter.motion.splines import bezier, control_point
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.gcode.interpreter.state.stored_points import length_scale
from CNCStepper.gcode.lathe.profile_cycles import run_profile
from CNCStepper.gcode.lathe.threading import run_thread, tap, thread
from CNCStepper.state import UNKNOWN
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID

if TYPE_CHECKING:
    from CNCStepper.gcode.interpreter.execute import Execution

Motion = Callable[["Execution", int, int], None]
PROBED = 5061  # first parameter of where a probe tripped, in coordinates and units of the text
PROBE_TRIPPED = 5070


def straight(block: Execution, motion: int, before: int) -> None:
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


def block_machine(block: Execution) -> None:
    """Refuse G53 under compensation."""
    if compensation_codes.active(block):
        block.uncompensated("G53 may not be used", "G53")


def end_in_work(block: Execution) -> tuple[float, float, float]:
    """Return where the words lead in work mm, as the text has it: without the rounding of machine coordinates."""
    return end_point(block.model.local(), block.plan, block.values)


def follow_surface(block: Execution, end: tuple[float, float, float]) -> None:
    """Let the spindle's speed follow X under G96."""
    model = block.model
    if model.state.surface_m_min and not isnan(end[0]):
        model.change(spindle_rpm=rpm_at(model, end))


def arc(block: Execution, motion: int, before: int) -> None:
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
        block.move(motion, end, arc, feed, further, row=plan.moves)
        return
    work = end_in_work(block)
    arc = arc_of(model.local(), plan, block.values, work, motion, block.dialect)
    placed = arc._replace(centre=model.machine(arc.centre))
    feed = block.feed_of(motion, model.machine(work), placed, further)
    if compensation_codes.active(block):
        block.next_further = further
        compensated_path.arc(block, motion, work, arc, feed)
        model.further = further
    else:
        block.move(motion, model.machine(work), placed, feed, further, row=plan.moves)


def probe(block: Execution, motion: int, before: int) -> None:
    """G38.2 to G38.5: towards the end until the probe trips, or clears; where that will be is not known."""
    model, name = block.model, MOTION_NAMES[motion]
    block.uncompensated("nothing may be probed", name)
    if model.state.feed_mode == "per_turn":
        raise ProgramError("feed-mode", "a probe takes no feed per turn", value=name, advice="write G94 before")
    if model.state.feed_mm_min <= 0:
        raise ProgramError("no-feed", f"{name} has no feed", value=name, advice="write an F word above 0 before")
    end = end_point(model, block.plan, block.values)
    further = further_end(model, block.plan, block.values)
    if name in ("G38.2", "G38.4") and (end, further) == (model.position, model.further):
        raise ProgramError("no-move", "the probe stands at its end already", value=name, advice="correct the end")
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


def _work_point(block: Execution) -> tuple[float, ...]:
    model = block.model
    return (*model.work(model.position), *model.further_work())


MOTIONS: dict[int, Motion] = {
    RAPID: straight,
    LINE: straight,
    ARC_CW: arc,
    ARC_CCW: arc,
    **dict.fromkeys(CYCLES, run_block),
    **{MOTION_NAMES.index(name): probe for name in PROBES},
    **{MOTION_NAMES.index(name): bezier for name in SPLINES},
    **{MOTION_NAMES.index(name): run_profile for name in PROFILE_CYCLES},
    MOTION_NAMES.index("G5.2"): control_point,
    MOTION_NAMES.index("G33"): thread,
    MOTION_NAMES.index("G33.1"): tap,
    MOTION_NAMES.index("G76"): run_thread,
}
