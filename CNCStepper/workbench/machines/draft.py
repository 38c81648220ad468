# SPDX-License-Identifier: LGPL-2.1-or-later
"""A profile while it is changed: every value as typed, and its error; no Qt.

    content (TOML) ──► texts ──typed──► texts ──► content and problems ──► a machine, or the problem of each field

A text that is no value is kept as it is, and so is all that the profile holds beside the rows: nothing is lost.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from CNCStepper.machine.files.toml_text import put
from CNCStepper.machine.files.validation_errors import message_of
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.wiring import STANDARD_PINS, Signals
from CNCStepper.workbench.machines.declaration import (
    CHECK,
    EITHER,
    NUMBER,
    NUMBERS,
    PINS,
    POINTS,
    SET,
    WHOLE,
    WORDS,
    Path,
    Row,
    rows,
    tables,
)
from CNCStepper.workbench.panels.field_errors import sentence_of
from CNCStepper.workbench.panels.number_input import Refused, tidied
from CNCStepper.workbench.services.translation import later

MISSING = later("A value is missing here")
NO_NUMBER = later("'{0}' is no number")
NO_WHOLE = later("'{0}' is no whole number")
POINT_FORM = later("write points as: 0 1.2; 300 1.0")
TRUE = "true"
ADDRESS = ("signals", "base")  # that people know in hexadecimal figures
ROWS = tuple(rows())
TABLES = {table.key: table for table in tables()}
Problems = dict[Path, Refused]


class Draft:
    """The texts of one profile; `name` is that of its file.

    texts: of each row. pins: of each signal. lists: of each list of tables, the texts of each of its entries.
    """

    def __init__(self, name: str, content: Mapping[str, Any]):
        self.name = name
        self.begin(content)

    def begin(self, content: Mapping[str, Any]) -> None:
        """Hold what a file holds; what was typed is forgotten."""
        self._content: dict[str, Any] = copy.deepcopy(dict(content))
        self.texts = {row.path: text_of(_value_at(content, row.path), row) for row in ROWS}
        self.pins = {str(name): _number_text(pin) for name, pin in (_value_at(content, PINS) or {}).items()}
        self.lists = {
            key: [{row.path[-1]: text_of(entry.get(row.path[-1]), row) for row in table.columns} for entry in entries]
            for key, table in TABLES.items()
            if isinstance(entries := content.get(key, []), list)
        }
        self._begun = self._state()

    @property
    def is_changed(self) -> bool:
        """Whether something was typed that the file does not hold."""
        return self._state() != self._begun

    def content(self) -> tuple[dict[str, Any], Problems]:
        """Return what the texts say, and those that say nothing."""
        content, problems = copy.deepcopy(self._content), Problems()
        for row in ROWS:
            self._take(content, problems, row, row.path, self.texts[row.path], _value_at(self._content, row.path))
        self._take_pins(content, problems)
        for key, entries in self.lists.items():
            self._take_list(content, problems, key, entries)
        return _without_empty(content), problems

    def judged(self) -> tuple[dict[str, Any], Problems]:
        """Return the content with all that is wrong with it: of single texts, and of the machine as a whole.

        A problem of the whole stands at the row that it names first, or at ().
        """
        content, problems = self.content()
        try:
            Machine.model_validate(content)
        except ValidationError as error:
            for problem in error.errors():
                path = self._row_of(problem)
                problems.setdefault(path, _refused(path, problem))
        return content, problems

    @property
    def signals(self) -> tuple[str, ...]:
        """The signals that may have a pin: those of the motors typed, and those that have one."""
        motors = tuple(self.texts[("signals", "motors")].replace(",", " ").split())
        try:
            known = Signals.model_validate({"motors": motors} if motors else {}).lines
        except ValidationError:
            known = Signals().lines
        return (*known, *(name for name in self.pins if name not in known))

    def standard_pin(self, signal: str) -> int | None:
        """Return the pin of a signal in a profile that gives none."""
        return None if any(self.pins.values()) else STANDARD_PINS.get(signal)

    # --- inside ----------------------------------------------------------------------------------

    def _state(self) -> Any:
        return copy.deepcopy((self.texts, {key: pin for key, pin in self.pins.items() if pin}, self.lists))

    def _take(self, content: dict[str, Any], problems: Problems, row: Row, path: Path, text: str, before: Any) -> None:
        """Put the value of a text into the content; one that was not changed stays what it was."""
        if text == text_of(before, row):
            return
        try:
            put(content, path, value_of(text, row))
        except Refused as refused:
            problems[path] = refused
        except KeyError:
            problems[path] = Refused(MISSING)

    def _take_pins(self, content: dict[str, Any], problems: Problems) -> None:
        row = Row(PINS, WHOLE)
        for name in (*self.pins, *(_value_at(self._content, PINS) or {})):
            before = (_value_at(self._content, PINS) or {}).get(name)
            self._take(content, problems, row, (*PINS, name), self.pins.get(name, ""), before)

    def _take_list(self, content: dict[str, Any], problems: Problems, key: str, entries: list[dict[str, str]]) -> None:
        found = []
        for number, entry in enumerate(entries):
            values: dict[str, Any] = {}
            for row in TABLES[key].columns:
                path = (key, str(number), row.path[-1])
                self._take(values, problems, row, row.path[-1:], entry.get(row.path[-1], ""), None)
                if row.path[-1:] in problems:
                    problems[path] = problems.pop(row.path[-1:])
            found.append(values)
        if found or key in content:
            content[key] = found

    def _row_of(self, problem: Any) -> Path:
        """Return the row of a problem: the one at its place, or below it the one that its sentence names."""
        place = tuple(str(part) for part in problem["loc"])
        known = {*self.texts, *((*PINS, name) for name in self.signals)}
        known |= {
            (key, str(number), column.path[-1])
            for key, entries in self.lists.items()
            for number in range(len(entries))
            for column in TABLES[key].columns
        }
        for length in range(len(place), 0, -1):
            if place[:length] in known:
                return place[:length]
        words = message_of(problem)
        if listed := [key for key in self.lists if words.startswith(f"{key}:")]:
            return (listed[0],)
        named = [path for path in known if path[: len(place)] == place and path[-1] in words]
        first = min(named, key=lambda path: (words.index(path[-1]), path), default=())
        return first or min((path for path in known if place and path[: len(place)] == place), default=())


def text_of(value: Any, row: Row) -> str:
    """Return a value of a profile as it is typed; "" for none."""
    if value is None:
        return ""
    if row.kind == POINTS and isinstance(value, (list, tuple)):
        return "; ".join(" ".join(map(_number_text, point)) for point in value)
    if row.kind in (SET, WORDS, NUMBERS) and isinstance(value, (list, tuple)):
        return " ".join(one if isinstance(one, str) else _number_text(one) for one in value)
    if row.path == ADDRESS and isinstance(value, int):
        return f"0x{value:X}"
    if isinstance(value, bool):
        return TRUE if value else ""
    return value if isinstance(value, str) else _number_text(value)


def value_of(text: str, row: Row) -> Any:
    """Return the value of a text, None for an empty one; raises Refused."""
    text = text.strip()
    if not text:
        return None
    if row.kind in (SET, WORDS):
        return text.replace(",", " ").split()
    if row.kind == NUMBERS:
        return [_number(part) for part in text.split()]
    if row.kind == POINTS:
        points = [[_number(part) for part in point.split()] for point in text.split(";") if point.strip()]
        if any(len(point) != 2 for point in points):
            raise Refused(POINT_FORM)
        return points
    if row.kind == CHECK:
        return text == TRUE
    if row.kind == NUMBER:
        return _number(text)
    if row.kind == WHOLE:
        return _whole(text)
    return int(text) if row.kind == EITHER and text.isdecimal() else text


def _number(text: str) -> float | int:
    text = tidied(text)
    try:
        number = float(text)
    except ValueError as error:
        raise Refused(NO_NUMBER, text[:20]) from error
    return int(number) if number.is_integer() and abs(number) < 1e15 else number


def _whole(text: str) -> int:
    text = text.strip()
    try:
        return int(text, 16) if text.lower().startswith("0x") else int(text)
    except ValueError as error:
        raise Refused(NO_WHOLE, text[:20]) from error


def _number_text(value: Any) -> str:
    return f"{value:.10g}" if isinstance(value, (int, float)) and not isinstance(value, bool) else str(value)


def _value_at(content: Mapping[str, Any], path: Path) -> Any:
    found: Any = content
    for part in path:
        if not isinstance(found, Mapping):
            return None
        found = found.get(part)
    return found


def _without_empty(content: dict[str, Any]) -> dict[str, Any]:
    """Return tables without those in which nothing is left: a table that is not there is left out."""
    inner = {key: _without_empty(one) if isinstance(one, dict) else one for key, one in content.items()}
    return {key: one for key, one in inner.items() if one != {}}


def _refused(path: Path, problem: Any) -> Refused:
    if problem["type"] == "missing":
        return Refused(MISSING)
    if isinstance(problem.get("ctx", {}).get("error"), ValueError):
        return Refused("{0}", message_of(problem))
    unit = next((row.unit for row in ROWS if row.path == path), "")
    return sentence_of(".".join(path), problem, lambda _, number: f"{number:.10g} {unit}".rstrip())
