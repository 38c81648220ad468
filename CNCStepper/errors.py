# SPDX-License-Identifier: LGPL-2.1-or-later
"""One root for every refusal: a code, the place, the value, the limit, and what to do."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from CNCStepper.safe_text import printable

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
        self.what = printable(what, MOST_CHARACTERS)
        self.advice = printable(advice, MOST_CHARACTERS)
        self.value = printable(value, MOST_CHARACTERS)
        self.limit = printable(limit, MOST_CHARACTERS)
        self.place = place
        super().__init__(str(self))

    @property
    def sentence(self) -> str:
        """What is wrong and what to do, for a person who sees the place."""
        numbers = [f"{name} {text}" for name, text in (("value", self.value), ("limit", self.limit)) if text]
        return self.what + (f" ({', '.join(numbers)})" if numbers else "") + (f"; {self.advice}" if self.advice else "")

    def __str__(self) -> str:
        place = f"{self.place}: " if self.place else ""
        return f"{place}{self.sentence} [{self.code}]"

    def at(self, place: Place) -> CNCStepperError:
        """Return the same error, naming `place`."""
        return type(self)(self.code, self.what, advice=self.advice, value=self.value, limit=self.limit, place=place)


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
