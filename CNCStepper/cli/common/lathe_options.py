# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of a lathe program's stock and tools, and how X is given."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import MOST, Named, NumberType
from CNCStepper.cli.common.program_options import ProgramOptions
from CNCStepper.cli.job_file import is_turning_file
from CNCStepper.errors import Text
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.job.comparison.lathe_setup import LatheSetup
    from CNCStepper.job.prove import Proof
    from CNCStepper.job.turning.prove_program import TurnedBar
    from CNCStepper.job.turning.report import TurnedVerdict
    from CNCStepper.machine.tools.turning_tool import TurningTool
    from CNCStepper.state import Start

HEAD_CHARACTERS = 65_536  # of a program, in which G7 is looked for
X_WORDS = {
    "diameter": Text("X is a diameter"),
    "radius": Text("X is a radius"),
    "both": Text("X is a diameter in some lines and a radius in others; findings give radii"),
}


class _Bar(click.ParamType):
    """DIAMETERxLENGTH or DIAMETERxLENGTHxBORE in mm."""

    name = "DxL[xBORE]"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, ...]:
        if isinstance(value, tuple):
            return value
        try:
            sizes = tuple(float(part) for part in value.lower().removeprefix("bar:").split("x"))
        except ValueError:
            sizes = ()
        if len(sizes) not in (2, 3) or not all(0 < size < MOST for size in sizes) or sizes[2:] >= sizes[:1]:
            self.fail(
                Text("'{value}' is no bar: write its diameter and length in mm, such as 55x170", value=value),
                param,
                ctx,
            )
        return sizes


def _turning_tool(text: str) -> TurningTool:
    from CNCStepper.machine.tools.turning_tool_text import turning_tool_from_text

    return turning_tool_from_text(text)


@dataclass(frozen=True)
class LatheOptions:
    """The command line's values; bar_mm: diameter, length and, of a tube, bore."""

    bar_mm: tuple[float, ...] | None
    face_mm: float
    tools: tuple[TurningTool, ...]

    def turns(self, given: ProgramOptions) -> bool:
        """Return whether a lathe program is asked about; refuses options that do not go together."""
        of_job = given.job_path is not None and is_turning_file(given.job_path)
        if self.bar_mm and (given.stock_mm or given.job_path):
            raise click.UsageError(Text("--bar is the stock of a lathe: leave --stock and --job out"))
        if (self.tools or self.face_mm) and not self.bar_mm:
            raise click.UsageError(Text("--turning-tool and --face go with --bar"))
        return bool(self.bar_mm) or of_job

    def prove(
        self,
        text: str,
        given: ProgramOptions,
        machine: Machine,
        file: str,
        dialect: str,
        start: Start | None,
        part: int | None = None,
    ) -> tuple[Proof, TurnedVerdict]:
        """Return the proof of a lathe program and the verdict on its part; part: which program of the job it is."""
        from CNCStepper.job.turning.prove_program import prove_text_of_job, prove_turned

        words: dict[str, Any] = {"file": file, "dialect": dialect, "start": start}
        if self.bar_mm is None:
            assert given.job_path is not None  # turns() has looked
            return prove_text_of_job(text, given.job_path, machine, part=part, **words)
        if part is not None:
            raise click.UsageError(Text("--part goes with --job"))
        return prove_turned(text, machine, self._bar(), {tool.number: tool for tool in self.tools}, **words)

    def setup(
        self,
        texts: Sequence[str],
        given: ProgramOptions,
        machine: Machine,
        dialect: str,
        start: Start | None,
        part: int | None,
    ) -> tuple[LatheSetup, Start | None]:
        """Return what cuts compared lathe programs, and in which state they begin; part: which of the job's."""
        from CNCStepper.job.comparison.lathe_setup import setup_of_bar, setup_of_job
        from CNCStepper.job.turning.turning_job import load_turning_job

        if self.bar_mm is None:
            assert given.job_path is not None  # turns() has looked
            return setup_of_job(load_turning_job(given.job_path)[0], machine, texts, part, start, dialect)
        if part is not None:
            raise click.UsageError(Text("--part goes with --job"))
        return setup_of_bar(self._bar(), {tool.number: tool for tool in self.tools}, machine, dialect, start), start

    def _bar(self) -> TurnedBar:
        from CNCStepper.job.turning.prove_program import TurnedBar

        assert self.bar_mm is not None
        diameter_mm, length_mm, bore_mm = (*self.bar_mm, 0.0)[:3]
        return TurnedBar(diameter_mm, length_mm, bore_mm, self.face_mm)


def lathe_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options; the function gets their values as `lathe`."""

    @click.option("--bar", type=_Bar(), help="A lathe's stock: diameter x length from the chuck's face to z = 0, mm.")
    @click.option(
        "--face", type=NumberType(), default=0.0, show_default=True, help="How far the raw end lies over z = 0, mm."
    )
    @click.option(
        "--turning-tool",
        "turning_tools",
        multiple=True,
        type=Named("[N=]TOOL", _turning_tool),
        help="A lathe's tool: CNMG120408, boring:CCMT060204, parting:3, drill:10; 2=drill:10 is tool 2.",
    )
    @wraps(function)
    def command(
        *arguments: Any,
        bar: tuple[float, ...] | None,
        face: float,
        turning_tools: tuple[TurningTool, ...],
        **more: Any,
    ) -> Any:
        return function(*arguments, lathe=LatheOptions(bar, face, turning_tools), **more)

    return command


def show_x(program: Path, text: str, dialect: str, machine: Machine | None, err: bool = False) -> None:
    """Say how a lathe program gives X; nothing is said of another machine's program without G7 and G8."""
    from CNCStepper.gcode.lathe.diameter_mode import is_lathe_program, x_is

    is_lathe = machine is not None and "y" not in machine.own_axes
    if is_lathe or is_lathe_program(text, dialect):
        show_text("{program}: {words}", err=err, program=program, words=X_WORDS[x_is(text, dialect)])


def show_x_of_file(program: Path, dialect: str, machine: Machine | None, err: bool = False) -> None:
    """Say the same of a program's file by its first lines; a pipe can be read only once, and is left alone."""
    if program.is_file():
        with program.open("rb") as file:
            text = file.read(HEAD_CHARACTERS).decode("latin-1")
        show_x(program, text.rpartition("\n")[0] or text, dialect, machine, err)
