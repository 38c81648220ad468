# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a whole program: line after line, or as its O-words branch.

    line ──► leads elsewhere?  no ──► Interpreter.line            (unless lines are being skipped)
                              yes ──► jump · skip to a label · call · return

As in LinuxCNC nothing is looked up ahead: a branch that is not taken, the text of a subroutine where it is defined
and what stands between a call and its subroutine are *skipped*, line by line, up to the line with the wanted label.
The labels of loops and branches belong to the subroutine that they stand in ("sub#label").
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.interpreter.fast_path.text_runs import read_runs, refused_runs
from CNCStepper.gcode.interpreter.flow.branches_and_loops import Blocks, refused
from CNCStepper.gcode.interpreter.flow.flow_line_parser import (
    CONDITIONS,
    GLOBAL,
    FlowLine,
    leads,
    read_flow_line,
    read_m98,
)
from CNCStepper.gcode.interpreter.flow.numbered_blocks import NumberedBlocks
from CNCStepper.gcode.interpreter.flow.subprogram_files import Library, Source
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.interpreter.state.system_parameters import SystemParameters
from CNCStepper.gcode.syntax.words import Word, is_percent_mark, program_lines


@dataclass(frozen=True)
class Limits:
    """What stops endless programs. lines: how many more may be run than the program has. calls: how deep."""

    lines: int = 2_000_000
    calls: int = 9


@dataclass
class _Call:
    """A subroutine that runs: its name, the line of its call, and its return address in the text."""

    name: str
    fanuc: bool
    source: Source
    index: int
    line: int


def run(
    interpreter: Interpreter, text: str, library: Library | None = None, limits: Limits | None = None
) -> Iterator[None]:
    """Read a whole program with a new interpreter and yield after each line; raises ProgramError at its place."""
    if not (yield from read_runs(interpreter, text)):
        yield from run_on(interpreter, program_lines(text), library, limits)


def run_whole(
    interpreter: Interpreter, text: str, library: Library, progress: Callable[[float], None] = lambda share: None
) -> None:
    """Read a whole program with a new interpreter; raises ProgramError at its place.

    progress: called with the share of its lines that is reached, from 0 to 1.
    """
    lines = text.count("\n") or 1
    for _ in run(interpreter, text, library):
        progress(min(1.0, interpreter.line_number / lines))


def run_on(
    interpreter: Interpreter, lines: Sequence[str], library: Library | None = None, limits: Limits | None = None
) -> Iterator[None]:
    """Read the rest of a program of which an interpreter has read the first lines, all without flow control."""
    if interpreter.dialect.o_words:
        yield from Flow(interpreter, lines, library or Library(), limits or Limits()).run()
        return
    if interpreter.dialect.two_block_cycles:
        yield from NumberedBlocks(interpreter, lines).run()
        return
    for index in range(interpreter.line_number, len(lines)):
        interpreter.line(lines[index])
        yield


def refusals(interpreter: Interpreter, text: str, library: Library | None = None) -> Iterator[ProgramError]:
    """Read a whole program with a new interpreter and yield why lines are refused; they change nothing.

    Reading goes on after them up to the first line that leads elsewhere; behind that, the first refusal is the last.
    """
    if (yield from refused_runs(interpreter, text)):
        return
    lines = program_lines(text)
    for line in lines[interpreter.line_number :]:
        try:
            if interpreter.leads(line):
                for _ in run_on(interpreter, lines, library):
                    pass
                return
            interpreter.line(line)
        except ProgramError as error:
            yield error
            if interpreter.leads(line):
                return


class Flow:
    """The way through a program that has O-words."""

    def __init__(self, interpreter: Interpreter, lines: Sequence[str], library: Library, limits: Limits):
        self.interpreter = interpreter
        self.main = Source(interpreter.file, lines)
        self.library = library
        self.limits = limits
        self.source, self.index = self.main, interpreter.line_number  # the lines before hold words only
        self.calls: list[_Call] = []
        self.blocks = Blocks()
        self._take: Callable[[Model, list[Word], list[float]], None] | None = None  # who takes the lines instead
        interpreter.read_profile = self.profile
        self._seeking = ""  # the subroutine that is looked for
        self._defining = ""  # the subroutine whose text is being skipped
        self._rounds_left: dict[int, int] = {}  # of M98 L, by depth

    def run(self) -> Iterator[None]:
        """Run the program to its end."""
        left = len(self.main.lines) + self.limits.lines
        while self.index < len(self.source.lines):
            text = self.source.lines[self.index]
            self.index += 1
            left -= 1
            if left < 0:
                what = "the program runs on and on: is there a loop without an end?"
                limit = Text("{lines} lines more than the text has", lines=self.limits.lines)
                raise self._error("endless", what, "correct its condition, or split the program", limit)
            self._line(text)
            yield
        if not self.interpreter.ended:
            self._text_over()

    def _text_over(self) -> None:
        """Refuse a text that is over before the end of what was opened."""
        if self._seeking:
            what = Text("there is no subroutine o<{seeking}>", seeking=self._seeking)
            raise self._error("no-subroutine", what, "define it, or put its file beside the program")
        if self.blocks.skipping:
            name = self.blocks.skipping.rpartition("#")[2]
            what = Text("o{name} has no end: the text is over, and it is still being skipped", name=name)
            raise self._error("no-o-end", what, "write its endif, endwhile, endrepeat, while or endsub")
        if self.calls:
            what = Text("the subroutine o<{call}> has no end", call=self.calls[-1].name)
            raise self._error("no-endsub", what, "write endsub, or M99 in a subprogram of Fanuc's form")

    def _line(self, text: str) -> None:
        reader = self.interpreter
        number, place = self._number(), Place(self.source.file, self.index)
        if reader.ended or not leads(text):
            if not self.blocks.skipping or reader.ended or (is_percent_mark(text) and reader.tape.opened_by_mark):
                self._read(text, number, place)
            else:
                reader.check_skipped(text, place)
            return
        try:
            line = read_flow_line(text, SystemParameters(reader.model, self.index), reader.dialect.strict_comments)
            if line is None or (line.keyword == "m99" and not self.calls):
                if not self.blocks.skipping:
                    self._read(text, number, place)
                return
            if not (line.deleted and reader.dialect.skips_deleted):
                reader.flow_line(line.sequence, number, place)
                self._flow(line)
        except ProgramError as error:
            column = error.place.column if error.place else 0
            raise (
                error if error.place and error.place.line else error.at(Place(place.file, place.line, column))
            ) from None

    def _read(self, text: str, number: int, place: Place) -> None:
        if self._take:
            self._take(self.interpreter.model, *self.interpreter.taken_at(text, place))
        else:
            self.interpreter.line_at(text, number, place)

    def profile(self, number: int, model: Model, take: Callable[[Model, list[Word], list[float]], None]) -> None:
        """Run the subroutine o<number> for a cycle that takes its lines; `model` replaces the interpreter's."""
        reader, depth, left = self.interpreter, len(self.calls), self.limits.lines
        kept = reader.model, reader.line_number, reader.sequence, self._take
        reader.model, self._take = model, take
        try:
            call = read_flow_line(f"o{number} call", SystemParameters(model, self.index), False)
            assert call is not None
            self._flow(call)
            while len(self.calls) > depth:
                left -= 1
                if left < 0 or self.index >= len(self.source.lines):
                    self._text_over()
                    limit = f"{self.limits.lines} lines"
                    raise self._error("endless", "the profile has no end", "correct its loops", limit)
                self.index += 1
                self._line(self.source.lines[self.index - 1])
        finally:
            reader.model, reader.line_number, reader.sequence, self._take = kept

    def _number(self) -> int:
        """Return the line of the main file: where a subroutine of another file was called from."""
        if self.source is self.main:
            return self.index
        return next((call.line for call in reversed(self.calls) if call.source is self.main), 0)

    def _flow(self, line: FlowLine) -> None:
        """Read the rest of a line as far as it counts, and follow it."""
        if line.keyword == "m98":
            if self.blocks.skipping:
                return
            read_m98(line)
        elif line.keyword == "m99":
            line.name = self.calls[-1].name
        label = line.name if line.keyword in GLOBAL else f"{self._scope()}#{line.name}"
        if line.keyword in ("sub", "") and self._defining:
            what = "a subroutine may not be defined inside another one"
            raise refused(line, "nested-sub", what, "write it before or after the other one")
        if self._defining and line.keyword not in ("endsub", "return"):
            return
        if self.blocks.skipping and self.blocks.skipping != label:
            return
        test = line.condition() if line.keyword in CONDITIONS else 0.0
        if line.keyword in ("endsub", "return", "m99") and not self._defining:
            self.interpreter.model.parameters.returned = line.value()
        if line.keyword == "call":
            line.read_arguments()
        if not self.blocks.skipping:
            line.end()
        if self._seeking and line.keyword not in ("sub", ""):
            return
        self._follow(line, label, test)

    def _scope(self) -> str:
        return self.calls[-1].name if self.calls else self._defining

    def _follow(self, line: FlowLine, label: str, test: float) -> None:
        if line.keyword in ("sub", ""):
            self._sub(line, label)
        elif line.keyword in ("endsub", "return", "m99"):
            self._return(line)
        elif line.keyword in ("call", "m98"):
            self._call(line)
        elif self.blocks.follow(line, label, test, self.source, self.index - 1):
            self._go(label)

    # subroutines

    def _sub(self, line: FlowLine, label: str) -> None:
        """Begin to run a subroutine, or skip the text of one where it is defined."""
        if self.calls and self.calls[-1].fanuc != (line.keyword == ""):
            what = "o<name> sub is called by o<name> call" if self.calls[-1].fanuc else "O1234 is called by M98 P1234"
            raise refused(line, "wrong-call", what, "correct the call")
        if self.blocks.skipping:
            self.blocks.define(line, label, self.source, self.index - 1)
            self.blocks.skipping = ""
        self._seeking = ""
        if line.keyword == "sub" and not self.calls:
            self.blocks.define(line, label, self.source, self.index - 1)
            self.blocks.skipping = self._defining = label

    def _return(self, line: FlowLine) -> None:
        if not self.calls:
            if not self._defining:
                advice = "take it out, or end with M2"
                raise refused(line, "not-in-sub", Text("{line} is outside any subroutine", line=line.keyword), advice)
            if line.keyword == "endsub":
                self.blocks.skipping = self._defining = ""
            return
        call = self.calls[-1]
        if call.fanuc != (line.keyword == "m99"):
            what = "O1234 ends with M99" if call.fanuc else "o<name> sub ends with o<name> endsub"
            raise refused(line, "wrong-return", what, "write that as its last line")
        if line.keyword == "endsub":
            self.blocks.skipping = ""
        self.calls.pop()
        self.source, self.index = call.source, call.index
        self.interpreter.leave_call(restore=not call.fanuc)

    def _call(self, line: FlowLine) -> None:
        fanuc = line.keyword == "m98"
        if fanuc and not self._rounds(line):
            return
        if len(self.calls) >= self.limits.calls:
            what, advice = "subroutines call each other too deep", "let fewer of them call each other"
            raise refused(line, "too-many-calls", what, advice, str(self.limits.calls))
        back = self.index - 1 if fanuc and len(self.calls) in self._rounds_left else self.index
        self.calls.append(_Call(line.name, fanuc, self.source, back, self.index))
        self.interpreter.model.parameters.enter(None if fanuc else line.arguments)
        self._go(line.name)

    def _rounds(self, line: FlowLine) -> bool:
        """Count the rounds of M98 L: after each but the last the call itself comes next; whether there is one."""
        left = self._rounds_left.pop(len(self.calls), line.repeats)
        if left > 1:
            self._rounds_left[len(self.calls)] = left - 1
        return left != 0

    def _go(self, label: str) -> None:
        """Go to the line of a label; an unknown one is searched for in a file, then in the following lines."""
        known = self.blocks.labels.get(label)
        if known:
            self.source, self.index = known.source, known.index
            return
        source = self.library.find(label)
        if source:
            self.source, self.index = source, 0
        self.blocks.skipping = self._seeking = label

    def _error(self, code: str, what: str, advice: str, limit: str = "") -> ProgramError:
        place = Place(self.source.file, self.index, 1)
        return ProgramError(code, what, advice=advice, limit=limit, place=place)
