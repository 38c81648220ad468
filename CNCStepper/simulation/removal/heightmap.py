# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut part as a map of heights: what pictures, meshes and the removed volume are made from.

Each cell's height is that of the material at its centre, cut by the cutter's own profile along the
move's own line, arc or helix; `cutter_profile.py` and the `removal_` modules say how.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from CNCStepper.kernels import COMPILED
from CNCStepper.simulation.cutter_profile import Form
from CNCStepper.simulation.cutter_solid import Tools
from CNCStepper.simulation.removal.removal_moves import Moves, moves_of
from CNCStepper.simulation.removal.tiles import Grid, Part
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments
from CNCStepper.toolpath import Toolpath

CELLS = 600 if COMPILED else 150  # along the stock's longer side; plain Python is 200 times slower


class HeightMap:
    """Heights of the material over a stock; z = 0 is the stock's top.

    stock; x_mm, y_mm: the cells' centres. cell_mm: lengths of a cell along x and y; the cells fill the stock exactly.
    part: the tiles behind it.
    """

    def __init__(self, stock: Stock, cell_mm: float = 0.0, part: Part | None = None):
        """cell_mm: the longest side a cell may have. part: what is cut already; its own cells are taken then."""
        self.part = part or Part(Grid.of(stock, cell_mm or max(stock.size_mm[:2]) / CELLS))
        self.stock = stock
        self.cell_mm = self.part.grid.cell_mm
        self.x_mm, self.y_mm = (self.part.grid.centres_mm(axis) for axis in range(2))

    @cached_property
    def heights_mm(self) -> np.ndarray:
        """Heights at the centres, float64[rows, columns], rows along y; below the stock where a tool went through."""
        return self.part.heights_mm()

    @property
    def removed_volume_mm3(self) -> float:
        """The volume that was cut from the stock; below its bottom there is nothing to cut."""
        return self.part.removed_volume_mm3

    def cut(self, form: Form, pieces: Segments) -> None:
        """Cut along the segments, in their order, with a cutter of that form."""
        self.part = self.part.after(Moves.lines(pieces.begin, pieces.end, form))
        self.__dict__.pop("heights_mm", None)


def height_map(toolpath: Toolpath, tools: Tools, stock: Stock, cell_mm: float = 0.0) -> HeightMap:
    """Return the stock after the whole program; rows with a tool that is not among `tools` cut nothing."""
    uncut = HeightMap(stock, cell_mm)
    return HeightMap(stock, part=uncut.part.after(moves_of(toolpath, tools, stock)))
