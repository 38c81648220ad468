# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the start state: the machine's state before the first line."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import wraps
from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.common.options import FilePath, NumbersType, read_program
from CNCStepper.cli.common.path_types import InputFolder
from CNCStepper.state import Start

search_option = click.option(
    "--search",
    multiple=True,
    type=InputFolder(),
    help="A folder of subroutines, looked through after the program's own; may be given more than once.",
)
_OPTIONS = (
    click.option("--work-zero", type=NumbersType(), help="Where the work zero lies, in machine coordinates."),
    click.option(
        "--position",
        type=NumbersType(),
        help="Where the machine stands at first, in machine coordinates; without a work zero, as seen from that.",
    ),
    click.option(
        "--parameters",
        type=FilePath,
        help="LinuxCNC's parameter file (.var) in mm: work offsets, G92, the places of G28 and G30.",
    ),
    click.option(
        "--tool-table", type=FilePath, help="A LinuxCNC tool table in mm: lengths for G43, diameters for G41 and G42."
    ),
    search_option,
)


@dataclass(frozen=True)
class StartOptions:
    """The start state on the command line; every option may be left out."""

    work_zero: tuple[float, float, float] | None = None
    position: tuple[float, float, float] | None = None
    parameters: Path | None = None
    tool_table: Path | None = None
    search: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return self != StartOptions()

    def start(self) -> Start | None:
        """Return the start state of the options, None where none is given."""
        return self.on(Start()) if self else None

    def on(self, start: Start) -> Start:
        """Return `start` with the options that are given; raises ProgramError at a wrong line of a file."""
        if self.parameters:
            from CNCStepper.gcode.interpreter.state.parameters import read_parameters, with_parameters

            start = with_parameters(start, read_parameters(read_program(self.parameters), str(self.parameters)))
        if self.work_zero:
            offsets = start.work_offsets_mm | {start.work_system: self.work_zero}
            start = replace(start, work_offsets_mm=offsets, zero_known=True)
        if self.position:
            start = replace(start, position_mm=self.position)
        if self.tool_table:
            from CNCStepper.gcode.interpreter.functions.tools import read_tool_table

            tools = read_tool_table(read_program(self.tool_table), start.machine_unit_mm, str(self.tool_table))
            start = replace(start, tools=tools)
        return replace(start, search=self.search)


def start_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options of the start state; the function gets their values as `given`."""

    @wraps(function)
    def command(
        *arguments: Any,
        work_zero: tuple[float, float, float] | None,
        position: tuple[float, float, float] | None,
        parameters: Path | None,
        tool_table: Path | None,
        search: tuple[str, ...],
        **more: Any,
    ) -> Any:
        return function(*arguments, given=StartOptions(work_zero, position, parameters, tool_table, search), **more)

    for option in reversed(_OPTIONS):
        command = option(command)
    return command
