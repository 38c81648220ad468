# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: places at lengths along a chain of lines and arcs, and the chain cut there; rows as in box_tree.py."""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.geometry.box_tree import direction_at, place_at, rows_of
from CNCStepper.geometry.curve_columns import FLAT_RAD, STRAIGHT_MM
from CNCStepper.kernels import njit
from CNCStepper.tolerances import COINCIDENT_MM


@njit
def measured(xy, bulge):
    """Return the rows of a chain and the length from its start to each of its vertices, float64[n + 1]."""
    rows, before_mm = rows_of(xy, bulge), np.zeros(len(xy))
    for row in range(len(rows)):
        before_mm[row + 1] = before_mm[row] + rows[row, 10]
    return rows, before_mm


@njit
def places_along(rows, before_mm, lengths_mm):
    """Return the place and the unit direction at each length from the start, float64[k, 2] both.

    before_mm, float64[n + 1]: the length from the start to each vertex. A length beyond an end counts as that end.
    """
    places, directions = np.empty((len(lengths_mm), 2)), np.empty((len(lengths_mm), 2))
    for index in range(len(lengths_mm)):
        length_mm = min(max(lengths_mm[index], 0.0), before_mm[-1])
        row = min(max(np.searchsorted(before_mm, length_mm, side="right") - 1, 0), len(rows) - 1)
        on_mm = length_mm - before_mm[row]
        places[index, 0], places[index, 1] = place_at(rows, row, on_mm)
        directions[index, 0], directions[index, 1] = direction_at(rows, row, on_mm)
    return places, directions


@njit
def stretch(xy, bulge, rows, before_mm, first_mm, last_mm):
    """Return the columns of the stretch between two lengths from the start, `first_mm` below `last_mm`.

    Beyond the end it continues from the start, as a closed chain does. A place within COINCIDENT_MM of a vertex is it.
    """
    whole_mm, count = before_mm[-1], 0
    part_xy, part_bulge = np.empty((len(rows) + 3, 2)), np.empty(len(rows) + 2)
    row = np.searchsorted(before_mm, first_mm + COINCIDENT_MM, side="right") - 1
    if row == len(rows):
        row, first_mm, last_mm = 0, first_mm - whole_mm, last_mm - whole_mm
    begun_mm, round_mm = first_mm, 0.0
    part_xy[0] = xy[row]
    if begun_mm > before_mm[row] + COINCIDENT_MM:
        part_xy[0, 0], part_xy[0, 1] = place_at(rows, row, begun_mm - before_mm[row])
    else:
        begun_mm = before_mm[row]
    while True:
        ends_mm = round_mm + before_mm[row + 1]
        if last_mm < ends_mm - COINCIDENT_MM:
            part_xy[count + 1, 0], part_xy[count + 1, 1] = place_at(rows, row, last_mm - round_mm - before_mm[row])
            part_bulge[count] = _bulge_of(rows, row, begun_mm, last_mm)
            break
        part_xy[count + 1] = xy[row + 1]
        is_whole = begun_mm == round_mm + before_mm[row]
        part_bulge[count] = bulge[row] if is_whole else _bulge_of(rows, row, begun_mm, ends_mm)
        if last_mm <= ends_mm + COINCIDENT_MM:
            break
        count, row, begun_mm = count + 1, row + 1, ends_mm
        if row == len(rows):
            row, round_mm = 0, round_mm + whole_mm
    return part_xy[: count + 2], part_bulge[: count + 1]


@njit
def with_vertices(xy, bulge, rows, before_mm, places_mm):
    """Return the chain with a vertex at each ascending place, float64[k], and the numbers of these vertices, int64[k].

    A place within COINCIDENT_MM of a vertex or of the place before it is that vertex.
    """
    count, total = len(bulge), len(bulge) + len(places_mm)
    cut_xy, cut_bulge, numbers = np.empty((total + 1, 2)), np.empty(total), np.empty(len(places_mm), np.int64)
    vertex, place = 0, 0
    for row in range(count):
        cut_xy[vertex], begun_mm = xy[row], before_mm[row]
        last = row + 1 == count
        while place < len(places_mm) and (last or places_mm[place] < before_mm[row + 1] - COINCIDENT_MM):
            at_mm = places_mm[place]
            if at_mm >= before_mm[-1] - COINCIDENT_MM:
                break
            if at_mm > begun_mm + COINCIDENT_MM:
                cut_bulge[vertex] = _bulge_of(rows, row, begun_mm, at_mm)
                vertex, begun_mm = vertex + 1, at_mm
                cut_xy[vertex, 0], cut_xy[vertex, 1] = place_at(rows, row, at_mm - before_mm[row])
            numbers[place] = vertex
            place += 1
        whole = begun_mm == before_mm[row]
        cut_bulge[vertex] = bulge[row] if whole else _bulge_of(rows, row, begun_mm, before_mm[row + 1])
        vertex += 1
    cut_xy[vertex] = xy[count]
    numbers[place:] = vertex
    return cut_xy[: vertex + 1], cut_bulge[:vertex], numbers


@njit
def _bulge_of(rows, row, from_mm, to_mm):
    """Return the bulge of a part of a row; 0 for one that is as good as straight."""
    bulge = math.tan(rows[row, 5] * (to_mm - from_mm) / 4.0)
    return bulge if abs(bulge) * (to_mm - from_mm) / 2.0 > STRAIGHT_MM else 0.0


@njit
def area_of(xy, bulge):
    """Return the signed area of a closed chain, positive when it runs counter-clockwise."""
    twice = 0.0
    for row in range(len(bulge)):
        bx, by, wx, wy = xy[row, 0] - xy[0, 0], xy[row, 1] - xy[0, 1], xy[row + 1, 0], xy[row + 1, 1]
        wx, wy = wx - xy[row, 0], wy - xy[row, 1]
        sweep = 4.0 * math.atan(bulge[row])
        share = sweep / 6.0
        if abs(sweep) > FLAT_RAD:
            share = (sweep - math.sin(sweep)) / (4.0 * math.sin(sweep / 2.0) ** 2)
        twice += bx * wy - by * wx + share * (wx * wx + wy * wy)
    return twice / 2.0
