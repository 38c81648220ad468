# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a compared lathe program is cut with: bar, tools, where its zero lies on the part, and what was cut before it.

A program with one is read onto the part: X the radius, Z = 0 the finished end face, Z < 0 towards the chuck.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce

from CNCStepper.cycles.turning.turned_coordinates import Placement
from CNCStepper.errors import Text
from CNCStepper.gcode.dialects import dialect as dialect_named
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.turning.make_turning import TurnedProgram, in_part, is_split_turning, make_turning, placement_of
from CNCStepper.job.turning.prove_program import TurnedBar, part_number, require_no_part, sections_of, tools_of_table
from CNCStepper.job.turning.prove_turning import start_of
from CNCStepper.job.turning.report import setup_of
from CNCStepper.job.turning.turning_job import TurningJob
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.simulation.prior_programs import followed
from CNCStepper.simulation.turning.half_section import HalfSection, bar
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_part import TurnedPart, turned_part
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath


@dataclass(frozen=True)
class LatheSetup:
    """See the module. sections: of a job's tools, by number. tools: those that stand for all other numbers.

    before: the moves on the part of the programs that cut it earlier, None for none.
    """

    stock: HalfSection
    placement: Placement
    sections: Mapping[int, ToolSection] = field(default_factory=dict)
    tools: Mapping[int, TurningTool] = field(default_factory=dict)
    before: Toolpath | None = None

    def part(self, on_part: Toolpath, stock: HalfSection | None = None) -> TurnedPart:
        """Return what a program's moves on the part leave of the bar, or of another one."""
        moves = moves_of(followed(self.before, on_part) if self.before else on_part)
        return turned_part(moves, stock or self.stock, {**sections_of(moves, self.tools), **self.sections})


def setup_of_bar(
    stock: TurnedBar, tools: Mapping[int, TurningTool], machine: Machine, dialect: str, start: Start | None
) -> LatheSetup:
    """Return what cuts programs that no job has made; their zero is on the axis, at the finished end face."""
    raw = bar(stock.diameter_mm, stock.length_mm, stock.face_mm, stock.bore_mm)
    placement = Placement(z_sign=dialect_named(machine.language(dialect)).z_sign)
    return LatheSetup(raw, placement, tools={**(tools_of_table(start.tools) if start else {}), **tools})


def setup_of_job(
    job: TurningJob, machine: Machine, texts: Sequence[str], part: int | None, start: Start | None, dialect: str = ""
) -> tuple[LatheSetup, Start | None]:
    """Return what cuts a program of a job, and in which state it begins.

    texts: of which the first one that makes the moves of one of the job's programs says which that is, where `part` is
    None. Raises JobError where none of them does.
    """
    setup = setup_of(job)
    whole = LatheSetup(setup.stock, placement_of(job, machine), setup.tools)
    if not is_split_turning(job, machine):
        require_no_part(part)
        names_tools = "T" in dialect_named(machine.language(dialect)).letters
        return whole, start if names_tools else replace(start or Start(), tool=job.operation[0].tool)
    made = make_turning(job, machine)
    number = part_number(texts, made, machine, part, dialect)
    earlier = [_on_part(one, job, machine, start) for one in made[: number - 1]]
    before = reduce(followed, earlier) if earlier else None
    return replace(whole, before=before), start_of(made[number - 1], machine, start)


def _on_part(program: TurnedProgram, job: TurningJob, machine: Machine, start: Start | None) -> Toolpath:
    moves = interpret(program.program, start_of(program, machine, start), machine.language())
    return in_part(moves, placement_of(job, machine))


def bar_text(stock: HalfSection) -> Text:
    """Return a bar's sizes in words."""
    z_low, inner, z_high, outer = stock.region.bounds
    sizes = {"diameter": 2 * outer, "length": z_high - z_low}
    if inner:
        return Text("ø{diameter:g} × {length:g} mm with a bore of ø{bore:g} mm", **sizes, bore=2 * inner)
    return Text("ø{diameter:g} × {length:g} mm", **sizes)
