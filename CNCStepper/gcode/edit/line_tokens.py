# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a line with their columns, so that one is changed and the rest of the text stays.

    N20 G1 X 10.5 (to the edge) Y[#1 + 2]
    ^   ^  ^ ^  ^               ^^       ^
    |   |  | first, last of the number    an expression is a word's value too

A word's value is a number, or an expression (`[…]`, `#…`, a function); assignments (`#1=2`) and O-words are no words.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.syntax.words import SIGNS, split_line

_BLANKS = " \t"
_NUMBER = re.compile(r"[+-]?[ \t]*(?:[0-9][0-9 \t]*(?:\.[0-9 \t]*)?|\.[0-9 \t]+)")
_ASSIGNMENT = re.compile(r"#(?:[^=\[\]]|\[[^\]]*\])*=")
Edit = tuple[int, int, str]  # replace the characters [first, last) of a line


@dataclass(frozen=True, slots=True)
class Token:
    """A word in its line: [begin, last) is the whole, [first, last) its value as written; number: None for an
    expression."""

    letter: str
    begin: int
    first: int
    last: int
    written: str
    number: float | None

    @property
    def name(self) -> str:
        """The code of a G or M word ("G1" for G01), "" for an expression; else the letter."""
        if self.letter not in "GM":
            return self.letter
        return "" if self.number is None else f"{self.letter}{self.number:g}"


def tokens_of(text: str, file: str = "", number: int = 0) -> list[Token]:
    """Return the words of a line in their order, up to an O-word; raises ProgramError for other text."""
    code = split_line(text).code
    tokens: list[Token] = []
    at = _skip(code, 0)
    while at < len(code):
        assigned = _ASSIGNMENT.match(code, at)
        if assigned:
            at = _skip(code, _expression_end(code, _skip(code, assigned.end())))
            continue
        letter = code[at].upper()
        if letter == "O" or code[at] == "%":
            break
        token = _token(code, letter, at) if "A" <= letter <= "Z" or letter in SIGNS else None
        if token is None:
            what = "this is no word that can be edited"
            value = code[at:].strip()[:40]
            raise ProgramError("edit-word", what, value=value, advice="take it out", place=Place(file, number, at + 1))
        tokens.append(token)
        at = _skip(code, token.last)
    return tokens


def is_plain(text: str) -> bool:
    """Whether the code of a line holds words with plain numbers only."""
    code = split_line(text).code
    return not any(character in "#[<oO" for character in code)


def comment_spans(text: str) -> list[tuple[int, int]]:
    """Return [first, last) of each comment of a line."""
    spans = []
    for comment in split_line(text).comments:
        first = comment.column - 1
        spans.append((first, len(text) if comment.to_end else text.find(")", first) + 1 or len(text)))
    return spans


def changed(text: str, edits: Iterable[Edit]) -> str:
    """Return a line with parts of it replaced; the parts do not overlap."""
    for first, last, new in sorted(edits, reverse=True):
        text = text[:first] + new + text[last:]
    return text


def first_place(text: str) -> int:
    """Return the index of a line's first word, after blanks, "/" and the N word; its end when there is none."""
    return next((token.begin for token in tokens_of(text) if token.letter != "N"), len(text.rstrip()))


def _token(code: str, letter: str, at: int) -> Token | None:
    first = _skip(code, at + 1)
    match = _NUMBER.match(code, first)
    if match:
        written = match[0].rstrip(_BLANKS)
        number = float("".join(written.split()))
        return Token(letter, at, first, first + len(written), written, number)
    last = _expression_end(code, first)
    return Token(letter, at, first, last, code[first:last], None) if last > first else None


def _expression_end(code: str, at: int) -> int:
    """Return where one value ends: a sign, a number, `#` of a value, `<name>`, `[…]`, a function, ATAN[…]/[…]."""
    while at < len(code) and code[at] in "+-#" + _BLANKS:
        at += 1
    match = _NUMBER.match(code, at)
    if match:
        return at + len(match[0].rstrip(_BLANKS))
    if code[at : at + 1] == "<":
        return code.find(">", at) + 1 or len(code)
    begin = at
    while at < len(code) and code[at].isalpha():
        at += 1
    if code[at : at + 1] != "[":
        return begin
    end = _bracket_end(code, at)
    if code[begin:at].upper() == "ATAN" and code[_skip(code, end) :][:1] == "/":
        return _bracket_end(code, _skip(code, _skip(code, end) + 1))
    return end


def _bracket_end(code: str, at: int) -> int:
    depth = 0
    for place in range(at, len(code)):
        depth += (code[place] == "[") - (code[place] == "]")
        if not depth:
            return place + 1
    return len(code)


def _skip(code: str, at: int) -> int:
    while at < len(code) and (code[at] in _BLANKS or (code[at] == "/" and not code[:at].strip())):
        at += 1
    return at
