# SPDX-License-Identifier: LGPL-2.1-or-later
"""The labels of a program, and its branches and loops: which lines are skipped, and when the text goes back.

Lines of a branch that is not taken, after a loop's end or after a break are *skipped*, one by one, up to the line
with the label that ends it. As in LinuxCNC, a label of a branch or a loop has one place only.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import trunc

from CNCStepper.errors import Place, ProgramError, Text, one_of
from CNCStepper.gcode.interpreter.flow.flow_line_parser import FlowLine
from CNCStepper.gcode.interpreter.flow.subprogram_files import Source

BRANCHES = ("if", "elseif", "else", "endif")
MOST_LABELS = 20_000  # they may be computed: o[#1] if [...]


@dataclass
class Label:
    """A label's first line and its kind. repeats: how many are left, -1 while it is not running."""

    keyword: str
    source: Source
    index: int
    repeats: int = -1


class Blocks:
    """Holds all labels read so far, and whether lines are being skipped (`skipping` is the label that ends it)."""

    def __init__(self) -> None:
        self.labels: dict[str, Label] = {}
        self.skipping = ""
        self._branch_taken = False
        self._breaking = self._continuing = False

    def define(self, line: FlowLine, label: str, source: Source, index: int) -> None:
        """Note the line of a label; raises ProgramError when another line has it already."""
        known = self.labels.get(label)
        if known:
            what = Text(
                "{line} is in line {index} of {known_file} already",
                line=line.label,
                index=known.index + 1,
                known_file=known.source.file or "the text",
            )
            raise refused(line, "label-twice", what, "give one of the two another label")
        self._note(line, label, source, index)

    def _note(self, line: FlowLine, label: str, source: Source, index: int) -> None:
        if len(self.labels) >= MOST_LABELS:
            raise refused(
                line, "too-many-labels", "the program has too many labels", "split the program", str(MOST_LABELS)
            )
        self.labels[label] = Label(line.keyword, source, index)

    def follow(self, line: FlowLine, label: str, test: float, source: Source, index: int) -> bool:
        """Follow the branch or loop line at `index`; return whether the text goes back to its label."""
        keyword = line.keyword
        if keyword in ("if", "while", "repeat"):
            self._opens(line, label, source, index)
        if keyword in BRANCHES:
            return self._branch(line, label, test)
        if keyword in ("endwhile", "endrepeat"):
            return self._end_round(line, label)
        if keyword in ("break", "continue"):
            return self._leave_round(line, label)
        self.skipping = ""
        if keyword == "do":
            if label not in self.labels:
                self._note(line, label, source, index)
            return False
        return self._begin_round(line, label, test)

    def _opens(self, line: FlowLine, label: str, source: Source, index: int) -> None:
        """Note the line of a label, if it is new; a `while` may also end the `do` of its label."""
        known = self.labels.get(label)
        ends_do = known is not None and known.keyword == "do" and line.keyword == "while"
        if not ends_do and (known is None or known.source is not source or known.index != index):
            self.define(line, label, source, index)

    def _opened_by(self, line: FlowLine, label: str, *keywords: str) -> None:
        known = self.labels.get(label)
        if known is None or known.keyword not in keywords:
            what = Text(
                "{line} has no {keywords} with the label {line2} before it",
                line=line.keyword,
                keywords=one_of(keywords),
                line2=line.label,
            )
            raise refused(line, "no-label", what, "write one before it, or correct the label")

    # branches

    def _branch(self, line: FlowLine, label: str, test: float) -> bool:
        if line.keyword == "if":
            self._take(label, test != 0)
            return False
        self._opened_by(line, label, "if")
        if line.keyword == "endif":
            self.skipping, self._branch_taken = "", True
        elif self._branch_taken:
            self.skipping = label
        elif line.keyword == "else" or test != 0:
            self._take(label, True)
        return False

    def _take(self, label: str, taken: bool) -> None:
        self._branch_taken = taken
        self.skipping = "" if taken else label

    # loops

    def _begin_round(self, line: FlowLine, label: str, test: float) -> bool:
        known = self.labels[label]
        if known.keyword == "do":
            return self._again(test)
        if line.keyword == "while":
            self.skipping = "" if test != 0 else label
        else:
            self._repeat(known, label, test)
        return False

    def _again(self, test: float) -> bool:
        """The `while` that ends a `do`. A break is remembered until such a line comes, as in LinuxCNC."""
        again = test != 0 and not self._breaking
        self._breaking = False
        return again

    def _repeat(self, known: Label, label: str, test: float) -> None:
        if known.repeats < 0:
            known.repeats = max(0, trunc(test + 0.5))
        if known.repeats > 0:
            known.repeats -= 1
        else:
            known.repeats = -1
            self.skipping = label

    def _end_round(self, line: FlowLine, label: str) -> bool:
        """Go back for the next round, unless the loop is over; a `continue` has skipped to here."""
        self._opened_by(line, label, line.keyword.removeprefix("end"))
        again = not self.skipping or self._continuing
        if self.skipping:
            self.skipping, self._continuing = "", False
        return again

    def _leave_round(self, line: FlowLine, label: str) -> bool:
        self._opened_by(line, label, "while", "do")
        if not self.skipping:
            self.skipping = label
            self._breaking = self._breaking or line.keyword == "break"
            self._continuing = self._continuing or line.keyword == "continue"
        return False


def refused(line: FlowLine, code: str, what: str, advice: str, limit: str = "") -> ProgramError:
    """Return the refusal of a line."""
    value = line.keyword.upper() if line.keyword in ("m98", "m99") else f"{line.label} {line.keyword}".strip()
    return ProgramError(code, what, value=value, limit=limit, place=Place(column=line.column), advice=advice)
