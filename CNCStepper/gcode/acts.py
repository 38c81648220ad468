# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words and codes that act beside the moves: F, S, T, tool change, dwell, stops and the end.

Each function is one act of `codes.Code`; it changes the block's copy of the model only.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from CNCStepper.gcode.codes import RS274, Code
from CNCStepper.gcode.offsets import OFFSET_ACTS, say_work_offset
from CNCStepper.toolpath import LINE
from CNCStepper.units import MM_PER_INCH

if TYPE_CHECKING:
    from CNCStepper.gcode.execute import Execution

SET_FEED = "SET_FEED_RATE({})"


def feed(block: Execution, code: Code) -> None:
    f_word = block.not_negative("F")
    if not block.model.plain:
        return  # in inverse time F belongs to the move of its line
    units = next((one.sets["units"] for one in block.plan.codes if one.step == "units"), None)
    scale = block.model.scale
    if units and block.dialect.feed_in_new_units:
        scale = MM_PER_INCH if units == "inch" else 1.0
    block.model.change(feed_mm_min=f_word * scale)
    block.lengths(SET_FEED, f_word * scale)


def feed_mode(block: Execution, code: Code) -> None:
    inverse = code.name == "G93"
    clears = not inverse and (block.dialect.feed_mode_clears_feed or not block.model.plain)
    block.model.change(feed_mode="inverse_time" if inverse else "per_minute")
    if clears:
        block.model.change(feed_mm_min=0.0)
    if not inverse:
        block.call("SET_FEED_RATE(0.0000)")


def speed(block: Execution, code: Code) -> None:
    speed = block.not_negative("S")
    block.model.change(spindle_rpm=speed)
    block.call(f"SET_SPINDLE_SPEED(0, {speed:.4f})")


def tool(block: Execution, code: Code) -> None:
    tool = block.whole("T", 0, block.dialect.largest_tool, "tool-number")
    block.model.selected_tool = tool
    if block.dialect.tool_word_changes:
        block.model.change(tool=tool)
    block.event("tool_select", tool)
    block.call(f"SELECT_TOOL({tool})")


def tool_change(block: Execution, code: Code) -> None:
    tool = block.model.selected_tool
    block.model.change(spindle="off", tool=tool)
    block.event("tool_change", tool)
    for call in ("START_CHANGE()", "STOP_SPINDLE_TURNING(0)", f"CHANGE_TOOL({tool})"):
        block.call(call)


def dwell(block: Execution, code: Code) -> None:
    seconds = block.not_negative("P")
    block.event("dwell", seconds)
    block.call(f"DWELL({seconds:.4f})")


def blend(block: Execution, code: Code) -> None:
    tolerance = block.not_negative("P") if "P" in block.plan.slots else 0.0
    naive = block.not_negative("Q") if "Q" in block.plan.slots else tolerance
    block.call(f"SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, {tolerance:.6f})")
    block.call(f"SET_NAIVECAM_TOLERANCE({naive:.4f})")


def stop(block: Execution, code: Code) -> None:
    block.event("pause" if code.name == "M0" else "optional_pause", text=block.stop_text)


def end(block: Execution, code: Code) -> None:
    """M2, M30: outputs off and the modes of a fresh start; units, G92 and tool length stay."""
    model = block.model
    block.event("end", float(code.name[1:]))
    state = model.state
    model.change_offset(work_system="G54")
    say_work_offset(block)
    block.call("SET_XY_ROTATION(0.0000)")
    if state.plane != "XY":
        block.call(RS274["G17"].calls[0])
    block.call("SET_FEED_MODE(0, 0)")
    block.call("SET_FEED_RATE(0.0000)")
    block.call("STOP_SPINDLE_TURNING(0)")
    block.call("SET_SPINDLE_MODE(0 0.0000)")
    for lit, call in ((state.mist, "MIST_OFF()"), (state.flood, "FLOOD_OFF()")):
        if lit:
            block.call(call)
    for call in ("PALLET_SHUTTLE()",) * (code.name == "M30") + ("PROGRAM_END()",):
        block.call(call)
    model.change(plane="XY", distance="absolute", feed_mode="per_minute", spindle="off", mist=False, flood=False)
    model.motion = LINE
    model.ended = True


ACTS: dict[str, Callable[[Execution, Code], None]] = {
    **OFFSET_ACTS,
    **{act.__name__: act for act in (feed, feed_mode, speed, tool, tool_change, dwell, blend, stop, end)},
}
