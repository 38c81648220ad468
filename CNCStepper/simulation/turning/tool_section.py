# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe tool in the half plane: the outline that cuts and the one of its holder, about its control point.

Outlines are shapely polygons with x = z and y = r, in mm; arcs are chords within CHORD_MM. A sweep needs convex parts:
an outline that is not convex is divided into some.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.machine.tools.turning_tool import Outline, TurningTool
from CNCStepper.tolerances import SAME_SHARE

CHORD_MM = 0.0003  # how far chords leave the arcs of outlines and moves


@dataclass(frozen=True)
class ToolSection:
    """A tool's cutting outline and its holder, None where that is not known.

    nose_radius_mm: 0 for a sharp one. depth_max_mm, feed_max_mm_turn: 0 where the tool names no limit. pitch_mm: of a
    threading insert whose feeds follow the spindle though the program does not say so; else 0.
    """

    cutting: Polygon
    holder: Polygon | None = None
    nose_radius_mm: float = 0.0
    depth_max_mm: float = 0.0
    feed_max_mm_turn: float = 0.0
    pitch_mm: float = 0.0
    words: str = ""

    @classmethod
    def of(cls, tool: TurningTool, pitch_mm: float = 0.0) -> ToolSection:
        """Return the section of a job's tool; pitch_mm: with which its feeds follow the spindle, 0 for not."""
        holder = tool.holder_outline()
        return cls(
            polygon_of(tool.outline()),
            polygon_of(holder) if holder else None,
            tool.nose_mm,
            tool.ap_max_mm,
            tool.feed_max_mm_rev,
            pitch_mm,
            tool.words,
        )

    @cached_property
    def cutting_parts(self) -> list[np.ndarray]:
        """The convex parts of the cutting outline, float64[k, 2] each."""
        return convex_parts(self.cutting)

    @cached_property
    def holder_parts(self) -> list[np.ndarray]:
        """The convex parts of the holder; none where it is not known."""
        return convex_parts(self.holder) if self.holder is not None else []


def polygon_of(outline: Outline) -> Polygon:
    """Return a closed outline of vertices (z, r, bulge) as a polygon of chords.

    Where an arc is level or upright it has a corner, so that cylinders and faces come out exactly.
    """
    vertices = np.asarray(outline, float)
    points = [
        _arc_points(complex(*begin[:2]), complex(*end[:2]), begin[2])
        for begin, end in zip(vertices, np.roll(vertices, -1, axis=0), strict=True)
    ]
    flat = np.concatenate(points)
    return Polygon(np.column_stack([flat.real, flat.imag]))


def _arc_points(begin: complex, end: complex, bulge: float) -> np.ndarray:
    """Return the corners of an arc's chords without its end, complex[k]; of a line its begin alone."""
    if bulge == 0:
        return np.array([begin])
    sweep = 4 * np.arctan(bulge)
    centre = (begin + end) / 2 + (end - begin) / 2 * 1j / np.tan(sweep / 2)
    radius, first = abs(begin - centre), np.angle(begin - centre)
    count = int(np.ceil(abs(sweep) / (2 * np.arccos(1 - min(CHORD_MM / radius, 1.0)))))
    quarters = np.arange(-8, 9) * np.pi / 2
    turned = (quarters - first) / sweep
    shares = np.concatenate([np.arange(count) / count, turned[(turned > 0) & (turned < 1)]])
    return centre + radius * np.exp(1j * (first + sweep * np.unique(shares)))


def convex_parts(polygon: Polygon) -> list[np.ndarray]:
    """Return a polygon as convex pieces without their closing points, float64[k, 2] each."""
    hull = polygon.convex_hull
    if hull.area - polygon.area <= SAME_SHARE * hull.area:
        return [_ring(hull)]
    parts: list[Polygon] = []
    for triangle in shapely.get_parts(shapely.constrained_delaunay_triangles(polygon)):
        for place, part in enumerate(parts):
            joined = part.union(triangle)
            if joined.geom_type == "Polygon" and joined.convex_hull.area - joined.area <= SAME_SHARE * joined.area:
                parts[place] = joined
                break
        else:
            parts.append(triangle)
    return [_ring(part.convex_hull) for part in parts]


def _ring(polygon: Polygon) -> np.ndarray:
    return np.asarray(polygon.exterior.coords, float)[:-1]
