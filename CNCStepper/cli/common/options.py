# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options and arguments that several verbs have, and their parsers.

With which options a job was made: its journal keeps them, so that its restart can be offered whole.

{"options": {"--machine": ["table-a"], "--job": ["/home/ana/part.toml"]},      as `cncstepper restart` takes them
 "files": {"/home/ana/part.toml": "9f86d0..."}}                                their fingerprints as they were
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from CNCStepper.cli.common.path_types import InputPath, as_typed
from CNCStepper.errors import CNCStepperError, ProgramError, Text
from CNCStepper.gcode.dialects import dialect as dialect_called
from CNCStepper.gcode.dialects import dialect_names
from CNCStepper.input_file import read_input
from CNCStepper.machine.profile import Machine, load_machine, profile_names
from CNCStepper.machine.tools.tool import tool_from_text
from CNCStepper.quantities import QUANTITIES, Bounds, shown

if TYPE_CHECKING:
    from CNCStepper.simulation.stock import Stock

MOST_PROGRAM_BYTES = 400_000_000  # of a program that is held whole: `check` and `time` read files of any length
MOST = QUANTITIES["factor"].most  # beyond it no length, angle or factor makes sense


ABOUT_0 = 1e-6  # a bound so little below 0 lets 0 in


class NumberType(click.ParamType):
    """One number with a decimal point, above a bound where there is one, or within those of a kind of quantity."""

    name = "NUMBER"

    def __init__(self, above: float = -MOST, kind: str = ""):
        self._above = above
        self._bounds = Bounds(kind) if kind else None

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            number = float(value)
        except ValueError:
            number = float("nan")
        if self._bounds and not self._bounds.allows(number):
            self.fail(
                Text("{value} is not a number from {words}", value=shown(value), words=self._bounds.words), param, ctx
            )
        if not self._above < number < MOST:
            self.fail(self._refusal(value), param, ctx)
        return number

    def _refusal(self, value: Any) -> Text:
        if -ABOUT_0 < self._above < 0.0:
            return Text("'{value}' is not a number from 0 on with a decimal point, such as 1.5", value=value)
        if self._above > -MOST:
            return Text(
                "'{value}' is not a number above {least:g} with a decimal point, such as 1.5",
                value=value, least=self._above,
            )  # fmt: skip
        return Text("'{value}' is not a number with a decimal point, such as 1.5", value=value)


class _PlaceType(click.ParamType):
    """Numbers with decimal points, joined by commas; `refusal` has the reason for a wrong one."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, ...]:
        if isinstance(value, tuple):
            return value
        try:
            numbers = tuple(float(part) for part in value.split(","))
        except ValueError:
            numbers = ()
        if refusal := self.refusal(numbers):
            self.fail(Text("'{value}' {refusal}", value=value, refusal=refusal), param, ctx)
        return numbers

    def refusal(self, numbers: tuple[float, ...]) -> str:
        """Return why these numbers (none: the text holds no numbers) are refused; "" where they are allowed."""
        raise NotImplementedError


class NumbersType(_PlaceType):
    """X,Y,Z in mm with decimal points."""

    name = "X,Y,Z"

    def __init__(self, kind: str = ""):
        self._low, self._high = (Bounds(kind).low, Bounds(kind).high) if kind else (-MOST, MOST)

    def refusal(self, numbers: tuple[float, ...]) -> str:
        """Return why these are not three numbers within the bounds."""
        if len(numbers) == 3 and all(self._low <= number <= self._high for number in numbers):
            return ""
        if self._low > 0:
            return Text("is not three lengths above 0 in mm with decimal points, such as 100,70,20")
        return Text("is not three numbers in mm with decimal points, such as 100,70,20")


class PointType(_PlaceType):
    """X,Y or X,Y,Z in mm with decimal points."""

    name = "X,Y[,Z]"

    def refusal(self, numbers: tuple[float, ...]) -> str:
        """Return why these are not two or three numbers."""
        if len(numbers) in (2, 3) and all(-MOST < number < MOST for number in numbers):
            return ""
        return Text("is no point: two or three numbers in mm, such as 12.5,40 or 12.5,40,-2")


class Named(click.ParamType):
    """A word that one of our own readers understands; its refusal is a usage error (exit 2)."""

    def __init__(self, name: str, reader: Any):
        self.name = name
        self._reader = reader

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if not isinstance(value, str):
            return value
        if ctx is not None and param is not None:
            ctx.meta[as_typed(param)] = value
        try:
            return self._reader(value)
        except CNCStepperError as error:
            self.fail(Text("{error}", error=error), param, ctx)


ToolType = Named("SHAPE:MM", tool_from_text)
DialectType = Named("DIALECT", lambda name: dialect_called(name).name)
FilePath = InputPath()

program_argument = click.argument("program", type=FilePath)


def _dialect_option(default: str) -> Any:
    text = f"How the program is to be read: {', '.join(dialect_names())}. [default: {default}]"
    return click.option("--dialect", type=DialectType, help=text)


dialect_option = _dialect_option("as the machine does; without one grbl")
linuxcnc_option = _dialect_option("linuxcnc")
job_option = click.option(
    "--job", "job_path", type=FilePath, help="Take stock, tools, clamps and the shapes wanted from this job file."
)


def check_stock(stock: Any, tool: Any, job_path: Path | None, required: bool = False) -> None:
    """Refuse options that describe the stock in part or twice; raises a usage error."""
    if job_path and (stock or tool):
        raise click.UsageError(Text("--job says the stock and the tools: leave --stock and --tool out"))
    if tool and not stock:
        raise click.UsageError(Text("--tool goes with --stock"))
    if required and not job_path and not (stock and tool):
        raise click.UsageError(Text("give --stock and --tool, or --job"))


def machine_option(required: bool) -> Any:
    """Return the option that names a machine profile."""
    text = "A profile's name (table-a) or its TOML file."
    return click.option("--machine", type=Named("PROFILE", load_machine), required=required, help=text)


def stock_options(required: bool) -> Any:
    """Return the decorator that adds --stock, --origin and --tool."""

    def add(function: Any) -> Any:
        for option in (
            click.option(
                "--tool",
                type=ToolType,
                required=required,
                help="The cutter, for example flat:6 or ball:2.",
            ),
            click.option(
                "--origin",
                type=click.Choice(["top-centre", "top-left-front"]),
                default="top-centre",
                show_default=True,
                help="Where on the stock the work zero lies.",
            ),
            click.option("--stock", type=NumbersType(kind="length"), required=required, help="The stock's size in mm."),
        ):
            function = option(function)
        return function

    return add


def stock_of(size_mm: tuple[float, float, float] | None, origin: str) -> Stock | None:
    """Return the stock that the options name, or None."""
    if not size_mm:
        return None
    from CNCStepper.simulation.stock import Stock  # it loads shapely

    return Stock(size_mm, origin)


def dialect_name(dialect: str | None, machine: Machine | None) -> str:
    """Return the dialect asked for, else the machine's own, else grbl."""
    return machine.language(dialect or "") if machine else dialect or "grbl"


def read_program(path: Path) -> str:
    """Return the text of a program file: UTF-8 (a byte-order mark is dropped), else Latin-1."""
    from CNCStepper.gcode.syntax.text_format import decoded

    return decoded(program_bytes(path))[0]


def program_bytes(path: Path) -> bytes:
    """Return the content of a program file, or of a pipe that the shell names; raises ProgramError."""
    return read_input(path, MOST_PROGRAM_BYTES, streams=True, refusal=ProgramError)


KEPT = {
    *("machine", "dialect", "job_path", "part", "stock", "origin", "tool"),
    *("work_zero", "position", "parameters", "tool_table", "search", "overlap", "height"),
}
OF_STOCK = ("--stock", "--origin", "--tool")
OF_JOB = ("--job", "--part")
ReproduceOptions = Mapping[str, Any]


def reproduce_options() -> ReproduceOptions:
    """Return those of the options of the command that runs now which a restart takes too."""
    context = click.get_current_context()
    given = (
        param
        for param in context.command.params
        if param.name in KEPT and context.get_parameter_source(param.name) is ParameterSource.COMMANDLINE
    )
    return plain_options({param.opts[0]: _values(param, context) for param in given})


def plain_options(options: Mapping[str, Iterable[Any]]) -> ReproduceOptions:
    """Return options with their values as plain data; paths are made whole, their files fingerprinted."""
    values = [value for several in options.values() for value in several]
    files = [value.resolve() for value in values if isinstance(value, Path) and value.is_file()]
    return {
        "options": {name: [_text(value) for value in several] for name, several in options.items()},
        "files": {str(file): digest_of_file(file) for file in files},
    }


def merged(proven: ReproduceOptions, own: ReproduceOptions) -> ReproduceOptions:
    """Return the options of a job: those of its proof and those of its own command line, which win."""
    if not proven:
        return own
    said = own["options"]
    instead = OF_STOCK if "--job" in said else OF_JOB if "--stock" in said else ()
    options = {name: values for name, values in proven["options"].items() if name not in instead} | said
    return {"options": options, "files": proven["files"] | own["files"]}


def digest_of_file(file: Path) -> str:
    """Return the SHA-256 of a file's bytes."""
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _values(param: click.Parameter, context: click.Context) -> Iterable[Any]:
    assert param.name
    value = context.meta.get(as_typed(param), context.params[param.name])
    if param.name == "machine" and value not in profile_names():
        value = Path(value)
    if param.name == "search":
        return [Path(folder) for folder in value]
    return [value]


def _text(value: Any) -> str:
    if isinstance(value, Path):
        return str(value.resolve())
    if isinstance(value, tuple):
        return ",".join(map(_text, value))
    return f"{value:.10g}" if isinstance(value, float) else str(value)
