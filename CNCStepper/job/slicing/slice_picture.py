# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a stack: its sheets above each other, each part in a colour of its own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import shapely
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb

from CNCStepper.job.slicing.solid_slices import Stack
from CNCStepper.simulation.views.picture_style import head, new_figure, save_figure

PALETTE = ("#4f81bd", "#d99a3d", "#6aa84f", "#a05fb4", "#c0504d")
LIGHT = np.array([0.85, -0.52])  # seen from above
CAMERA = np.array([0.53, -0.848])  # the direction towards it, seen from above
ELEVATION_DEG = 26.0
DARKEST = 0.45
MOST_FACES = 60_000
CHORD_SHARE = 1.0 / 400.0  # of the size: how far drawn outlines leave the sections


def save_stack_picture(file: Path, stack: Stack, title: str) -> None:
    """Draw the stack as PNG or SVG, as the file's name ends."""
    figure = new_figure(9.0, 8.0)
    share = stack.volume_mm3 / stack.solid_volume_mm3 - 1.0
    parts = list(dict.fromkeys(each.part for each in stack.slices))
    facts = [
        f"{len(stack.slices)} sheets of {stack.thickness_mm:g} mm",
        f"{stack.volume_mm3 / 1000:.4g} cm³, {share:+.2%} of the solid",
        ", ".join(parts),
    ]
    head(figure, title, facts)
    axes = figure.add_axes((0.04, 0.03, 0.92, 0.82))
    corners, colours = _faces(stack, parts)
    drawn = [_projected(face) for face in corners]
    axes.add_collection(PolyCollection(drawn, facecolors=colours, edgecolors=colours, linewidths=0.3))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_axis_off()
    save_figure(figure, file)


def _projected(points: np.ndarray) -> np.ndarray:
    """Return points, float64[n, 3], as the camera sees them, float64[n, 2]: in parallel projection."""
    rise = np.radians(ELEVATION_DEG)
    across = points[:, :2] @ np.array([-CAMERA[1], CAMERA[0]])
    return np.column_stack([across, points[:, 2] * np.cos(rise) - points[:, :2] @ CAMERA * np.sin(rise)])


def _faces(stack: Stack, parts: list[str]) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Return the corners and colours of the walls that face the camera and of the top faces, the nearest last."""
    corners: list[np.ndarray] = []
    colours: list[np.ndarray] = []
    outlines = [piece.outline for each in stack.slices for piece in each.pieces]
    left, low, right, high = shapely.total_bounds(outlines)
    chord_mm = CHORD_SHARE * max(right - left, high - low)
    for each in stack.slices:
        colour = np.array(to_rgb(PALETTE[parts.index(each.part) % len(PALETTE)]))
        for piece in each.pieces:
            drawn = shapely.geometry.polygon.orient(shapely.simplify(piece.outline, chord_mm))
            for ring in (drawn.exterior, *drawn.interiors):
                _add_wall(corners, colours, np.asarray(ring.coords), each.begin_mm, stack.thickness_mm, colour)
            top = each.begin_mm + stack.thickness_mm
            for part in shapely.get_parts(shapely.delaunay_triangles(drawn)):
                if drawn.covers(part.representative_point()):
                    xy = np.asarray(part.exterior.coords)[:3]
                    corners.append(np.column_stack([xy, np.full(3, top)]))
                    colours.append(colour * 0.98)
    return corners[-MOST_FACES:], colours[-MOST_FACES:]


def _add_wall(
    corners: list[np.ndarray],
    colours: list[np.ndarray],
    ring: np.ndarray,
    begin_mm: float,
    thickness_mm: float,
    colour: np.ndarray,
) -> None:
    edges = np.diff(ring, axis=0)
    normals = np.column_stack([edges[:, 1], -edges[:, 0]]) / np.maximum(np.hypot(*edges.T), 1e-12)[:, None]
    lit = DARKEST + (0.9 - DARKEST) * np.clip(0.5 + 0.5 * (normals @ LIGHT), 0.0, 1.0)
    away = -(ring[:-1] + ring[1:]) @ CAMERA
    seen = [number for number in np.argsort(-away, kind="stable").tolist() if normals[number] @ CAMERA > 0.0]
    for number in seen:
        (x1, y1), (x2, y2) = ring[number], ring[number + 1]
        low, high = begin_mm, begin_mm + thickness_mm
        corners.append(np.array([(x1, y1, low), (x2, y2, low), (x2, y2, high), (x1, y1, high)]))
        colours.append(colour * lit[number])
