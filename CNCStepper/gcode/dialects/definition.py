# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of a dialect: one small definition, as data, of a controller's language.

The reader, the interpreter, the writer and `prepare` are written once and ask this form. A dialect names
the codes that it knows, says why it refuses others, and fixes the points in which controllers differ.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from CNCStepper.gcode.dialects.codes import CYCLES, NO_MOTION, RS274, Code
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID


@dataclass(frozen=True)
class ArcRule:
    """When the radii at both ends of an arc differ too much, in the text's own unit.

    An arc is refused when they differ by more than `slack` AND by more than `gap` or `relative` of the
    radius; when a radius is under `smallest_radius`; when it ends elsewhere than it starts but sweeps less
    than `smallest_angle_rad`, which the controller would run as a whole circle.
    """

    slack: float
    gap: float
    relative: float
    smallest_radius: float = 1e-9
    smallest_angle_rad: float = 0.0
    radius_slack: float = 0.0  # how much too short an R word may be

    def limits(self, scale: float) -> ArcRule:
        """Return the rule with its lengths in mm; `scale`: mm per unit of the text."""
        slack, gap, smallest = self.slack * scale, self.gap * scale, self.smallest_radius * scale
        return replace(self, slack=slack, gap=gap, smallest_radius=smallest, radius_slack=self.radius_slack * scale)


@dataclass(frozen=True)
class Writing:
    """How programs for this dialect are written.

    header, footer: the first and the last lines, "{units}" for the word of the unit. opens, closes: what stands before
    and after all blocks. units: that word; a unit without one is not written, "" is a language that knows only it.
    decimals: digits after the point by unit. largest_radius_mm: greater arcs become lines, because the controller's
    numbers are too coarse. canned: the cycles that are written as such, others move by move. work_systems: without any
    the program's one is the machine's. comment: its form, "" where there are none. block_end: what ends every block.
    code_digits: 2 for G01. number_step: from one N word to the next, 0 for none. helices, full_circles: whether an arc
    may leave its plane and end where it begins. whole_ends: every block names all coordinates. lifts: Z is the height.
    rapid_feed: rapids heed F, so that both rapids and cuts name it. pointed: every number has its point. short: numbers
    have no trailing zeros. keeps_distance: moves that were incremental stay so.
    """

    header: tuple[str, ...] = ()
    footer: tuple[str, ...] = ("M5", "M9", "M2")
    opens: str = ""
    closes: str = ""
    units: Mapping[str, str] = field(default_factory=lambda: {"mm": "G21", "inch": "G20"})
    decimals: Mapping[str, int] = field(default_factory=lambda: {"mm": 3, "inch": 4})
    largest_radius_mm: float = 1e9
    tool_change: tuple[str, ...] = ("pause", "split")
    canned: tuple[str, ...] = ()
    work_systems: tuple[str, ...] = ("G54", "G55", "G56", "G57", "G58", "G59")
    comment: str = "({})"
    block_end: str = ""
    code_digits: int = 1
    number_step: int = 0
    helices: bool = True
    full_circles: bool = True
    whole_ends: bool = False
    lifts: bool = True
    rapid_feed: bool = False
    pointed: bool = False
    short: bool = False
    keeps_distance: bool = False


@dataclass(frozen=True)
class Dialect:
    """What one controller's language is.

    codes: by name. letters: the words it knows beside G and M. refused: code or letter -> what to do instead.
    repeats: the motions that coordinates alone repeat. errors: our code -> the controller's own answer.
    front: how lines are brought into the form of RS274 before they are read, functions of `preprocessor.py` by name.
    settings: key -> value -> the fields that it changes, as in `mach:dwell=ms`; the first value is the dialect itself.
    """

    name: str
    title: str
    codes: Mapping[str, Code]
    letters: str
    arc_rules: Mapping[str, ArcRule]
    refused: Mapping[str, str] = field(default_factory=dict)
    errors: Mapping[str, str] = field(default_factory=dict)
    writing: Writing | None = None
    settings: Mapping[str, Mapping[str, Mapping[str, Any]]] = field(default_factory=dict)
    # the text
    front: tuple[str, ...] = ()
    line_limit: int = 0  # characters of one line with its newline; 0 is "no limit"
    reads_files: bool = False  # the machine reads the file itself: the limit holds for comments too
    largest_line_number: int = 2**31 - 1
    line_number_first: bool = False
    expressions: bool = False  # parameters and values in brackets
    o_words: bool = False  # subroutines, branches and loops; M98 and M99
    strict_comments: bool = False  # a comment must be closed, and may not hold "("
    strict_percent_markers: bool = False  # "%" only as first and last line
    skips_deleted: bool = False  # the block delete switch: lines that begin with "/" are left out
    needs_end: bool = False  # M2, M30 or "%" must end the text
    stops_at_end: bool = False  # nothing after M2 or M30 is read
    # words
    largest_tool: int = 2**31 - 1
    work_systems: int = 9
    tool_word_changes: bool = False  # T alone means that the tool is in the spindle
    feed_in_new_units: bool = False  # F is in the units that its own line selects
    feed_mode_clears_feed: bool = False  # G94 always forgets F, not only after G93
    suspend_g92: bool = False
    tool_offsets_sideways: bool = False  # G43.1 takes all axes, not only Z
    most_m_codes: int = 0  # on one line; 0 is "no limit"
    conflicts: Mapping[str, tuple[str, ...]] = field(default_factory=dict)  # beside those of one modal group
    cancel_yields: bool = False  # G80 may share a line with another motion, which counts
    cancel_takes_no_axes: bool = False  # beside G80 on the line, not even those of G43.1
    # motion
    compensates_backlash: bool = False  # the controller compensates the backlash of its axes, so the sender does not
    first_motion: int = NO_MOTION
    repeats: frozenset[int] = frozenset((RAPID, LINE, ARC_CW, ARC_CCW)) | CYCLES
    arc_needs_plane_axis: bool = False
    centre_repeats_arc: bool = False  # I, J or K without an axis word repeat a modal arc
    machine_moves_incremental: bool = False  # G53 is accepted under G91
    machine_word_alone: bool = False  # and without a motion on its line, while G0 or G1 is modal
    axes_need_motion: bool = False  # while G80 is in force no line has axis words, be they of G43.1, G92 or G10
    arc_centres: str = "incremental"
    distance: str = "absolute"  # as the machine is switched on
    dwell_letter: str = "P"
    dwell_unit_s: float = 1.0  # what one of that letter is after G4
    feed_unit_mm_min: float = 1.0  # what F1 is in a metric text; the front has turned it into mm/min already
    default_feed_mm_min: float = 0.0  # in force until an F comes
    needs_own_feed: bool = False  # a program must name its feed: the default cannot reach the machine
    feed_is_setting: bool = False  # of the machine: a program needs no F for it
    has_z: bool = True
    power: str = "speed"  # "speed": M3 with S; "switch": M3 without S is on; "always": on from the program's begin
    plasma: bool = False  # QtPlasmaC chooses cut data by material, pierces and moves Z itself
    spindles: int = 1  # that the word $ may name
    waits_for_index: bool = False  # each run of G1 begins at the spindle's index, so that thread passes meet
    starts_at_work_zero: bool = False  # an unknown tool position is taken as the work zero
    z_sign: float = 1.0  # of a lathe: -1 where Z falls away from the chuck
    is_lathe: bool = False  # the language of a lathe: the plane is ZX, and there is no Y
    diameter: bool = False  # X words are diameters without a code for it
    feed_mode: str = "per_minute"  # what F means as the machine is switched on
    lead_word: str = "K"  # of G33: K along the path, or F along the axis that moves farther
    two_block_cycles: bool = False  # of a lathe: G70 to G73 name blocks by N, G76 takes two blocks
    axis_increments: bool = False  # of a lathe: U and W are X and Z from where the tool is
    turret: bool = False  # T0203 turns the turret to tool 2 and takes its offset 3

    def motion_code(self, motion: int) -> Code | None:
        """Return the code that selects the kind of move `motion`, or None."""
        for code in self.codes.values():
            if code.motion == motion:
                return code
        return None

    @property
    def first_plane(self) -> str:
        """The plane in force as the machine is switched on, and behind a program's end."""
        return "ZX" if self.is_lathe else "XY"

    def own_name(self, name: str) -> str:
        """Return what the dialect calls the code `name` of RS274, "" where it lacks it."""
        return next((own for own, code in self.codes.items() if code == RS274[name]), "")


def with_axes(dialect: Dialect, axes: int) -> Dialect:
    """Return the dialect for a machine of so many axes: with nine, where A is read, U V W are read too."""
    more = "".join(letter for letter in "UVW" if letter not in dialect.letters)
    return replace(dialect, letters=dialect.letters + more) if axes == 9 and "A" in dialect.letters else dialect


def rs274_codes(names: str, *changed: Code) -> Mapping[str, Code]:
    """Return the codes of RS274 with these names (separated by blanks), some replaced or added."""
    codes = {name: RS274[name] for name in names.split()}
    return MappingProxyType({**codes, **{code.name: code for code in changed}})


def changed(name: str, **fields) -> Code:
    """Return the RS274 code `name` with some fields changed."""
    return replace(RS274[name], **fields)


def same_advice(names: Iterable[str], advice: str) -> dict[str, str]:
    """Return one advice for many refused codes or letters."""
    return dict.fromkeys(names, advice)
