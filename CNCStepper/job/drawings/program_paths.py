# SPDX-License-Identifier: LGPL-2.1-or-later
"""A G-code program as a drawing: its feeds seen from above, on a layer for each height.

    G0 ...            a rapid ends a chain
    G1 X.. Y.. ──┐
    G2 X.. Y.. ──┴─►  one chain: lines and arcs of the XY plane, exact; a move along Z alone adds nothing

Coordinates are those of the work zero of the first move. The layer is named after the height at which the chain ends,
the chain after the line of the program that begins it.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing, Share, Skipped
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.geometry.curve import Curve
from CNCStepper.input_file import read_input
from CNCStepper.tolerances import COINCIDENT_MM
from CNCStepper.toolpath import ARC_CCW, ARC_CW, RAPID, XY, Toolpath

DIALECT_OF = {".ngc": "linuxcnc"}
DIALECT = "grbl"
MOST_SKIPPED = 1000
NEAR_FULL_RAD = 1e-9


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the feeds of a program as chains; raises ProgramError for a program that the interpreter refuses."""
    place = Place(str(path))
    text = read_input(path).decode("utf-8", "replace")
    dialect = DIALECT_OF.get(path.suffix.casefold(), DIALECT)
    toolpath = interpret(text, None, dialect, str(path), lambda done: share(0.8 * done))
    with placed(place):
        chains, skipped = feeds(toolpath)
    if not chains:
        what = "the program holds no feed that is seen from above"
        raise JobError("program-empty", what, advice="give a program that cuts along X and Y", place=place)
    warnings = (Text("the program is read as {dialect}", dialect=dialect),)
    return Drawing(tuple(chains), skipped=tuple(skipped), warnings=warnings)


def feeds(toolpath: Toolpath) -> tuple[list[Chain], list[Skipped]]:
    """Return the chains of feeds of a table of moves, and the first MOST_SKIPPED of the feeds that are in none."""
    table, zero_mm = toolpath.table(), _zero_mm(toolpath)
    begins, ends = toolpath.begins()[:, :3] - zero_mm, table.end[:, :3] - zero_mm
    feeds_on = table.kind != RAPID
    known = np.isfinite(begins[:, :2]).all(axis=1) & np.isfinite(ends[:, :2]).all(axis=1)
    arcs = (table.kind == ARC_CW) | (table.kind == ARC_CCW)
    readable = feeds_on & known & (~arcs | (table.plane == XY))
    skipped = [_skipped(int(table.line[row]), bool(known[row])) for row in np.flatnonzero(feeds_on & ~readable)]
    bulges, halves = _bulges(toolpath, begins, ends, arcs)
    moves = readable & (halves | (np.hypot(*(ends - begins)[:, :2].T) > COINCIDENT_MM))
    chains = []
    for rows in np.split(np.arange(len(table)), np.flatnonzero(~readable)):
        own = rows[moves[rows]]
        if len(own):
            chains.append(_chain(own, begins, ends, bulges, halves, table.centre - zero_mm, int(table.line[own[0]])))
    return chains, skipped[:MOST_SKIPPED]


def _zero_mm(toolpath: Toolpath) -> np.ndarray:
    """Return the work zero of the first move, float64[3]: one that is set later moves no line of the drawing."""
    return toolpath.offsets_mm()[0] if len(toolpath) else np.zeros(3)  # type: ignore[no-any-return]


def _skipped(line: int, is_known: bool) -> Skipped:
    why = "an arc of another plane than XY" if is_known else "its begin is not known"
    return Skipped("feed", "", f"line {line}", why)


def _bulges(
    toolpath: Toolpath, begins: np.ndarray, ends: np.ndarray, arcs: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the bulge of each row, 0 for lines, and which rows are full circles, whose bulge is that of each half."""
    table = toolpath.table()
    centres = (table.centre - _zero_mm(toolpath))[:, :2]
    first, last = ((places[:, :2] - centres) @ (1.0, 1j) for places in (begins, ends))
    sense = np.where(table.kind == ARC_CCW, 1.0, -1.0)
    sweep = np.mod(sense * (np.angle(last) - np.angle(first)), math.tau)
    whole = arcs & ((sweep <= NEAR_FULL_RAD) | (sweep >= math.tau - NEAR_FULL_RAD) | (table.turns > 1))
    sweep = np.where(whole, math.pi, sweep)
    return np.where(arcs, sense * np.tan(sweep / 4.0), 0.0), whole


def _chain(
    rows: np.ndarray,
    begins: np.ndarray,
    ends: np.ndarray,
    bulges: np.ndarray,
    whole: np.ndarray,
    centres: np.ndarray,
    line: int,
) -> Chain:
    xy, sweeps = [begins[rows[0], :2]], []
    for row in rows.tolist():
        if whole[row]:
            xy.append(2.0 * centres[row, :2] - xy[-1])
            sweeps.append(bulges[row])
        xy.append(ends[row, :2])
        sweeps.append(bulges[row])
    height_mm = round(float(ends[rows[-1], 2]), 4)
    layer = f"Z {height_mm:g}" if math.isfinite(height_mm) else "Z ?"
    return Chain(Curve(np.array(xy), np.array(sweeps)), Attributes(layer=layer, name=f"line {line}"))
