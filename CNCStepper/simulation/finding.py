# SPDX-License-Identifier: LGPL-2.1-or-later
"""A finding: one thing that a check saw, with its place, value, limit and what to do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from CNCStepper.errors import Place

Severity = Literal["error", "warning", "info"]


@dataclass(frozen=True)
class Finding:
    """One thing that a check saw.

    code: stable name of the rule. place: file, line and column of the block. place_mm: work coordinates,
    or None where the finding has no place on the part. value, limit: numbers in `unit`, or None.
    text: one sentence without a full stop. advice: what to change. count: moves with the same finding.
    """

    severity: Severity
    code: str
    place: Place
    text: str
    advice: str = ""
    place_mm: tuple[float, ...] | None = None
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    count: int = 1

    def __str__(self) -> str:
        numbers = [
            f"{name} {number:.7g} {self.unit}".rstrip()
            for name, number in (("value", self.value), ("limit", self.limit))
            if number is not None
        ]
        more = [f"{self.count} moves"] if self.count > 1 else []
        if self.place_mm is not None:
            numbers.insert(
                0, "at " + " ".join(f"{n}{v + 0.0:.7g}" for n, v in zip("XYZ", self.place_mm, strict=False)) + " mm"
            )
        brackets = f" ({', '.join(numbers + more)})" if numbers or more else ""
        advice = f"; {self.advice}" if self.advice else ""
        return f"{self.place}: {self.severity}: {self.text}{brackets}{advice} [{self.code}]"

    def as_dict(self) -> dict[str, Any]:
        """Return the finding with the keys of the JSON report."""
        return {
            "severity": self.severity,
            "code": self.code,
            "file": self.place.file,
            "line": self.place.line,
            "column": self.place.column,
            "place_mm": None if self.place_mm is None else [round(float(v), 6) for v in self.place_mm],
            "value": None if self.value is None else round(float(self.value), 6),
            "limit": None if self.limit is None else round(float(self.limit), 6),
            "unit": self.unit,
            "count": self.count,
            "text": self.text,
            "advice": self.advice,
        }

    @classmethod
    def from_dict(cls, content: dict[str, Any]) -> Finding:
        """Return the finding of `as_dict`, after its way through JSON."""
        rest = dict(content)
        place = Place(rest.pop("file"), rest.pop("line"), rest.pop("column"))
        place_mm = rest.pop("place_mm")
        return cls(place=place, place_mm=None if place_mm is None else tuple(place_mm), **rest)


def refused(findings: list[Finding]) -> bool:
    """Return whether any of the findings forbids sending the program."""
    return any(finding.severity == "error" for finding in findings)
