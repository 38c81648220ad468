# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judge the path that the virtual axes took against the drawing itself; knows nothing of cycles or programs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import shapely

STRETCH = 20  # points; so short that it hardly crosses itself
REST_S = 0.05  # without a step for that long the axes rest: a dwell, a pause
LEVEL_MM = 0.005  # what lies that close to a depth is on it: two steps of the Z axis


@dataclass(frozen=True)
class Cut:
    """How far the axes' path is off the drawing, in mm."""

    wall_mm: float  # the pocket's finished wall from the drawn ellipse, at the worst point
    floor_mm: float  # the deepest points from the drawn depths
    line_mm: float  # the engraved line from the drawn one, both ways
    samples: int

    @property
    def worst_mm(self) -> float:
        """The worst of all."""
        return max(self.wall_mm, self.floor_mm, self.line_mm)


def motion_s(trace: Path) -> float:
    """Return how long the axes moved: the times between rows, without those in which they rested."""
    times = np.loadtxt(trace, delimiter=",", skiprows=1, usecols=0)
    gaps = np.diff(times)
    return float(gaps[gaps < REST_S].sum())


def judge(
    trace: Path,
    zero_mm: tuple[float, float, float],
    ellipse: shapely.Polygon,
    tool_radius_mm: float,
    depth_mm: float,
    line: shapely.LineString,
    line_depth_mm: float,
) -> Cut:
    """Compare the trace of the axes (machine coordinates) with the drawn ellipse and the drawn line."""
    path = np.loadtxt(trace, delimiter=",", skiprows=1, usecols=(1, 2, 3)) - zero_mm
    pocket = path[_over(path, ellipse)]
    engraved = path[(path[:, 2] < -line_depth_mm + LEVEL_MM) & ~_over(path, ellipse)]
    return Cut(
        _wall_mm(pocket, ellipse, tool_radius_mm, depth_mm),
        max(abs(pocket[:, 2].min() + depth_mm), abs(engraved[:, 2].min() + line_depth_mm)),
        _line_mm(engraved, line),
        len(path),
    )


def _over(path: np.ndarray, ellipse: shapely.Polygon) -> np.ndarray:
    return shapely.contains_xy(ellipse, path[:, 0], path[:, 1])


def _wall_mm(pocket: np.ndarray, ellipse: shapely.Polygon, tool_radius_mm: float, depth_mm: float) -> float:
    """Sweep the tool along the path on the floor, and measure the sweep's edge from the drawn wall, both ways."""
    floor = pocket[pocket[:, 2] < -depth_mm + LEVEL_MM]
    swept = _swept(floor[:, :2], tool_radius_mm)
    outside = shapely.Polygon(swept.exterior).exterior
    if any(shapely.Polygon(hole).area > 0.01 for hole in swept.interiors):
        raise SystemExit("an island stands in the pocket")
    there = shapely.distance(ellipse.exterior, shapely.points(np.asarray(outside.coords)))
    back = shapely.distance(outside, shapely.points(np.asarray(ellipse.exterior.coords)))
    return float(max(there.max(), back.max()))


def _swept(path: np.ndarray, tool_radius_mm: float) -> shapely.Geometry:
    """Return what a round tool sweeps, stretch by stretch: the buffer of a line that crosses itself can lack pieces."""
    points = np.asarray(shapely.simplify(shapely.LineString(path), 0.0005).coords)
    stretches = [points[k : k + STRETCH + 1] for k in range(0, len(points) - 1, STRETCH)]
    return shapely.union_all(
        shapely.buffer([shapely.LineString(one) for one in stretches], tool_radius_mm, quad_segs=64)
    )


def _line_mm(engraved: np.ndarray, line: shapely.LineString) -> float:
    """Return the distance between the axes' path on its depth and the drawn line, at the worst point of either."""
    cut = shapely.LineString(engraved[:, :2])
    there = shapely.distance(line, shapely.points(engraved[:, :2]))
    back = shapely.distance(cut, shapely.points(np.asarray(shapely.segmentize(line, 0.1).coords)))
    return float(max(there.max(), back.max()))
