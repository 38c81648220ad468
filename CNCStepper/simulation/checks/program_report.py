# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a program as plain data for strict JSON: the same program gives the same bytes.

Lengths are those of the tip in work coordinates. What is not known is null, never NaN.

A set of lines of a file, a bit each: that of 100 000 000 lines takes 13 MB.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.simulation.arc_chords import extremes
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.tip_segments import Segments, clipped_below, segments_of_chunks, tips_mm, tips_of_chunks
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Span, Toolpath, distinct

if TYPE_CHECKING:
    from CNCStepper.simulation.cutter_solid import Tools
    from CNCStepper.simulation.exact.gouge import Worst
    from CNCStepper.simulation.exact.swept_area import Judgement
    from CNCStepper.simulation.removal.heightmap import HeightMap

BITS = 8  # of a byte
BLOCK = 1 << 20  # bytes that are counted at once


class LineSet:
    """Line numbers from 1; 0, no line, is never in it."""

    def __init__(self) -> None:
        self._bits = np.zeros(0, np.uint8)

    def add(self, lines: np.ndarray) -> None:
        """Take lines, int[n], in any order."""
        if not len(lines):
            return
        first, last = int(lines.min()) // BITS, int(lines.max()) // BITS + 1
        if last > len(self._bits):
            self._bits = np.append(self._bits, np.zeros(last, np.uint8))
        among = np.zeros((last - first) * BITS, bool)
        among[lines - first * BITS] = True
        if first == 0:
            among[0] = False
        self._bits[first:last] |= np.packbits(among)

    def count(self) -> int:
        """Return how many there are."""
        blocks = (self._bits[first : first + BLOCK] for first in range(0, len(self._bits), BLOCK))
        return sum(int(np.count_nonzero(np.unpackbits(block))) for block in blocks)


DECIMALS = 6
SAME_PLACE_DECIMALS = 3
LENGTH_TOLERANCE_MM = 0.001  # of the chords whose lengths stand for an arc's


def report(
    toolpath: Toolpath,
    times_s: np.ndarray,
    *,
    whole_s: float | None = None,
    file: str = "",
    findings: Sequence[Finding] = (),
    judgement: Judgement | None = None,
    part: HeightMap | None = None,
    tools: Tools | None = None,
    pieces: Sequence[dict[str, Any]] = (),
) -> dict[str, Any]:
    """Return the figures of a program, as dicts, lists, texts, numbers and None; see `Figures`.

    times_s: end time of every row, float64[n]. whole_s: with what is waited behind the last one; None where nothing is.
    part: the stock after the program. pieces: what is cut free of a sheet, as `SheetVerdict.told` has them.
    """
    figures = Figures(tools)
    figures.see(toolpath, times_s, [row for span in _operations(toolpath.spans) for row in (span.first, span.last)])
    known: dict[str, Any] = {"findings": findings, "judgement": judgement, "part": part, "pieces": pieces}
    return figures.report(toolpath, whole_s=whole_s, file=file, **known)


class Figures:
    """The figures of a program that may come in parts, each a whole table of consecutive rows.

    Its blocks are the lines of the file that move, however often they are run; its moves are those of the machine.
    tools: a beam among them cuts wherever it is on; without them the tool's height decides what is cut.
    """

    def __init__(self, tools: Tools | None = None):
        self._tools = tools
        self._stretches = [_Stretch(0)]  # between the rows at which operations begin and end
        self._moves = self._arcs = 0
        self._lines = LineSet()  # of the file, that move
        self._used_tools: set[int] = set()
        self._low, self._high = np.full(3, np.nan), np.full(3, np.nan)

    def see(self, toolpath: Toolpath, times_s: np.ndarray, marks: Iterable[int] = ()) -> None:
        """Take the next part; marks: rows of the whole program at which an operation begins or ends, in this part."""
        table, first = toolpath.table(), self._moves
        lengths = _Lengths(toolpath, self._tools)
        self._moves += len(table)
        self._arcs += int(np.isin(table.kind, (ARC_CW, ARC_CCW)).sum())
        self._used_tools |= {toolpath.states[k].tool for k in distinct(table.state)}
        self._lines.add(table.line)
        self._see_places(toolpath)
        inner = sorted({mark for mark in marks if first <= mark < self._moves})
        if inner[:1] == [self._stretches[-1].first]:
            del inner[0]
        for begin, end in pairwise([first, *inner, self._moves]):
            if begin in inner:
                self._stretches.append(_Stretch(begin))
            self._stretches[-1].add(lengths, slice(begin - first, end - first), times_s)

    def report(
        self,
        toolpath: Toolpath,
        *,
        whole_s: float | None = None,
        file: str = "",
        findings: Sequence[Finding] = (),
        judgement: Judgement | None = None,
        part: HeightMap | None = None,
        pieces: Sequence[dict[str, Any]] = (),
    ) -> dict[str, Any]:
        """Return the report; of `toolpath` only the start and the spans are read.

        whole_s: the time including dwells after the last row; None for an empty program.
        """
        whole = self._between(0, self._moves)
        return {
            "program": file,
            "blocks": self._lines.count(),
            "moves": self._moves,
            "time_s": _number(self._end_s(self._moves) if whole_s is None else whole_s),
            **whole.lengths(),
            "plunges": whole.plunges,
            "pierces": whole.pierces(),
            "arcs": self._arcs,
            "tools": sorted(self._used_tools),
            "bounding_box_mm": {"min": _known(self._low), "max": _known(self._high)},
            "work_zero_known": toolpath.start.zero_known,
            "operations": [self._operation(span) for span in _operations(toolpath.spans)],
            "errors": sum(finding.severity == "error" for finding in findings),
            "warnings": sum(finding.severity == "warning" for finding in findings),
            "limits_exceeded": [finding.as_dict() for finding in findings if finding.code == "travel"],
            "rapids_in_stock": [finding.as_dict() for finding in findings if finding.code == "rapid-in-stock"],
            **_verdict(judgement),
            "removed_volume_mm3": None if part is None else _number(part.removed_volume_mm3),
            "pieces": list(pieces),
            "findings": [finding.as_dict() for finding in findings],
        }

    def _see_places(self, toolpath: Toolpath) -> None:
        """Extend the box by the path of the tip."""
        for chunk, begin, end in tips_of_chunks(toolpath):
            if len(chunk):
                shift = chunk.end[:, :3] - end
                low, high = extremes(chunk, begin + shift)
                self._low = np.fmin(self._low, np.fmin.reduce(low - shift))
                self._high = np.fmax(self._high, np.fmax.reduce(high - shift))

    def _between(self, first: int, last: int) -> _Stretch:
        """Return rows [first, last) as one stretch, both of them the begin or end of an operation or of the program."""
        sums, firsts = _Stretch(first), [one.first for one in self._stretches]
        for one in self._stretches[bisect_left(firsts, first) : bisect_left(firsts, last)]:
            sums.join(one)
        return sums

    def _end_s(self, row: int) -> float:
        """Return when the row before a mark ends."""
        before = bisect_left([one.first for one in self._stretches], row)
        return next((one.end_s for one in reversed(self._stretches[:before]) if one.count), 0.0)

    def _operation(self, span: Span) -> dict[str, Any]:
        rows = self._between(span.first, span.last)
        return {
            "name": span.name,
            "time_s": _number(self._end_s(span.last) - self._end_s(span.first)),
            "moves": span.last - span.first,
            **rows.lengths(),
            "plunges": rows.plunges,
            "pierces": rows.pierces(),
        }


def _operations(spans: Iterable[Span]) -> list[Span]:
    return [span for span in spans if span.kind == "operation"]


class _Stretch:
    """The figures of consecutive rows from row `first` on."""

    def __init__(self, first: int):
        self.first, self.count, self.end_s = first, 0, 0.0
        self.plunges = 0
        self._cut_mm = self._air_mm = self._rapid_mm = 0.0
        self._places: list[np.ndarray] = []  # of pierces
        self._burnt = 0  # how often a beam begins to cut
        self._begins_burning = self._ends_burning = False

    def add(self, lengths: _Lengths, rows: slice, times_s: np.ndarray) -> None:
        """Take further rows, the next ones of a part."""
        count = rows.stop - rows.start
        if not count:
            return
        feed, whole, below = lengths.kind[rows] != RAPID, lengths.whole[rows], lengths.below[rows]
        self._cut_mm += below[feed].sum()
        self._air_mm += (whole - below)[feed].sum()
        self._rapid_mm += whole[~feed].sum()
        self.plunges += int(lengths.plunging[rows].sum())
        piercing = lengths.plunging[rows] & (lengths.end[rows][:, 2] < 0.0) & ~lengths.is_beam[rows]
        if piercing.any():
            self._places.append(np.unique(np.round(lengths.end[rows][piercing, :2], SAME_PLACE_DECIMALS), axis=0))
        burns = lengths.burns[rows]
        self._burnt += int(np.count_nonzero(burns & ~np.append(self._ends_burning, burns[:-1])))
        self._begins_burning |= bool(burns[0]) and not self.count
        self._ends_burning = bool(burns[-1])
        self.count, self.end_s = self.count + count, float(times_s[rows.stop - 1])

    def join(self, other: _Stretch) -> None:
        """Take the rows of a stretch that comes behind."""
        self._cut_mm, self._air_mm = self._cut_mm + other._cut_mm, self._air_mm + other._air_mm
        self._rapid_mm, self.plunges = self._rapid_mm + other._rapid_mm, self.plunges + other.plunges
        self._places += other._places
        self._burnt += other._burnt - (self._ends_burning and other._begins_burning)
        if other.count:
            self._begins_burning |= other._begins_burning and not self.count
            self._ends_burning = other._ends_burning
        self.count += other.count

    def lengths(self) -> dict[str, float]:
        """Return the lengths of the rows: cutting (feeds below the stock's top), feeding in air, rapid."""
        return {
            "cut_length_mm": _number(self._cut_mm),
            "air_length_mm": _number(self._air_mm),
            "rapid_length_mm": _number(self._rapid_mm),
        }

    def pierces(self) -> int:
        """Return at how many places the tool feeds straight down into the stock; pecks and levels are one pierce.

        A beam pierces each time it begins to cut.
        """
        places = len(np.unique(np.vstack(self._places), axis=0)) if self._places else 0
        return places + self._burnt


class _Lengths:
    """Length of every row of a part, and how much of it lies below the stock's top, or is cut by a beam."""

    def __init__(self, toolpath: Toolpath, tools: Tools | None):
        self.kind = toolpath.table().kind
        self.plunging, self.end = _plunging(toolpath), tips_mm(toolpath)[1]
        self.whole, self.below = (np.zeros(len(toolpath)) for _ in range(2))
        for chords in segments_of_chunks(toolpath, LENGTH_TOLERANCE_MM):
            path = chords.known_in_x()
            below = clipped_below(path, 0.0)
            _add(self.whole, path)
            _add(self.below, below[below.low_mm < 0.0])
        np.minimum(self.below, self.whole, out=self.below)
        self.is_beam = self.burns = np.zeros(len(toolpath), bool)
        if tools is not None:
            from CNCStepper.simulation.exact.beams import beam_cuts, beam_rows

            self.is_beam, self.burns = beam_rows(toolpath, tools)[0], beam_cuts(toolpath, tools)
        self.below[self.is_beam] = np.where(self.burns, self.whole, 0.0)[self.is_beam]


def _plunging(toolpath: Toolpath) -> np.ndarray:
    """Return which rows feed straight down, bool[n]."""
    straight_down = [np.zeros(0, bool)]
    for chunk, begin, end in tips_of_chunks(toolpath):
        delta = end - begin
        sideways = np.hypot(delta[:, 0], delta[:, 1])
        straight_down.append((chunk.kind == LINE) & (sideways < 1e-9) & (delta[:, 2] < 0))
    return np.concatenate(straight_down)


def _add(lengths: np.ndarray, path: Segments) -> None:
    """Add the lengths of segments to those of their rows."""
    if len(path):
        first = int(path.row[0])
        length = np.bincount(path.row - first, path.length_mm)
        lengths[first : first + len(length)] += length


def _known(bound: np.ndarray) -> list[float | None]:
    """Return the coordinates, None for an axis that is never known."""
    return [_number(value) if np.isfinite(value) else None for value in bound]


def _verdict(judgement: Judgement | None) -> dict[str, Any]:
    if judgement is None:
        return dict.fromkeys(("gouge_mm", "gouge_place_mm", "left_over_mm", "left_over_place_mm", "islands"))
    return {
        "gouge_mm": _number(judgement.gouge_mm),
        "gouge_place_mm": _place(judgement.gouge),
        "left_over_mm": _number(judgement.left_over_mm),
        "left_over_place_mm": _place(judgement.left_over),
        "islands": [
            {"place_mm": [_number(v) for v in island.place_mm], "thickness_mm": _number(island.thickness_mm)}
            for island in judgement.islands
        ],
    }


def _place(worst: Worst) -> list[float] | None:
    return None if worst.place_mm is None else [_number(v) for v in worst.place_mm]


def _number(value: float) -> float:
    """Return a finite number with few enough digits to be the same everywhere, and no minus zero."""
    return round(float(value), DECIMALS) + 0.0
