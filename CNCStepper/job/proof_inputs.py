# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a proof is made against."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from CNCStepper.machine.processes import MILLING, Process

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from CNCStepper.cycles.cycle import Removal
    from CNCStepper.machine.cut_data import CutData
    from CNCStepper.machine.profile import Machine
    from CNCStepper.simulation.checks.clamps import Clamp
    from CNCStepper.simulation.cutter_solid import Tools
    from CNCStepper.simulation.stock import Stock


@dataclass(frozen=True)
class Given:
    """What a proof was made against; None and empty are "not given", and then not judged.

    before: the fingerprints of the programs that had cut the stock before this one. process, cut_data: how it cuts, and
    the row of the cut chart. parts: shapely polygons that are to be left whole.
    """

    text: str
    dialect: str
    machine: Machine
    stock: Stock | None = None
    tools: Tools | None = None
    removals: Sequence[Removal] = ()
    keep_out: Sequence[Clamp] = ()
    edge_mm: float | None = None
    before: Sequence[str] = ()
    process: Process = MILLING
    cut_data: CutData | None = None
    parts: Sequence[BaseGeometry] = ()
