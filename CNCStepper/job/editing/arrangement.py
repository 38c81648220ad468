# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where copies of programs lie on the work surface: at given places, in a grid, or nested by what each cuts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.gcode.edit.arrange import Copy, arranged
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.editing.edit_check import EditCheck
from CNCStepper.machine.profile import Machine
from CNCStepper.nesting.nest import nest
from CNCStepper.nesting.nesting_model import Budget, Item, Placement, Sheet, Spacing, moved, turned
from CNCStepper.nesting.outlines import simplified
from CNCStepper.simulation.finding import Finding
from CNCStepper.toolpath import ARC_CCW, ARC_CW, RAPID, Toolpath

CHORD_RAD = 0.1  # of arcs in an outline
COARSE_MM = 0.05  # how far a simplified outline may exceed the cuts
THIN_MM = 0.05  # half the width that a cut has at least
MOST_COPIES = 2_000
SEARCH_S = 5.0
ROUNDING_MM = 0.001  # of a place: programs are written in µm


@dataclass(frozen=True)
class Program:
    """A program, how often it is wanted, and the outline of its cuts widened by the tool's radius."""

    name: str
    text: str
    count: int
    outline: Polygon


def program_of(name: str, text: str, count: int, dialect: str, tool_radius_mm: float) -> Program:
    """Return a program with its outline; raises JobError for one that cuts nothing and for too many copies."""
    if not 1 <= count <= MOST_COPIES:
        limit = f"1 to {MOST_COPIES}"
        what, advice = "the count of copies is out of bounds", "give a count within the limit"
        raise JobError("arrange-count", what, value=f"{count}", limit=limit, advice=advice)
    path = interpret(text, None, dialect, name)
    return Program(name, text, count, cut_outline(path, name, max(tool_radius_mm, THIN_MM)))


def cut_outline(path: Toolpath, name: str, radius_mm: float) -> Polygon:
    """Return the outline round all cuts of a path, seen from above, in work coordinates."""
    table, offsets = path.table(), path.offsets_mm()
    begins, ends = path.begins()[:, :2] - offsets[:, :2], table.end[:, :2] - offsets[:, :2]
    lines = []
    for row in np.flatnonzero(table.kind != RAPID).tolist():
        if np.isfinite(begins[row]).all() and np.isfinite(ends[row]).all():
            lines.append(_line(table.kind[row], begins[row], ends[row], table.centre[row, :2] - offsets[row, :2]))
    whole = shapely.union_all(shapely.buffer(lines, radius_mm, quad_segs=2)) if lines else Polygon()
    if whole.is_empty:
        advice = "give a program that cuts along X and Y"
        raise JobError("arrange-cuts", "the program cuts nothing at a known place", place=Place(name), advice=advice)
    filled = shapely.union_all([Polygon(part.exterior) for part in shapely.get_parts(whole)])
    outline = filled if isinstance(filled, Polygon) else filled.convex_hull
    return simplified(Polygon(outline.exterior), COARSE_MM)


def _line(kind: int, begin: np.ndarray, end: np.ndarray, centre: np.ndarray) -> shapely.LineString:
    """Return a move as a line of chords; arcs of other planes are straight from above."""
    if kind not in (ARC_CW, ARC_CCW) or not np.isfinite(centre).all():
        return shapely.LineString([begin, end])
    first, last = (math.atan2(*(point - centre)[::-1]) for point in (begin, end))
    sense = 1.0 if kind == ARC_CCW else -1.0
    sweep = (sense * (last - first)) % (2.0 * math.pi) or 2.0 * math.pi
    angles = first + sense * np.linspace(0.0, sweep, 2 + int(sweep / CHORD_RAD))
    radius = math.dist(begin, centre) / math.cos(CHORD_RAD / 2.0)
    places = centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    return shapely.LineString([begin, *places[1:-1], end])


def at_places(programs: Sequence[Program], places: Sequence[tuple[float, float, float]]) -> list[Copy]:
    """Return the copies at places of their work zeros (x_mm, y_mm, rotation_deg); one program takes all of them."""
    wanted = [program for program in programs for _ in range(program.count)]
    if len(programs) == 1:
        wanted = [programs[0]] * len(places)
    if len(wanted) != len(places):
        what = Text("{count} copies have {places} places", count=len(wanted), places=len(places))
        raise JobError("arrange-places", what, advice="give --at once for each copy")
    return [Copy(program.name, program.text, *place) for program, place in zip(wanted, places, strict=True)]


def in_grid(programs: Sequence[Program], columns: int, gap_mm: float) -> list[Copy]:
    """Return the copies in rows of `columns` from 0, 0; each cell is as large as the largest outline and the gap."""
    boxes = np.array([program.outline.bounds for program in programs])
    wide, high = (boxes[:, 2:] - boxes[:, :2]).max(axis=0) + gap_mm
    wanted = [program for program in programs for _ in range(program.count)]
    copies = []
    for number, program in enumerate(wanted):
        left, low = program.outline.bounds[:2]
        row, column = divmod(number, columns)
        copies.append(Copy(program.name, program.text, _rounded(column * wide - left), _rounded(row * high - low)))
    return copies


def on_sheet(
    programs: Sequence[Program], size_mm: tuple[float, float], gap_mm: float, rotations_deg: Sequence[float]
) -> list[Copy]:
    """Return the copies nested on a sheet from 0, 0; raises JobError that names a copy without a place."""
    items = items_of(programs, rotations_deg)
    placements = nested(items, work_surface(size_mm), gap_mm, Budget(SEARCH_S))
    return copies_at(programs, placements)


def items_of(programs: Sequence[Program], rotations_deg: Sequence[float] | None) -> list[Item]:
    """Return the programs as what is nested; rotations_deg: None for any."""
    allowed = None if rotations_deg is None else tuple(rotations_deg)
    return [Item(program.name, program.outline, program.outline, program.count, allowed) for program in programs]


def work_surface(size_mm: tuple[float, float]) -> Sheet:
    """Return the sheet from 0, 0 on which programs lie."""
    return Sheet("work surface", shapely.box(0.0, 0.0, *size_mm))


def nested(items: Sequence[Item], sheet: Sheet, gap_mm: float, budget: Budget) -> list[Placement]:
    """Return where the items lie, rounded to what programs are written in; raises JobError for one without a place."""
    layout = nest(items, [sheet], Spacing(gap_mm + 2.0 * ROUNDING_MM), budget)
    if layout.unplaced:
        missing = layout.unplaced[0]
        name = items[missing.item].name
        what = Text("{count} copies of {name} have no place on the work surface", count=missing.count, name=name)
        raise JobError("arrange-room", what, advice="give fewer copies, a smaller gap or a larger --sheet")
    return [replace(each, x_mm=_rounded(each.x_mm), y_mm=_rounded(each.y_mm)) for each in layout.placements]


def copies_at(programs: Sequence[Program], placements: Sequence[Placement]) -> list[Copy]:
    """Return the copies at their placements, by program and then from left to right."""
    ordered = sorted(placements, key=lambda each: (each.item, each.x_mm, each.y_mm))
    return [
        Copy(programs[each.item].name, programs[each.item].text, each.x_mm, each.y_mm, each.rotation_deg)
        for each in ordered
    ]


def _rounded(value_mm: float) -> float:
    """Return a place on the grid that programs are written in."""
    return round(value_mm, 3) + 0.0


def outlines_at(programs: Sequence[Program], copies: Sequence[Copy]) -> list[Polygon]:
    """Return the outline of each copy at its place."""
    outlines = {program.name: program.outline for program in programs}
    return [moved(turned(outlines[copy.name], copy.rotation_deg), copy.x_mm, copy.y_mm) for copy in copies]


def require_apart(programs: Sequence[Program], copies: Sequence[Copy]) -> None:
    """Raise JobError that names two copies which cut into each other."""
    outlines = outlines_at(programs, copies)
    tree = shapely.STRtree(outlines)
    left, right = tree.query(outlines, predicate="intersects")
    for one, other in zip(left.tolist(), right.tolist(), strict=True):
        if one < other and outlines[one].intersection(outlines[other]).area > COARSE_MM**2:
            what = Text("{one} and {other} cut into each other", one=copies[one].title, other=copies[other].title)
            raise JobError("arrange-overlap", what, advice="place them farther apart, or --allow-overlap")


def arranged_and_checked(
    programs: Sequence[Program],
    copies: Sequence[Copy],
    dialect: str,
    file: str,
    machine: Machine | None,
    allow_overlap: bool = False,
) -> tuple[str, list[Finding]]:
    """Return the one program of all copies, and the errors for which it may not be written.

    Raises JobError for copies that cut into each other, ProgramError for a program that cannot be moved or sent.
    """
    if not allow_overlap:
        require_apart(programs, copies)
    text = arranged(copies, dialect)
    return text, EditCheck(dialect, None, file, machine).new_errors(programs[0].text, text)
