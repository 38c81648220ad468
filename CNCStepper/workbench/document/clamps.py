# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of a document that clamp the work: the areas that the tool avoids, seen from above.

A job keeps the outlines of its clamps in one list of points, in the document's coordinates: ring after ring, each
closed by its first point, the height of the points that of the clamp's top.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from CNCStepper.errors import JobError, Text
from CNCStepper.workbench.drawings.shapes import containers_of, placed_shape
from CNCStepper.workbench.features.base import FAILED

ROUND_MM = 0.05  # how far round faces are taken for flat ones; their outline is widened by as much
PLANE = "Part::GeomPlane"
Point = tuple[float, float, float]


def outlines_of(solids: Iterable[Any]) -> list[Point]:
    """Return the rings of several solids; raises JobError naming one that is none."""
    return [point for solid in solids for point in outline_of(solid)]


def outline_of(solid: Any) -> list[Point]:
    """Return the closed ring round a solid as it lies in the document: its convex hull seen from above, at its top.

    Nothing of the solid lies outside; the gap of a hook or a fork counts as clamp too. Raises JobError for what is
    no solid.
    """
    from shapely import MultiPoint

    shape = placed_shape(solid)
    if shape.isNull() or not shape.Solids:
        raise JobError(
            FAILED,
            Text("'{solid}' is no solid and cannot be a clamp", solid=solid.Label),
            advice="choose a solid, for example a box",
        )
    flat = all(face.Surface.TypeId == PLANE for face in shape.Faces)
    points = [vertex.Point for vertex in shape.Vertexes] if flat else shape.tessellate(ROUND_MM)[0]
    margin_mm = 0.0 if flat else ROUND_MM
    hull = MultiPoint([(point.x, point.y) for point in points]).convex_hull.buffer(margin_mm, join_style="mitre")
    top_mm = max(point.z for point in points) + margin_mm
    return [(x, y, top_mm) for x, y in hull.exterior.coords]


def rings_of(job: Any) -> Iterator[list[Point]]:
    """Yield the outlines that a job keeps, in the document's coordinates."""
    ring: list[Point] = []
    for point in map(tuple, job.ClampOutlines):
        ring.append(point)
        if len(ring) > 1 and point == ring[0]:
            yield ring
            ring = []


def clamps_content(job: Any) -> tuple[dict[str, Any], ...]:
    """Return the `[[clamp]]` tables of a job file, in work coordinates."""
    x0, y0, z0 = job.WorkOrigin
    return tuple(
        {"corners_mm": tuple((x - x0, y - y0) for x, y, _ in ring[:-1]), "top_mm": ring[0][2] - z0}
        for ring in rings_of(job)
    )


def containers(solids: Iterable[Any]) -> list[Any]:
    """Return the parts and bodies that the solids move with, each once."""
    return list(dict.fromkeys(holder for solid in solids for holder in containers_of(solid)))
