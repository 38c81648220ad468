# SPDX-License-Identifier: LGPL-2.1-or-later
"""The area that a tool's outline sweeps along moves: of a convex part the hull of it at both ends, exactly.

A tool that crosses the axis cuts on the other side too, as the part turns: its mirror image belongs to the area.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.tip_segments import segments
from CNCStepper.simulation.turning.tool_section import CHORD_MM
from CNCStepper.tolerances import NO_LENGTH_MM, SAME_MM
from CNCStepper.toolpath import RAPID, Toolpath

BLOCK = 4096  # moves that are swept at once


@dataclass(frozen=True)
class Moves:
    """Straight moves of the tool's control point in the half plane, columns of n.

    begin, end: float64[n, 2], z and r in mm. row: index into the table. tool: its number. rapid: bool. pitch_mm: of a
    move that follows the spindle, else 0. feed_mm_turn: NaN where the spindle's speed is not known. line: of the file.
    """

    begin: np.ndarray
    end: np.ndarray
    row: np.ndarray
    tool: np.ndarray
    rapid: np.ndarray
    pitch_mm: np.ndarray
    feed_mm_turn: np.ndarray
    line: np.ndarray

    def __len__(self) -> int:
        return len(self.row)

    def __getitem__(self, which: np.ndarray | slice) -> Moves:
        return Moves(*(getattr(self, one.name)[which] for one in fields(self)))


def moves_of(toolpath: Toolpath, chuck_at_minus_z: bool = True) -> Moves:
    """Return the known moves of a table (X as radius) with arcs as chords, in the work system of its first row.

    chuck_at_minus_z: whether Z falls towards the chuck, as on most lathes; else Z is turned round.
    """
    table, states = toolpath.table(), toolpath.states
    pieces = segments(toolpath, CHORD_MM)
    place = [2, 0]
    begin, end = (points[:, place] + _tool_offsets(toolpath)[pieces.row] for points in (pieces.begin, pieces.end))
    if not chuck_at_minus_z:
        begin, end = begin * (-1, 1), end * (-1, 1)
    known = np.isfinite(begin).all(axis=1) & np.isfinite(end).all(axis=1)
    row = pieces.row[known]
    state = table.state[row]
    used = {index: states[index] for index in np.unique(state).tolist()}
    rpm = np.array([used[index].spindle_rpm or np.nan for index in state.tolist()], float)
    tool = np.array([used[index].tool for index in state.tolist()], int)
    pitch = np.zeros(len(table))
    for event in toolpath.events:
        if event.kind == "synchronised" and 0 <= event.index - table.first < len(table):
            pitch[event.index - table.first] = abs(event.value)
    rapid = table.kind[row] == RAPID
    per_turn = np.array([used[index].feed_mm_turn * (used[index].feed_mode == "per_turn") for index in state.tolist()])
    feed_mm_turn = np.where(per_turn > 0, per_turn, table.feed[row] / rpm)
    return Moves(begin[known], end[known], row, tool, rapid, pitch[row], feed_mm_turn, table.line[row])


def _tool_offsets(toolpath: Toolpath) -> np.ndarray:
    """Return what a lathe tool's own offset along Z and X adds to the stock's frame on each row, float64[n, 2].

    The tip lies at work coordinates in whatever offset of the tool is in force; the frame knows its length alone.
    """
    states = toolpath.states
    if not len(toolpath):
        return np.zeros((0, 2))
    table = toolpath.table()
    first = toolpath.frame or states[int(table.state[0])]
    known = toolpath.start.work_offsets_mm
    shifts = {}
    for index in np.unique(table.state).tolist():
        state = states[index]
        system, home = (np.array(known.get(one.work_system, (0.0, 0.0, 0.0))[:3]) for one in (state, first))
        moved = np.array(state.g92_mm[:3]) - np.array(first.g92_mm[:3]) + system - home
        own = np.array(first.offset_mm[:3]) - np.array(state.offset_mm[:3]) + moved
        own[2] += state.tool_length_mm - first.tool_length_mm
        shifts[index] = own[[2, 0]]
    return np.array([shifts[index] for index in table.state.tolist()])


def swept(parts: list[np.ndarray], moves: Moves) -> np.ndarray:
    """Return the area that an outline's convex parts sweep on each move, an array of n shapely geometries."""
    areas = np.empty(len(moves), object)
    for first in range(0, len(moves), BLOCK):
        some = moves[first : first + BLOCK]
        of_parts = [hulls(part, some.begin, some.end) for part in parts]
        areas[first : first + BLOCK] = of_parts[0] if len(parts) == 1 else shapely.union_all(of_parts, axis=0)
    for index in np.flatnonzero(moves.pitch_mm > 0).tolist():
        areas[index] = _thread_section(parts, moves[index : index + 1])
    return _mirrored_at_axis(areas)


def outlines_at(parts: list[np.ndarray], places: np.ndarray) -> np.ndarray:
    """Return the outline at each place, float64[n, 2], on both sides of the axis: an array of n shapely geometries."""
    of_parts = [hulls(part, places, places) for part in parts]
    return _mirrored_at_axis(of_parts[0] if len(parts) == 1 else np.asarray(shapely.union_all(of_parts, axis=0)))


def hulls(part: np.ndarray, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return the hulls of a convex outline at both ends of each move."""
    corners = np.concatenate([begin[:, None] + part, end[:, None] + part], axis=1)
    count = corners.shape[1]
    index = np.repeat(np.arange(len(begin)), count)
    return shapely.convex_hull(shapely.multipoints(corners.reshape(-1, 2), indices=index))  # type: ignore[no-any-return]


def swept_at(part: np.ndarray, ends: np.ndarray) -> BaseGeometry:
    """Return the area of a convex outline between two places, float64[2, 2]."""
    return hulls(part, ends[:1], ends[1:])[0]


def _thread_section(parts: list[np.ndarray], move: Moves) -> BaseGeometry:
    """Return what a move that follows the spindle cuts out of one half section: the outline once a turn.

    The half plane meets the tool when the turn is whole; the move begins at the spindle's index.
    """
    way = move.end[0] - move.begin[0]
    length_mm = float(np.hypot(*way))
    if abs(way[0]) <= NO_LENGTH_MM:
        return shapely.union_all([hulls(part, move.begin, move.end)[0] for part in parts])
    along_mm = np.arange(0.0, length_mm + SAME_MM, move.pitch_mm[0])
    return shapely.union_all(outlines_at(parts, move.begin[0] + way * (along_mm / length_mm)[:, None]))


def _mirrored_at_axis(areas: np.ndarray) -> np.ndarray:
    """Return the areas with the mirror images of those that cross the axis."""
    below = shapely.bounds(areas)[:, 1] < 0
    if below.any():
        images = shapely.transform(areas[below], lambda points: points * (1.0, -1.0))
        areas[below] = shapely.union(areas[below], images)
    return areas
