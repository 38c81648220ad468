# SPDX-License-Identifier: LGPL-2.1-or-later
"""A point list as a drawing: one chain, closed where its last point is its first."""

from __future__ import annotations

from pathlib import Path

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing, Share
from CNCStepper.drawing.point_list import read_points
from CNCStepper.drawing.read_drawing import ReadOptions


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the drawing of a file of points "x,y"; raises JobError that names file and line."""
    curve = read_points(path)
    unit_mm = options.unit_mm or 1.0
    share(1.0)
    return Drawing((Chain(curve.scaled(unit_mm), Attributes(name=path.stem)),), unit_mm=unit_mm)
