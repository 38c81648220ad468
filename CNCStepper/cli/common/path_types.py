# SPDX-License-Identifier: LGPL-2.1-or-later
"""Types of options and arguments that name files and folders: by them a verb lists its inputs and outputs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import click

from CNCStepper.errors import Text
from CNCStepper.input_file import STREAM_NAME, input_kind
from CNCStepper.output_files import Output, in_folder
from CNCStepper.safe_text import printable

TYPED = "CNCStepper.as_typed."  # in a context's meta, and the parameter's name


class InputPath(click.Path):
    """A file that is read: a regular one, or a pipe that the shell itself names ("/dev/stdin", "/dev/fd/63")."""

    def __init__(self, exists: bool = True):
        super().__init__(exists=exists, dir_okay=False, path_type=Path)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the path; a pipe without a writer would let the command wait for ever, a device never ends."""
        path = super().convert(value, param, ctx)
        if not STREAM_NAME.fullmatch(str(path)) and (kind := _kind_of(path)):
            self.fail(Text("'{path}' is {kind}, not a file", path=printable(str(path)), kind=kind), param, ctx)
        return path


def _kind_of(path: Any) -> str:
    try:
        return input_kind(path)
    except OSError:  # it need not be there, or cannot be looked at: who opens it says so
        return ""


class InputFolder(click.Path):
    """A folder of subroutines that are read."""

    def __init__(self) -> None:
        super().__init__(exists=True, file_okay=False)


class OutputPath(click.Path):
    """A file that is written. kind: one of `output_files.MARKS`, "" for what carries no mark."""

    def __init__(self, kind: str):
        super().__init__(dir_okay=False, path_type=Path)
        self.kind = kind

    def outputs(self, path: Path, option: str, context: click.Context) -> Iterator[Output]:
        """Yield the files that are written under that path."""
        yield Output(path, option, self.kind)


class OutputFolder(OutputPath):
    """A folder into which files are written.

    names: returns the regular expressions of their whole names, each with its kind, of a command's parameters.
    """

    def __init__(self, names: Callable[[Mapping[str, Any]], Mapping[str, str]]):
        super().__init__("")
        self.file_okay, self.dir_okay, self.name = False, True, "directory"
        self._names = names

    def outputs(self, path: Path, option: str, context: click.Context) -> Iterator[Output]:
        """Yield the files in the folder whose place a new one would take."""
        for names, kind in self._names(context.params).items():
            for file in in_folder(path, names):
                yield Output(file, option, kind)


def as_typed(param: click.Parameter) -> str:
    """Return by what a context's `meta` knows the word that was read into the value of a parameter."""
    return f"{TYPED}{param.name}"
