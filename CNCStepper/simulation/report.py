# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a program as plain data for strict JSON: the same program gives the same bytes.

Lengths are those of the tip in work coordinates. What is not known is null, never NaN.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from CNCStepper.simulation.arcs import extremes
from CNCStepper.simulation.beams import beam_cuts, beam_rows
from CNCStepper.simulation.cutter import Tools
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.gouge import Worst
from CNCStepper.simulation.heightmap import HeightMap
from CNCStepper.simulation.segments import Segments, clipped_below, segments_of_chunks, tips_mm, tips_of_chunks
from CNCStepper.simulation.sweep import Judgement
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Toolpath

DECIMALS = 6
SAME_PLACE_DECIMALS = 3
LENGTH_TOLERANCE_MM = 0.001  # of the chords whose lengths stand for an arc's


def report(
    toolpath: Toolpath,
    times_s: np.ndarray,
    *,
    file: str = "",
    findings: Sequence[Finding] = (),
    judgement: Judgement | None = None,
    part: HeightMap | None = None,
    tools: Tools | None = None,
) -> dict[str, Any]:
    """Return what is known of a program, as dicts, lists, texts, numbers and None.

    Its blocks are the lines of the file that move, however often they are run; its moves are those of the machine.
    times_s: end time of every row, float64[n]. part: the stock after the program. tools: a beam among them cuts
    wherever it is on; without them the tool's height says what is cut.
    """
    lengths = _Lengths(toolpath, tools)
    whole = slice(0, len(toolpath))
    table = toolpath.table()
    return {
        "program": file,
        "blocks": len(np.unique(table.line[table.line > 0])),
        "moves": len(toolpath),
        "time_s": _number(times_s[-1]) if len(times_s) else 0.0,
        **lengths.of(whole),
        "plunges": lengths.plunges(whole),
        "pierces": lengths.pierces(whole),
        "arcs": int(np.isin(table.kind, (ARC_CW, ARC_CCW)).sum()),
        "tools": sorted({toolpath.states[k].tool for k in np.unique(table.state)}),
        "bounding_box_mm": _bounding_box(toolpath),
        "work_zero_known": toolpath.start.zero_known,
        "operations": [_operation(span, lengths, times_s) for span in toolpath.spans if span.kind == "operation"],
        "errors": sum(finding.severity == "error" for finding in findings),
        "warnings": sum(finding.severity == "warning" for finding in findings),
        "limits_exceeded": [finding.as_dict() for finding in findings if finding.code == "travel"],
        "rapids_in_stock": [finding.as_dict() for finding in findings if finding.code == "rapid-in-stock"],
        **_verdict(judgement),
        "removed_volume_mm3": None if part is None else _number(part.removed_volume_mm3),
        "findings": [finding.as_dict() for finding in findings],
    }


class _Lengths:
    """Length of every row, and how much of it lies below the stock's top, or is cut by a beam."""

    def __init__(self, toolpath: Toolpath, tools: Tools | None):
        self.kind = toolpath.table().kind
        self.plunging, self.end = _plunging(toolpath), tips_mm(toolpath)[1]
        self.whole, self.below = (np.zeros(len(toolpath)) for _ in range(2))
        for chords in segments_of_chunks(toolpath, LENGTH_TOLERANCE_MM):
            path = chords.level_where_unknown()
            below = clipped_below(path, 0.0)
            _add(self.whole, path)
            _add(self.below, below[below.low_mm < 0.0])
        np.minimum(self.below, self.whole, out=self.below)
        self.is_beam, self.burns = beam_rows(toolpath, tools)[0], beam_cuts(toolpath, tools)
        self.below[self.is_beam] = np.where(self.burns, self.whole, 0.0)[self.is_beam]

    def of(self, rows: slice) -> dict[str, float]:
        """Return the lengths of the rows: cutting (feeds below the stock's top), feeding in air, rapid."""
        feed = self.kind[rows] != RAPID
        whole, below = self.whole[rows], self.below[rows]
        return {
            "cut_length_mm": _number(below[feed].sum()),
            "air_length_mm": _number((whole - below)[feed].sum()),
            "rapid_length_mm": _number(whole[~feed].sum()),
        }

    def plunges(self, rows: slice) -> int:
        """Return how many of the rows feed straight down."""
        return int(self.plunging[rows].sum())

    def pierces(self, rows: slice) -> int:
        """Return at how many places the tool feeds straight down into the stock; pecks and levels are one pierce.

        A beam pierces each time it begins to cut.
        """
        piercing = self.plunging[rows] & (self.end[rows][:, 2] < 0.0) & ~self.is_beam[rows]
        places = len(np.unique(np.round(self.end[rows][piercing, :2], SAME_PLACE_DECIMALS), axis=0))
        return places + int(np.diff(self.burns[rows], prepend=False, append=False).sum()) // 2


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
        length = np.bincount(path.row - first, np.linalg.norm(path.end - path.begin, axis=1))
        lengths[first : first + len(length)] += length


def _operation(span, lengths: _Lengths, times_s: np.ndarray) -> dict[str, Any]:
    rows = slice(span.first, span.last)
    begins_s = float(times_s[span.first - 1]) if span.first else 0.0
    ends_s = float(times_s[span.last - 1]) if span.last else 0.0
    return {
        "name": span.name,
        "time_s": _number(ends_s - begins_s),
        "moves": span.last - span.first,
        **lengths.of(rows),
        "plunges": lengths.plunges(rows),
        "pierces": lengths.pierces(rows),
    }


def _bounding_box(toolpath: Toolpath) -> dict[str, list[float | None]]:
    """Return the smallest and largest coordinates of the tip, None for an axis that is never known."""
    if not len(toolpath):
        return {"min": [None] * 3, "max": [None] * 3}
    lows, highs = [], []
    for chunk, begin, end in tips_of_chunks(toolpath):
        if len(chunk):
            shift = chunk.end[:, :3] - end
            low, high = extremes(chunk, begin + shift)
            lows.append(np.fmin.reduce(low - shift))
            highs.append(np.fmax.reduce(high - shift))
    bounds = np.fmin.reduce(lows), np.fmax.reduce(highs)
    return {
        name: [_number(v) if np.isfinite(v) else None for v in bound]
        for name, bound in zip(("min", "max"), bounds, strict=True)
    }


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
