# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two programs compared by their interpreted moves, with their figures and the words for both.

    text ──► interpret ──► tool path ──► compare_paths ──► alone, common, first lines that differ, deviation
                               └──► figures, time, part            of each, side by side

Comments, numbers of lines, units and modal words make no difference: only the motion, its feed, tool and speed do.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from CNCStepper.errors import Text
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.comparison.part_difference import CutPart, PartDifference, part_difference
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.interpolation.dda_stream import times_and_whole_s
from CNCStepper.motion.planner.plan import begun
from CNCStepper.quantities import duration_text
from CNCStepper.simulation.comparison.path_figures import PathFigures, Range, figures_of
from CNCStepper.simulation.comparison.path_overlay import PathComparison, compare_paths
from CNCStepper.state import Start
from CNCStepper.tolerances import SAME_PATH_MM
from CNCStepper.toolpath import Toolpath

Share = Callable[[float], None]
PartOf = Callable[["ComparedProgram", Toolpath], CutPart]
READ, COMPARED, TIMED = 0.35, 0.75, 0.9  # shares of the work by then


@dataclass(frozen=True)
class ComparedProgram:
    """A program to compare. name: of its file or object."""

    name: str
    text: str
    dialect: str = "grbl"
    start: Start | None = None


@dataclass(frozen=True)
class ProgramComparison:
    """Two programs; paths, figures and times_s of the first and the second. part: None without stock and tools."""

    names: tuple[str, str]
    same_mm: float
    toolpaths: tuple[Toolpath, Toolpath]
    paths: PathComparison
    figures: tuple[PathFigures, PathFigures]
    times_s: tuple[float, float] | None
    part: PartDifference | None

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

    machine: its planner gives the times. same_mm: how far paths may be apart that are one. part_of: cuts the stock by a
    program's path. share: called with the share that is done, from 0 to 1.
    """
    one = _read(first, lambda done: share(READ / 2 * done))
    other = _read(second, lambda done: share(READ / 2 * (1 + done)))
    paths = compare_paths(one, other, same_mm, lambda done: share(READ + (COMPARED - READ) * done))
    times_s = (_time_s(one, machine), _time_s(other, machine)) if machine else None
    share(TIMED)
    part = part_difference(part_of(first, one), part_of(second, other)) if part_of else None
    figures = figures_of(one), figures_of(other)
    share(1.0)
    return ProgramComparison((first.name, second.name), same_mm, (one, other), paths, figures, times_s, part)


def _read(program: ComparedProgram, share: Share) -> Toolpath:
    return interpret(program.text, program.start, program.dialect, program.name, share)


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
    if (part := found.part) is not None:
        yield _part_sentence(part)


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
    }
