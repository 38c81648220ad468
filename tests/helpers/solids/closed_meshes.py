# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sphere, a hull with cavities and a thin wall, as triangles, float64[n, 3, 3] in mm, and their binary STL files."""

from __future__ import annotations

from pathlib import Path

import numpy as np

ROW = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def sphere(radius_mm: float, centre_mm: tuple[float, float, float] = (0.0, 0.0, 0.0), rings: int = 60) -> np.ndarray:
    """Return a sphere of level rings and meridians; its corners lie on it."""
    heights = np.linspace(0.0, np.pi, rings + 1)
    turns = np.linspace(0.0, 2.0 * np.pi, 2 * rings, endpoint=False)
    radius, height = np.sin(heights), np.cos(heights)
    radius[[0, -1]] = 0.0
    points = np.stack(
        [radius[:, None] * np.cos(turns), radius[:, None] * np.sin(turns), np.repeat(height[:, None], 2 * rings, 1)], -1
    )
    upper, lower = points[:-1], points[1:]
    a, b, c, d = upper, np.roll(upper, -1, 1), lower, np.roll(lower, -1, 1)
    faces = np.concatenate([np.stack([a, c, d], 2).reshape(-1, 3, 3), np.stack([a, d, b], 2).reshape(-1, 3, 3)])
    area = np.linalg.norm(np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0]), axis=1)
    return faces[area > 1e-12] * radius_mm + np.array(centre_mm)


def box(low_mm: tuple[float, float, float], high_mm: tuple[float, float, float]) -> np.ndarray:
    """Return a box of twelve triangles."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    corners = np.array(low_mm) + corners * (np.array(high_mm) - np.array(low_mm))
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))]
    return corners[np.array(faces)]


def inside_out(mesh: np.ndarray) -> np.ndarray:
    """Return a mesh whose faces look inwards: a cavity."""
    return mesh[:, ::-1]


def hull_with_cavities() -> np.ndarray:
    """Return a sphere of 25 mm with a round cavity off its middle and a square one."""
    cavities = inside_out(sphere(9.0, (-8.0, 0.0, 3.0), 40)), inside_out(box((4.0, -6.0, -9.0), (15.0, 6.0, 4.0)))
    return np.concatenate([sphere(25.0), *cavities])


def thin_wall() -> np.ndarray:
    """Return a ring of four walls, 0.8 mm thick, 20 mm high, round 40 x 30 mm; it is open above and below."""
    sides = box((0, 0, 0), (40, 0.8, 20)), box((0, 29.2, 0), (40, 30, 20))
    return np.concatenate([*sides, box((0, 0.8, 0), (0.8, 29.2, 20)), box((39.2, 0.8, 0), (40, 29.2, 20))])


def write_stl(path: Path, mesh: np.ndarray) -> None:
    """Write a binary STL file."""
    rows = np.zeros(len(mesh), ROW)
    rows["corners"] = mesh
    path.write_bytes(b"mesh of a test".ljust(80) + len(mesh).to_bytes(4, "little") + rows.tobytes())
