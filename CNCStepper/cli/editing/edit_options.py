# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared parts of the verbs that change a program: options, check, difference, saving."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.findings_output import save, show_findings
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.lathe_options import show_x
from CNCStepper.cli.common.options import (
    check_stock,
    dialect_name,
    dialect_option,
    machine_option,
    program_argument,
    program_bytes,
    stock_of,
    stock_options,
)
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.start_state_options import StartOptions, start_options
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.gcode.edit.edit_result import Edited
    from CNCStepper.gcode.syntax.text_format import FileForm
    from CNCStepper.machine.profile import Machine
    from CNCStepper.machine.tools.tool import Tool
    from CNCStepper.state import Start

MOST_SHOWN = 200  # lines of a difference, where nobody asked for all


@dataclass(frozen=True)
class Opened:
    """A program that is to be changed, how it is read, and against what its new text is checked."""

    path: Path
    text: str
    form: FileForm
    dialect: str
    start: Start | None
    machine: Machine | None
    stock: tuple[float, float, float] | None
    origin: str
    tool: Tool | None

    @property
    def reading(self) -> dict[str, Any]:
        """The arguments that every editing function takes."""
        return {"dialect": self.dialect, "start": self.start, "file": str(self.path)}

    def check(self, text: str) -> None:
        """End the command with status 1 where the new text has errors that the old one had not."""
        from CNCStepper.job.editing.edit_check import EditCheck

        judge = EditCheck(
            self.dialect, self.start, str(self.path), self.machine, stock_of(self.stock, self.origin), self.tool
        )
        errors = judge.new_errors(self.text, text)
        if errors:
            show_findings(errors)
            show_text("{path}: not changed; the new program would be refused", err=True, path=self.path)
            sys.exit(1)


def reading_options(function: Callable[..., None]) -> Callable[..., None]:
    """Add PROGRAM and how it is read and checked; the function gets an `Opened` first."""

    @program_argument
    @dialect_option
    @machine_option(required=False)
    @stock_options(required=False)
    @start_options
    @wraps(function)
    def command(
        program: Path,
        dialect: str | None,
        machine: Machine | None,
        stock: tuple[float, float, float] | None,
        origin: str,
        tool: Tool | None,
        given: StartOptions,
        **more: Any,
    ) -> None:
        from CNCStepper.gcode.syntax.text_format import decoded

        check_stock(stock, tool, None)
        text, form = decoded(program_bytes(program))
        start = given.start()
        opened = Opened(program, text, form, dialect_name(dialect, machine), start, machine, stock, origin, tool)
        show_x(program, text, opened.dialect, machine, err=True)
        function(opened, **more)

    return command


def editing_options(function: Callable[..., Edited]) -> Callable[..., None]:
    """Add what every edit has: how the program is read, and what becomes of the new one."""

    @click.option("-o", "--out", type=OutputPath("program"), help="Write the new program there.")
    @click.option("--in-place", is_flag=True, help="Write the new program over the old one.")
    @click.option("--diff/--no-diff", default=None, help="Show all that changes. [default: where nothing is written]")
    @wraps(function)
    def command(opened: Opened, out: Path | None, in_place: bool, diff: bool | None, **more: Any) -> None:
        if out and in_place:
            raise click.UsageError(Text("give either --out or --in-place"))
        edited = function(opened, **more)
        opened.check(edited.text)
        target = opened.path if in_place else out
        show(edited, opened.path, diff, target is None)
        if target:
            save(target, opened.form.encoded(edited.text))
        show_text("{where}; {changed}", err=target is None, where=_where(target, opened.path), changed=_changed(edited))

    return reading_options(command)


def _where(target: Path | None, read: Path) -> Text:
    """Return in words where the new program was written."""
    if target:
        return Text("{target}: written", target=target)
    return Text("{read}: not written; add --out FILE or --in-place", read=read)


def _changed(edited: Edited) -> Text:
    """Return in words how much an edit changed."""
    if edited.changes == 1:
        return Text("1 line changed")
    return Text("{changes} lines changed", changes=edited.changes) if edited.changes else Text("nothing changed")


def show(edited: Edited, path: Path, asked: bool | None, unsaved: bool) -> None:
    """Print the difference, all of it where it was asked for, its begin where nothing is written."""
    if asked is False or (asked is None and not unsaved):
        return
    lines = edited.diff(path.name).splitlines()
    shown = lines if asked else lines[:MOST_SHOWN]
    for line in shown:
        click.echo(line)
    if len(shown) < len(lines):
        show_text("... {lines} more lines; --diff shows all", err=True, lines=len(lines) - len(shown))
