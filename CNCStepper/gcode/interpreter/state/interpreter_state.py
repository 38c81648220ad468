# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state of the interpreter between lines; a block changes a copy, which replaces it when all went well.

The modes that M70 and M73 keep.

The words of canned cycles that stick while one is modal.

The speed of the spindle at a place: under G96 it follows X.
"""

from __future__ import annotations

from cmath import rect
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import inf, isnan, radians, tau
from typing import Any, NamedTuple

from CNCStepper.canned_cycle_expansion import Place
from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import CODE_OF_PLANE
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_state import Compensation
from CNCStepper.gcode.interpreter.motion.nurbs import Nurbs
from CNCStepper.gcode.interpreter.state.parameters import (
    G92_IN_FORCE,
    ROTATION,
    Parameters,
    further_of,
    nine,
    offset_number,
    parameters_at,
    stored_point,
)
from CNCStepper.gcode.syntax.material_comments import MaterialComment
from CNCStepper.state import ZERO3, ZERO9, Start, State, ToolEntry
from CNCStepper.tolerances import SAME_MM
from CNCStepper.units import MM_PER_INCH


class Modes(NamedTuple):
    """The modes of a moment; `on_return`: they come back when the subroutine ends (M73)."""

    state: State
    feed_number: float
    plane: str  # its code
    side: str  # "G40", "G41" or "G42"
    diameter: bool
    to_initial: bool
    path_calls: tuple[str, ...]
    overrides: frozenset[str]
    has_length: bool
    on_return: bool


class Run(NamedTuple):
    """What sticks: the height before the run, and the last block's Z, R and P or Q, as numbers of the text.

    bore: I, J and K of a G87. dwell: the last P of any cycle.
    """

    initial: float
    z: float
    r: float
    own: float
    bore: Place = (0.0, 0.0, 0.0)
    dwell: float = 0.0


@dataclass(frozen=True)
class Plasma:
    """What QtPlasmaC's words have set.

    materials: by number, as the text has them. cut_feed_mm_min, kerf_mm, pierce_s: of the one in force, 0 where it is
    not in the text. share: of the feed. tool: that runs. cut_off: whether the torch is kept off.
    """

    materials: Mapping[int, MaterialComment] = field(default_factory=dict)
    cut_feed_mm_min: float = 0.0
    kerf_mm: float = 0.0
    pierce_s: float = 0.0
    share: float = 1.0
    tool: int | None = None
    cut_off: bool = False

    def pin(self, name: str) -> float:
        """Return the value of `#<_hal[...]>` in mm; raises ProgramError where the text does not give it."""
        values = {"_hal[plasmac.cut-feed-rate]": self.cut_feed_mm_min, "_hal[plasmac.kerf-width]": self.kerf_mm}
        if name not in values:
            what = "this pin of the machine is not known to this reader"
            raise ProgramError("unknown-parameter", what, advice="write the value itself")
        if not values[name]:
            what = "the program does not contain the values of the material that QtPlasmaC has selected"
            example = "(nu=7, ph=3.8, pd=0.4, ch=1.5, fr=3850, kw=1.5)"
            advice = Text(
                "write its comment before, such as {example}, or name material and thickness", example=example
            )
            raise ProgramError("material-unknown", what, value=f"#<{name}>", advice=advice)
        return values[name]


Point = tuple[float, float, float]
ZERO: Point = ZERO3
FIRST_PATH_CALLS = ("SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS, 0.000000)", "SET_NAIVECAM_TOLERANCE(0.0000)")
NO_FURTHER = (0.0,) * 6
POWER_ON = 1.0  # the speed of "on" without S
NO_LIMIT = 1e30  # turns a minute, of G96 without D


class Model:
    """The modal state, the position in machine coordinates (NaN where unknown) and the offsets.

    scale: mm per unit of the text. absolute: G90. per_minute: G94. plain: nothing but words and feeds per minute, so
    that the short ways through a line serve. further: the machine position of A B C (degrees) U V W (mm), empty
    until one of them is named. origin, g92, tool_offset: of all nine axes, mm and degrees; offset: the three together,
    machine = offset + work turned by `turn`; further_offset: the same of the six. diameter: X words are diameters
    (G7). highest_rpm: of the spindle under G96, from G50. cycle_words: of first blocks of a lathe's cycles.
    run: the words of canned cycles that stick while one is modal; to_initial: G98. parameters: the program's
    own, shared by the copies; a refused block's are rolled back. path_calls: what a trace says when the path mode in
    force comes back. tools: the tool table; loaded: the entry of the tool in the spindle. saved: modes kept by M70
    and M73, by level of call. feed_number: what the last F said, whatever the units since. feed_of_file_mm_min:
    what must be written into a file that has no F, 0 where that is not known. far_plane: "G17.1" and its like, in which
    only lines are read, or "". overrides: what may change speeds while the program runs. bare: read
    as LinuxCNC's stand-alone interpreter reads, whose probe never trips. stands: where the machine stands, if that is
    not `position` (`stand_alone_position.py`).
    """

    __slots__ = (
        "absolute",
        "arc_allowed",
        "bare",
        "compensation",
        "cycle_words",
        "diameter",
        "ended",
        "far_plane",
        "feed_number",
        "feed_of_file_mm_min",
        "further",
        "further_offset",
        "g92",
        "highest_rpm",
        "loaded",
        "motion",
        "nurbs",
        "offset",
        "operations",
        "origin",
        "overrides",
        "parameters",
        "path_calls",
        "per_minute",
        "plain",
        "plasma",
        "position",
        "run",
        "saved",
        "scale",
        "selected_tool",
        "spline_ij",
        "stands",
        "state",
        "to_initial",
        "tool_offset",
        "tools",
        "turn",
        "unit_mm",
        "zero_known",
    )

    state: State
    motion: int
    position: Point
    further: tuple[float, ...]
    origin: tuple[float, ...]
    g92: tuple[float, ...]
    tool_offset: tuple[float, ...]
    turn: complex | None
    parameters: Parameters
    unit_mm: float
    tools: dict[int, ToolEntry]
    loaded: ToolEntry
    selected_tool: int
    operations: tuple[str, ...]
    ended: bool
    run: Run | None
    to_initial: bool
    path_calls: tuple[str, ...]
    zero_known: bool
    scale: float
    offset: Point
    further_offset: tuple[float, ...]
    absolute: bool
    per_minute: bool
    plain: bool
    plasma: Plasma | None
    diameter: bool
    highest_rpm: float
    cycle_words: dict[str, dict[str, float]]
    compensation: Compensation | None
    arc_allowed: bool
    nurbs: Nurbs | None
    spline_ij: tuple[float, float]
    saved: dict[int, Modes]
    feed_number: float
    feed_of_file_mm_min: float
    far_plane: str
    overrides: frozenset[str]
    bare: bool
    stands: Point | None

    def copy(self) -> Model:
        """Return a copy; what it holds is never changed in place."""
        other = Model.__new__(Model)
        for name in Model.__slots__:
            setattr(other, name, getattr(self, name))
        return other

    def change(self, **fields: Any) -> None:
        """Change fields of the modal state."""
        self.state = state = replace(self.state, **fields)
        self.scale = MM_PER_INCH if state.units == "inch" else 1.0
        self.absolute = state.distance == "absolute"
        self.per_minute = state.feed_mode == "per_minute"
        self.offset = state.offset_mm  # type: ignore[assignment]
        self.look()

    def look(self) -> None:
        """Note whether the short ways through a line serve."""
        simple = self.turn is None and self.compensation is None and not self.further and self.arc_allowed
        here = self.stands is None
        here = here and self.feed_share == 1.0
        self.plain = self.per_minute and simple and here and not (self.diameter or self.far_plane)

    @property
    def feed_share(self) -> float:
        """The share of F at which the tool moves."""
        return self.plasma.share if self.plasma else 1.0

    @property
    def plane_code(self) -> str:
        """The code of the plane in force, "G17" to "G19.1"."""
        return self.far_plane or CODE_OF_PLANE[self.state.plane]

    def change_offset(self, **fields: Any) -> None:
        """Change fields and put the offset in force together from origin, G92 and tool."""
        turn = self.turn or 1.0
        g92 = complex(*self.g92[:2]) * turn
        x, y, z = (self.origin[axis] + self.tool_offset[axis] for axis in range(3))
        offset = (x + g92.real, y + g92.imag, z + self.g92[2])
        parts = (further_of(self.origin), further_of(self.g92), further_of(self.tool_offset))
        self.further_offset = tuple(map(sum, zip(*parts, strict=True)))
        length = self.tool_offset[2]
        self.change(g92_mm=self.g92[:3], tool_length_mm=length, offset_mm=offset, **fields)

    def use_system(self, system: str) -> None:
        """Take origin and rotation of a work system from the parameters."""
        first = offset_number(system)
        self.origin = stored_point(self.parameters, first, self.unit_mm)
        rotation = self.parameters.get(first + ROTATION)
        self.turn = rect(1.0, radians(rotation)) if rotation else None
        self.change_offset(work_system=system, rotation_deg=rotation)

    def work(self, machine: Point) -> Point:
        """Return a point of the machine in work coordinates, mm."""
        x, y, z = (machine[axis] - self.offset[axis] for axis in range(3))
        if self.turn is None:
            return x, y, z
        flat = complex(x, y) * self.turn.conjugate()
        return flat.real, flat.imag, z

    def machine(self, work: Point) -> Point:
        """Return a point in work coordinates, mm, in those of the machine."""
        x, y, z = work
        if self.turn is not None:
            flat = complex(x, y) * self.turn
            x, y = flat.real, flat.imag
        return x + self.offset[0], y + self.offset[1], z + self.offset[2]

    def further_work(self) -> tuple[float, ...]:
        """Return the positions of A B C U V W in work coordinates."""
        return tuple(a - b for a, b in zip(self.further or NO_FURTHER, self.further_offset, strict=True))

    def local(self) -> Model:
        """Return a copy with this one's (programmed) work coordinates for its machine coordinates."""
        other = self.copy()
        other.offset, other.turn, other.compensation = ZERO, None, None
        other.position = self.programmed_work()
        return other

    def programmed_work(self) -> Point:
        """Return the tool position of the text, in work mm."""
        ours = self.compensation
        return ours.programmed_work if ours and ours.entered else self.work(self.position)


def model_at(start: Start, dialect: Dialect, bare: bool = False) -> Model:
    """Return the model of a machine in the state `start`; raises ProgramError when it has not three or nine axes."""
    if len(start.position_mm) not in (3, 9):
        raise ProgramError(
            "axes",
            "programs are read for machines with three axes, or with nine",
            value=f"{len(start.position_mm)} axes",
            advice="give a start position of X, Y and Z",
        )
    model = Model()
    model.state = State(
        tool=start.tool,
        arc_centres=dialect.arc_centres,
        distance=dialect.distance,
        plane=dialect.first_plane,
        feed_mode=dialect.feed_mode,
        feed_mm_min=0.0 if dialect.needs_own_feed else dialect.default_feed_mm_min,
        spindle="cw" if dialect.power == "always" else "off",
        spindle_rpm=POWER_ON if dialect.power == "always" else start.spindle_rpm,
    )
    model.motion = dialect.first_motion
    model.feed_number = model.state.feed_mm_min
    model.feed_of_file_mm_min = dialect.default_feed_mm_min if dialect.needs_own_feed else 0.0
    model.parameters = parameters_at(start)
    model.unit_mm = start.machine_unit_mm
    model.tools = _tools(start)
    model.loaded = model.tools.get(start.tool, ToolEntry())
    model.selected_tool = start.tool
    model.zero_known = start.zero_known
    model.further = tuple(start.position_mm[3:])
    _fresh_modes(model, bare)
    model.diameter = dialect.diameter
    if dialect.plasma:
        model.plasma = Plasma(cut_feed_mm_min=dialect.default_feed_mm_min)
    model.g92 = nine(start.g92_mm)
    model.use_system(start.work_system)
    model.position = _first_position(start, model.offset, dialect)
    return model


def _fresh_modes(model: Model, bare: bool) -> None:
    """Set what no start state names."""
    model.bare = bare
    model.stands = None
    model.plasma = None
    model.operations = ()
    model.ended = False
    model.run = None
    model.to_initial = False
    model.path_calls = FIRST_PATH_CALLS
    model.turn = None
    model.origin = model.tool_offset = ZERO9
    model.further_offset = NO_FURTHER
    model.diameter = False
    model.highest_rpm = NO_LIMIT
    model.cycle_words = {}
    model.far_plane = ""
    model.compensation = None
    model.arc_allowed = True
    model.nurbs = None
    model.spline_ij = (0.0, 0.0)
    model.saved = {}
    model.overrides = frozenset(("feed", "speed", "hold"))


def _tools(start: Start) -> dict[int, ToolEntry]:
    """Return the tool table with the lengths that are given apart."""
    tools = dict(start.tools)
    for number, length in start.tool_lengths_mm.items():
        entry = tools.get(number, ToolEntry(pocket=number))
        tools[number] = replace(entry, offset_mm=(*entry.offset_mm[:2], length, *entry.offset_mm[3:]))
    return tools


def _first_position(start: Start, offset: Point, dialect: Dialect) -> Point:
    x, y, z = start.position_mm[:3]
    if not dialect.has_z and isnan(z):
        z = offset[2]
    if dialect.is_lathe and isnan(y):  # an axis that is not there
        y = offset[1]
    if dialect.starts_at_work_zero:
        x, y, z = (zero if value != value else value for value, zero in zip((x, y, z), offset, strict=True))
    return float(x), float(y), float(z)


def saved_g92(model: Model) -> tuple[float, ...]:
    """Return what G92.3 brings back: the parameters, mm and degrees."""
    return stored_point(model.parameters, G92_IN_FORCE + 1, model.unit_mm)


def rpm_at(model: Model, end: Point) -> float:
    """Return the speed in turns a minute at a place: the one commanded, or that of the surface speed."""
    if not model.state.surface_m_min:
        return model.state.spindle_rpm
    radius = abs(model.work(end)[0])
    rpm = model.state.surface_m_min * 1000.0 / (tau * radius) if radius else inf
    return 0.0 if isnan(rpm) else min(rpm, model.state.largest_rpm)


def mean_rpm(model: Model, end: Point) -> float:
    """Return the speed with which a feed a turn takes as long from the tool's place to `end` as with that of G96.

    Between two radii a turn takes 2 pi r / v, but no less than at the highest speed.
    """
    speed_mm_min, largest = model.state.surface_m_min * 1000.0, model.state.largest_rpm
    first, last = model.work(model.position)[0], model.work(end)[0]
    if not speed_mm_min or largest <= 0.0 or isnan(first) or isnan(last) or abs(last - first) < SAME_MM:
        return rpm_at(model, end)
    slow_mm = speed_mm_min / (tau * largest)  # the radius below which the highest speed counts

    def turned(radius: float) -> float:
        least = min(abs(radius), slow_mm)
        rest = tau / speed_mm_min * (radius * radius - least * least) / 2.0
        return (least / largest + rest) * (1.0 if radius >= 0.0 else -1.0)

    return abs((last - first) / (turned(last) - turned(first)))
