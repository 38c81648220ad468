# SPDX-License-Identifier: LGPL-2.1-or-later
"""One root for every refusal: a code, the place, the value, the limit, and what to do."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Place:
    """Where in a file something stands; lines and columns count from 1, 0 means "not known"."""

    file: str = ""
    line: int = 0
    column: int = 0

    def __str__(self) -> str:
        parts = [self.file or "<text>"]
        if self.line:
            parts.append(str(self.line))
            if self.column:
                parts.append(str(self.column))
        return ":".join(parts)


class CNCStepperError(Exception):
    """The root of all errors of this project.

    `what` is one sentence without a full stop; `advice` says what to change. `value` and `limit`
    already carry their units, as in "12.5 mm".
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
        self.what = what
        self.advice = advice
        self.value = value
        self.limit = limit
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


class MissingPackage(CNCStepperError, ImportError):
    """An optional package that is not installed."""
