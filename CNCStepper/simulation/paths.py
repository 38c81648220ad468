# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool's path as lines to draw, sorted into rapids, feeds, arcs and plunges."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from CNCStepper.simulation.lines import Lines
from CNCStepper.simulation.segments import Segments, chains, segments
from CNCStepper.toolpath import LINE, RAPID, Toolpath

DRAWN_MM = 0.02  # how far a drawn arc may leave the true one


@dataclass(frozen=True)
class DrawnPath:
    """Polylines float64[k, 3] by what the tool does on them, and the lower ends of the plunges, float64[n, 3]."""

    rapids: list[np.ndarray]
    feeds: list[np.ndarray]
    arcs: list[np.ndarray]
    plunges: np.ndarray


def drawn_path(toolpath: Toolpath) -> DrawnPath:
    """Return the path in work coordinates, without what begins at an unknown position."""
    path = segments(toolpath, DRAWN_MM).known()
    kind = toolpath.table().kind[path.row]
    sideways = np.hypot(*(path.end - path.begin)[:, :2].T) > 1e-9
    plunging = (kind == LINE) & ~sideways & (path.end[:, 2] < path.begin[:, 2])
    return DrawnPath(
        _unrepeated(path[(kind == RAPID) & sideways]),
        _unrepeated(path[(kind == LINE) & sideways]),
        _unrepeated(path[(kind > LINE)]),
        path.end[plunging],
    )


def _unrepeated(path: Segments) -> list[np.ndarray]:
    """Return the segments as polylines, without those that lie on another one seen from above."""
    flat = np.round(np.concatenate([path.begin[:, :2], path.end[:, :2]], axis=1), 4)
    keys = np.ascontiguousarray(flat).view([("", flat.dtype)] * 4).ravel() if len(flat) else np.zeros(0)
    first = np.sort(np.unique(keys, return_index=True)[1])
    return chains(path[first])


def lines_in_space(toolpath: Toolpath, most: int) -> tuple[Lines, Lines]:
    """Return all rapids and all feeds as lines for a 3D view, with at most about `most` points each.

    Longer paths are thinned evenly; the ends of every run of rapids or feeds stay.
    """
    path = segments(toolpath, DRAWN_MM).known()
    rapid = toolpath.table().kind[path.row] == RAPID
    return _lines(chains(path[rapid]), most), _lines(chains(path[~rapid]), most)


def _lines(polylines: list[np.ndarray], most: int) -> Lines:
    keep_every = max(1, math.ceil(sum(map(len, polylines)) / most))
    thin = [np.vstack([line[:-1:keep_every], line[-1:]]) for line in polylines]
    points = np.concatenate(thin) if thin else np.zeros((0, 3))
    return Lines(points.astype(np.float32), np.array([len(line) for line in thin], np.int32))
