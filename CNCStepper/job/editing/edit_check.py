# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an edited program may be written: it can be read and sent, and the checks find no new or greater error."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.job.wire_round_trip import wire_round_trip
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start

NO_FARTHER = 1.001  # how far beyond a limit counts as no farther: an edit rounds


@dataclass(frozen=True)
class EditCheck:
    """What an edit is checked against; without a machine only whether it can be read and sent in its dialect."""

    dialect: str | Dialect = "grbl"
    start: Start | None = None
    file: str = ""
    machine: Machine | None = None
    stock: Stock | None = None
    tools: dict[int, Tool] | Tool | None = None

    def new_errors(self, before: str, after: str) -> list[Finding]:
        """Return the errors of the program `after` that are none of `before`: more of a kind, or farther over a limit.

        Raises ProgramError where the new one cannot be read or sent.
        """
        errors = self._errors(after)
        had = _beyond(self._errors_of_old(before)) if errors else {}
        found: list[Finding] = []
        for code, new in _by_code(errors).items():
            old = had.get(code, [])
            if len(new) > len(old):
                found += new
            else:
                found += [
                    one for one, beyond in zip(new, old, strict=False) if _beyond_limit(one) > NO_FARTHER * beyond
                ]
        return found

    def _errors_of_old(self, text: str) -> list[Finding]:
        try:
            return self._errors(text)
        except ProgramError:  # it could be read, or there were no edit; it could not be sent, the new one can
            return []

    def _errors(self, text: str) -> list[Finding]:
        _, motors, toolpath = wire_round_trip(text, self.machine, self.dialect, self.file, self.start)
        if self.machine is None:
            return []
        found = check(toolpath, self.machine, file=self.file, stock=self.stock, tools=self.tools, motors=motors)
        return [finding for finding in found if finding.severity == "error"]


def _by_code(findings: list[Finding]) -> dict[str, list[Finding]]:
    """Return the findings of each kind, the farthest over its limit first."""
    found: defaultdict[str, list[Finding]] = defaultdict(list)
    for finding in sorted(findings, key=_beyond_limit, reverse=True):
        found[finding.code].append(finding)
    return found


def _beyond(findings: list[Finding]) -> dict[str, list[float]]:
    return {code: [_beyond_limit(finding) for finding in own] for code, own in _by_code(findings).items()}


def _beyond_limit(finding: Finding) -> float:
    """Return how far a finding's value lies beyond its limit, 0 where it has none."""
    if finding.value is None or finding.limit is None:
        return 0.0
    return abs(finding.value - finding.limit)
