# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moves as straight segments of the tool's tip in the stock's work coordinates.

The stock stands still on the table: its frame is the work offset of the first row. A later offset
(G55, G92) moves the tool, not the stock; a tool length is taken off on every row, so that the
positions are always those of the tip.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from CNCStepper.simulation.arc_chords import arcs_of
from CNCStepper.toolpath import ARC_CW, Chunk, Toolpath, begins_of


@dataclass(frozen=True)
class Segments:
    """begin, end: float64[n, 3], mm, NaN where unknown; row: int64[n], index into the table of moves."""

    begin: np.ndarray
    end: np.ndarray
    row: np.ndarray

    def __len__(self) -> int:
        return len(self.row)

    def __getitem__(self, which: np.ndarray | slice) -> Segments:
        if isinstance(which, np.ndarray) and which.dtype == bool and which.all():
            return self
        return Segments(self.begin[which], self.end[which], self.row[which])

    @property
    def low_mm(self) -> np.ndarray:
        """The lower of the two heights of each segment."""
        return np.minimum(self.begin[:, 2], self.end[:, 2])

    @property
    def length_mm(self) -> np.ndarray:
        """The length of each segment, float64[n]."""
        x, y, z = (self.end - self.begin).T
        return np.sqrt(x * x + y * y + z * z)

    @property
    def are_known(self) -> bool:
        """Whether all ends are known."""
        return bool(np.isfinite(self.begin).all() and np.isfinite(self.end).all())

    def known(self) -> Segments:
        """Return those whose two ends are known."""
        if self.are_known:
            return self
        return self[np.isfinite(self.begin).all(axis=1) & np.isfinite(self.end).all(axis=1)]

    def known_in(self, axes: tuple[int, ...]) -> Segments:
        """Return those known in `axes`; other axes that are unknown at both ends count as 0."""
        if self.are_known:
            return self
        begin, end = self.begin.copy(), self.end.copy()
        for other in {0, 1, 2}.difference(axes):
            nowhere = np.isnan(begin[:, other]) & np.isnan(end[:, other])
            begin[nowhere, other] = end[nowhere, other] = 0.0
        return Segments(begin, end, self.row).known()

    def known_in_x(self) -> Segments:
        """Return those known in X; Y and Z count as 0 where they are known at neither end.

        A lathe has no Y, and a table without Z no height.
        """
        return self.known_in((0,))


def frame_mm(toolpath: Toolpath) -> np.ndarray:
    """Return the machine coordinates of the stock's work zero, float64[3]: the offset of the first row."""
    first = next((chunk for chunk in toolpath.chunks if len(chunk)), None)
    state = toolpath.frame or toolpath.states[int(first.state[0]) if first else 0]
    return np.array(state.offset_mm[:3], float) - (0.0, 0.0, state.tool_length_mm)


def tips_mm(toolpath: Toolpath) -> tuple[np.ndarray, np.ndarray]:
    """Return begin and end of the tool's tip on every row, float64[n, 3], in the stock's frame."""
    table = toolpath.table()
    shift = _shift_mm(toolpath, table)
    return toolpath.begins()[:, :3] - shift, table.end[:, :3] - shift


def tips_of_chunks(toolpath: Toolpath) -> Iterator[tuple[Chunk, np.ndarray, np.ndarray]]:
    """Yield each chunk with its `tips_mm`: a long program's need not be held whole."""
    before = np.asarray(toolpath.start.position_mm, float)
    for chunk in toolpath.chunks:
        shift = _shift_mm(toolpath, chunk)
        yield chunk, begins_of(chunk, before)[:, :3] - shift, chunk.end[:, :3] - shift
        before = chunk.end[-1] if len(chunk) else before


def _shift_mm(toolpath: Toolpath, chunk: Chunk) -> np.ndarray:
    """Return what leads from the tip in the stock's frame to the machine's coordinates on each row, float64[n, 3]."""
    shift = np.tile(frame_mm(toolpath), (len(chunk), 1))
    shift[:, 2] += np.array([state.tool_length_mm for state in toolpath.states], float)[chunk.state]
    return shift


def segments_of_chunks(toolpath: Toolpath, tolerance_mm: float) -> Iterator[Segments]:
    """Yield `segments` a chunk at a time: those of a long program need not be held whole."""
    first = 0
    for chunk, begin, end in tips_of_chunks(toolpath):
        pieces = chords_of(chunk, begin, end, tolerance_mm)
        yield Segments(pieces.begin, pieces.end, pieces.row + first)
        first += len(chunk)


def segments(toolpath: Toolpath, tolerance_mm: float) -> Segments:
    """Return all moves as segments; chords leave their arcs by at most `tolerance_mm`."""
    begin, end = tips_mm(toolpath)
    return chords_of(toolpath.table(), begin, end, tolerance_mm)


def chords_of(
    table: Chunk, begin: np.ndarray, end: np.ndarray, tolerance_mm: float, whole: np.ndarray | None = None
) -> Segments:
    """Return moves from begin[n, 3] to end[n, 3] as segments; chords leave their arcs by at most `tolerance_mm`.

    whole: bool[n], rows that stay one segment from begin to end though they are arcs.
    """
    if not (table.kind >= ARC_CW).any():
        return Segments(begin, end, np.arange(len(table)))
    centre = table.centre + (end - table.end[:, :3])
    counts = np.ones(len(table), np.int64)
    shapes = arcs_of(table, begin, end, centre)
    for shape in shapes:
        counts[shape.rows] = shape.counts(tolerance_mm)
    if whole is not None:
        counts[whole] = 1
    row = np.repeat(np.arange(len(table)), counts)
    step = np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts)
    share = (step + 1) / counts[row]
    points = begin[row] + (end - begin)[row] * share[:, None]
    for shape in shapes:
        shape.bend(points, row, share)
    last = share == 1.0
    points[last] = end[row[last]]
    starts = np.vstack([np.full((1, 3), np.nan), points[:-1]])[: len(row)]
    starts[step == 0] = begin[row[step == 0]]
    return Segments(starts, points, row)


def clipped_below(pieces: Segments, level_mm: float) -> Segments:
    """Return the parts of the segments whose height is at most `level_mm`."""
    pieces = pieces[pieces.low_mm <= level_mm]
    if (np.maximum(pieces.begin[:, 2], pieces.end[:, 2]) <= level_mm).all():
        return pieces
    begin, end = pieces.begin.copy(), pieces.end.copy()
    for here, there in ((begin, pieces.end), (end, pieces.begin)):
        above = here[:, 2] > level_mm
        share = (here[above, 2] - level_mm) / (here[above, 2] - there[above, 2])
        here[above] += (there[above] - here[above]) * share[:, None]
    return Segments(begin, end, pieces.row)


def split_ramps(pieces: Segments, step_mm: float) -> Segments:
    """Return the segments with those that change their height by more than `step_mm` cut into equal parts."""
    rise = np.abs(pieces.end[:, 2] - pieces.begin[:, 2])
    is_ramp = np.hypot(*(pieces.end - pieces.begin)[:, :2].T) > 1e-9
    return parted(pieces, np.where(is_ramp, np.maximum(np.ceil(rise / step_mm), 1), 1).astype(np.int64))


def shortened(pieces: Segments, step_mm: float) -> Segments:
    """Return the segments with those that are longer than `step_mm`, seen from above, cut into equal parts."""
    length = np.hypot(*(pieces.end - pieces.begin)[:, :2].T)
    return parted(pieces, np.maximum(np.ceil(length / step_mm), 1).astype(np.int64))


def parted(pieces: Segments, counts: np.ndarray) -> Segments:
    """Return each segment cut into as many equal parts."""
    index = np.repeat(np.arange(len(pieces)), counts)
    step = np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)
    delta = (pieces.end - pieces.begin)[index]
    first = (step / counts[index])[:, None]
    last = ((step + 1) / counts[index])[:, None]
    return Segments(pieces.begin[index] + delta * first, pieces.begin[index] + delta * last, pieces.row[index])


def chains(pieces: Segments) -> list[np.ndarray]:
    """Return the segments joined to polylines, float64[k, 3] each, broken where one does not begin at the last end."""
    if not len(pieces):
        return []
    joined = (pieces.begin[1:] == pieces.end[:-1]).all(axis=1)
    breaks = np.flatnonzero(~joined) + 1
    firsts, lasts = np.r_[0, breaks], np.r_[breaks, len(pieces)]
    return [np.vstack([pieces.begin[a : a + 1], pieces.end[a:b]]) for a, b in zip(firsts, lasts, strict=True)]
