# SPDX-License-Identifier: LGPL-2.1-or-later
"""However much a program is wrong in, few findings are kept, and none that decides whether it is refused is lost."""

from __future__ import annotations

from collections.abc import Iterator

from CNCStepper.errors import Place
from CNCStepper.simulation.finding import MOST_LISTED, Finding, Findings, Severity, refused

MANY = 3 * MOST_LISTED


def found(severity: Severity, count: int, group: str = "") -> Iterator[Finding]:
    """Yield findings of one code, in groups of their own where `group` begins their names."""
    for line in range(1, count + 1):
        yield Finding(
            severity, "spin-up", Place("p.nc", line, 1), "too soon", group=f"{group}{line}" if group else None
        )


def test_of_many_the_first_are_listed_and_the_others_counted() -> None:
    findings = Findings()
    findings.add(found("warning", MANY))
    *listed, more = findings.all()
    assert len(listed) == MOST_LISTED and more.count == MANY - MOST_LISTED
    assert more.place.line == MOST_LISTED + 1 and "not listed" in more.text


def test_an_error_behind_many_warnings_of_its_kind_still_refuses() -> None:
    findings = Findings()
    findings.add(found("warning", MANY))
    assert not refused(findings.all())
    findings.add([Finding("error", "spin-up", Place("p.nc", 9000, 1), "far too soon")])
    assert refused(findings.all()) and findings.all()[0].text == "far too soon"


def test_groups_are_bounded_too_and_those_that_are_listed_go_on_counting() -> None:
    findings = Findings()
    for _ in range(2):
        findings.add(found("error", MANY, "clamp"))
    kept = findings.all()
    assert len(kept) == MOST_LISTED + 1 and kept[0].count == 2
    assert sum(one.count for one in kept) == 2 * MANY
