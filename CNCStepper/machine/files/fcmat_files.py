# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material files (.FCMat) of FreeCAD 1.0 and newer: the part of YAML that FreeCAD writes, read and written.

    General:                           ("General", "Name")                                  Entry("Mild Steel", 2)
      Name: "Mild Steel"        ◄──►   ("Models", "Machinability", "SurfaceSpeedHSS")       Entry("25 m/min", 5)
    Models:
      Machinability:
        SurfaceSpeedHSS: '25 m/min'

Mappings nest; texts are plain, quoted or blocks (`>`, `|`) whose last empty lines do not count. A list is read as an
empty text: nothing that is used here is one. All else of YAML is refused with its line. FreeCAD's Python need not have
a YAML package.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input

MOST_BYTES, DEEPEST = 4_000_000, 10  # a material is some 3 kB, its keys are three deep
INDENT = "  "
KEY = re.compile(r"""( *)(?:"([^"\\]*)"|'([^']*)'|([\w(][^:#"'\[\]{}]*)) *:(?:[ \t]+(.*))?""")
BLOCK = re.compile(r"([|>])(?:([1-9])?[+-]?|[+-]([1-9]))(?:[ \t]+#.*)?")
INSIDE = {'"': re.compile(r'(?:[^"\\]|\\.)*'), "'": re.compile(r"(?:[^']|'')*")}
NOT_PLAIN = ("[", "]", "{", "}", ",", "&", "*", "!", "%", "@", "`", "- ", "? ")
OF_0_20 = re.compile(r"(?:[ \t]*(?:[;#].*)?\n)*\[")  # the first section of an INI file


@dataclass(frozen=True)
class Entry:
    """A text of the file, and the line of its key."""

    text: str
    line: int


Content = dict[tuple[str, ...], Entry]
Nested = Mapping[str, "str | Nested"]


@dataclass(frozen=True)
class _Key:
    """A key that the lines below may belong to; `is_open` when it has no text."""

    name: str
    indent: int
    is_open: bool


def read_fcmat(path: Path) -> Content:
    """Return the texts of a material file by the names of their keys; raises JobError with the line."""
    try:
        text = read_input(path, MOST_BYTES).decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        what, advice = "the material file is not in UTF-8", "save the material anew in FreeCAD"
        raise JobError("fcmat", what, advice=advice, place=Place(str(path))) from error
    if OF_0_20.match(text):
        raise JobError(
            "fcmat-old",
            "this is a material file of FreeCAD 0.20, without surface speeds",
            advice="take one of FreeCAD 1.0 or newer, with the model Machinability",
            place=Place(str(path)),
        )
    return _Reader(text.split("\n"), str(path)).content()


def fcmat_text(content: Nested) -> str:
    """Return the text of a material file; every text is quoted."""
    return "\n".join(["---\n# File created by CNCStepper", *_lines(content, "")]) + "\n"


def _lines(content: Nested, margin: str) -> list[str]:
    lines: list[str] = []
    for key, value in content.items():
        if isinstance(value, str):
            lines.append(f"{margin}{key}: {json.dumps(value, ensure_ascii=not value.isprintable())}")
        else:
            lines += [f"{margin}{key}:", *_lines(value, margin + INDENT)]
    return lines


class _Reader:
    """Reads line after line; `_at` is the number of lines that are read."""

    def __init__(self, lines: Sequence[str], file: str):
        self._lines, self._file, self._at = lines, file, 0
        self._parents: list[_Key] = []

    def content(self) -> Content:
        found: Content = {}
        seen: set[tuple[str, ...]] = set()
        while self._skip_empty():
            number = self._at + 1
            name, indent, rest = self._key()
            self._close(indent)
            path = (*(parent.name for parent in self._parents), name)
            if path in seen or len(path) > DEEPEST:
                raise self._refusal(Text("the key '{name}' is there twice or nested too deeply", name=name), number)
            seen.add(path)
            text = self._value(rest, indent)
            if text is not None:
                found[path] = Entry(text, number)
            self._parents.append(_Key(name, indent, text is None))
        return found

    # --- lines --------------------------------------------------------------------------------------

    def _skip_empty(self) -> bool:
        """Pass over comments, empty lines and the mark before the first key; return whether a line is left."""
        while self._at < len(self._lines):
            line = self._lines[self._at].strip()
            if line and line[0] != "#" and not (line == "---" and not self._parents):
                return True
            self._at += 1
        return False

    def _key(self) -> tuple[str, int, str]:
        """Take a line; return its key, its indentation and the rest."""
        line = self._lines[self._at]
        self._at += 1
        match = KEY.fullmatch(line.rstrip())
        if match is None:
            raise self._refusal("this is no key with its value")
        name = next(part for part in match.group(2, 3, 4) if part is not None).strip()
        return name, len(match[1]), (match[5] or "").strip()

    def _close(self, indent: int) -> None:
        """Leave the mappings that end before a key with this indentation."""
        sibling = None
        while self._parents and self._parents[-1].indent >= indent:
            sibling = self._parents.pop().indent
        is_child = sibling is None and (not self._parents or self._parents[-1].is_open)
        if sibling != indent and not is_child:
            raise self._refusal("the indentation fits no key above")

    # --- values -------------------------------------------------------------------------------------

    def _value(self, rest: str, indent: int) -> str | None:
        """Return the text behind a key; None where there is none, so that keys may follow below."""
        if not rest or rest[0] == "#":
            return "" if self._passed_list(indent) else None
        if rest[0] in "|>":
            return self._block(rest, indent)
        if rest[0] in INSIDE:
            return self._quoted(rest[1:], rest[0])
        return self._plain(rest)

    def _passed_list(self, indent: int) -> bool:
        """Pass over a list below a key; return whether there was one."""
        if not (self._skip_empty() and self._is_item(indent)):
            return False
        while self._skip_empty() and (self._is_item(indent) or _margin(self._lines[self._at]) > indent):
            self._at += 1
        return True

    def _is_item(self, indent: int) -> bool:
        line = self._lines[self._at]
        return _margin(line) >= indent and line.strip().startswith("-")

    def _block(self, rest: str, indent: int) -> str:
        header = BLOCK.fullmatch(rest)
        if header is None:
            raise self._refusal("the block of text begins with signs that are not known")
        digit = header[2] or header[3]
        margin, kept = indent + int(digit) if digit else 0, list[str]()
        while self._at < len(self._lines):
            line = self._lines[self._at]
            if line.strip():
                margin = margin or _margin(line)
                if _margin(line) < max(margin, indent + 1):
                    break
            kept.append(line[margin:])
            self._at += 1
        return _folded(kept).strip("\n") if header[1] == ">" else "\n".join(kept).rstrip("\n")

    def _quoted(self, rest: str, quote: str) -> str:
        """Return a quoted text, which may end on a later line."""
        number, pieces = self._at, list[str]()
        while True:
            end = _end(INSIDE[quote], rest)
            pieces.append(rest[:end])
            if end < len(rest):
                break
            if self._at == len(self._lines):
                raise self._refusal("the quoted text has no end", number)
            rest = self._lines[self._at]
            self._at += 1
        tail = rest[end + 1 :].strip()
        if rest[end] != quote or (tail and tail[0] != "#"):
            raise self._refusal("this is no quoted text")
        text = pieces[0] if len(pieces) == 1 else _folded(pieces)
        return text.replace("''", "'") if quote == "'" else self._unescaped(text, number)

    def _unescaped(self, text: str, number: int) -> str:
        try:
            return str(json.loads(f'"{text}"', strict=False))
        except ValueError as error:
            raise self._refusal("the quoted text has an escape that is not known", number) from error

    def _plain(self, rest: str) -> str:
        text = re.split(r"\s#", rest, maxsplit=1)[0].strip()
        if text.startswith(NOT_PLAIN) or ": " in text or text.endswith(":"):
            raise self._refusal("this value must be in quotes")
        return text

    def _refusal(self, why: str, line: int = 0) -> JobError:
        """Return the error for a line, else for the one that was read last."""
        return JobError(
            "fcmat",
            Text("not a material file that FreeCAD writes: {why}", why=why),
            advice="correct the line, or save the material anew in FreeCAD",
            place=Place(self._file, line or self._at),
        )


def _margin(line: str) -> int:
    return len(line) - len(line.lstrip(" "))


def _end(pattern: re.Pattern[str], text: str) -> int:
    match = pattern.match(text)
    return match.end() if match else 0


def _folded(lines: Sequence[str]) -> str:
    """Return lines as one paragraph: a line's end is a space, each empty line a new line."""
    return re.sub(r"\n(\n*)", lambda match: match[1] or " ", "\n".join(line.strip() for line in lines))
