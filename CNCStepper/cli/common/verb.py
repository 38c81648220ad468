# SPDX-License-Identifier: LGPL-2.1-or-later
"""The class of every verb: before it begins, all files that it is going to write are held against those that it reads.

A verb names its outputs by the type of the option, `OutputPath` or `OutputFolder`, and its inputs by `InputPath`, all
in path_types.py. The files that a job, a profile or a tool library names, and the subroutines that a program calls, are
inputs too.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.common.option_hints import add_conversion, add_option_hint
from CNCStepper.cli.common.path_types import InputFolder, InputPath, OutputPath, as_typed
from CNCStepper.errors import CNCStepperError, ProgramError, Text
from CNCStepper.output_files import Input, Output, check_outputs

OVERWRITE = "CNCStepper.overwrite"  # in a context's meta
LISTS = (".toml", ".json", ".fctl", ".fctb")  # files that name other files
SUBROUTINES = (".ngc", ".nc")
CALL = re.compile(r"(?i)o\s*<\s*([^<>]+?)\s*>\s*call")


class Verb(click.Command):
    """A command that checks its outputs before it begins; where it has some, it takes --overwrite."""

    def __init__(self, *arguments: Any, **words: Any):
        super().__init__(*arguments, **words)
        if any(isinstance(param.type, OutputPath) for param in self.params):
            self.params.append(_overwrite_option())

    def invoke(self, ctx: click.Context) -> Any:
        """Run it, unless an output would cost a file; raises OutputError."""
        outputs = [
            output
            for param, value in _given(ctx)
            if isinstance(param.type, OutputPath)
            for output in param.type.outputs(value, _spelled(param), ctx)
        ]
        _check(outputs, ctx)
        try:
            return super().invoke(ctx)
        except CNCStepperError as error:
            add_option_hint(error, ctx)
            if isinstance(error, ProgramError):
                add_conversion(error, ctx)
            raise


class Verbs(click.Group):
    """A group of verbs."""

    command_class = Verb


def check_further(outputs: Sequence[Output]) -> None:
    """Check outputs of the running verb whose names are known only when its inputs are read; raises OutputError."""
    _check(outputs, click.get_current_context())


def _check(outputs: Sequence[Output], context: click.Context) -> None:
    if outputs:
        check_outputs(outputs, _inputs(outputs, context), bool(context.meta.get(OVERWRITE)))


def _overwrite_option() -> click.Option:
    def remember(context: click.Context, param: click.Parameter, value: bool) -> None:
        context.meta[OVERWRITE] = value

    text = "Also replace files that CNCStepper did not make."
    return click.Option(["--overwrite"], is_flag=True, expose_value=False, callback=remember, help=text)


def _given(context: click.Context) -> Iterator[tuple[click.Parameter, Any]]:
    """Yield each parameter that has a value, with the value, or with each where there are several."""
    for param in context.command.params:
        value = context.params.get(param.name or "")
        values = value if getattr(param, "multiple", False) or param.nargs == -1 else (value,)
        yield from ((param, each) for each in values or () if each is not None)


def _spelled(param: click.Parameter) -> str:
    long = [name for name in param.opts if name.startswith("--")]
    return long[0] if long else f"the {param.human_readable_name}"


def _inputs(outputs: Sequence[Output], context: click.Context) -> Iterator[Input]:
    """Yield every file that the command reads."""
    programs, folders = list[Path](), list[Path]()
    for param, value in _given(context):
        if isinstance(param.type, InputFolder):
            folders.append(Path(value))
        typed = context.meta.get(as_typed(param))
        if isinstance(param.type, InputPath):
            file = Path(value)
        elif typed is not None and Path(typed).is_file():
            file = Path(typed)
        else:
            continue
        what = _spelled(param)
        yield Input(file, _as_read(param, what))
        for named in files_named(file):
            yield Input(named, Text("a file that {what} names", what=what.lower()))
        if param.name == "program":
            programs.append(file)
    if any(output.path.suffix.lower() in SUBROUTINES and output.path.exists() for output in outputs):
        for program in programs:
            for file in _called(program, folders):
                yield Input(file, Text("a subroutine that is called"))


def _as_read(param: click.Parameter, what: str) -> Text:
    """Return how a sentence names a file of an option or an argument, which may take several."""
    if what.startswith("--"):
        return Text("{what}, which is read", what=what)
    if param.nargs == -1:
        return Text("one of {what} that are read", what=what.lower())
    return Text("{what} that is read", what=what.lower())


def files_named(file: Path) -> list[Path]:
    """Return the files that a job, a profile, a tool library or a tool bit names, and those that these name."""
    found: dict[Path, None] = {}
    waiting = [file]
    while waiting:
        holder = waiting.pop()
        for text in _texts(_content(holder)):
            for path in (holder.parent / text, holder.parent.parent / "Bit" / text):
                if _is_file(path) and path not in found:
                    found[path] = None
                    waiting.append(path)
    return list(found)


def _content(file: Path) -> Any:
    """Return the content of a file of LISTS, None for any other and for an unreadable one: its reader reports it."""
    try:
        if file.suffix.lower() == ".toml":
            from CNCStepper.machine.profile import read_toml

            return read_toml(file)
        return json.loads(file.read_text("utf-8")) if file.suffix.lower() in LISTS else None
    except (OSError, ValueError, RecursionError):
        return None


def _texts(content: Any) -> Iterator[str]:
    """Yield every text in a structure of lists and tables."""
    waiting = [content]
    while waiting:
        each = waiting.pop()
        if isinstance(each, str):
            yield each
        elif isinstance(each, Mapping):
            waiting.extend(each.values())
        elif isinstance(each, list):
            waiting.extend(each)


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):  # a text that is no name of a file
        return False


def _called(program: Path, folders: Iterable[Path]) -> list[Path]:
    """Return the files of the subroutines that a program calls, and that these call."""
    beside = (program.parent, *folders)
    found, waiting = dict[Path, None](), [program]
    while waiting:
        for name in set(CALL.findall(waiting.pop().read_text("latin-1"))):
            for path in (folder / f"{name}{suffix}" for folder in beside for suffix in SUBROUTINES):
                if _is_file(path) and path not in found:
                    found[path] = None
                    waiting.append(path)
    return list(found)
