# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of values while it is edited: every cell as typed, and what is wrong with it; no Qt.

    Library.rows() ──► TableDraft: texts ──typed──► judged() ──► values of all rows ──► Library.save()
                                                            └──► {(row, key): sentence}

A text that is no value stays as it was typed, so that nothing is lost while it is corrected.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, Protocol

from pydantic import BaseModel, ValidationError

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.files.validation_errors import refusal_of
from CNCStepper.safe_text import printable

Kind = Literal["text", "number", "whole", "choice", "rows"]
Values = dict[str, Any]
Problems = dict[tuple[int, str], str]  # a sentence by the row and the key of its cell
MOST_SHOWN = 40  # characters of a text in a sentence


@dataclass(frozen=True)
class Column:
    """A column: its key with its unit as suffix, what its cells hold, and the choices of a "choice".

    rows: several lists of numbers in one cell, "5 0.03 0.07; 8 0.05 0.09". is_needed: whether a cell may not be empty.
    """

    key: str
    kind: Kind = "number"
    choices: tuple[str, ...] = ()
    is_needed: bool = False


@dataclass
class Row:
    """A row while it is edited: its texts by key, and what the file holds of it besides."""

    texts: dict[str, str]
    kept: Any = None


class Library(Protocol):
    """A kind of table: its columns, the rows that are there, and where they are read and written.

    A row's values are by the columns' keys, None where a cell is empty. ENDINGS: of files that it imports and exports.
    """

    ENDINGS: tuple[str, ...]
    columns: tuple[Column, ...]

    def rows(self) -> list[tuple[Values, Any]]:
        """Return the values of each row, and what its file holds besides; raises JobError for a bad file."""

    def new_row(self, rows: Sequence[Values]) -> Values:
        """Return the values of a row that is added to others."""

    def judge(self, rows: Sequence[Values]) -> Problems:
        """Return what is wrong with rows that can be read."""

    def save(self, rows: Sequence[tuple[Values, Any]]) -> Path:
        """Write the user's file; raises JobError or OSError."""

    def read(self, path: Path) -> tuple[list[tuple[Values, Any]], list[str]]:
        """Return the rows of another file, and notes on what is left out; raises JobError."""

    def write(self, rows: Sequence[tuple[Values, Any]], path: Path) -> list[str]:
        """Write another file, and return notes on what is left out; raises JobError."""


@dataclass
class TableDraft:
    """The rows of a library while they are edited."""

    library: Library
    table: list[Row] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.begin()

    def begin(self) -> None:
        """Hold what the library's file holds; what was typed is forgotten. Raises JobError for a bad file."""
        self.table = [self._row(values, kept) for values, kept in self.library.rows()]
        self._begun = self._texts()

    @property
    def is_changed(self) -> bool:
        """Whether something was typed that the file does not hold."""
        return self._texts() != self._begun

    def add(self, after: int) -> int:
        """Add a row behind another one and return its number."""
        values, _ = self._read(Problems())
        self.table.insert(after + 1, self._row(self.library.new_row(values)))
        return after + 1

    def duplicate(self, number: int) -> int:
        """Add a copy of a row, with the keys of its own that a new row has."""
        added = self.add(number)
        fresh = self.table[added].texts
        own = {key: text for key, text in fresh.items() if key in OF_ONE_ROW}
        self.table[added].texts = {**self.table[number].texts, **own}
        return added

    def delete(self, numbers: Iterable[int]) -> None:
        """Delete rows."""
        for number in sorted(set(numbers), reverse=True):
            del self.table[number]

    def found(self, words: str) -> list[int]:
        """Return the rows whose cells hold each of the words, whatever their case."""
        wanted = words.casefold().split()
        lines = [" ".join(row.texts.values()).casefold() for row in self.table]
        return [number for number, line in enumerate(lines) if all(word in line for word in wanted)]

    def judged(self) -> tuple[list[tuple[Values, Any]], Problems]:
        """Return the values of all rows, and what is wrong with cells."""
        problems = Problems()
        values, readable = self._read(problems)
        for (place, key), sentence in self.library.judge([values[number] for number in readable]).items():
            problems.setdefault((readable[place], key), sentence)
        return [(one, row.kept) for one, row in zip(values, self.table, strict=True)], problems

    def save(self) -> Path:
        """Write the rows, which must be sound, into the library's file."""
        rows, _ = self.judged()
        path = self.library.save(rows)
        self.begin()
        return path

    def import_file(self, path: Path) -> list[str]:
        """Add the rows of a file at the end, and return notes on what is left out; raises JobError."""
        rows, notes = self.library.read(path)
        for values, kept in rows:
            taken = [found for found, _ in self.judged()[0]]
            fresh = self.library.new_row(taken)
            doubled = [
                key for key in OF_ONE_ROW if key in values and any(values[key] == each.get(key) for each in taken)
            ]
            self.table.append(self._row({**values, **{key: fresh[key] for key in doubled}}, kept))
        return notes

    def export_file(self, path: Path, numbers: Sequence[int]) -> list[str]:
        """Write some rows, which must be sound, into a file, and return notes on what is left out; raises JobError."""
        rows, _ = self.judged()
        return self.library.write([rows[number] for number in numbers], path)

    # --- inside ------------------------------------------------------------------------------------

    def _row(self, values: Mapping[str, Any], kept: Any = None) -> Row:
        return Row({column.key: text_of(values.get(column.key)) for column in self.library.columns}, kept)

    def _texts(self) -> list[dict[str, str]]:
        return [copy.copy(row.texts) for row in self.table]

    def _read(self, problems: Problems) -> tuple[list[Values], list[int]]:
        """Return the values of all rows, and the numbers of those whose texts are all values."""
        values, readable = [], []
        for number, row in enumerate(self.table):
            found = Values()
            for column in self.library.columns:
                try:
                    found[column.key] = value_of(row.texts.get(column.key, ""), column)
                except ValueError as error:
                    problems[number, column.key] = error.args[0]
            values.append(found)
            if len(found) == len(self.library.columns):
                readable.append(number)
        return values, readable


OF_ONE_ROW = ("number", "key")  # the keys by which rows are told apart


def text_of(value: Any) -> str:
    """Return a value as it is typed; "" for none."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return f"{value:.10g}"
    if isinstance(value, list | tuple):
        return "; ".join(" ".join(f"{number:.10g}" for number in row) for row in value)
    return str(value)


def value_of(text: str, column: Column) -> Any:
    """Return the value of a text, None for an empty one; raises ValueError with the sentence."""
    text = text.strip()
    if not text:
        if column.is_needed:
            raise ValueError(Text("{key} is missing", key=column.key))
        return None
    if column.kind == "choice" and text not in column.choices:
        raise ValueError(Text("{key} must be one of: {choices}", key=column.key, choices=", ".join(column.choices)))
    if column.kind == "rows":
        return tuple(tuple(map(number_of, row.split())) for row in text.split(";") if row.strip())
    if column.kind in ("number", "whole"):
        number = number_of(text)
        if column.kind == "whole" and not number.is_integer():
            raise ValueError(Text("'{text}' is no whole number", text=printable(text, MOST_SHOWN)))
        return int(number) if column.kind == "whole" else number
    return text == "true" if column.choices == ("true", "false") else text


def model_problem(model: type[BaseModel], content: Mapping[str, Any]) -> tuple[tuple[str, ...], str] | None:
    """Return the place and the sentence of what is wrong with the content of a model, None where it is sound."""
    try:
        model.model_validate(dict(content))
    except ValidationError as error:
        first = error.errors()[0]
        return tuple(map(str, first["loc"])), refusal_of(model, error, "").sentence
    return None


def doubled(rows: Sequence[Values], key: str) -> Problems:
    """Return a problem at each row whose value of a key an earlier row has already."""
    seen, problems = set(), Problems()
    for number, row in enumerate(rows):
        if row[key] in seen:
            problems[number, key] = Text("another row has {key} {value} already", key=key, value=row[key])
        seen.add(row[key])
    return problems


def unknown_ending(path: Path, endings: Sequence[str]) -> JobError:
    """Return the error for a file that the library cannot read or write."""
    advice = Text("give a file that ends in {endings}", endings=", ".join(endings))
    return JobError("library-kind", Text("'{path}' is no file of this library", path=path.name), advice=advice)


def number_of(text: str) -> float:
    """Return a number; its one decimal sign is a point or a comma. Raises ValueError with the sentence."""
    if text.count(",") + text.count(".") <= 1:
        try:
            number = float(text.replace(",", "."))
            if abs(number) < float("inf"):
                return number
        except ValueError:
            pass
    raise ValueError(Text("'{text}' is no number", text=printable(text, MOST_SHOWN)))
