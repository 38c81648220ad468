# SPDX-License-Identifier: LGPL-2.1-or-later
"""All checks of a program that was read back from its text, as one list of findings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import MILLING, Process
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.check_context import CheckContext, Cutting, PartCheck
from CNCStepper.simulation.checks import corner_checks, machine_checks, motor_checks
from CNCStepper.simulation.finding import Finding, Findings
from CNCStepper.toolpath import Toolpath

if TYPE_CHECKING:  # modules for the stock are loaded where there is one: a short check takes half the time without
    from shapely.geometry.base import BaseGeometry

    from CNCStepper.cycles.cycle import Removal
    from CNCStepper.simulation.checks.clamps import Clamp
    from CNCStepper.simulation.checks.load_checks import Loads
    from CNCStepper.simulation.checks.stock_checks import StillSpindle
    from CNCStepper.simulation.cutter_solid import Tools
    from CNCStepper.simulation.exact.beams import Beams
    from CNCStepper.simulation.exact.free_pieces import SheetVerdict
    from CNCStepper.simulation.exact.stored_cuts import StoredCuts
    from CNCStepper.simulation.exact.swept_area import Judgement
    from CNCStepper.simulation.stock import Stock

ROW_CHECKS: tuple[Callable[[CheckContext], Iterator[Finding]], ...] = (
    machine_checks.rates,
    motor_checks.motors,
)  # each row alone
PART_CHECKS: tuple[type[PartCheck], ...] = (
    machine_checks.Travel,
    machine_checks.Starts,
    machine_checks.Outputs,
    machine_checks.SpinUp,
    machine_checks.ToolChanges,
    corner_checks.Blended,
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
    process: Process = MILLING,
    cut_data: CutData | None = None,
    parts: Sequence[BaseGeometry] = (),
    sheet: SheetVerdict | None = None,
) -> list[Finding]:
    """Return the findings of a program, the worst first; an empty list for a clean program.

    Whether the work zero is known says `toolpath.start`. tools: by number, or one tool that stands for
    every number. Checks that need a stock, tools or removals are left out where these are not given; a
    `judgement` already made is used instead of judging again. How deep a gouge and how thick a rest are
    allowed say the removals. keep_out: the clamps. edge_mm: how far from the sheet's edge cuts must stay, None for
    no matter how near. cut: the moves after those of the programs that have cut the same stock before (`followed`);
    what is wrong with these, on no line, is not told again. motors: the same rows as the motors go them, where their
    axes have play: travel, rates and torque are theirs. process: one that cuts through the sheet is checked by its own
    rules too. cut_data: the row of the cut chart. parts: shapely polygons that are to be left whole. sheet: what is cut
    free of the sheet, where that is known already.
    """
    of_tool = CheckContext.of(toolpath, machine, file)
    of_motors = of_tool if motors is None or motors is toolpath else CheckContext.of(motors, machine, file)
    of_cut = of_tool if cut is None or cut is toolpath else CheckContext.of(cut, machine, file)
    cutting = Cutting(process, cut_data, parts)
    checks = Checks(stock, tools, keep_out, edge_mm, cutting=cutting)
    checks.see(of_motors, of_tool, of_cut)
    if sheet is None and cutting.is_through_sheet and tools is not None:
        from CNCStepper.simulation.exact.free_pieces import sheet_verdict

        sheet = sheet_verdict(of_cut, cutting, tools, stock)
    if judgement is None and tools is not None and removals:
        from CNCStepper.simulation.exact.swept_area import judge

        judgement = judge(of_cut.toolpath, tools, removals, stock)
    return checks.end(judgement, sheet=sheet)


class Checks:
    """All checks of a program, which may come in parts, each a whole table of consecutive rows.

    Every part must fit into memory; what the parts before have left is kept as little as it can be.
    """

    def __init__(
        self,
        stock: Stock | None = None,
        tools: Tools | None = None,
        keep_out: Sequence[Clamp] = (),
        edge_mm: float | None = None,
        kept: StoredCuts | None = None,
        cutting: Cutting | None = None,
    ):
        """kept: where the cutting paths of parts before stay; None: there is one part only."""
        self._stock, self._tools, self._keep_out, self._edge_mm = stock, tools, keep_out, edge_mm
        self._cutting = cutting or Cutting()
        self._of_process: list[PartCheck] | None = None
        self._findings = Findings()
        self._of_motors = [one() for one in PART_CHECKS]
        self._beams: Beams | None = None
        self._loads: Loads | None = None
        self._still_spindle: StillSpindle | None = None
        self._kept = kept
        self._tools_seen: set[int] = set()
        self._last: tuple[CheckContext, CheckContext] | None = None  # as the motors and as the tool go it

    def see(self, of_motors: CheckContext, of_tool: CheckContext, of_cut: CheckContext | None = None) -> None:
        """Check the next part: as the motors go it, as the tool does, and after the programs before on this stock."""
        of_cut = of_cut or of_tool
        self._last = of_motors, of_cut
        for row_check in ROW_CHECKS:
            self._findings.add(row_check(of_motors))
        for one in self._of_motors:
            self._findings.add(one(of_motors))
        if self._keep_out:
            from CNCStepper.simulation.checks.clamps import clamps

            self._findings.add(clamps(of_tool, self._tools, self._keep_out))
        self._findings.add(finding for finding in self._in_stock(of_cut) if finding.place.line)

    def end(
        self,
        judgement: Judgement | None = None,
        line: Callable[[int], int] | None = None,
        sheet: SheetVerdict | None = None,
    ) -> list[Finding]:
        """Return what was found, in the order of the lines.

        line: gives the file's line of a row that was judged, where that is not a row of the last part. sheet: what was
        cut free of it, for a process that cuts through.
        """
        if self._last:
            of_motors, of_cut = self._last
            for one in self._of_motors:
                self._findings.add(one.end(of_motors))
            at_end = (self._beams, self._loads, *(self._of_process or ()))
            found = [one for check in at_end if check for one in check.end(of_cut)]
            if sheet:
                from CNCStepper.simulation.checks.sheet_checks import sheet_findings

                found += sheet_findings(of_cut, sheet.cuts, sheet.freed)
            if judgement:
                from CNCStepper.simulation.checks.stock_checks import verdict

                found += verdict(of_cut, judgement, line, self._cutting.process)
            self._findings.add(finding for finding in found if finding.place.line)
        return self._findings.all()

    def _in_stock(self, subject: CheckContext) -> Iterator[Finding]:
        if self._tools is None:
            return
        from CNCStepper.simulation.checks.clamps import sheet_edge
        from CNCStepper.simulation.checks.stock_checks import tools_known

        yield from tools_known(subject, self._tools, self._tools_seen)
        if self._cutting.is_through_sheet:
            yield from self._as_process(subject, self._tools)
        if self._stock is not None:
            yield from self._at_stock(subject, self._stock, self._tools)
            if self._edge_mm is not None:
                yield from sheet_edge(subject, self._tools, self._stock, self._edge_mm)

    def _as_process(self, subject: CheckContext, tools: Tools) -> Iterator[Finding]:
        from CNCStepper.simulation.checks.process_checks import process_checks

        if self._of_process is None:
            self._of_process = process_checks(self._cutting, tools, self._stock)
        for one in self._of_process:
            yield from one(subject)

    def _at_stock(self, subject: CheckContext, stock: Stock, tools: Tools) -> Iterator[Finding]:
        from CNCStepper.simulation.checks import load_checks, plunge_and_drill_checks, stock_checks
        from CNCStepper.simulation.exact import beams

        self._beams = self._beams or beams.Beams(stock, tools, self._cutting.process)
        self._still_spindle = self._still_spindle or stock_checks.StillSpindle()
        yield from stock_checks.unknown_place_cuts(subject, stock)
        yield from self._beams(subject)
        checks = stock_checks.StockChecks(subject, stock, tools, self._kept or ())
        yield from checks.rapids()
        yield from self._still_spindle(checks)
        yield from checks.below()
        yield from plunge_and_drill_checks.plunges(checks)
        yield from plunge_and_drill_checks.sideways(checks)
        self._loads = self._loads or load_checks.Loads(stock, tools)
        yield from self._loads(subject)
        if self._kept is not None:
            self._kept.add(checks.cuts)
