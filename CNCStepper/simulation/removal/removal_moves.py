# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moves that remove material, as the kernels want them: straight lines, and arcs of the XY plane as they are.

Arcs of the other planes, and spirals, are chords that leave them by at most CHORD_MM.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from CNCStepper.machine.tools.tool_profile import Form, form_of
from CNCStepper.simulation.arc_chords import Arcs, arcs_of
from CNCStepper.simulation.cutter_solid import BEAM, Tools, tool_numbered
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, chords_of, tips_mm
from CNCStepper.toolpath import RAPID, XY, Toolpath

CHORD_MM = 0.0002
SPIRAL_MM = 0.02  # an arc whose two radii differ by more is no rounded arc
AFTER_LAST, BEFORE_NEXT = 1, 2  # bits of `joined`
ARC_COLUMNS = 6  # centre x, y; angle at the begin; sweep, signed (rad); radius at begin and end


@dataclass(frozen=True)
class Moves:
    """n moves of the tip in the stock's frame, in the order in which they are run.

    begin, end: float64[n, 3], mm. arc: int64[n], index into `arcs`, -1 for a line. arcs: float64[k, 6].
    form: int64[n], index into `forms`, float64[f, 4], the fields of `Form`. joined: uint8[n], a line that goes on
    where the line before it with the same form ended (AFTER_LAST), or is gone on from (BEFORE_NEXT).
    row: int64[n], of the table of moves. share: float64[n], of the row's length that is done at the move's end.
    """

    begin: np.ndarray
    end: np.ndarray
    arc: np.ndarray
    arcs: np.ndarray
    form: np.ndarray
    forms: np.ndarray
    joined: np.ndarray
    row: np.ndarray
    share: np.ndarray

    def __len__(self) -> int:
        return len(self.row)

    @classmethod
    def lines(cls, begin: np.ndarray, end: np.ndarray, form: Form) -> Moves:
        """Return straight moves of one cutter from begin[n, 3] to end[n, 3], each on a row of its own."""
        rows = np.arange(len(begin))
        pieces = Segments(np.asarray(begin, float), np.asarray(end, float), rows)
        return _moves(pieces, np.full(len(rows), -1), np.zeros((0, ARC_COLUMNS)), np.zeros(len(rows), int), [form])

    def part_of(self, index: int, share: float) -> Moves:
        """Return the first `share` of one move, as the last move that there is."""
        begin, end = self.begin[index : index + 1], self.end[index : index + 1]
        arcs = self.arcs[self.arc[index : index + 1]].copy() if self.arc[index] >= 0 else self.arcs[:0]
        if share < 1.0:
            end = begin + (end - begin) * share
            arcs[:, 5] = arcs[:, 4] + (arcs[:, 5] - arcs[:, 4]) * share
            arcs[:, 3] *= share
        return Moves(
            begin,
            end,
            np.array([len(arcs) - 1]),
            arcs,
            self.form[index : index + 1],
            self.forms,
            self.joined[index : index + 1] & AFTER_LAST,
            self.row[index : index + 1],
            self.share[index : index + 1],
        )


def moves_of(toolpath: Toolpath, tools: Tools, stock: Stock) -> Moves:
    """Return the moves that can reach into the stock; rows with a tool that is not among `tools` are left out."""
    table = toolpath.table()
    begin, end = tips_mm(toolpath)
    shape = arcs_of(table, begin, end, table.centre + (end - table.end[:, :3]))[XY]
    round_ = np.abs(shape.radius[:, 1] - shape.radius[:, 0]) <= SPIRAL_MM
    whole = np.zeros(len(table), bool)
    whole[shape.rows[round_]] = True
    pieces = chords_of(table, begin, end, CHORD_MM, whole)
    share = _shares(pieces.row)
    arc_of_row = np.full(len(table), -1)
    arc_of_row[shape.rows[round_]] = np.arange(int(round_.sum()))
    forms, form_of_row, beam = _forms(toolpath, tools, stock)
    pieces = _through(pieces, beam[pieces.row], stock.bottom_mm)
    used = (form_of_row[pieces.row] >= 0) & (pieces.low_mm < stock.top_mm)
    if not pieces.are_known:
        used &= np.isfinite(pieces.begin).all(axis=1) & np.isfinite(pieces.end).all(axis=1)
    row = pieces.row[used]
    return _moves(pieces[used], arc_of_row[row], _columns(shape, round_), form_of_row[row], forms, share[used])


def _moves(
    pieces: Segments,
    arc: np.ndarray,
    arcs: np.ndarray,
    form: np.ndarray,
    forms: Sequence[Form],
    share: np.ndarray | None = None,
) -> Moves:
    joined = np.zeros(len(pieces), np.uint8)
    if len(pieces) > 1:
        goes_on = (pieces.begin[1:] == pieces.end[:-1]).all(axis=1) & (form[1:] == form[:-1])
        goes_on &= (arc[1:] < 0) & (arc[:-1] < 0)
        joined[1:][goes_on] |= AFTER_LAST
        joined[:-1][goes_on] |= BEFORE_NEXT
    return Moves(
        np.ascontiguousarray(pieces.begin),
        np.ascontiguousarray(pieces.end),
        arc,
        arcs,
        form,
        np.array(forms, float).reshape(-1, len(Form._fields)),
        joined,
        pieces.row,
        np.ones(len(pieces)) if share is None else share,
    )


def _forms(toolpath: Toolpath, tools: Tools, stock: Stock) -> tuple[list[Form], np.ndarray, np.ndarray]:
    """Return the forms used, the form of every row (-1: none that cuts), and which rows are cut by a beam."""
    table = toolpath.table()
    forms: list[Form] = []
    of_state, is_beam = np.full(len(toolpath.states), -1), np.zeros(len(toolpath.states), bool)
    for k, state in enumerate(toolpath.states):
        tool = tool_numbered(tools, state.tool)
        if tool is None or (tool.shape in BEAM and not state.spindle_turns):
            continue
        form = form_of(tool, stock.top_mm - stock.bottom_mm)
        if form not in forms:
            forms.append(form)
        of_state[k], is_beam[k] = forms.index(form), tool.shape in BEAM
    form_of_row, beam = of_state[table.state], is_beam[table.state]
    form_of_row[beam & (table.kind == RAPID)] = -1
    return forms, form_of_row, beam


def _through(pieces: Segments, beam: np.ndarray, bottom_mm: float) -> Segments:
    """Return the segments with those of a beam laid at the stock's bottom."""
    if not beam.any():
        return pieces
    begin, end = pieces.begin.copy(), pieces.end.copy()
    begin[beam, 2] = end[beam, 2] = bottom_mm
    return Segments(begin, end, pieces.row)


def _shares(row: np.ndarray) -> np.ndarray:
    """Return how much of its row is done at the end of each segment."""
    if not len(row):
        return np.ones(0)
    first = np.r_[True, row[1:] != row[:-1]]
    if first.all():
        return np.ones(len(row))
    counts = np.bincount(row)[row]
    place = np.arange(len(row)) - np.maximum.accumulate(np.where(first, np.arange(len(row)), 0))
    return (place + 1) / counts


def _columns(shape: Arcs, which: np.ndarray) -> np.ndarray:
    return np.column_stack(
        [shape.centre[which, :2], shape.angle[which], shape.sweep[which], shape.radius[which]]
    ).reshape(-1, ARC_COLUMNS)
