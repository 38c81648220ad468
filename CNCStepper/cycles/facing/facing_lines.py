# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The facing lines of a region, and the side entry of the tool to each run.

       strip    +-----------+         A line stands in the middle of each strip, all strips equally wide, and runs from
    - - - - - -/- - - - - - -\- -     the leftmost to the rightmost place of the region in its strip, and the overhang
    ==========/===============\==     more. The tool is as wide as a strip at least, so nothing stays in it.
    - - - - -/- - - - - - - - -\-
            +-------------------+

A chain is what can be cut to and fro: lines of neighbouring strips whose ends are joined by ways that stay where the
tool's centre may be. What is to be cut comes in groups, and each group can be cut in one of several ways, each of them
a list of runs; so one can be chosen to which the tool comes from beside the stock.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from shapely import LineString
from shapely.affinity import rotate
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.cycles.clearing.spiral_pattern import spiral
from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.region import Region


@dataclass(frozen=True)
class Line:
    """One line, from left to right: the number of its strip, its ends' x, and its height."""

    strip: int
    left_mm: float
    right_mm: float
    height_mm: float

    def ends(self, rightwards: bool) -> list[tuple[float, float]]:
        """Return begin and end of the line run one way or the other."""
        points = [(self.left_mm, self.height_mm), (self.right_mm, self.height_mm)]
        return points if rightwards else points[::-1]


def lines_of(region: BaseGeometry, wide_mm: float, overhang_mm: float) -> list[Line]:
    """Return the lines of a region in strips of that width, from the lowest strip on."""
    left, low, right, high = region.bounds
    lines = []
    for strip in range(round((high - low) / wide_mm)):
        bottom = low + strip * wide_mm
        inside = shapely.clip_by_rect(region, left - 1.0, bottom, right + 1.0, bottom + wide_mm)
        spans = shapely.bounds(shapely.get_parts(inside))[:, ::2] + (-overhang_mm, overhang_mm)
        lines += [Line(strip, first, last, bottom + wide_mm / 2.0) for first, last in _merged(spans)]
    return lines


def chains_of(lines: Sequence[Line], room: BaseGeometry) -> list[list[Line]]:
    """Return the lines in chains through neighbouring strips; `room` is where the tool's centre may be."""
    shapely.prepare(room)
    done: list[list[Line]] = []
    open_: list[list[Line]] = []
    for strip, group in itertools.groupby(lines, key=lambda line: line.strip):
        grown: list[list[Line]] = []
        for line in group:
            chain = next((one for one in open_ if one[-1].strip == strip - 1 and _joins(one[-1], line, room)), None)
            if chain is None:
                grown.append([line])
            else:
                open_.remove(chain)
                grown.append([*chain, line])
        done += open_
        open_ = grown
    return done + open_


def zigzags(chains: Iterable[Sequence[Line]], angle_deg: float) -> list[list[list[Curve]]]:
    """Return a group for each chain: one run, from any of the four ends of its first and last line."""
    return [
        [
            [_turned(_to_and_fro(lines, rightwards), angle_deg)]
            for lines in (chain, chain[::-1])
            for rightwards in (True, False)
        ]
        for chain in chains
    ]


def one_way(chains: Iterable[Sequence[Line]], angle_deg: float, climb: bool) -> list[list[list[Curve]]]:
    """Return a group for each chain: a run for each line, upwards or downwards, uncut stock on the same side.

    For climb the uncut stock lies to the right: above, where lines run to the left.
    """
    groups = []
    for chain in chains:
        upwards = [_turned(np.array(line.ends(not climb)), angle_deg) for line in chain]
        downwards = [_turned(np.array(line.ends(climb)), angle_deg) for line in reversed(chain)]
        groups.append([upwards, downwards])
    return groups


def inwards(room: Region, area: Area) -> tuple[list[list[list[Curve]]], float]:
    """Return a group for each part of a room, the spiral run from the wall to the middle, and how far turns are apart.

    Raises CycleError where a part's shape does not allow it.
    """
    runs = [run for part in room.parts() for run in spiral(replace(area, room=part))]
    groups = [[[joined([one.curve.reversed() for one in reversed(run.passes)])]] for run in runs]
    return groups, max((run.apart_mm for run in runs), default=0.0)


def level(region: BaseGeometry, angle_deg: float) -> BaseGeometry:
    """Return a region turned so that lines with that angle lie level."""
    return rotate(region, -angle_deg, origin=(0.0, 0.0))


def _to_and_fro(chain: Sequence[Line], rightwards: bool) -> np.ndarray:
    return np.array([end for number, line in enumerate(chain) for end in line.ends(rightwards == (number % 2 == 0))])


def _turned(points: np.ndarray, angle_deg: float) -> Curve:
    return Curve(points, np.zeros(len(points) - 1)).rotated(angle_deg)


def _merged(spans: np.ndarray) -> list[tuple[float, float]]:
    """Return ascending spans in which overlapping ones are one."""
    found: list[tuple[float, float]] = []
    for first, last in sorted(map(tuple, spans.tolist())):
        if found and first <= found[-1][1]:
            found[-1] = (found[-1][0], max(found[-1][1], last))
        else:
            found.append((first, last))
    return found


def _joins(before: Line, after: Line, room: BaseGeometry) -> bool:
    ends = zip(before.ends(True), after.ends(True), strict=True)
    return all(room.covers(LineString([here, there])) for here, there in ends)
