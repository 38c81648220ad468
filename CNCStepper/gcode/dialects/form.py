# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of a dialect: one small definition, as data, of what a controller's language is.

The reader, the interpreter, the writer and `prepare` are written once and ask this form. A dialect names
the codes that it knows, says why it refuses others, and fixes the points in which controllers differ.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from CNCStepper.gcode.codes import NO_MOTION, RS274, Code
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


@dataclass(frozen=True)
class Writing:
    """How programs for this dialect are written.

    header: the modes that a program sets first. decimals: digits after the point by unit.
    largest_radius_mm: greater arcs are written as lines, because the controller's numbers are too coarse.
    """

    header: tuple[str, ...]
    decimals: Mapping[str, int] = field(default_factory=lambda: {"mm": 3, "inch": 4})
    largest_radius_mm: float = 1e9
    tool_change: tuple[str, ...] = ("pause", "split")
    work_systems: tuple[str, ...] = ("G54", "G55", "G56", "G57", "G58", "G59")


@dataclass(frozen=True)
class Dialect:
    """What one controller's language is.

    codes: by name. letters: the words it knows beside G and M. refused: code or letter -> what to do instead.
    repeats: the motions that coordinates alone repeat. errors: our code -> the controller's own answer.
    """

    name: str
    title: str
    codes: Mapping[str, Code]
    letters: str
    arc_rules: Mapping[str, ArcRule]
    refused: Mapping[str, str] = field(default_factory=dict)
    errors: Mapping[str, str] = field(default_factory=dict)
    writing: Writing | None = None
    # the text
    line_limit: int = 0  # characters of one line with its newline; 0 is "no limit"
    largest_line_number: int = 2**31 - 1
    line_number_first: bool = False
    strict_comments: bool = False  # a comment must be closed, and may not hold "("
    strict_tape: bool = False  # "%" only as first and last line
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
    # motion
    first_motion: int = NO_MOTION
    repeats: frozenset[int] = frozenset((RAPID, LINE, ARC_CW, ARC_CCW))
    arc_needs_plane_axis: bool = False
    centre_repeats_arc: bool = False  # I, J or K without an axis word repeat a modal arc
    machine_moves_incremental: bool = False  # G53 is accepted under G91
    arc_centres: str = "incremental"
    default_feed_mm_min: float = 0.0
    starts_at_work_zero: bool = False  # where the position is unknown the tool stands at the work zero

    def motion_code(self, motion: int) -> Code | None:
        """Return the code that selects the kind of move `motion`, or None."""
        for code in self.codes.values():
            if code.motion == motion:
                return code
        return None


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
