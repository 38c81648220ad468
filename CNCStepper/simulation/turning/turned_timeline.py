# SPDX-License-Identifier: LGPL-2.1-or-later
"""A turned part at any moment of its program: the passes that are done, and the move in hand as far as it has come.

marks        stock ── pass ── pass ────── pass ──►      regions that are kept: after each pass, and within
moves          | | |  | | | | | | | | | |  | |          long ones after every SPACING moves that cut
a moment                          ^ the mark before it, less what the moves since then have swept
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.tip_track import TipTrack
from CNCStepper.simulation.turning.half_section import HalfSection, solid
from CNCStepper.simulation.turning.swept_outline import Moves, swept
from CNCStepper.simulation.turning.turned_part import Sections, TurnedPart
from CNCStepper.toolpath import Toolpath

SPACING = 24  # moves that cut between two regions that are kept
ALONG = [2, 0]  # columns of z and radius in a point


@dataclass(frozen=True)
class TurnedMoment:
    """The part at a moment. done: how many moves have ended; partial: what the one in hand has swept, None for none.

    tool: the number of the one in hand, 0 before the first.
    """

    section: HalfSection
    done: int
    partial: BaseGeometry | None
    tool: int


class TurnedTimeline:
    """The part of a program by time, in s.

    track: of the program, as `track_of` gives it. first_row: the program's first one in the part's moves, behind the
    programs before it.
    """

    def __init__(self, part: TurnedPart, tools: Sections, track: TipTrack, first_row: int = 0):
        self.part, self.track = part, track
        self._tools, self._first = tools, first_row
        self._cuts = ~part.moves.rapid
        self._cuts[[contact.move for contact in part.rapids]] = True
        self._marks = _spaced(part, self._cuts)

    @property
    def duration_s(self) -> float:
        """How long the program runs."""
        return self.track.duration_s

    def at(self, time_s: float) -> TurnedMoment:
        """Return the part at a moment, with the pieces that have fallen until then."""
        moves, done, share = self.part.moves, *self._done(time_s)
        place = bisect_right(self._marks, done, key=lambda mark: mark[0]) - 1
        since, region = self._marks[place]
        partial = self._partial(done, share) if share > 0 else None
        gone = self.part.areas[since:done][self._cuts[since:done]]
        if len(gone) or partial is not None:
            region = solid(region.difference(shapely.union_all([*gone, partial])))
        fallen = [one.section.region for one in self.part.fallen if one.move < done]
        if fallen:
            region = shapely.union_all([region, *fallen])
        current = min(done, len(moves) - 1)
        return TurnedMoment(HalfSection(region), done, partial, int(moves.tool[current]) if len(moves) else 0)

    def cutters(self, moment: TurnedMoment, places: np.ndarray, near_mm: float) -> np.ndarray:
        """Return which tool has cut each place of a surface, float64[n, 2], last: int64[n], 0 for raw stock.

        near_mm: how far the places may be from the surface.
        """
        points, last = shapely.points(places), np.full(len(places), -1)
        found, area = self._tree.query(points, predicate="dwithin", distance=near_mm)
        move = self._cutting[area]
        until = move < moment.done
        np.maximum.at(last, found[until], move[until])
        tools = (
            np.where(last >= 0, self.part.moves.tool[last], 0) if len(self.part.moves) else np.zeros(len(places), int)
        )
        if moment.partial is not None:
            tools[shapely.dwithin(points, moment.partial, near_mm)] = moment.tool
        return tools

    def _done(self, time_s: float) -> tuple[int, float]:
        """Return how many moves have ended at a moment, and the share that the one in hand has done."""
        rows, own = self.part.moves.row, self.track.row_at(time_s) if len(self.track) else -1
        if own < 0:
            return 0, 0.0
        first, last = np.searchsorted(rows, [self._first + own, self._first + own + 1]).tolist()
        way = (last - first) * self.track.share_at(own, time_s)
        whole = int(way)
        return first + whole, way - whole

    def _partial(self, move: int, share: float) -> BaseGeometry | None:
        """Return what a move has swept when it has done a share of its way; None for one that cuts nothing."""
        if move >= len(self._cuts) or not self._cuts[move]:
            return None
        whole = self.part.moves[move : move + 1]
        part = replace(whole, end=whole.begin + (whole.end - whole.begin) * share)
        return swept(self._tools[int(whole.tool[0])].cutting_parts, part)[0]  # type: ignore[no-any-return]

    @cached_property
    def _cutting(self) -> np.ndarray:
        return np.flatnonzero(self._cuts)

    @cached_property
    def _tree(self) -> shapely.STRtree:
        return shapely.STRtree(self.part.areas[self._cutting])


def _spaced(part: TurnedPart, cuts: np.ndarray) -> list[tuple[int, BaseGeometry]]:
    """Return the marks of a part with the stock before them, and further ones within long passes."""
    marks: list[tuple[int, BaseGeometry]] = [(0, part.stock.region)]
    for done, region in part.marks:
        before, left = marks[-1]
        own = before + np.flatnonzero(cuts[before:done])
        for last in own[SPACING - 1 : -1 : SPACING].tolist():
            left = solid(left.difference(shapely.union_all(part.areas[before : last + 1][cuts[before : last + 1]])))
            before = last + 1
            marks.append((before, left))
        marks.append((done, region))
    return marks


def track_of(path: Toolpath, ends_s: np.ndarray, moves: Moves, first_row: int = 0) -> TipTrack:
    """Return the track of a program's table of moves on the part, the control point where the part's moves have it.

    ends_s: when each row ends. moves: of the part, the program's rows from first_row on.
    """
    track = TipTrack.of(path, ends_s)
    rows = first_row + np.arange(len(track))
    first, after = (np.searchsorted(moves.row, rows, side=side) for side in ("left", "right"))
    known = np.flatnonzero(after > first)
    begin, end, centre = track.begin.copy(), track.end.copy(), track.centre.copy()
    shift = moves.begin[first[known]] - begin[known][:, ALONG]
    place = np.ix_(known, np.array(ALONG))
    centre[place] += np.where(np.isfinite(shift), shift, 0.0)
    begin[place] = moves.begin[first[known]]
    end[place] = moves.end[after[known] - 1]
    begin[:, 1] = end[:, 1] = 0.0
    return replace(track, begin=begin, end=end, centre=centre)
