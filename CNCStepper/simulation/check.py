# SPDX-License-Identifier: LGPL-2.1-or-later
"""All checks of a program that was read back from its text, as one list of findings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from CNCStepper.cycles.form import Removal
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation import corner_checks, load_checks, machine_checks, motor_checks, stock_checks, tool_checks
from CNCStepper.simulation.beams import beams
from CNCStepper.simulation.clamps import Clamp, clamps, sheet_edge
from CNCStepper.simulation.cutter import Tools
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.subject import Subject
from CNCStepper.simulation.sweep import Judgement, judge
from CNCStepper.toolpath import Toolpath

SEVERITIES = ("error", "warning", "info")
MACHINE_CHECKS = (
    machine_checks.travel,
    machine_checks.rates,
    machine_checks.starts,
    machine_checks.outputs,
    machine_checks.spin_up,
    machine_checks.tool_changes,
    motor_checks.motors,
    corner_checks.blended,
)


def check(
    toolpath: Toolpath,
    machine: Machine,
    *,
    file: str = "",
    stock: Stock | None = None,
    tools: Tools | None = None,
    removals: Sequence[Removal] | None = None,
    judgement: Judgement | None = None,
    keep_out: Sequence[Clamp] = (),
    edge_mm: float | None = None,
    cut: Toolpath | None = None,
    motors: Toolpath | None = None,
) -> list[Finding]:
    """Return what is wrong with a program, in the order of its lines; an empty list is a clean program.

    Whether the work zero is known says `toolpath.start`. tools: by number, or one tool that stands for
    every number. Checks that need a stock, tools or removals are left out where these are not given; a
    `judgement` already made is used instead of judging again. How deep a gouge and how thick a rest are
    allowed say the removals. keep_out: the clamps. edge_mm: how far from the sheet's edge cuts must stay, None for
    no matter how near. cut: the moves after those of the programs that have cut the same stock before (`followed`);
    what is wrong with these, on no line, is not told again. motors: the same rows as the motors go them, where their
    axes have play: travel, rates and torque are theirs.
    """
    subject = Subject.of(toolpath, machine, file)
    of_motors = subject if motors is None or motors is toolpath else Subject.of(motors, machine, file)
    found = [finding for one in MACHINE_CHECKS for finding in one(of_motors)]
    found += clamps(subject, tools, keep_out)
    if cut is not None and cut is not toolpath:
        subject = Subject.of(cut, machine, file)
    found += [
        finding for finding in _in_stock(subject, stock, tools, removals, judgement, edge_mm) if finding.place.line
    ]
    return sorted(found, key=lambda finding: (finding.place.line, SEVERITIES.index(finding.severity), finding.code))


def _in_stock(
    subject: Subject,
    stock: Stock | None,
    tools: Tools | None,
    removals: Sequence[Removal] | None,
    judgement: Judgement | None,
    edge_mm: float | None,
) -> list[Finding]:
    found: list[Finding] = []
    if tools is not None:
        found += stock_checks.tools_known(subject, tools)
        if stock is not None:
            found += _at_stock(subject, stock, tools)
            if edge_mm is not None:
                found += sheet_edge(subject, tools, stock, edge_mm)
        if judgement is None and removals:
            judgement = judge(subject.toolpath, tools, removals, stock)
    if judgement is not None:
        found += stock_checks.verdict(subject, judgement)
    return found


def _at_stock(subject: Subject, stock: Stock, tools: Tools) -> Iterator[Finding]:
    yield from stock_checks.blind(subject, stock)
    yield from beams(subject, stock, tools)
    checks = stock_checks.StockChecks(subject, stock, tools)
    for one in (checks.rapids, checks.still_spindle, checks.below):
        yield from one()
    yield from tool_checks.plunges(checks)
    yield from tool_checks.sideways(checks)
    yield from load_checks.loads(subject, stock, tools)
