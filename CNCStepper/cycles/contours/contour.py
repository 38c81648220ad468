# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contour: along drawn curves, on them, inside or outside, at several depths, with tabs, leads and dog-bones.

    sides     drawn curves ---> paths of the tool's centre, exact parallels     cycles/contours/scrap_side.py
    dogbones  inside corners sharper than the tool                              cycles/contours/dogbones.py
    leads     where a path begins and how the tool comes and goes, in scrap     cycles/contours/leads.py
    tabs      where it must stay above what holds the part                      cycles/contours/tabs.py
    plan      all of these put together, in order; what is removed, warnings    cycles/contours/contour_plan.py
    run       down, along, up, level by level                                   cycles/contours/contour_levels.py

With `finish_stepover_mm` a roughing contour that much farther out is cut to the full depth first. What lies inside
an outline is cut before it.
"""

from __future__ import annotations

from CNCStepper.cycles.contours.contour_levels import run
from CNCStepper.cycles.contours.contour_model import ContourModel
from CNCStepper.cycles.contours.contour_plan import planned
from CNCStepper.cycles.contours.scrap_side import as_cycle_error
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.moves import Moves
from CNCStepper.cycles.passes import require_few_blocks
from CNCStepper.errors import GeometryError
from CNCStepper.toolpath import TableBuilder


class Contour(ContourModel):
    """A contour that can be cut."""

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the contours to `table`; raises CycleError before any row when they cannot be cut safely."""
        try:
            plan = planned(self, setup)
        except GeometryError as error:
            raise as_cycle_error(error) from error
        require_few_blocks(sum(path.blocks for path in plan.paths))
        moves, feed = Moves(table, setup), setup.tool.feed_mm_min
        for number, path in enumerate(plan.paths, start=1):
            table.open_span("contour", f"{'finishing' if path.finishing else 'roughing'} contour {number}")
            feed_here = (self.finish_feed_mm_min or feed) if path.finishing else feed
            run(path, moves, plan.tab_top_mm, feed_here, self.ramp_deg > 0)
            table.close_span()
        return plan.answer
