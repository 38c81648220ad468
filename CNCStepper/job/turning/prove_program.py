# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a lathe program that was not made just now.

Without a job bar and tools come from whoever asks, and no profile is wanted; with one it is one of the job's programs,
on the part that those before it have cut.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from CNCStepper.errors import JobError, Text
from CNCStepper.gcode.dialects import dialect as dialect_named
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.lathe.diameter_mode import x_is
from CNCStepper.job.prove import Proof, prove, with_findings
from CNCStepper.job.turning.make_turning import TurnedProgram, in_part, is_split_turning, make_turning, placement_of
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.report import TurnedVerdict, judge_turning, setup_of
from CNCStepper.job.turning.turning_job import TurningJob, load_turning_job
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.machine.tools.turning_tool_text import EVERY_NUMBER
from CNCStepper.simulation.turning.half_section import bar
from CNCStepper.simulation.turning.obstacles import chuck_region
from CNCStepper.simulation.turning.swept_outline import Moves, moves_of
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turning_checks import TurningSetup
from CNCStepper.state import Start, ToolEntry
from CNCStepper.toolpath import Toolpath

CHUCK_SHARE = 2.0  # diameter of the chuck where it is not known, by that of the bar


@dataclass(frozen=True)
class TurnedBar:
    """Raw stock in a chuck, mm: its length from the chuck's face to z = 0, face_mm beyond that; 0 for a solid bar."""

    diameter_mm: float
    length_mm: float
    bore_mm: float = 0.0
    face_mm: float = 0.0


def prove_turned(
    text: str,
    machine: Machine,
    stock: TurnedBar,
    tools: Mapping[int, TurningTool],
    *,
    file: str = "",
    dialect: str = "",
    start: Start | None = None,
) -> tuple[Proof, TurnedVerdict]:
    """Return the proof of a lathe program's text, with the findings about its part, and the verdict on that part.

    tools: by number; that of EVERY_NUMBER stands for the others. Those of a lathe in the start's tool table count too.
    The work zero is on the axis, at the finished end face. Raises ProgramError for a text that cannot be read.
    """
    language = dialect_named(machine.language(dialect))
    proof = prove(text, machine, file=file, dialect=dialect, start=start)
    moves = moves_of(proof.toolpath, chuck_at_minus_z=language.z_sign > 0)
    sections = sections_of(moves, {**(tools_of_table(start.tools) if start else {}), **tools})
    given = x_is(text, language.name)
    setup = TurningSetup(
        bar(stock.diameter_mm, stock.length_mm, stock.face_mm, stock.bore_mm),
        sections,
        {"chuck": chuck_region(stock.length_mm, CHUCK_SHARE * stock.diameter_mm)},
        x_factor=2.0 if given == "diameter" else 1.0,
        file=file,
    )
    return _joined(proof, judge_turning(moves, setup, given))


def sections_of(moves: Moves, tools: Mapping[int, TurningTool]) -> dict[int, ToolSection]:
    """Return the sections of the tools that moves use; that of EVERY_NUMBER stands for those that are not known."""
    usual = tools.get(EVERY_NUMBER)
    used = {number: tools.get(number, usual) for number in set(moves.tool.tolist())}
    return {number: ToolSection.of(tool) for number, tool in used.items() if tool is not None}


def prove_text_of_job(
    text: str,
    job_path: Path,
    machine: Machine | None = None,
    *,
    part: int | None = None,
    file: str = "",
    dialect: str = "",
    start: Start | None = None,
) -> tuple[Proof, TurnedVerdict]:
    """Return the same of a program of a lathe's job file, behind those that cut before it.

    machine: in place of the job's own. part: which of the job's programs the text is, from 1; None finds the one that
    makes the same moves. Raises JobError and ProgramError.
    """
    job, own = load_turning_job(job_path)
    machine = machine or own
    if is_split_turning(job, machine):
        programs = _as_part(text, job, machine, part, dialect)
        *_, last = prove_turning(job, machine, programs, Path(), file, start, dialect)
        return last.proof, last.verdict
    require_no_part(part)
    if "T" not in dialect_named(machine.language(dialect)).letters:
        start = replace(start or Start(), tool=job.operation[0].tool)
    proof = prove(text, machine, file=file, dialect=dialect, start=start)
    path = in_part(proof.toolpath, placement_of(job, machine))
    return _joined(proof, judge_turning(moves_of(path), setup_of(job, file), job.x_is))


def require_no_part(part: int | None) -> None:
    """Raise JobError for a part of a job that has one program."""
    if part is not None:
        what, advice = "the job has one program for all its tools", "leave --part out"
        raise JobError("turning-part", what, value=str(part), limit="1", advice=advice)


def _as_part(text: str, job: TurningJob, machine: Machine, part: int | None, dialect: str) -> list[TurnedProgram]:
    """Return the job's programs up to one, this text in place of that; raises JobError where it is none of them."""
    made = make_turning(job, machine)
    part = part_number([text], made, machine, part, dialect)
    return [*made[: part - 1], replace(made[part - 1], program=text)]


def part_number(
    texts: Sequence[str], made: Sequence[TurnedProgram], machine: Machine, part: int | None, dialect: str
) -> int:
    """Return which of a job's programs is meant, from 1: that part, or the one that makes the moves of a text.

    Raises JobError for none.
    """
    for text in texts if part is None else ():
        moves = interpret(text, Start(), dialect=machine.language(dialect))
        same = [one.number for one in made if same_moves(interpret(one.program, Start(), machine.language()), moves)]
        if len(same) == 1:
            return same[0]
    if part is None or part > len(made):
        what = Text("the job has {count} programs, one a tool, and this is not one of them", count=len(made))
        names = ", ".join(f"{one.number} = tool {one.tool}" for one in made)
        advice = "make them with `cncstepper run`, or check it with --part"
        raise JobError("turning-part", what, value=str(part or ""), limit=names, advice=advice)
    return part


def same_moves(one: Toolpath, other: Toolpath) -> bool:
    """Return whether two programs make the same moves, whatever their lines look like."""
    first, second = one.table(), other.table()
    return len(first) == len(second) and all(
        np.array_equal(getattr(first, name), getattr(second, name), equal_nan=name != "kind")
        for name in ("kind", "end", "feed")
    )


def tools_of_table(entries: Mapping[int, ToolEntry]) -> dict[int, TurningTool]:
    """Return a LinuxCNC tool table's lathe tools: those with orientation and angles; the diameter is the nose's."""
    return {
        number: TurningTool(
            number=number,
            orientation=entry.orientation,
            front_deg=entry.front_deg,
            back_deg=entry.back_deg,
            nose_radius_mm=entry.diameter_mm / 2,
        )
        for number, entry in entries.items()
        if entry.orientation and not math.isnan(entry.diameter_mm) and entry.front_deg != entry.back_deg
    }


def _joined(proof: Proof, verdict: TurnedVerdict) -> tuple[Proof, TurnedVerdict]:
    told = replace(proof, report={**proof.report, **verdict.report()})
    return with_findings(told, verdict.findings), verdict
