# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two programs compared by their interpreted moves, with their figures and the words for both.

    text ──► interpret ──► tool path ──► compare_paths ──► alone, common, first lines that differ, deviation
                               └──► figures, time, part            of each, side by side

Comments, numbers of lines, units and modal words make no difference: only the motion, its feed, tool and speed do.
The parts of lathe programs with a `lathe_setup.py` are compared by their exact profiles, on the bar of the first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.errors import JobError, Text
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.lathe.diameter_mode import is_lathe_program
from CNCStepper.job.comparison.lathe_setup import LatheSetup, bar_text
from CNCStepper.job.comparison.part_difference import CutPart, PartDifference, part_difference
from CNCStepper.job.comparison.turned_difference import ComparedSections
from CNCStepper.job.comparison.turned_words import ring_rows, turned_sentences
from CNCStepper.job.turning.make_turning import in_part
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.interpolation.dda_stream import times_and_whole_s
from CNCStepper.motion.planner.plan import begun
from CNCStepper.quantities import duration_text
from CNCStepper.simulation.comparison.path_figures import PathFigures, Range, figures_of
from CNCStepper.simulation.comparison.path_overlay import PathComparison, compare_paths
from CNCStepper.simulation.turning.turned_part import TurnedPart
from CNCStepper.state import Start
from CNCStepper.tolerances import SAME_MM, SAME_PATH_MM
from CNCStepper.toolpath import Toolpath

Share = Callable[[float], None]
PartOf = Callable[["ComparedProgram", Toolpath], CutPart]
READ, COMPARED, TIMED = 0.35, 0.75, 0.9  # shares of the work by then


@dataclass(frozen=True)
class ComparedProgram:
    """A program to compare. name: of its file or object. lathe: what cuts a lathe's. milled: whether it is a mill's."""

    name: str
    text: str
    dialect: str = "grbl"
    start: Start | None = None
    lathe: LatheSetup | None = None
    milled: bool = False


@dataclass(frozen=True)
class ProgramComparison:
    """Two programs; paths, figures and times_s of the first and the second.

    part: None without stock and tools. turned: the parts of lathe programs, else None. bars: theirs, where they differ.
    """

    names: tuple[str, str]
    same_mm: float
    toolpaths: tuple[Toolpath, Toolpath]
    paths: PathComparison
    figures: tuple[PathFigures, PathFigures]
    times_s: tuple[float, float] | None
    part: PartDifference | None
    turned: tuple[TurnedPart, TurnedPart] | None = None
    bars: tuple[Text, Text] | None = None

    @property
    def verdict(self) -> Text:
        """What is true of both, in one sentence."""
        if self.paths.same:
            return Text("the motion is the same")
        if self.paths.same_places:
            return Text("the same places are passed, in another order or at another feed, speed or tool")
        return Text("the tool paths differ")

    def lines(self, rows: tuple[int, int] | None) -> tuple[int, int] | None:
        """Return the lines of two rows of the tables; 0 where a program has ended by then."""
        if rows is None:
            return None
        first, second = (
            int(path.table().line[row]) if row >= 0 else 0 for path, row in zip(self.toolpaths, rows, strict=True)
        )
        return first, second


def compare_programs(
    first: ComparedProgram,
    second: ComparedProgram,
    *,
    machine: Machine | None = None,
    same_mm: float = SAME_PATH_MM,
    part_of: PartOf | None = None,
    share: Share = lambda share: None,
) -> ProgramComparison:
    """Return what two programs have in common and alone; raises ProgramError for one that cannot be read.

    Raises JobError for a lathe's program and a mill's.

    machine: its planner gives the times. same_mm: how far paths may be apart that are one. part_of: cuts the stock by a
    program's path. share: called with the share that is done, from 0 to 1.
    """
    one = _read(first, lambda done: share(READ / 2 * done))
    other = _read(second, lambda done: share(READ / 2 * (1 + done)))
    require_one_kind(first, one, second, other)
    paths = compare_paths(one, other, same_mm, lambda done: share(READ + (COMPARED - READ) * done))
    times_s = (_time_s(one, machine), _time_s(other, machine)) if machine else None
    share(TIMED)
    turned = _turned(first, one, second, other)
    parts = turned or ((part_of(first, one), part_of(second, other)) if part_of else None)
    part = part_difference(*parts, same_mm) if parts else None
    figures = _figures(one), _figures(other)
    share(1.0)
    names, bars = (first.name, second.name), _bars(first.lathe, second.lathe)
    return ProgramComparison(names, same_mm, (one, other), paths, figures, times_s, part, turned, bars)


def _read(program: ComparedProgram, share: Share) -> Toolpath:
    path = interpret(program.text, program.start, program.dialect, program.name, share)
    return in_part(path, program.lathe.placement) if program.lathe else path


def require_one_kind(first: ComparedProgram, one: Toolpath, second: ComparedProgram, other: Toolpath) -> None:
    """Raise JobError where one program is a lathe's and the other one a mill's.

    A lathe's is cut with a lathe's setup, or is in the language of one; a mill's is of its job, or moves along Y.
    """
    names = [Path(program.name).name for program in (first, second)]
    milled = [first.milled or _moves_along_y(one), second.milled or _moves_along_y(other)]
    if not any(milled) or not (_is_turned(first) or _is_turned(second)):
        return
    advice = "choose two programs of a mill, or two of a lathe"
    if all(milled):
        what = Text("{name} moves along Y: a lathe's bar and tools do not cut it", name=names[0])
        raise JobError("compare-kinds", what, advice=advice)
    mill = milled.index(True)
    what = Text("{mill} is a mill's program and {lathe} a lathe's", mill=names[mill], lathe=names[1 - mill])
    raise JobError("compare-kinds", what, advice=advice)


def _is_turned(program: ComparedProgram) -> bool:
    return program.lathe is not None or is_lathe_program(program.text, program.dialect)


def _moves_along_y(path: Toolpath) -> bool:
    y_mm = path.table().end[:, 1]
    known_mm = y_mm[np.isfinite(y_mm)]
    return len(known_mm) > 0 and float(np.ptp(known_mm)) > SAME_MM


def _turned(
    first: ComparedProgram, one: Toolpath, second: ComparedProgram, other: Toolpath
) -> tuple[TurnedPart, TurnedPart] | None:
    """Return what two lathe programs leave of the bar of the first one; None where their bars are not known."""
    if first.lathe is None or second.lathe is None:
        return None
    return first.lathe.part(one), second.lathe.part(other, first.lathe.stock)


def _bars(first: LatheSetup | None, second: LatheSetup | None) -> tuple[Text, Text] | None:
    """Return the bars of two lathe programs where they differ."""
    if first is None or second is None:
        return None
    one_mm, other_mm = (np.array(lathe.stock.region.bounds) for lathe in (first, second))
    same = np.abs(one_mm - other_mm).max() <= SAME_MM
    return None if same else (bar_text(first.stock), bar_text(second.stock))


def _figures(path: Toolpath) -> PathFigures:
    """Return a path's figures; an axis that is known nowhere, as Y of a lathe, takes no length away."""
    unknown = [axis for axis in range(3) if np.isnan(path.table().end[:, axis]).all()]
    if not unknown or not len(path):
        return figures_of(path)

    def level(points: np.ndarray) -> np.ndarray:
        found = points.copy()
        found[:, unknown] = 0.0
        return found

    chunks = [replace(chunk, end=level(chunk.end), centre=level(chunk.centre)) for chunk in path.chunks]
    begin = tuple(level(np.array([path.start.position_mm], float))[0].tolist())
    known = Toolpath(replace(path.start, position_mm=begin), chunks, path.states, path.events, path.spans)
    found = figures_of(known)
    x, y, z = (None if axis in unknown else found.box_mm[axis] for axis in range(3))
    return replace(found, box_mm=(x, y, z))


def _time_s(path: Toolpath, machine: Machine) -> float:
    """Return how long a path takes, from the work zero where it begins at an unknown place."""
    return times_and_whole_s(begun(path), machine)[1]


def sentences(found: ProgramComparison) -> Iterator[Text]:
    """Yield what a person reads first: the verdict, the first lines that differ, the largest deviations."""
    yield found.verdict
    parting = found.paths.parting
    if ends := _ends(found, parting.path):
        yield Text("first difference of the path: {one}, {other}", one=ends[0], other=ends[1])
    if ends := _ends(found, parting.feed):
        yield Text("first other feed: {one}, {other}", one=ends[0], other=ends[1])
    if ends := _ends(found, parting.mode):
        yield Text("first other tool, spindle or coolant: {one}, {other}", one=ends[0], other=ends[1])
    if (worst := found.paths.deviation) is not None:
        x_mm, y_mm, z_mm = worst.place_mm
        yield Text(
            "largest deviation of the cuts: {distance_mm:.3f} mm at X{x_mm:.3f} Y{y_mm:.3f} Z{z_mm:.3f}, {line}",
            distance_mm=worst.distance_mm, x_mm=x_mm, y_mm=y_mm, z_mm=z_mm,
            line=_line_of(worst.line, found.names[0 if worst.first else 1]),
        )  # fmt: skip
    if found.turned and found.part:
        yield from turned_sentences(found.turned, found.names, found.bars, found.part.rings, found.same_mm)
    elif found.part:
        yield _part_sentence(found.part)


def _ends(found: ProgramComparison, rows: tuple[int, int] | None) -> tuple[Text, Text] | None:
    """Return the lines of two rows in words."""
    lines = found.lines(rows)
    if lines is None:
        return None
    return _line_of(lines[0], found.names[0]), _line_of(lines[1], found.names[1])


def _line_of(line: int, name: str) -> Text:
    name = Path(name).name
    return Text("line {line} of {name}", line=line, name=name) if line else Text("the end of {name}", name=name)


def _part_sentence(part: PartDifference) -> Text:
    if part.place_mm is None:
        return Text("the simulated parts are the same")
    return Text(
        "the simulated parts differ by up to {deepest_mm:.3f} mm at {first}{x_mm:.2f} {second}{y_mm:.2f}",
        deepest_mm=part.deepest_mm, first=part.axes[0], x_mm=part.place_mm[0], second=part.axes[1],
        y_mm=part.place_mm[1],
    )  # fmt: skip


def rows(found: ProgramComparison) -> Iterator[tuple[str, str, str]]:
    """Yield name and both values of each figure, as a person reads them; names are Texts."""
    one, other = found.figures
    yield Text("moves"), _count(one.moves), _count(other.moves)
    yield Text("rapids"), _count(one.rapids), _count(other.rapids)
    yield Text("arcs"), _count(one.arcs), _count(other.arcs)
    yield Text("cut length"), _mm(one.cut_length_mm), _mm(other.cut_length_mm)
    yield Text("rapid length"), _mm(one.rapid_length_mm), _mm(other.rapid_length_mm)
    if found.times_s:
        yield Text("time"), duration_text(found.times_s[0]), duration_text(found.times_s[1])
    yield Text("tools"), _tools(one), _tools(other)
    for axis, name in enumerate("XYZ"):
        yield name, _range(one.box_mm[axis], "mm"), _range(other.box_mm[axis], "mm")
    yield Text("feed"), _range(one.feed_mm_min, "mm/min"), _range(other.feed_mm_min, "mm/min")
    yield Text("spindle speed"), _range(one.spindle_rpm, "rpm"), _range(other.spindle_rpm, "rpm")
    here, there = found.paths.first, found.paths.second
    yield Text("cut only here"), _mm(here.length_mm(True, False)), _mm(there.length_mm(True, False))
    yield Text("rapid only here"), _mm(here.length_mm(False, False)), _mm(there.length_mm(False, False))
    if (part := found.part) is not None:
        yield Text("removed only here"), _cm3(part.only_first_mm3), _cm3(part.only_second_mm3)
        yield from ring_rows(part.rings)


def _count(number: int) -> str:
    return f"{number:,}".replace(",", " ")


def _mm(length_mm: float) -> str:
    return f"{length_mm:.2f} mm"


def _cm3(volume_mm3: float) -> str:
    return f"{volume_mm3 / 1000:.3f} cm³"


def _tools(figures: PathFigures) -> str:
    return ", ".join(f"T{tool}" for tool in figures.tools) or "-"


def _range(found: Range | None, unit: str) -> str:
    if found is None:
        return "-"
    low, high = (f"{round(value, 3):g}" for value in found)
    return f"{low} {unit}" if low == high else f"{low} … {high} {unit}"


def compared_sections(found: ProgramComparison) -> ComparedSections | None:
    """Return what a picture shows of the parts of two lathe programs."""
    if found.turned is None or found.part is None:
        return None
    one, other = found.turned
    volumes_mm3 = found.part.only_first_mm3, found.part.only_second_mm3
    return ComparedSections(one.stock, one.section, other.section, found.part.rings, volumes_mm3)


def report_of(found: ProgramComparison) -> dict[str, Any]:
    """Return the comparison as plain data for JSON; lines are from 1, 0 for the end of a program."""
    paths = found.paths
    worst, parting = paths.deviation, paths.parting
    return {
        "same": paths.same,
        "same_places": paths.same_places,
        "tolerance_mm": found.same_mm,
        "verdict": str(found.verdict),
        "first_difference": {
            "path": found.lines(parting.path),
            "feed": found.lines(parting.feed),
            "mode": found.lines(parting.mode),
        },
        "deviation": asdict(worst) if worst else None,
        "programs": [
            {
                "name": name,
                **asdict(figures),
                "time_s": found.times_s[number] if found.times_s else None,
                "cut_only_here_mm": judged.length_mm(True, False),
                "rapid_only_here_mm": judged.length_mm(False, False),
                "cut_common_mm": judged.length_mm(True, True),
            }
            for number, (name, figures, judged) in enumerate(
                zip(found.names, found.figures, (paths.first, paths.second), strict=True)
            )
        ],
        "part": asdict(found.part) if found.part else None,
        "bars": list(found.bars) if found.bars else None,
    }
