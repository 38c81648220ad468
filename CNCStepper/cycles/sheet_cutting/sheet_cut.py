# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting parts out of sheet by torch, laser, jet, knife or point, as a cutter would.

chains      parts and holes, and the beam's paths half a kerf off them       chains.py
loops       sharp outside corners; a drag knife's swivels                    corner_loops.py
leads       where each path is begun, proven to lie in scrap                 lead_places.py, lead_room.py
precedence  what must be cut before what                                     cut_precedence.py
rapids      a short order, round the pieces that are free                    rapids.py
strokes     feeds and power along each path                                  strokes.py
moves       pierce, cut and rapids in the table                              torch_moves.py
"""

from __future__ import annotations

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.sheet_cutting.sheet_model import SheetModel
from CNCStepper.cycles.sheet_cutting.sheet_plan import planned
from CNCStepper.cycles.sheet_cutting.torch_moves import TorchMoves, torch_of
from CNCStepper.toolpath import TableBuilder


class SheetCut(SheetModel):
    """Parts and holes that can be cut out of sheet."""

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append all cuts; raises CycleError before any row when they cannot be cut safely."""
        plan = planned(self, setup)
        torch = torch_of(setup, self.pierce_delay_s, plan.depth_mm, self.dynamic_power)
        moves = TorchMoves(table, torch)
        for spot in plan.spots:
            moves.spot(spot.point, spot.way, spot.title, self.spot_s, plan.mark_power)
        for cut in plan.cuts:
            moves.run(cut)
        return plan.answer
