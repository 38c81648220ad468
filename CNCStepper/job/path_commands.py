# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moves of a program as the commands of FreeCAD's Path, thinned where there are more than a window can draw."""

from __future__ import annotations

from math import isfinite

import numpy as np

from CNCStepper.toolpath import ARC_CW, LINE, RAPID, XY, Toolpath

MOST_MOVES = 20_000
NAMES = ("G0", "G1", "G2", "G3")
Command = tuple[str, dict[str, float]]


def commands(toolpath: Toolpath, most: int = MOST_MOVES) -> list[Command]:
    """Return at most `most` commands G0, G1, G2, G3 with their words in mm, in the table's coordinates.

    Arcs outside the XY plane, of several turns, or whose start was thinned away become straight lines. An axis
    whose position is not yet known is left out.
    """
    table, begins = toolpath.table(), toolpath.begins()
    rows = kept_rows(table.kind, most)
    follows = np.diff(rows, prepend=-1) == 1
    is_arc = (table.kind >= ARC_CW) & (table.plane == XY) & (table.turns == 1)
    kinds = np.where(is_arc[rows] & follows, table.kind[rows], np.minimum(table.kind[rows], LINE))
    ends, centres = table.end[rows, :3], table.centre[rows, :2] - begins[rows, :2]
    return [_command(*row) for row in zip(kinds.tolist(), ends.tolist(), centres.tolist(), strict=True)]


def gcode(moves: list[Command]) -> str:
    """Return commands as text, which FreeCAD's Path reads in half the time that it takes single commands."""
    lines = (f"{name} {' '.join(f'{letter}{value:.6f}' for letter, value in words.items())}" for name, words in moves)
    return "\n".join(lines)


def kept_rows(kind: np.ndarray, most: int) -> np.ndarray:
    """Return which rows to draw, ascending: all, or the ends of runs of rapids and of feeds and evenly some between.

    The last row is always there. Where even the ends of runs are too many, they too are taken evenly.
    """
    count = len(kind)
    if count <= most:
        return np.arange(count)
    rapid = kind == RAPID
    ends = np.append(np.flatnonzero(rapid[1:] != rapid[:-1]), count - 1)
    if len(ends) >= most:
        return ends[_evenly(len(ends), most)]
    between = np.setdiff1d(np.arange(count), ends, assume_unique=True)
    return np.union1d(ends, between[_evenly(len(between), most - len(ends))])


def _evenly(count: int, wanted: int) -> np.ndarray:
    """Return `wanted` different indices below `count`, the last one among them."""
    return (np.arange(1, wanted + 1) * count) // wanted - 1


def _command(kind: int, end_mm: list[float], centre_mm: list[float]) -> Command:
    """Return a move as a command; centre_mm: of an arc, from its begin."""
    words = {axis: value for axis, value in zip("XYZ", end_mm, strict=False) if isfinite(value)}
    if kind >= ARC_CW:
        words["I"], words["J"] = centre_mm
    return NAMES[kind], words
