# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a sheet that have fallen, hatched: at the time of the picture nothing holds them.

They are drawn where they were cut, on the top face.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from CNCStepper.simulation.exact.free_pieces import FreePiece
from CNCStepper.simulation.views.path_lines import Until
from CNCStepper.simulation.views.picture_style import COLOURS, INK

HATCH = "///"
Project = Callable[[np.ndarray], np.ndarray]  # from points float64[n, 3] to the picture's float64[n, 2]


def fallen_until(pieces: Sequence[FreePiece], until: Until | None) -> tuple[BaseGeometry, ...]:
    """Return the shapes of the pieces that come free before a time, or by the end; None is before the first move."""
    if until is None:
        return ()
    last = until.row if until.share == 1.0 else until.row - 1
    return tuple(piece.shape for piece in pieces if piece.row <= last)


def draw_fallen(axes: Axes, shapes: Iterable[BaseGeometry], height_mm: float, project: Project) -> list[str]:
    """Draw pieces with their holes, at a height; return the name of what there is, for the legend."""
    found = [polygon for shape in shapes for polygon in shapely.get_parts(shape).tolist()]
    for polygon in map(orient, found):  # holes run the other way round, so that they stay empty
        rings = [polygon.exterior, *polygon.interiors]
        path = Path.make_compound_path(*(_ring(ring, height_mm, project) for ring in rings))
        axes.add_patch(PathPatch(path, fc=COLOURS["fallen"], ec=INK, lw=0.5, hatch=HATCH, zorder=1.5))
    return ["fallen"] if found else []


def _ring(ring: BaseGeometry, height_mm: float, project: Project) -> Path:
    points = shapely.get_coordinates(ring)
    flat = project(np.column_stack([points, np.full(len(points), height_mm)]))
    return Path(flat, closed=True)
