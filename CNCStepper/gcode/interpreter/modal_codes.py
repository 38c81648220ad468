# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words and codes without motion: F, feed and plane modes, dwell, stops and the end; `ACTS` has all.

Each function is one act of `codes.Code`; it changes the block's copy of the model only.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.gcode.dialects.codes import MOTION_NAMES, RS274, Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.canonical_output import SET_FEED
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_codes import (
    COMPENSATION_ACTS,
    end_compensation,
    flush,
)
from CNCStepper.gcode.interpreter.functions.coordinate_offsets import OFFSET_ACTS, emit_rotation, emit_work_offset
from CNCStepper.gcode.interpreter.functions.outputs import OUTPUT_ACTS
from CNCStepper.gcode.interpreter.functions.spindle import SPINDLE_ACTS, check_spindle
from CNCStepper.gcode.interpreter.functions.tools import TOOL_ACTS
from CNCStepper.gcode.interpreter.motion.splines import SPLINE_ACTS
from CNCStepper.gcode.interpreter.state.modal_state_stack import MODE_ACTS
from CNCStepper.toolpath import LINE
from CNCStepper.units import MM_PER_INCH


def feed(block: Block, code: Code) -> None:
    """F: the feed a minute or a turn, in the units that hold for it; in inverse time it belongs to its line's move."""
    f_word = block.not_negative("F")
    mode = block.model.state.feed_mode
    if mode == "inverse_time":
        return  # F belongs to the move of its line
    units = next((one.sets["units"] for one in block.plan.codes if one.step == "units"), None)
    scale = block.model.scale
    if units and block.dialect.feed_in_new_units:
        scale = MM_PER_INCH if units == "inch" else 1.0
    block.model.feed_number = f_word
    block.model.change(**{"feed_mm_turn" if mode == "per_turn" else "feed_mm_min": f_word * scale})
    block.lengths(SET_FEED, f_word * scale)


def feed_mode(block: Block, code: Code) -> None:
    """G93, G94, G95: what F means from now on; what it was is forgotten where the meaning changes."""
    check_spindle(block)
    mode = {"G93": "inverse_time", "G94": "per_minute", "G95": "per_turn"}[code.name]
    before = block.model.state.feed_mode
    block.model.change(feed_mode=mode)
    if mode == "inverse_time":
        return
    if block.dialect.feed_mode_clears_feed or before != "per_minute":
        block.model.change(feed_mm_min=0.0, feed_mm_turn=0.0)
        block.model.feed_number = 0.0
    block.call("SET_FEED_RATE(0.0000)")


def plane(block: Block, code: Code) -> None:
    """G17, G18, G19: their state is set already; under compensation the plane stays."""
    compensation = block.model.compensation
    if compensation and (block.model.far_plane or compensation.plane != block.model.state.plane):
        block.uncompensated("the plane may not be changed", code.name)
    block.model.far_plane = ""
    block.model.look()


def other_plane(block: Block, code: Code) -> None:
    """G17.1, G18.1, G19.1: planes of U, V and W, in which no arc and no cycle is read, and no held move is made."""
    if block.model.compensation and block.model.compensation.held:
        block.uncompensated("the plane may not be changed", code.name)
    block.model.far_plane = code.name
    block.model.look()


def diameter(block: Block, code: Code) -> None:
    """G7, G8: X words are diameters from their own line on, or radii."""
    model, on = block.model, code.name == "G7"
    if on == model.diameter:
        return
    block.scale_x(0.5 if on else 2.0)
    if on and MOTION_NAMES[block.plan.motion] == "G76":  # LinuxCNC halves its depths once more on the line of G7
        for letter in "IJK":
            block.scale(letter, 0.5)
    model.diameter = on
    model.look()
    block.call(f'COMMENT("interpreter: Lathe diameter mode changed to {"diameter" if on else "radius"}")')


def dwell(block: Block, code: Code) -> None:
    """G4: wait without motion."""
    seconds = block.not_negative("P") * block.dialect.dwell_unit_s
    block.event("dwell", seconds)
    block.call(f"DWELL({seconds:.4f})")


def blend(block: Block, code: Code) -> None:
    """G64: P is how far corners may be cut, Q how far points may be left out, each in the units of the text."""
    block.uncompensated("the path mode may not be changed", code.name)
    tolerance = max(0.0, block.value("P")) if "P" in block.plan.slots else 0.0
    block.model.change(blend_mm=tolerance * block.model.scale)
    naive = block.value("Q") if "Q" in block.plan.slots else -1.0
    naive = naive if naive >= 0 else tolerance
    continuous = f"SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, {tolerance:.6f})"
    block.model.path_calls = (continuous, f"SET_NAIVECAM_TOLERANCE({naive:.4f})")
    for call in block.model.path_calls:
        block.call(call)


def path(block: Block, code: Code) -> None:
    """G61, G61.1: follow the path exactly, the latter with a stop at each corner."""
    block.uncompensated("the path mode may not be changed", code.name)
    block.model.path_calls = (code.calls[0], block.model.path_calls[1])
    block.model.change(blend_mm=0.0)


def retract(block: Block, code: Code) -> None:
    """G98, G99: canned cycles go back to where they began, or to R."""
    block.uncompensated("the retract mode may not be changed", code.name)
    block.model.to_initial = code.name == "G98"


def stop(block: Block, code: Code) -> None:
    """M0, M1: pause, after the moves that compensation holds back."""
    flush(block)
    for call in STOP_CALLS[code.name]:
        block.call(call)
    block.event("optional_pause" if code.name == "M1" else "pause", text=block.stop_text)


def end(block: Block, code: Code) -> None:
    """M2, M30: outputs off and the modes of a fresh start; units, G92 and tool length stay."""
    model = block.model
    end_compensation(block)
    block.event("end", 30.0 if code.name == "M30" else 2.0)
    state = model.state
    model.use_system("G54")
    emit_work_offset(block)
    emit_rotation(block)
    if state.plane != "XY" or model.far_plane:
        block.call(RS274["G17"].calls[0])
    block.call("SET_FEED_MODE(0, 0)")
    block.call("SET_FEED_RATE(0.0000)")
    if "feed" not in model.overrides:
        block.call("ENABLE_FEED_OVERRIDE()")
    block.call("STOP_SPINDLE_TURNING(0)")
    block.call("SET_SPINDLE_MODE(0 0.0000)")
    for lit, call in ((state.mist, "MIST_OFF()"), (state.flood, "FLOOD_OFF()")):
        if lit:
            block.call(call)
    for call in ("PALLET_SHUTTLE()",) * (code.name == "M30") + ("PROGRAM_END()",):
        block.call(call)
    model.change(plane="XY", distance="absolute", feed_mode="per_minute", spindle="off", mist=False, flood=False)
    model.motion, model.far_plane = LINE, ""
    model.ended = True


STOP_CALLS = {
    "M0": ("PROGRAM_STOP()",),
    "M1": ("OPTIONAL_PROGRAM_STOP()",),
    "M60": ("PALLET_SHUTTLE()", "PROGRAM_STOP()"),
}
ACTS: dict[str, Callable[[Block, Code], None]] = {
    **OFFSET_ACTS,
    **TOOL_ACTS,
    **SPINDLE_ACTS,
    **OUTPUT_ACTS,
    **COMPENSATION_ACTS,
    **SPLINE_ACTS,
    **MODE_ACTS,
    **{
        act.__name__: act
        for act in (feed, feed_mode, plane, other_plane, diameter, dwell, blend, path, retract, stop, end)
    },
}
