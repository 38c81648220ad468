# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's tool table (`tool.tbl`), a tool a line, in any order of words:

    T3 P3 D0.201 Z+1.273 ;#7 tap drill
    |  |  |      |         `-- what it is, in words: the table has no shape
    |  |  |      `-- length offset; X Y A B C U V W likewise
    |  |  `-- diameter               I J Q: angles and orientation of a lathe's tool
    |  `-- pocket
    `-- number

The lengths are in the machine's own unit, which the file does not say. A shape is read from the comment's words, and
guesses are reported; other words are kept and written back.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input
from CNCStepper.machine.tools.stored_tool import StoredTool, given_keys, tool_or_note
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.safe_text import printable
from CNCStepper.word_pattern import words_beside

LETTERS = "TPXYZABCUVWDIJQ"
KNOWN_SHAPES = (("ball", "ball"), ("drill", "drill"), ("mill", "flat"), ("flat", "flat"), ("cutter", "flat"))
WRITTEN_KEYS = {"number", "shape", "diameter_mm", "length_offset_mm"}
LARGEST_NUMBER = 255  # of a tool in a job
MOST_BYTES, MOST_TOOLS = 4_000_000, 10_000
MOST_NAME = 200  # characters of a comment
LONGEST_WORD = 40  # characters of a number: no length has more digits


def read_table(path: Path, unit_mm: float = 1.0) -> list[StoredTool]:
    """Return the tools of a table whose lengths are in units of `unit_mm`; raises JobError that names the line."""
    lines = read_input(path, MOST_BYTES).decode("utf-8-sig", errors="replace").splitlines()
    numbered = [(number, line) for number, line in enumerate(lines, start=1) if line.partition(";")[0].strip()]
    if len(numbered) > MOST_TOOLS:
        value, limit = f"{len(numbered)}", f"{MOST_TOOLS}"
        what, advice = "the table has too many tools", "split the file"
        raise JobError("tool-table", what, value=value, limit=limit, place=Place(str(path)), advice=advice)
    return [_tool(line, unit_mm, Place(str(path), number)) for number, line in numbered]


def write_table(tools: list[StoredTool], path: Path, unit_mm: float = 1.0) -> list[str]:
    """Write the tools as a table in units of `unit_mm`; return what of them a table cannot hold."""
    lines: list[str] = []
    notes: list[str] = []
    for stored in tools:
        lines.append(_line(stored, unit_mm))
        if stored.tool is not None:
            lost = sorted(set(given_keys(stored.tool)) - WRITTEN_KEYS)
            told, names = "tool {number} '{name}': a table has no {lost}", ", ".join(lost)
            notes += [Text(told, number=stored.number, name=stored.name, lost=names)] if lost else []
    write_whole(path, "".join(f"{line}\n" for line in lines).encode("utf-8"))
    return notes


def line_words(line: str) -> tuple[list[tuple[str, str]], str, str]:
    """Return letter and number of each word of a table's line, other text before its comment, and the comment."""
    code, _, comment = line.partition(";")
    return *words_beside(code), comment


def _tool(line: str, unit_mm: float, place: Place) -> StoredTool:
    found, other, comment = line_words(line)
    words = dict(found)
    if other or set(words) - set(LETTERS) or "T" not in words:
        advice = "write a line such as: T3 P3 D6.0 Z+41.5 ;6 mm end mill"
        raise JobError(
            "tool-table", Text("not a tool of a table: '{line}'", line=line.strip()[:60]), advice=advice, place=place
        )
    name = printable(comment.strip(), MOST_NAME)
    _require_short(words, place)
    number, raw = int(float(words["T"])), {"words": words, "unit_mm": unit_mm}
    diameter_mm = float(words.get("D", "0")) * unit_mm
    if diameter_mm <= 0:
        return StoredTool(number, name, None, raw, ("the table gives it no diameter",))
    if number > LARGEST_NUMBER:
        return StoredTool(
            number, name, None, raw, (Text("its number is above {largest_number}", largest_number=LARGEST_NUMBER),)
        )
    shape, guess = _shape(name)
    offset = {"length_offset_mm": float(words["Z"]) * unit_mm} if "Z" in words else {}
    tool, notes = tool_or_note({"number": number, "shape": shape, "diameter_mm": diameter_mm, **offset})
    return StoredTool(number, name, tool, raw, (*guess, *notes))


def _require_short(words: dict[str, str], place: Place) -> None:
    """Raise JobError for a word whose number has more digits than any length or number has."""
    for letter, number in words.items():
        if len(number) > LONGEST_WORD:
            value, limit = f"{letter}{number[:12]}… ({len(number)} characters)", f"{LONGEST_WORD} characters"
            what, advice = "a number of the table is too long", "write fewer digits"
            raise JobError("tool-table", what, value=value, limit=limit, advice=advice, place=place)


def _shape(name: str) -> tuple[str, tuple[str, ...]]:
    """Return the shape that the comment names; without one a mill, with a note."""
    for word, shape in KNOWN_SHAPES:
        if word in name.lower():
            return shape, ()
    return "flat", (Text("read as a flat mill: '{name}' does not name a shape", name=name),)


def _line(stored: StoredTool, unit_mm: float) -> str:
    """Return the line of a tool: the words that it came with, where they still say the same."""
    before: dict[str, str] = stored.raw.get("words", {})
    words = dict(before) or {"T": str(stored.number), "P": str(stored.number)}
    words["T"] = before.get("T", str(stored.number))
    if stored.tool is not None:
        for letter, value_mm in (("D", stored.tool.diameter_mm), ("Z", stored.tool.length_offset_mm)):
            if value_mm is not None and not _says(before, letter, value_mm, stored.raw.get("unit_mm"), unit_mm):
                words[letter] = f"{value_mm / unit_mm:+.6f}" if letter == "Z" else f"{value_mm / unit_mm:.6f}"
    text = " ".join(f"{letter}{words[letter]}" for letter in LETTERS if letter in words)
    return f"{text} ;{stored.name or _name(stored.tool)}"


def _says(before: dict[str, str], letter: str, value_mm: float, was_mm: Any, unit_mm: float) -> bool:
    return letter in before and was_mm == unit_mm and abs(float(before[letter]) * unit_mm - value_mm) < 1e-9


def _name(tool: Tool | None) -> str:
    return "" if tool is None else tool.words
