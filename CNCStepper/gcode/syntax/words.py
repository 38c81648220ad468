# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splits a line of text into its words: comments, block delete, and words with the column of each.

Blanks may stand anywhere, also inside a number, and letters may be lower case (RS274/NGC). Errors name the
column; a reader of whole programs adds file and line.

The "%" that may open and close a program, as the marks at the two ends of a punched tape did.
"""

from __future__ import annotations

import re
from string import ascii_lowercase, ascii_uppercase
from typing import NamedTuple

from CNCStepper.errors import Place, ProgramError, Text

NUMBER = r"[+-]?(?:[0-9]{1,15}(?:\.[0-9]*)?|\.[0-9]+)(?![0-9])"
SIGNS = "@^$"  # polar distance and angle, and the number of a spindle, are words too
_WORD = re.compile(rf"([A-Z@^]|(?<!^)\$)({NUMBER})")  # a line that begins with $ is no program's
_NAMED = re.compile(r"<[^>]*>")  # the name of a parameter or of a subroutine
MOST_LINE = 100_000  # characters: each takes some 200 bytes of memory while it is read; controllers take 80 to 256
_BLANKS = " \t\r\n"
_CAPITALS = str.maketrans(ascii_lowercase, ascii_uppercase)
_SMALL = str.maketrans(ascii_uppercase, ascii_lowercase)
_RUN = re.compile(r"[^A-Z]?[^A-Z]*")  # the text up to the next letter

_COMPUTED = {
    "#": "parameters (#) are not part of this dialect",
    "[": "expressions in brackets are not part of this dialect",
    "<": "named parameters are not part of this dialect",
    "O": "an O-word begins a line of a whole program, in dialects that have them: here it is not read",
}
_SPEECH = ("MSG", "DEBUG", "PRINT", "LOG", "LOGOPEN", "LOGAPPEND", "PY")
_MISPLACED = {
    "$": "a line that begins with $ is a setting or command for the controller, not part of a program",
    "%": "% may stand only alone on a line",
    ")": "a comment is closed that was not opened",
    "/": "/ (block delete) may stand only at the beginning of a line",
    "*": "checksums are not part of this dialect",
    "!": "! is a command to the controller (feed hold), not part of a program",
    "?": "? is a command to the controller (status), not part of a program",
    "~": "~ is a command to the controller (cycle start), not part of a program",
}


class Word(NamedTuple):
    """A letter and its number as written (without blanks); the column counts from 1."""

    letter: str
    number: str
    column: int

    @property
    def text(self) -> str:
        """The word as written, in upper case."""
        return self.letter + self.number

    @property
    def name(self) -> str:
        """The code that a G or M word names: "G1" for G01; any other word is named by its letter."""
        return f"{self.letter}{float(self.number):g}" if self.letter in "GM" else self.letter


class Comment(NamedTuple):
    """The text between parentheses, or (`to_end`) after a semicolon; `kind` is "msg" for (MSG, ...), "" for most."""

    text: str
    column: int
    kind: str
    to_end: bool

    @property
    def message(self) -> bool:
        """Whether the operator shall see it."""
        return self.kind in ("msg", "debug")


class Line(NamedTuple):
    """A line whose comments are replaced by blanks, so that columns stay; `deleted`: it begins with "/"."""

    code: str
    comments: tuple[Comment, ...]
    deleted: bool


def program_lines(text: str) -> list[str]:
    """Return the lines of a program as an editor counts them: LF, CRLF or CR end a line, nothing else does."""
    lines = with_line_feeds(text).split("\n")
    if not lines[-1]:
        lines.pop()
    return lines


def with_line_feeds(text: str) -> str:
    """Return the text of a program with LF alone between lines and no byte order mark."""
    text = text.removeprefix("\ufeff")
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def split_line(text: str, strict_comments: bool = False) -> Line:
    """Return code and comments of one line; `strict_comments` refuses unclosed and nested ones.

    Raises ProgramError for a line that is longer than any program's.
    """
    require_short(len(text))
    code, comments = _without_comments(text, strict_comments)
    deleted = code.lstrip(_BLANKS).startswith("/")
    return Line(code.replace("/", " ", 1) if deleted else code, tuple(comments), deleted)


def require_short(length: int, place: Place | None = None) -> None:
    """Raise ProgramError where a line of `length` characters is longer than any program's."""
    if length > MOST_LINE:
        value, limit, advice = f"{length} characters", f"{MOST_LINE}", "break the line"
        raise ProgramError("line-long", "a line is too long", value=value, limit=limit, advice=advice, place=place)


def is_percent_mark(text: str) -> bool:
    """Whether the line is a "%", which begins or ends a program."""
    return text.strip(_BLANKS) == "%"


def pack(code: str) -> tuple[str, list[int]]:
    """Return a line without its blanks, its ASCII letters in capitals, and the column of each character left."""
    columns = [column for column, character in enumerate(code, 1) if character not in _BLANKS]
    packed = "".join(character for character in code if character not in _BLANKS)
    return packed.translate(_CAPITALS), columns


def packed_wire(text: str) -> str:
    """Return a wire line as a controller reads it: without blanks, in capitals."""
    return text.replace(" ", "").upper()


def code_pattern(letter: str, numbers: str) -> str:
    """Return the pattern of the codes of a letter in packed text, zeros in front allowed; `numbers`: "4|28\\.1"."""
    return rf"{letter}0*(?:{numbers})(?![\d.])"


def lower_case(name: str) -> str:
    """Return a name with its ASCII letters small; LinuxCNC distinguishes others, as in "ç" and "Ç"."""
    return name.translate(_SMALL)


def words_of(code: str) -> list[Word]:
    """Return the words of a line without comments; raises ProgramError (with its column) where there is none."""
    packed, columns = pack(code)
    words: list[Word] = []
    position = 0
    while position < len(packed):
        match = _WORD.match(packed, position)
        if match is None or match[1] == "O":
            raise not_a_word(packed, position, columns)
        words.append(Word(match[1], match[2], columns[position]))
        position = match.end()
    return words


def scanned_words(code: str) -> list[tuple[str, str]]:
    """Return letter and number of the words of a line without comments, in capitals, as far as there are any.

    Nothing is refused: expressions, names of parameters and whatever else is no word are passed over. This is for
    callers that search lines which the interpreter reads or has read.
    """
    return _WORD.findall(_NAMED.sub("", pack(code)[0]))


def scanned_codes(code: str) -> set[str]:
    """Return the names of the G and M codes of a line without comments, "G1" for G01, as `scanned_words` finds them."""
    return {Word(letter, number, 1).name for letter, number in scanned_words(code) if letter in "GM"}


def _without_comments(text: str, strict: bool) -> tuple[str, list[Comment]]:
    """Return `text` with its comments blanked, and the comments."""
    comments: list[Comment] = []
    code, position = "", 0
    while position < len(text):
        begin = min((at for at in (text.find("(", position), text.find(";", position)) if at >= 0), default=-1)
        if begin < 0:
            break
        if strict and _is_in_name(text, position, begin):  # without it two names would be one
            what = "the name of a parameter holds a comment"
            raise _error("comment", what, begin + 1, text[begin], "take it out of the name")
        end = _comment_end(text, begin, strict)
        if end > begin + 1:
            comments.append(_comment(text[begin + 1 : end], begin + 1, text[begin] == ";"))
        code += text[position:begin] + " " * (min(end + 1, len(text)) - begin)
        position = end + 1
    return code + text[position:], comments


def _is_in_name(text: str, position: int, at: int) -> bool:
    """Whether a place lies in the name of a parameter, #<...>, that begins from `position` on."""
    opened = text.rfind("<", position, at)
    return opened >= 0 and text[:opened].rstrip(_BLANKS).endswith("#") and text.find(">", opened, at) < 0


def _comment_end(text: str, begin: int, strict: bool) -> int:
    """Return where the comment that opens at `begin` closes."""
    if text[begin] == ";":
        return len(text)
    end = text.find(")", begin)
    if end < 0 and strict:
        raise _error("comment", "the comment is not closed", begin + 1, "(", "close it with )")
    end = len(text) if end < 0 else end
    nested = text.find("(", begin + 1, end)
    if nested >= 0 and strict:
        raise _error("comment", "a comment may not hold another one", nested + 1, "(", "take out the inner (")
    return end


def _comment(inner: str, column: int, to_end: bool) -> Comment:
    stripped = inner.lstrip(" \t")
    mark, comma, text = stripped.partition(",")
    if comma and mark.upper() in _SPEECH:
        return Comment(text, column, mark.lower(), to_end)
    if stripped.upper() == "LOGCLOSE":
        return Comment("", column, "logclose", to_end)
    return Comment(stripped, column, "", to_end)


def not_a_word(packed: str, position: int, columns: list[int]) -> ProgramError:
    """Describe the character at `position` that begins no word."""
    letter = packed[position]
    run = letter + (_RUN.match(packed, position + 1) or [""])[0]
    after = packed[position + 1 : position + 2]
    for character in (letter, after if letter.isascii() and letter.isalpha() else ""):
        if character in _COMPUTED:
            advice = "write the words with plain numbers"
            return _error("not-supported", _COMPUTED[character], columns[position], run, advice)
    if letter in _MISPLACED:
        return _error("misplaced", _MISPLACED[letter], columns[position], run, "take it out")
    if letter.isascii() and letter.isalpha():
        what = Text("the word {letter} has no number that can be read", letter=letter)
        return _error("bad-number", what, columns[position], run, "write a decimal number after the letter")
    if letter in "+-.0123456789":
        return _error("bad-number", "a number that no letter begins", columns[position], run, "correct the word before")
    advice = "write a point for decimals" if letter == "," else "take it out"
    return _error("unknown-character", "a word is a letter and a number", columns[position], run, advice)


def _error(code: str, what: str, column: int, value: str, advice: str) -> ProgramError:
    return ProgramError(code, what, advice=advice, value=value[:40], place=Place(column=column))


class PercentMarkers:
    """Whether a program has begun, by a mark or by its first line, and whether a mark has closed it."""

    def __init__(self) -> None:
        self.begun = self.opened_by_mark = self.closed = False

    @property
    def lacks_mark(self) -> bool:
        """Whether a mark opened the program and none closed it."""
        return self.opened_by_mark and not self.closed

    def is_mark(self, text: str, strict: bool) -> bool:
        """Whether a line is a mark; raises ProgramError where none is allowed.

        The first line opens the program by it, a later one closes it; a `strict` dialect closes only what was opened.
        """
        if not is_percent_mark(text):
            return False
        if not self.begun:
            self.begun = self.opened_by_mark = True
        elif self.opened_by_mark or not strict:
            self.closed = True
        else:
            place = Place(column=text.index("%") + 1)
            what = "% may stand only on the first and the last line"
            raise ProgramError("misplaced", what, value="%", advice="take it out", place=place)
        return True
