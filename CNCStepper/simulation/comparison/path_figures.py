# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of one tool path, to be read beside those of another one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from CNCStepper.simulation.tip_segments import segments
from CNCStepper.toolpath import LINE, RAPID, Toolpath, distinct

CHORD_MM = 0.005  # how far chords leave the arcs whose lengths and box are told
Range = tuple[float, float]


@dataclass(frozen=True)
class PathFigures:
    """Of one path; ranges are least and greatest, None where there is nothing of the kind.

    moves, rapids, arcs: rows. box_mm: of all known places, by axis. feed_mm_min: of cuts. spindle_rpm: while it turns
    or burns.
    """

    moves: int
    rapids: int
    arcs: int
    cut_length_mm: float
    rapid_length_mm: float
    tools: tuple[int, ...]
    box_mm: tuple[Range | None, Range | None, Range | None]
    feed_mm_min: Range | None
    spindle_rpm: Range | None


def figures_of(path: Toolpath) -> PathFigures:
    """Return the figures of a path of X, Y and Z; lengths from unknown places are left out."""
    table = path.table()
    pieces = segments(path, CHORD_MM)
    rapid = table.kind[pieces.row] == RAPID
    lengths_mm = np.nan_to_num(pieces.length_mm)
    states = [path.states[state] for state in distinct(table.state).tolist()]
    speeds = np.array([state.spindle_rpm for state in states if state.spindle_turns], float)
    return PathFigures(
        moves=len(table),
        rapids=int((table.kind == RAPID).sum()),
        arcs=int((table.kind > LINE).sum()),
        cut_length_mm=float(lengths_mm[~rapid].sum()),
        rapid_length_mm=float(lengths_mm[rapid].sum()),
        tools=tuple(sorted({state.tool for state in states})),
        box_mm=tuple(_range(pieces.end[:, axis], pieces.begin[:, axis]) for axis in range(3)),  # type: ignore[arg-type]
        feed_mm_min=_range(table.feed[table.kind != RAPID]),
        spindle_rpm=_range(speeds),
    )


def _range(*columns: np.ndarray) -> Range | None:
    """Return the least and the greatest of all known numbers."""
    known = [column[np.isfinite(column)] for column in columns]
    if not any(map(len, known)):
        return None
    return min(float(each.min()) for each in known if len(each)), max(float(each.max()) for each in known if len(each))
