# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo part in numbers: what the designer draws and what the judge compares the cut with."""

import csv
from pathlib import Path

PLATE_MM = (310, 200, 15)
ELLIPSE_CENTRE_MM, ELLIPSE_RADII_MM, DEPTH_MM = (60, 100), (40, 25), 10
MILL_MM, BALL_MM = 6, 2
MAP_CORNER_MM, MAP_DEPTH_MM = (120, 9), 1
ZERO_MM = (-350, -250, -40)  # where the plate's corner lies on the table, machine coordinates


def brazil() -> list[tuple[float, float]]:
    """Return the freehand points of the map where they lie on the plate, the first again at the end."""
    path = Path(__file__).resolve().parent / "brazil-outline.csv"
    with path.open(encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith(("#", "x"))]
    points = [(float(x) + MAP_CORNER_MM[0], float(y) + MAP_CORNER_MM[1]) for x, y in rows]
    return points if points[0] == points[-1] else [*points, points[0]]
