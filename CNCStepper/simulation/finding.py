# SPDX-License-Identifier: LGPL-2.1-or-later
"""A finding: one thing that a check saw, with its place, value, limit and what to do."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Any, Literal, get_args

from CNCStepper.errors import Place, Text, joined

Severity = Literal["error", "warning", "info"]
SEVERITIES: tuple[Severity, ...] = get_args(Severity)  # the worst first
MOST_LISTED = 1000  # findings of one code and severity that are listed one by one


@dataclass(frozen=True)
class Finding:
    """One thing that a check saw.

    code: stable name of the rule. place: file, line and column of the block. place_mm: work coordinates,
    or None where the finding has no place on the part. value, limit: numbers in `unit`, or None.
    text: one sentence without a full stop. advice: what to change. count: moves with the same finding.
    group: findings of one code and group in several parts of a program are one finding: the text and the numbers of the
    highest `rank`, all their moves, and the place of the first one where `at_first`, else that of the highest rank.
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
    group: str | None = field(default=None, compare=False, repr=False)
    rank: float = field(default=0.0, compare=False, repr=False)
    at_first: bool = field(default=True, compare=False, repr=False)

    def __str__(self) -> str:
        return str(self.line)

    @property
    def line(self) -> Text:
        """The whole finding on one line, as `str()` gives it in English."""
        told = Text("{text} ({numbers})", text=self.text, numbers=numbers) if (numbers := self._numbers) else self.text
        sentence = joined("; ", filter(None, (told, self.advice)))
        begin = f"{self.place}: {self.severity}"
        return Text("{begin}: {sentence} [{code}]", begin=begin, sentence=sentence, code=self.code)

    @property
    def _numbers(self) -> str:
        """Where on the part, value, limit and how many moves, as far as they are known."""
        parts = list[Text]()
        if self.place_mm is not None:
            words = (f"{name}{mm + 0.0:.7g}" for name, mm in zip("XYZ", self.place_mm, strict=False))
            parts.append(Text("at {place} mm", place=" ".join(words)))
        if self.value is not None:
            parts.append(Text("value {value}", value=f"{self.value:.7g} {self.unit}".rstrip()))
        if self.limit is not None:
            parts.append(Text("limit {limit}", limit=f"{self.limit:.7g} {self.unit}".rstrip()))
        if self.count > 1:
            parts.append(Text("{count} moves", count=self.count))
        return joined(", ", parts)

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


class Findings:
    """The findings of a program that is checked part after part, in the order of its rows.

    However many there are, at most MOST_LISTED of one code and severity are kept, and how many more there were:
    warnings never hide an error, so that the verdict is that of all.
    """

    def __init__(self) -> None:
        self._found: list[Finding] = []
        self._places: dict[tuple[str, str], int] = {}  # of a group among them
        self._listed: Counter[tuple[str, str]] = Counter()  # by code and severity
        self._more: dict[tuple[str, str], int] = {}  # place of the finding that counts the rest

    def add(self, found: Iterable[Finding]) -> None:
        """Take the findings of one part."""
        for one in found:
            place = None if one.group is None else self._places.get((one.code, one.group))
            if place is not None:
                self._found[place] = _as_one(self._found[place], one)
            elif self._listed[one.code, one.severity] < MOST_LISTED:
                self._list(one)
            else:
                self._count(one)

    def _list(self, one: Finding) -> None:
        self._listed[one.code, one.severity] += 1
        if one.group is not None:
            self._places[one.code, one.group] = len(self._found)
        self._found.append(one)

    def _count(self, one: Finding) -> None:
        """Count a finding that is not listed any more."""
        place = self._more.setdefault((one.code, one.severity), len(self._found))
        if place < len(self._found):
            self._found[place] = replace(self._found[place], count=self._found[place].count + one.count)
        else:
            text = "from here on findings of this kind are not listed"
            advice = "correct those that are, and check again"
            self._found.append(Finding(one.severity, one.code, one.place, text, advice, count=one.count))

    def all(self) -> list[Finding]:
        """Return all that are kept, the worst first."""
        return worst_first(self._found)


def _as_one(before: Finding, after: Finding) -> Finding:
    """Return one finding for those of two parts of a program."""
    worst = after if after.rank > before.rank else before
    placed = before if worst.at_first else worst
    return replace(worst, place=placed.place, place_mm=placed.place_mm, count=before.count + after.count)


def worst_first(findings: Iterable[Finding]) -> list[Finding]:
    """Return findings in the order in which all lists show them: by severity, then by line."""
    return sorted(findings, key=lambda one: (SEVERITIES.index(one.severity), one.place.line, one.code))


def refused(findings: list[Finding]) -> bool:
    """Return whether any of the findings forbids sending the program."""
    return any(finding.severity == "error" for finding in findings)
