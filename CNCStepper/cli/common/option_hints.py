# SPDX-License-Identifier: LGPL-2.1-or-later
"""Option hints for errors: the core has no options."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
import time
from collections.abc import Callable, Iterable
from itertools import chain, count
from pathlib import Path

import click

from CNCStepper.cancellation import interruptible
from CNCStepper.cli.common.language import show_text
from CNCStepper.errors import CNCStepperError, Place, ProgramError, Text

DIALECT = Text("--dialect says how a program is read: linuxcnc knows parameters, expressions and O-words")
TOOLS = Text("--tool-table FILE tells the tools' lengths and diameters")
PLACE = Text("--position X,Y,Z says where the machine stands at first, --parameters FILE the places of G28 and G30")
HINTS = {
    "unknown-position": PLACE,
    "no-subroutine": Text("--search FOLDER says where else the files of subroutines stand"),
    "tool-length": TOOLS,
    "tool-diameter": TOOLS,
    "not-expressible": Text("--leave-out leaves out what the target lacks: spindle, coolant, dwell, pause or tool"),
}


MOST_BYTES = 20_000_000  # of a program whose conversion is tried unasked
MOST_S = 5.0  # of processor time for that: a loop without end reads as no other dialect in any time
ALREADY_CONVERTS = ("convert", "trace")
START_PARAMETERS = ("work_zero", "position", "parameters", "tool_table", "search")
OF_START = ("--work-zero", "--position", "--parameters", "--tool-table", "--search")


def show_hints(errors: Iterable[CNCStepperError]) -> None:
    """Print on standard error, each once, what `add_option_hint` and `add_conversion` have found."""
    for text in dict.fromkeys(text for error in errors for text in getattr(error, "__notes__", ())):
        show_text("hint: {text}", err=True, text=text)


def add_option_hint(error: CNCStepperError, context: click.Context) -> None:
    """Add to a verb's refusal the options that help, where the verb has them."""
    text = DIALECT if error.code == "not-supported" and "dialect" in error.what else HINTS.get(error.code)
    options = {option for parameter in context.command.params for option in parameter.opts}
    if text and options & set(str(text).split()):
        error.add_note(text)


def add_conversion(error: ProgramError, context: click.Context) -> None:
    """Add to the refusal of a verb's program the command that converts it, where one does."""
    program = context.params.get("program")
    if not isinstance(program, Path) or context.info_name in ALREADY_CONVERTS:
        return
    if error.code == "tool-diameter":  # of a program that the verb reads: another dialect knows no more of the tool
        return
    if context.params.get("dialect"):  # who says what the program is does not want it taken for something else
        return
    if program.is_file() and program.stat().st_size <= MOST_BYTES and (text := _conversion(program, context, error)):
        error.add_note(text)


def _conversion(program: Path, context: click.Context, refusal: ProgramError) -> str:
    """Return the command that makes a program one that the verb reads, or why none does; "" where none is wanted."""
    from CNCStepper.cli.common.options import dialect_name, read_program
    from CNCStepper.cli.common.start_state_options import StartOptions
    from CNCStepper.gcode.conversion.foreign_programs import conversion_of

    machine, params = context.params.get("machine"), context.params
    target = dialect_name(params.get("dialect"), machine)
    rule, lengths = (machine.tool_change, machine.tool_length) if machine else ("pause", "none")
    start = StartOptions(**{name: params[name] for name in START_PARAMETERS if params.get(name)}).start()
    try:
        with interruptible(_ended_after(MOST_S)):
            found = conversion_of(read_program(program), target, start, str(program), rule, lengths)
    except _TooLongError:
        return ""
    except ProgramError as reason:
        return "" if _is_wrong(refusal, reason) else _no_conversion(target, reason)
    if found is None:
        return ""
    words = ["cncstepper", "convert", _as_file(program), "--dialect", found.source, "--to", target]
    words += ["--tool-change", rule, *(["--tool-length", found.tool_length] if found.tool_length else [])]
    words += [*_start_words(), "-o", _as_file(_new_name(program, target))]
    return Text("this makes it a program for {target}: {command}", target=target, command=shell_line(words))


def _no_conversion(target: str, reason: ProgramError) -> Text:
    return Text("no conversion makes it a program for {target}: {reason}", target=target, reason=reason)


class _TooLongError(Exception):
    """The conversion that nobody asked for takes too long."""


def _ended_after(most_s: float) -> Callable[[], None]:
    """Return what raises _TooLongError once so much processor time has passed."""
    end_s = time.thread_time() + most_s

    def look() -> None:
        if time.thread_time() > end_s:
            raise _TooLongError

    return look


def _is_wrong(refusal: ProgramError, reason: ProgramError) -> bool:
    """Return whether a program is wrong as another dialect reads it too: then its own refusal is enough."""
    there, here = refusal.place or Place(), reason.place or Place()
    return reason.code == refusal.code or (here.column > 0 and here.line == there.line)


def _start_words() -> list[str]:
    """Return the options of the start state, as the running verb was given them."""
    from CNCStepper.cli.common.options import reproduce_options

    options = reproduce_options()["options"]
    return [word for name in OF_START for value in options.get(name, ()) for word in (name, value)]


def _as_file(path: Path) -> str:
    """Return a path that is not taken for an option."""
    return f".{os.sep}{path}" if str(path).startswith("-") else str(path)


def _new_name(program: Path, target: str) -> Path:
    """Return the name of a file beside the program that is not there yet."""
    names = (f"{program.stem}-{target}{number}{program.suffix}" for number in chain([""], (f"-{n}" for n in count(2))))
    return next(path for path in map(program.with_name, names) if not os.path.lexists(path))


def shell_line(words: list[str]) -> str:
    """Return a command as it is pasted into this system's shell."""
    return subprocess.list2cmdline(words) if sys.platform == "win32" else shlex.join(words)
