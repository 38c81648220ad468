# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of flow control: O-words, and M98 and M99 as Fanuc and Mach have them.

o100 sub · endsub [value] · return [value] · call [1] [2]
o<name> if [..] · elseif [..] · else · endif · while [..] · endwhile · do · repeat [..] · endrepeat · break · continue
O1234 · M98 P1234 L2 · M99
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.interpreter.fast_path.policy import pays
from CNCStepper.gcode.interpreter.state.parameters import ARGUMENTS
from CNCStepper.gcode.interpreter.state.system_parameters import SystemParameters
from CNCStepper.gcode.syntax.expressions import Scanner
from CNCStepper.gcode.syntax.words import pack, split_line

_LEADS = re.compile(r"[ \t]*/?[ \t]*(?:N[0-9. \t]*)?(?:O|M[ \t0.+]*9[ \t]*[89](?![0-9])|M[ \t]*[#\[])", re.IGNORECASE)
_PROFILE = re.compile(r"G[ \t]*7[ \t]*[0-2]", re.IGNORECASE)
_NUMBERED_PROFILE = re.compile(r"G[ \t]*7[ \t]*[0-3](?![0-9.])", re.IGNORECASE)
_COMMENTS = re.compile(r"\([^)\r\n]*\)?|;[^\r\n]*")
_BEYOND_WORDS = re.compile(
    r"[#\[]|(?:^|[\r\n])[ \t]*/?[ \t]*(?:N[0-9. \t]*)?(?:O|M[ \t0.+]*9[ \t]*[89])", re.IGNORECASE
)
_SPOKEN = re.compile(r"\([ \t]*(?:DEBUG|PRINT|LOG)[^)\r\n]*[#%]", re.IGNORECASE)
_NUMBERED = re.compile(r"N[0-9]+(?:\.[0-9]+)?")
KEYWORDS = (
    "sub",
    "endsub",
    "call",
    "do",
    "while",
    "repeat",
    "if",
    "elseif",
    "else",
    "endif",
    "break",
    "continue",
    "endwhile",
    "endrepeat",
    "return",
)
CONDITIONS = ("while", "repeat", "if", "elseif")
GLOBAL = ("sub", "", "endsub", "call", "return", "m98", "m99")  # "" opens a subprogram of Fanuc's form


def is_plain(text: str) -> bool:
    """Whether a program holds nothing but words: neither parameters, expressions nor lines that lead elsewhere."""
    if ("#" in text or "[" in text) and _SPOKEN.search(text):
        return False
    if pays(len(text)):
        from CNCStepper.gcode.interpreter.flow.o_word_kernel import needs_interpreter

        return not needs_interpreter(np.frombuffer(text.encode("utf-8", "surrogatepass"), np.uint8))
    return not _BEYOND_WORDS.search(_COMMENTS.sub("", text))


@dataclass
class FlowLine:
    """One such line. keyword: of `KEYWORDS`, "" (O1234 alone), "m98" or "m99". column: where it begins.

    scanner: at the end of the text read so far; conditions and arguments are read only when they count.
    """

    keyword: str
    name: str
    column: int
    scanner: Scanner
    sequence: str
    deleted: bool
    repeats: int = -1  # L of M98
    arguments: list[float] = field(default_factory=list)

    @property
    def label(self) -> str:
        """The O-word as a program has it."""
        return f"o{self.name}" if self.name.isdigit() else f"o<{self.name}>"

    def condition(self) -> float:
        """Read the expression that must follow."""
        if self.scanner.next != "[":
            what = Text("[ is missing after {keyword}", keyword=self.keyword)
            raise self.scanner.error("bracket", what, Text("write {keyword} [condition]", keyword=self.keyword))
        return self.scanner.expression()

    def value(self) -> float | None:
        """Read the expression that may follow."""
        return self.scanner.expression() if self.scanner.next == "[" else None

    def read_arguments(self) -> None:
        """Read the arguments of a call."""
        while self.scanner.next == "[":
            if len(self.arguments) == ARGUMENTS:
                what = Text("a subroutine takes {arguments} arguments at most", arguments=ARGUMENTS)
                raise self.scanner.error("too-many-arguments", what, "put some in named parameters")
            self.arguments.append(self.scanner.expression())

    def end(self) -> None:
        """Refuse further text on the line."""
        if not self.scanner.ended:
            what = Text("nothing may follow {keyword}", keyword=self.keyword or "the number of a subprogram")
            raise self.scanner.error("after-o-word", what, "write it on a line of its own")


def leads(text: str) -> bool:
    """Whether a line may branch: a fast test for most lines."""
    return _LEADS.match(text) is not None


def has_profile(text: str) -> bool:
    """Whether a line may be a cycle whose profile is a subroutine: G70 to G72."""
    return _PROFILE.search(text) is not None


def names_blocks(text: str) -> bool:
    """Whether a line may be a cycle that names the blocks of its profile by N: Fanuc's G70 to G73."""
    return _NUMBERED_PROFILE.search(text) is not None


def read_flow_line(text: str, known: SystemParameters, strict_comments: bool) -> FlowLine | None:
    """Return the flow control of a line, None for another line; raises ProgramError with its column."""
    line = split_line(text, strict_comments)
    packed, columns = pack(line.code)
    scanner = Scanner(packed, columns, known)
    number = _NUMBERED.match(packed)
    if number:
        scanner.position = number.end()
    sequence = number[0][1:].partition(".")[0] if number else ""
    column = scanner.column
    if scanner.take("O"):
        name = scanner.name() if scanner.next == "<" else str(scanner.whole())
        return FlowLine(_keyword(scanner), name, column, scanner, sequence, line.deleted)
    if not scanner.take("M"):
        return None
    code = _code(scanner)
    if code not in (98, 99):
        return None
    return FlowLine(f"m{code}", "", column, scanner, sequence, line.deleted)


def read_m98(line: FlowLine) -> None:
    """Read the P and L words of M98 into name and repeats."""
    words: dict[str, int] = {}
    while not line.scanner.ended:
        letter = line.scanner.next
        if letter not in ("P", "L") or letter in words:
            raise line.scanner.error("unused-word", "M98 takes one P and one L", "write it on a line of its own")
        line.scanner.position += 1
        words[letter] = line.scanner.whole()
    if "P" not in words:
        raise line.scanner.error("missing-word", "M98 needs a P word", "write M98 P1234", 0)
    if words.get("L", 0) < 0:
        raise line.scanner.error("bad-value", "L may not be negative", "correct L", 0)
    line.name, line.repeats = str(words["P"]), words.get("L", -1)


def _keyword(scanner: Scanner) -> str:
    if scanner.ended:
        return ""
    for keyword in sorted(KEYWORDS, key=len, reverse=True):
        if scanner.take(keyword.upper()):
            return keyword
    raise scanner.error("o-word", "the O-word is unknown", Text("use one of: {keywords}", keywords=", ".join(KEYWORDS)))


def _code(scanner: Scanner) -> int:
    """Return the whole number that follows M, -1 when none can be read."""
    try:
        return scanner.whole()
    except ProgramError:
        return -1
