# SPDX-License-Identifier: LGPL-2.1-or-later
"""Executes one block on a copy of the model; its rows of the table wait until the whole block is good.

words -> Plan (line_grammar.py) -> Execution on a copy -> all good: the copy is the model, the actions are done
                                                -> ProgramError: nothing has changed

Which function executes each motion code: `MOTIONS` has all.

Each takes the block, the motion and the one that was modal before.

Words and codes without motion: F, feed and plane modes, dwell, stops and the end; `ACTS` has all.

Each function is one act of `codes.Code`; it changes the block's copy of the model only.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import (
    ANY_PLANE,
    CYCLES,
    MOTION_NAMES,
    NO_MOTION,
    PROBES,
    PROFILE_CYCLES,
    RS274,
    SPLINES,
    TWO_BLOCK_CYCLES,
    Code,
)
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.canned_cycles import retract, run_block
from CNCStepper.gcode.interpreter.canonical_output import SET_FEED
from CNCStepper.gcode.interpreter.cutter_compensation import compensation_codes
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_codes import (
    COMPENSATION_ACTS,
    end_compensation,
    flush,
)
from CNCStepper.gcode.interpreter.functions.coordinate_offsets import OFFSET_ACTS, emit_rotation, emit_work_offset
from CNCStepper.gcode.interpreter.functions.outputs import OUTPUT_ACTS
from CNCStepper.gcode.interpreter.functions.plasma import PLASMA_ACTS
from CNCStepper.gcode.interpreter.functions.spindle import SPINDLE_ACTS, check_spindle
from CNCStepper.gcode.interpreter.functions.tools import TOOL_ACTS
from CNCStepper.gcode.interpreter.motion.end_points import without_increments
from CNCStepper.gcode.interpreter.motion.probing import probe
from CNCStepper.gcode.interpreter.motion.splines import SPLINE_ACTS, bezier, control_point
from CNCStepper.gcode.interpreter.motion.straight_and_arc_moves import arc, straight
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.gcode.interpreter.state.modal_state_stack import MODE_ACTS
from CNCStepper.gcode.lathe.profile_cycles import run_profile
from CNCStepper.gcode.lathe.threading import run_thread, tap, thread
from CNCStepper.gcode.lathe.two_block_cycles import run_two_blocks
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID
from CNCStepper.units import MM_PER_INCH

Motion = Callable[[Block, int, int], None]
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

TWO_BLOCKS = frozenset(code.motion for code in TWO_BLOCK_CYCLES)


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
    told = f_word * scale * block.model.feed_share
    block.model.change(**{"feed_mm_turn" if mode == "per_turn" else "feed_mm_min": told})
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
    plane = block.dialect.first_plane
    if state.plane != plane or model.far_plane:
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
    own = {"plane": plane, "feed_mode": block.dialect.feed_mode}
    model.change(**own, distance="absolute", spindle="off", mist=False, flood=False)
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
    **PLASMA_ACTS,
    **COMPENSATION_ACTS,
    **SPLINE_ACTS,
    **MODE_ACTS,
    **{
        act.__name__: act
        for act in (feed, feed_mode, plane, other_plane, diameter, dwell, blend, path, retract, stop, end)
    },
}


class Execution(Block):
    """A block that calls the function of each of its codes, in RS274's order."""

    def execute(self, plan: Plan, values: list[float]) -> None:
        """Execute words, which become the block's own."""
        self.plan, self.values = plan, list(values)
        if self.dialect.axis_increments:
            self.plan, self.values = without_increments(self.model, plan, self.values)
        if self.model.diameter:
            self.scale_x(0.5)
        if plan.polar and self.model.plane_code != "G17":
            what = "@ and ^ lie in the plane XY"
            value = "@" if "@" in plan.slots else "^"
            raise ProgramError("polar", what, value=value, advice="write G17 on a line before")
        for code in plan.codes:
            if code.group == "motion" and code.motion is not None:
                self._motion(code)
                continue
            scale = self.model.scale
            changed = self._set(code)
            if self.model.scale != scale:
                stand_alone_position.units_change(self.model, scale)
            if changed or not code.silent:
                for call in code.calls:
                    self.call(call)
            if code.act:
                ACTS[code.act](self, code)
        if self.asks_position:
            stand_alone_position.ask_position(self.model)
            compensation_codes.take_centre_position(self)

    def _motion(self, code: Code) -> None:
        self._set(code)
        motion, before = self.plan.motion, self.model.motion
        if code.modal:
            self.model.motion = code.motion if code.motion is not None else NO_MOTION
        for call in code.calls:
            self.call(call)
        if self.model.far_plane and motion != NO_MOTION:
            self._check_far_plane(self.model.far_plane, motion)
        if motion != NO_MOTION:
            takes_two = self.dialect.two_block_cycles and motion in TWO_BLOCKS
            (run_two_blocks if takes_two else MOTIONS[motion])(self, motion, before)

    def _check_far_plane(self, plane: str, motion: int) -> None:
        """Refuse what lies in a plane of U, V and W."""
        name = MOTION_NAMES[motion]
        if motion not in ANY_PLANE:
            what = Text("{name} is not read in {plane}, a plane of the axes U, V and W", name=name, plane=plane)
            raise ProgramError("plane", what, value=name, advice="write G17, G18 or G19 before")
        if compensation_codes.active(self):
            self.uncompensated(Text("nothing moves in the plane {plane}", plane=plane), name)

    def _set(self, code: Code) -> bool:
        """Set the code's fields of the modal state; whether that changed any."""
        before = self.model.state
        if code.sets:
            self.model.change(**code.sets)
        return self.model.state != before
