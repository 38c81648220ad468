# SPDX-License-Identifier: LGPL-2.1-or-later
"""One root for every refusal: a code, the place, the value, the limit, and what to do.

A sentence with values is a `Text`: English for everybody, template and values for a window in another language.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import reduce
from numbers import Number
from typing import Any

from CNCStepper.safe_text import printable

NUMBER_OF_SYSTEM = re.compile(r"\[(?:Errno|WinError) -?\d+\] ?")
MOST_CHARACTERS = 4000  # of a part of a sentence: what a file or a library says may be of any length


@dataclass(frozen=True)
class Place:
    """Where in a file something stands; lines and columns count from 1, 0 means "not known"."""

    file: str = ""
    line: int = 0
    column: int = 0

    def __str__(self) -> str:
        parts = [printable(self.file) or "<text>"]
        if self.line:
            parts.append(str(self.line))
            if self.column:
                parts.append(str(self.column))
        return ":".join(parts)


class Text(str):
    """A sentence in English that keeps its template and its values: `Text("{key} is too long", key=key)`.

    Numbers, strings and texts stay values as they are; an error becomes its text,
    one of the operating system its words without the number, anything else its str().
    """

    __slots__ = ("template", "values")
    template: str
    values: dict[str, Any]

    def __new__(cls, template: str, /, **values: object) -> Text:
        kept = {name: _value(value) for name, value in values.items()}
        text = super().__new__(cls, template.format_map(kept))
        text.template, text.values = template, kept
        return text

    def translated(self, look_up: Callable[[str], str]) -> str:
        """Return the text in another language: template and values of type str looked up, numbers as they are."""
        values = {name: _translated(value, look_up) for name, value in self.values.items()}
        return look_up(self.template).format_map(values)

    def __reduce__(self) -> tuple[Callable[..., Text], tuple[str, dict[str, Any]]]:
        return _text, (self.template, self.values)

    def __deepcopy__(self, memo: object) -> Text:
        return self


def _value(value: object) -> Any:
    if isinstance(value, str | int | float):
        return value
    if isinstance(value, Number) and hasattr(value, "item"):  # of NumPy
        return value.item()
    if isinstance(value, ValueError) and value.args and isinstance(value.args[0], Text):  # of a model's own check
        return value.args[0]
    if isinstance(value, CNCStepperError):
        return value.text
    return NUMBER_OF_SYSTEM.sub("", str(value)) if isinstance(value, OSError) else str(value)


def _translated(value: Any, look_up: Callable[[str], str]) -> Any:
    if isinstance(value, Text):
        return value.translated(look_up)
    return look_up(value) if isinstance(value, str) and value else value


def _text(template: str, values: dict[str, Any]) -> Text:
    return Text(template, **values)


def joined(separator: str, parts: Iterable[str]) -> str:
    """Return texts with `separator` between them as one text, "" for none."""
    values = {f"part{number}": part for number, part in enumerate(parts, 1)}
    if len(values) < 2:
        return values.get("part1", "")
    return Text(separator.join(f"{{{name}}}" for name in values), **values)


def one_of(parts: Iterable[str]) -> str:
    """Return texts as "a or b or c", "" for none."""
    return reduce(lambda one, other: Text("{one} or {other}", one=one, other=other) if one else other, parts, "")


def all_of(parts: Iterable[str]) -> str:
    """Return texts as "a and b and c", "" for none."""
    return reduce(lambda one, other: Text("{one} and {other}", one=one, other=other) if one else other, parts, "")


def _printable(text: str) -> str:
    """Return a text bounded and on one line; template and values stay, where they give the same."""
    safe = printable(text, MOST_CHARACTERS)
    if safe == text:
        return text
    if not isinstance(text, Text):
        return safe
    values = {name: _printable(value) if isinstance(value, str) else value for name, value in text.values.items()}
    again = Text(text.template, **values)
    return again if again == safe else safe


class CNCStepperError(Exception):
    """The root of all errors of this project.

    `what` is one sentence without a full stop; `advice` says what to change. `value` and `limit`
    already carry their units, as in "12.5 mm". What came into them from outside is made printable.
    """

    def __init__(
        self,
        code: str,
        what: str,
        *,
        advice: str = "",
        value: str = "",
        limit: str = "",
        place: Place | None = None,
    ):
        self.code = code
        self.what = _printable(what)
        self.advice = _printable(advice)
        self.value = _printable(value)
        self.limit = _printable(limit)
        self.place = place
        super().__init__(str(self))

    @property
    def sentence(self) -> str:
        """What is wrong and what to do, for a person who sees the place."""
        value = Text("value {value}", value=self.value) if self.value else ""
        limit = Text("limit {limit}", limit=self.limit) if self.limit else ""
        numbers = joined(", ", filter(None, (value, limit)))
        what = Text("{what} ({numbers})", what=self.what, numbers=numbers) if numbers else self.what
        return joined("; ", filter(None, (what, self.advice)))

    @property
    def text(self) -> Text:
        """The whole error, as `str()` gives it in English."""
        whole = Text("{sentence} [{code}]", sentence=self.sentence, code=self.code)
        return Text("{place}: {error}", place=self.place, error=whole) if self.place else whole

    def __str__(self) -> str:
        return str(self.text)

    def __reduce__(self) -> tuple[Callable[..., CNCStepperError], tuple[object, ...]]:
        return _error, (type(self), self.code, self.what, self._rest())

    def at(self, place: Place | None) -> CNCStepperError:
        """Return the same error, naming `place`, or none."""
        return type(self)(self.code, self.what, **(self._rest() | {"place": place}))

    def _rest(self) -> dict[str, Any]:
        return {"advice": self.advice, "value": self.value, "limit": self.limit, "place": self.place}


def _error(kind: type[CNCStepperError], code: str, what: str, rest: dict[str, Any]) -> CNCStepperError:
    return kind(code, what, **rest)


@contextmanager
def placed(place: Place) -> Iterator[None]:
    """Give an error that leaves this block `place`, where it names none of its own."""
    try:
        yield
    except CNCStepperError as error:
        if error.place:
            raise
        raise error.at(place) from error


class GeometryError(CNCStepperError, ValueError):
    """A curve or region that cannot be used as it is."""


class CycleError(CNCStepperError, ValueError):
    """Parameters from which no safe cut can be made."""


class ProgramError(CNCStepperError, ValueError):
    """Program text that is refused."""


class JobError(CNCStepperError, ValueError):
    """A job, tool or machine file that is refused."""


class LinkError(CNCStepperError, OSError):
    """A port or a controller that does not answer as it should."""


class MachineRefusal(CNCStepperError, RuntimeError):
    """A controller that is not in the state to do what was asked."""


class OutputError(CNCStepperError, FileExistsError):
    """A file that is not written, because something would be lost."""


class MissingPackage(CNCStepperError, ImportError):
    """An optional package that is not installed."""


def missing_package(name: str) -> MissingPackage:
    """Return the error for a package that is not installed; `name` as pip knows it."""
    what = Text("{package} is not installed", package=name)
    advice = Text("install it: python -m pip install {package}", package=name)
    return MissingPackage(f"{name}-missing", what, advice=advice)
