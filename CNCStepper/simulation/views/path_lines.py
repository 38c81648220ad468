# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool's path as lines to draw, sorted into rapids, feeds, arcs and plunges.

Polylines as two arrays, as a 3D view takes them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.simulation.tip_segments import Segments, chains, segments
from CNCStepper.toolpath import LINE, RAPID, Toolpath


@dataclass(frozen=True)
class Lines:
    """Polylines one after another: points float32[n, 3] in work coordinates, counts int32[k] of points in each."""

    points: np.ndarray
    counts: np.ndarray

    def pieces(self, most: int) -> Iterator[Lines]:
        """Yield the same polylines, at most `most` points at a time; one that is cut continues from its last point."""
        ends = np.cumsum(self.counts)
        for first in range(0, max(len(self.points) - 1, 0), most - 1):
            last = min(first + most, len(self.points))
            within = ends[(ends > first) & (ends < last)]
            yield Lines(self.points[first:last], np.diff([first, *within, last]).astype(np.int32))


DRAWN_MM = 0.02  # how far a drawn arc may leave the true one
FROM_ABOVE = (0, 1)
LATHE = (2, 0)  # Z to the right, X upwards


@dataclass(frozen=True)
class Until:
    """How far a path is drawn: to the end of the share of a row that is done, where the tip is at `tip_mm`."""

    row: int
    share: float
    tip_mm: np.ndarray


@dataclass(frozen=True)
class DrawnPath:
    """Polylines float64[k, 3] by kind of motion; the last point of a plunge is its lower end."""

    rapids: list[np.ndarray]
    feeds: list[np.ndarray]
    arcs: list[np.ndarray]
    plunges: list[np.ndarray]

    def kinds(self) -> dict[str, list[np.ndarray]]:
        """Return the lines by the name of what they are."""
        return {"feeds": self.feeds, "arcs": self.arcs, "rapids": self.rapids, "plunges": self.plunges}

    @property
    def points_mm(self) -> np.ndarray:
        """All points of all lines, float64[n, 3]."""
        lines = self.rapids + self.feeds + self.arcs + self.plunges
        return np.vstack(lines) if lines else np.zeros((0, 3))


def drawn_path(toolpath: Toolpath, seen: tuple[int, ...] = FROM_ABOVE, until: Until | None = None) -> DrawnPath:
    """Return the path in work coordinates, without what begins at a position unknown in the view.

    seen: the axes that a view shows; lines that are points or repeat others there are left out, save plunges, which
    a lathe has not.
    """
    path = segments(toolpath, DRAWN_MM)
    path = (path if until is None else _until(path, until)).known_in(seen)
    kind = toolpath.table().kind[path.row]
    delta = path.end - path.begin
    sideways = np.hypot(delta[:, 0], delta[:, 1]) > 1e-9
    shown = (np.abs(delta[:, list(seen)]) > 1e-9).any(axis=1)
    plunging = (kind == LINE) & ~sideways & (delta[:, 2] < 0) & (seen != LATHE)
    return DrawnPath(
        _unrepeated(path[(kind == RAPID) & shown], seen),
        _unrepeated(path[(kind == LINE) & shown & ~plunging], seen),
        _unrepeated(path[kind > LINE], seen),
        chains(path[plunging]),
    )


def _until(path: Segments, until: Until) -> Segments:
    """Return the segments up to there, the one in hand only as far as it is done."""
    first, last = np.searchsorted(path.row, [until.row, until.row + 1])
    done = first + int((last - first) * until.share)
    end = path.end.copy()
    if done < last:
        end[done] = until.tip_mm
    return Segments(path.begin, end, path.row)[: min(done + 1, int(last))]


def _unrepeated(path: Segments, seen: tuple[int, ...]) -> list[np.ndarray]:
    """Return the segments as polylines, without those that lie on another one as it is seen."""
    flat = np.round(np.concatenate([path.begin[:, list(seen)], path.end[:, list(seen)]], axis=1), 4)
    keys = np.ascontiguousarray(flat).view([("", flat.dtype)] * flat.shape[1]).ravel() if len(flat) else np.zeros(0)
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
