# SPDX-License-Identifier: LGPL-2.1-or-later
"""System parameters: `#5420`…, `#<_x>`, `#<_metric>` and their like, computed by the reader.

Names and meanings are LinuxCNC's ("Predefined Named Parameters"). None of them can be assigned.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import ALL_AXES, MOTION_NAMES
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.interpreter.state.parameters import FIRST_POSITION, LARGEST, READ_ONLY, Parameters, length_scale
from CNCStepper.state import WORK_SYSTEMS
from CNCStepper.units import MM_PER_INCH

_AXES = ALL_AXES.lower()
_OF_THE_MACHINE = {
    "_ini[": "the settings file of the machine is not known to this reader",
    "_hal[": "the pins of the machine are not known to this reader",
}
TOOL = range(5400, 5414)
_POCKETS = ("_current_pocket", "_selected_pocket")


class SystemParameters:
    """The parameters as the line `line` may use them; `model` is the state before that line."""

    def __init__(self, model: Model, line: int):
        self.model = model
        self.parameters: Parameters = model.parameters
        self.line = line

    def number(self, number: int) -> float:
        """Return the value of `#number`; raises ProgramError where there can be none."""
        check_number(number)
        axis = number - FIRST_POSITION
        if 0 <= axis < len(_AXES):
            return self._position(axis)
        if number in TOOL:
            return _tool(self.model)[number - TOOL[0]]
        value = self.parameters.get(number)
        if value != value:
            what = Text("the value of #{number} is known only when the program runs", number=number)
            raise ProgramError("unknown-parameter", what, advice="a probe or an input sets it on the machine")
        return value

    def named(self, name: str) -> float:
        """Return the value of `#<name>`; raises ProgramError when it has none."""
        if name in _POCKETS:
            raise ProgramError("unknown-parameter", "this reader knows no pockets", advice="use #<_current_tool>")
        if is_predefined(name):
            return self._predefined(name)
        if self.model.plasma and name.startswith("_hal["):
            return self.model.plasma.pin(name) / self.model.scale
        for beginning, reason in _OF_THE_MACHINE.items():
            if name.startswith(beginning):
                raise ProgramError("unknown-parameter", reason, advice="write the value itself")
        if not self.parameters.has_name(name):
            raise ProgramError(
                "unknown-parameter", Text("#<{name}> has no value here", name=name), advice="assign it before"
            )
        return self.parameters.get_named(name)

    def exists(self, parameter: int | str) -> bool:
        """Whether a parameter can be read."""
        if isinstance(parameter, int):
            return 1 <= parameter <= LARGEST
        return is_predefined(parameter) or parameter in _POCKETS or self.parameters.has_name(parameter)

    def _predefined(self, name: str) -> float:
        if name[1:] in _AXES:
            return self._position(_AXES.index(name[1:]))
        if name == "_line":
            return float(self.line)
        return float(_OF_THE_MODEL[name](self.model))

    def _position(self, axis: int) -> float:
        """Return the tool's position along an axis, in the coordinates and units of the text."""
        model = self.model
        if axis >= 3:
            return model.further_work()[axis - 3] / length_scale(axis, model.scale)
        value = model.work(model.position)[axis]
        if value != value:
            what = Text("the position along {axis} is not known here", axis=_AXES[axis].upper())
            raise ProgramError("unknown-position", what, advice="move there with G90 first")
        return value / model.scale


def is_predefined(name: str) -> bool:
    """Whether a name means something before any program gives it a value."""
    return name == "_line" or name in _OF_THE_MODEL or (len(name) == 2 and name[0] == "_" and name[1] in _AXES)


def check_number(number: int) -> None:
    """Refuse a number that no parameter has."""
    if not 1 <= number <= LARGEST:
        what = Text("there is no parameter #{number}", number=number)
        raise ProgramError("parameter-range", what, limit=f"1 to {LARGEST}", advice="correct the number")


def check_assignable(target: int | str) -> None:
    """Refuse to assign what only the reader sets."""
    if isinstance(target, int):
        check_number(target)
        fixed = target in READ_ONLY
    else:
        fixed = is_predefined(target) or target in _POCKETS
    if fixed:
        name = f"#{target}" if isinstance(target, int) else f"#<{target}>"
        raise ProgramError("read-only", Text("{name} may not be assigned", name=name), advice="use a name of your own")


def _is(field: str, value: str) -> Callable[[Model], float]:
    return lambda model: getattr(model.state, field) == value


def _work_system(model: Model) -> float:
    """Return 540 for G54 to 590 for G59, 591 to 593 for G59.1 to G59.3."""
    index = WORK_SYSTEMS.index(model.state.work_system)
    return 540.0 + 10 * index if index < 6 else 585.0 + index


def _compensation(model: Model) -> float:
    """Return 400, 410 or 420 for G40, G41 and G42."""
    if model.compensation is None:
        return 400.0
    return 410.0 if model.compensation.left else 420.0


def _speed(model: Model) -> float:
    """Return the S word in force: turns a minute, or the speed of the surface."""
    surface = model.state.surface_m_min
    return abs(surface / (MM_PER_INCH * 0.012 if model.state.units == "inch" else 1.0) or model.state.spindle_rpm)


def _tool(model: Model) -> tuple[float, ...]:
    """Return #5400 to #5413 of the tool in the spindle, lengths in the machine's own unit."""
    tool, unit = model.loaded, model.unit_mm
    offsets = (value / length_scale(axis, unit) for axis, value in enumerate(tool.offset_mm))
    diameter = 0.0 if tool.diameter_mm != tool.diameter_mm else tool.diameter_mm / unit
    return model.state.tool, *offsets, diameter, tool.front_deg, tool.back_deg, tool.orientation


_OF_THE_MODEL: dict[str, Callable[[Model], float]] = {
    "_vmajor": lambda model: 2.9,
    "_vminor": lambda model: 0.0,
    "_task": lambda model: 0.0,
    "_motion_mode": lambda model: round(10 * float(MOTION_NAMES[model.motion][1:])),
    "_plane": lambda model: round(10 * float(model.plane_code[1:])),
    "_ccomp": _compensation,
    "_metric": _is("units", "mm"),
    "_imperial": _is("units", "inch"),
    "_absolute": _is("distance", "absolute"),
    "_incremental": _is("distance", "incremental"),
    "_inverse_time": _is("feed_mode", "inverse_time"),
    "_units_per_minute": _is("feed_mode", "per_minute"),
    "_units_per_rev": _is("feed_mode", "per_turn"),
    "_coord_system": _work_system,
    "_tool_offset": lambda model: any(model.tool_offset),
    "_retract_r_plane": lambda model: not model.to_initial,
    "_retract_old_z": lambda model: model.to_initial,
    "_spindle_rpm_mode": lambda model: model.state.surface_m_min == 0,
    "_spindle_css_mode": lambda model: model.state.surface_m_min != 0,
    "_ijk_absolute_mode": _is("arc_centres", "absolute"),
    "_lathe_diameter_mode": lambda model: model.diameter,
    "_lathe_radius_mode": lambda model: not model.diameter,
    "_spindle_on": lambda model: model.state.spindle != "off",
    "_spindle_cw": _is("spindle", "cw"),
    "_mist": lambda model: model.state.mist,
    "_flood": lambda model: model.state.flood,
    "_speed_override": lambda model: "speed" in model.overrides,
    "_feed_override": lambda model: "feed" in model.overrides,
    "_adaptive_feed": lambda model: "adaptive" in model.overrides,
    "_feed_hold": lambda model: "hold" in model.overrides,
    "_feed": lambda model: model.feed_number,
    "_rpm": _speed,
    "_current_tool": lambda model: model.state.tool,
    "_selected_tool": lambda model: model.selected_tool,
    "_value": lambda model: model.parameters.returned or 0.0,
    "_value_returned": lambda model: model.parameters.returned is not None,
    "_call_level": lambda model: model.parameters.level,
    "_remap_level": lambda model: 0.0,
}
