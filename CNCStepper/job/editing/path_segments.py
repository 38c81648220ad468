# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path of a program as segments with line numbers: drawn, highlighted, and picked by the pointer."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from CNCStepper.simulation.tip_segments import Segments, segments
from CNCStepper.simulation.views.path_lines import DRAWN_MM, Lines, lines_in_space
from CNCStepper.toolpath import RAPID, Toolpath

MOST_POINTS = 60_000  # of the rapids, and of the feeds, that a 3D view is given to draw
MOST_SHOWN = 2000  # segments of one line that are shown
REACH_PX = 8.0  # so near to a segment the pointer must be
SAME_PX = 1.5  # of segments that are as near as that, the one in front is meant
SAME_DEPTH = 9  # decimals: of those at one depth the nearest


class Picture:
    """The segments of a table of moves, in work coordinates."""

    def __init__(self, toolpath: Toolpath):
        self._toolpath = toolpath
        table = toolpath.table()
        self._line, self._cuts = table.line, table.kind != RAPID
        self._segments: Segments = segments(toolpath, DRAWN_MM)
        self._known = self._segments.known()

    def save(self, path: Path) -> None:
        """Write rapids and feeds as lines for a 3D view."""
        rapids, feeds = lines_in_space(self._toolpath, MOST_POINTS)
        np.savez(
            path,
            rapid_points=rapids.points,
            rapid_counts=rapids.counts,
            feed_points=feeds.points,
            feed_counts=feeds.counts,
        )

    def way(self, rows: np.ndarray) -> list[list[list[float]]]:
        """Return the path of rows as segments, [[x, y, z], [x, y, z]] each; rows without a known begin are left out."""
        kept: list[list[list[float]]] = []
        for row in rows.tolist():
            first, last = np.searchsorted(self._known.row, [row, row + 1])
            pieces = self._known[slice(first, min(last, first + MOST_SHOWN - len(kept)))]
            kept += np.stack([pieces.begin, pieces.end], axis=1).tolist()
            if len(kept) >= MOST_SHOWN:
                break
        return kept

    def pick(self, matrix: list[list[float]], size: list[float], at: list[float]) -> int | None:
        """Return the line whose way is seen at a place of the picture, None where there is none.

        matrix: what turns (x, y, z, 1), a row, into the picture's own from -1 to 1; size: of the picture in pixels,
        at: from its lower left corner.
        """
        picked = self._picked(self._known, matrix, size, at)
        return int(self._line[self._known.row[picked[0]]]) if picked else None

    def pick_mm(self, matrix: list[list[float]], size: list[float], at: list[float]) -> list[float] | None:
        """Return the place of the cuts that is seen there, [x, y, z] in work coordinates, with what `pick` is given."""
        cuts = self._known[self._cuts[self._known.row]]
        picked = self._picked(cuts, matrix, size, at)
        if picked is None:
            return None
        index, share = picked
        return (cuts.begin[index] + (cuts.end[index] - cuts.begin[index]) * share).tolist()

    def _picked(
        self, pieces: Segments, matrix: list[list[float]], size: list[float], at: list[float]
    ) -> tuple[int, float] | None:
        """Return the segment that is seen at a place of the picture, and at which share of it."""
        ends = [_seen(points, np.array(matrix), np.array(size)) for points in (pieces.begin, pieces.end)]
        (begin, begin_depth), (end, end_depth) = ends
        distance, share = _distance(begin, end, np.array(at))
        distance = np.where(np.isfinite(distance), distance, np.inf)
        if not len(distance) or distance.min() > REACH_PX:
            return None
        near = np.flatnonzero(distance <= distance.min() + SAME_PX)
        depth = begin_depth[near] + (end_depth[near] - begin_depth[near]) * share[near]
        best = int(near[np.lexsort((distance[near], depth.round(SAME_DEPTH)))[0]])
        return best, float(share[best])


def _seen(points: np.ndarray, matrix: np.ndarray, size: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return where points appear, in pixels, and how deep; NaN behind the eye."""
    turned = points @ matrix[:3] + matrix[3]
    w = np.where(turned[:, 3] > 0, turned[:, 3], np.nan)
    return (turned[:, :2] / w[:, None] + 1) / 2 * size, turned[:, 2] / w


def _distance(begin: np.ndarray, end: np.ndarray, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return how far a place lies from segments, and at which share of each its nearest point is."""
    way = end - begin
    squared = (way**2).sum(axis=1)
    share = np.clip(((at - begin) * way).sum(axis=1) / np.where(squared > 0, squared, 1), 0, 1)
    return np.hypot(*(begin + way * share[:, None] - at).T), share


def read_lines(path: Path) -> tuple[Lines, Lines]:
    """Return the rapids and feeds that `Picture.save` wrote."""
    with np.load(path, allow_pickle=False) as arrays:
        rapids = Lines(arrays["rapid_points"], arrays["rapid_counts"])
        return rapids, Lines(arrays["feed_points"], arrays["feed_counts"])
