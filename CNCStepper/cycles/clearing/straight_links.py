# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ground: a room of the tool's centre, and whether a straight way leads from one place in it to another."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from CNCStepper.cycles.moves import Point
from CNCStepper.geometry.line_of_sight import barrier_of, sees, shortened, within
from CNCStepper.geometry.region import Region

EDGE_MM = 0.001  # a way along the wall may be so much beyond it


class LinkRegion:
    """A room, and the obstacles of a straight link in it."""

    def __init__(self, region: Region):
        self.region = region

    @cached_property
    def _barrier(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        return barrier_of(*self.region.bundle, EDGE_MM)  # type: ignore[no-any-return]

    def sees(self, here: Point, there: Point) -> bool:
        """Return whether the straight way between two places stays in the room."""
        return bool(self._holds(np.array([here]))[0]) and bool(sees(*self._barrier, *here, *there))

    def shortened(self, way: np.ndarray) -> np.ndarray:
        """Return the vertices that stay of a way, float64[n, 2], with straight ones in the room for some stretches."""
        return shortened(self._holds(way), *self._barrier, way)  # type: ignore[no-any-return]

    def _holds(self, places: np.ndarray) -> np.ndarray:
        return within(self.region.rows, self.region.spines, places, EDGE_MM)  # type: ignore[no-any-return]
