# SPDX-License-Identifier: LGPL-2.1-or-later
"""Executes one block on a copy of the model; what it gives to the table waits until the whole block is good.

words -> Plan (line_grammar.py) -> Execution on a copy -> all good: the copy is the model, the actions are done
                                                -> ProgramError: nothing has changed
"""

from __future__ import annotations

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import ANY_PLANE, MOTION_NAMES, NO_MOTION, Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.cutter_compensation import compensation_codes
from CNCStepper.gcode.interpreter.modal_codes import ACTS
from CNCStepper.gcode.interpreter.motion_codes import MOTIONS
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.gcode.syntax.line_grammar import Plan


class Execution(Block):
    """A block that calls the function of each of its codes, in RS274's order."""

    def execute(self, plan: Plan, values: list[float]) -> None:
        """Execute words, which are the block's from then on."""
        self.plan, self.values = plan, list(values)
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
            MOTIONS[motion](self, motion, before)

    def _check_far_plane(self, plane: str, motion: int) -> None:
        """Refuse what lies in a plane of U, V and W."""
        name = MOTION_NAMES[motion]
        if motion not in ANY_PLANE:
            what = f"{name} is not read in {plane}, a plane of the axes U, V and W"
            raise ProgramError("plane", what, value=name, advice="write G17, G18 or G19 before")
        if compensation_codes.active(self):
            self.uncompensated(f"nothing moves in the plane {plane}", name)

    def _set(self, code: Code) -> bool:
        """Set the code's fields of the modal state; whether that changed any."""
        before = self.model.state
        if code.sets:
            self.model.change(**code.sets)
        return self.model.state != before
