# SPDX-License-Identifier: LGPL-2.1-or-later
r"""How a contour is run, level by level.

plunge, closed      down at the start (or at the begin of the lead-in), round, on to the next level
plunge, open        down at the begin, along, up and back; on its line it may turn and cut on the way back
ramp, closed        round and round with even fall, no lap deeper than the stepdown or steeper than the ramp, then
                    one level lap; the lead-out is cut out and back at the end of each lap, so that it too deepens
                    by steps
ramp, open          down the whole way from the end to the begin, then level in the wanted direction

 floor before  ----------.            .----------   over a tab the tool goes straight up, along, and straight
 tab's top                \  .----.  .              down at the plunge feed
 floor         ------------`-'    `--'-----------
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from CNCStepper.cycles.contours.leads import Fitted
from CNCStepper.cycles.moves import Moves, point_of
from CNCStepper.geometry.curve import Curve, joined

Piece = tuple[Curve, bool]  # a stretch of path, and whether the tool is to be above the tabs along it


@dataclass(frozen=True)
class Path:
    """A contour that is ready to run: its pieces from its start on, its leads, and what runs on past its start.

    relieved: the pieces with the strokes into inside corners, as they are run. whole: the same in one piece, as it is
    run above the tabs. overcut: the head of the first piece; head_mm: how long that is with its strokes. closed: it
    ends where it begins. floors_mm: its levels. finishing: it is the last along this wall. turns: an open one may be
    cut in either direction.
    """

    pieces: tuple[Piece, ...]
    relieved: tuple[Piece, ...]
    whole: Curve
    fitted: Fitted
    overcut: Curve | None
    head_mm: float
    closed: bool
    floors_mm: tuple[float, ...]
    finishing: bool
    turns: bool

    @property
    def stays(self) -> bool:
        """Whether the tool ends a level where it begins the next one."""
        return not self.fitted.leads and (self.overcut is None if self.closed else self.turns)

    @property
    def blocks(self) -> int:
        """Return about how many blocks it takes."""
        return (len(self.floors_mm) + 1) * (sum(len(piece) + 2 * up for piece, up in self.relieved) + 6)

    def cutting_leads(self, ramping: bool) -> list[Curve]:
        """Return the leads that cut; a spiral's lead-in stays above the stock."""
        if ramping and self.closed:
            return [self.fitted.lead_out] if self.fitted.lead_out is not None else []
        return self.fitted.leads

    def low_curves(self, ramping: bool) -> list[Curve]:
        """Return where the tool is at the lowest floor."""
        runs: list[list[Curve]] = [[]]
        for piece, up in self.pieces:
            if up:
                runs.append([])
            else:
                runs[-1].append(piece)
        return [joined(run) for run in runs if run] + self.cutting_leads(ramping)


def run(path: Path, moves: Moves, tab_top_mm: float, feed_mm_min: float, ramping: bool) -> None:
    """Cut a contour at all its levels, from above and up again."""
    runner = _Runner(path, moves, tab_top_mm, feed_mm_min)
    if ramping:
        runner.spiral() if path.closed else runner.to_and_fro()
    else:
        runner.levels()
    moves.retract()


@dataclass(frozen=True)
class _Runner:
    path: Path
    moves: Moves
    tab_top_mm: float
    feed_mm_min: float

    def levels(self) -> None:
        path, lead_in, lead_out = self.path, self.path.fitted.lead_in, self.path.fitted.lead_out
        for number, floor_mm in enumerate(path.floors_mm):
            pieces = self._pieces(floor_mm)
            if path.turns and not path.closed and number % 2:
                pieces = _back(pieces)
            if number == 0 or not path.stays:
                self._come((pieces[0][0] if lead_in is None else lead_in).xy[0])
            self.moves.plunge(floor_mm)
            self._follow(lead_in)
            self._along(pieces, floor_mm, floor_mm)
            self._follow(path.overcut)
            self._follow(lead_out)

    def spiral(self) -> None:
        path, lead_in = self.path, self.path.fitted.lead_in
        self._come((path.whole if lead_in is None else lead_in).xy[0])
        self.moves.plunge(0.0)
        self._follow(lead_in)
        for top_mm, floor_mm in pairwise((0.0, *path.floors_mm)):
            head, rest = _parted(self._pieces(floor_mm), path.head_mm)
            there_mm = top_mm + (floor_mm - top_mm) * _length_mm(head) / _length_mm([*head, *rest])
            self._along(head, top_mm, there_mm)
            self._out_and_back()
            self._along(rest, there_mm, floor_mm)
        self._along(self._pieces(path.floors_mm[-1]), path.floors_mm[-1], path.floors_mm[-1])
        self._follow(path.overcut)
        self._follow(path.fitted.lead_out)

    def to_and_fro(self) -> None:
        path, lead_in, lead_out = self.path, self.path.fitted.lead_in, self.path.fitted.lead_out
        self._come((path.whole if lead_out is None else lead_out).xy[-1])
        self.moves.plunge(0.0)
        for top_mm, floor_mm in pairwise((0.0, *path.floors_mm)):
            way = [*_alone(lead_in), *self._pieces(floor_mm), *_alone(lead_out)]
            self._along(_back(way), top_mm, floor_mm)
            self._along(way, floor_mm, floor_mm)

    def _pieces(self, floor_mm: float) -> Sequence[Piece]:
        """Return what is run on the way to a floor: above all tabs nothing need be cut in pieces."""
        return self.path.relieved if floor_mm < self.tab_top_mm else [(self.path.whole, False)]

    def _come(self, xy) -> None:
        if not math.isnan(self.moves.z_mm):
            self.moves.retract()
        self.moves.approach(point_of(xy))

    def _out_and_back(self) -> None:
        if (lead_out := self.path.fitted.lead_out) is not None:
            self._follow(lead_out)
            self._follow(lead_out.reversed())

    def _follow(self, curve: Curve | None) -> None:
        if curve is not None:
            self.moves.follow(curve, self.feed_mm_min)

    def _along(self, pieces: Sequence[Piece], top_mm: float, floor_mm: float) -> None:
        """Run along the pieces with even fall, above the tabs where the tool must be."""
        whole_mm = _length_mm(pieces)
        done_mm = 0.0
        for piece, up in pieces:
            begin_mm = top_mm + (floor_mm - top_mm) * done_mm / whole_mm
            done_mm += piece.length_mm
            end_mm = top_mm + (floor_mm - top_mm) * done_mm / whole_mm
            if up:
                self._over(piece, begin_mm, end_mm)
            else:
                self._slope(piece, begin_mm, end_mm)

    def _over(self, piece: Curve, begin_mm: float, end_mm: float) -> None:
        """Run along a piece, but never below the tabs' top."""
        if end_mm >= self.tab_top_mm:
            self._slope(piece, begin_mm, end_mm)
            return
        if begin_mm > self.tab_top_mm:
            share = (begin_mm - self.tab_top_mm) / (begin_mm - end_mm)
            parts = piece.split([share * piece.length_mm])
            self._slope(parts[0], begin_mm, self.tab_top_mm)
            piece = parts[-1]
        if begin_mm <= self.tab_top_mm or len(parts) > 1:
            self._slope(piece, self.tab_top_mm, self.tab_top_mm)

    def _slope(self, piece: Curve, begin_mm: float, end_mm: float) -> None:
        if self.moves.z_mm != begin_mm:
            self.moves.plunge(begin_mm)
        if begin_mm == end_mm:
            self.moves.follow(piece, self.feed_mm_min)
        else:
            self.moves.slope(piece, end_mm, self.feed_mm_min)


def _parted(pieces: Sequence[Piece], head_mm: float) -> tuple[list[Piece], list[Piece]]:
    """Return the pieces up to where the lead-out begins and those after; no tab stands before."""
    if not head_mm:
        return [], list(pieces)
    (first, up), *rest = pieces
    head, *tail = first.split([head_mm])
    return [(head, up)], [(piece, up) for piece in tail] + rest


def _alone(lead: Curve | None) -> list[Piece]:
    return [] if lead is None else [(lead, False)]


def _back(pieces: Sequence[Piece]) -> list[Piece]:
    return [(piece.reversed(), up) for piece, up in reversed(pieces)]


def _length_mm(pieces: Sequence[Piece]) -> float:
    return sum(piece.length_mm for piece, _ in pieces)
