# SPDX-License-Identifier: LGPL-2.1-or-later
"""The moves of one cut in the table: rapids without power, pierce, lead-in, strokes, lead-out, power off.

            rapid            clearance          without Z all of this is at height 0
----------------------.
                      |      pierce height      power on, dwell
                      '-.
                        '--- cut height         lead-in, cut, lead-out, power off
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.moves import Track
from CNCStepper.cycles.sheet_cutting.strokes import Stroke, even
from CNCStepper.geometry.curve import Curve
from CNCStepper.state import State
from CNCStepper.toolpath import TableBuilder

Point = tuple[float, float]
PLUNGE_MM_MIN = 1000.0  # at most, from the pierce height down, where the chart does not say how fast


@dataclass(frozen=True)
class Torch:
    """Heights, delay and power of the cuts; power_s: the S word of full power. switched: whether there is a power."""

    clearance_mm: float
    pierce_height_mm: float
    cut_height_mm: float
    plunge_mm_min: float
    delay_s: float
    power_s: float
    spindle: str
    switched: bool
    has_z: bool


@dataclass(frozen=True)
class Cut:
    """One cut as it is run: from the pierce on, with the rapids that lead there, float64[k, 2].

    words: of its span. power: the share of the power from which those of its strokes are taken. pierced: whether the
    sheet is pierced at its begin, which takes the pierce's delay.
    """

    title: str
    way: np.ndarray
    lead_in: Curve | None
    strokes: Sequence[Stroke]
    lead_out: Curve | None
    words: dict[str, float]
    power: float = 1.0
    pierced: bool = True

    def with_leads(self) -> list[Stroke]:
        """Return the strokes with the leads before and behind them."""
        found, first, last = list(self.strokes), self.strokes[0], self.strokes[-1]
        if self.lead_in is not None:
            found.insert(0, even(self.lead_in, float(first.feeds_mm_min[0]), first.power))
        if self.lead_out is not None:
            found.append(even(self.lead_out, float(last.feeds_mm_min[-1]), last.power))
        return found

    @property
    def begin(self) -> Point:
        """Where it is pierced."""
        curve = self.lead_in or self.strokes[0].curve
        return float(curve.xy[0, 0]), float(curve.xy[0, 1])

    @property
    def end(self) -> Point:
        """Where it ends."""
        curve = self.lead_out or self.strokes[-1].curve
        return float(curve.xy[-1, 0]), float(curve.xy[-1, 1])


class TorchMoves:
    """Appends cuts to a table."""

    def __init__(self, table: TableBuilder, torch: Torch):
        self._table, self._torch = table, torch
        self._off: State = replace(table.state, spindle="off", spindle_rpm=0.0)

    def run(self, cut: Cut) -> None:
        """Append one cut: rapid there, pierce, cut, power off, up again."""
        torch, table = self._torch, self._table
        table.open_span("contour", cut.title, **cut.words)
        self._come(cut.way)
        self._pierce(cut)
        self._follow(cut)
        self._power(0.0)
        if torch.has_z:
            table.rapid((*cut.end, torch.clearance_mm))
        table.close_span()

    def spot(self, point: Point, way: np.ndarray, title: str, time_s: float, power: float) -> None:
        """Append a spot: the power is on for a time over a point."""
        torch, table = self._torch, self._table
        table.open_span("contour", title)
        self._come(way)
        self._down(point, torch.pierce_height_mm, rapid=True)
        self._power(power)
        table.event("dwell", time_s)
        self._power(0.0)
        if torch.has_z:
            table.rapid((*point, torch.clearance_mm))
        table.close_span()

    def _come(self, way: np.ndarray) -> None:
        self._table.set_state(self._off)
        for x, y in way.tolist():
            self._table.rapid((x, y, self._torch.clearance_mm if self._torch.has_z else 0.0))

    def _pierce(self, cut: Cut) -> None:
        torch = self._torch
        first = cut.strokes[0].power if cut.strokes else 1.0
        self._table.open_span("pierce", cut.title)
        self._down(cut.begin, torch.pierce_height_mm, rapid=True)
        self._power(cut.power * first)
        if torch.switched and torch.delay_s and cut.pierced:
            self._table.event("dwell", torch.delay_s)
        if torch.pierce_height_mm != torch.cut_height_mm:
            self._down(cut.begin, torch.cut_height_mm, rapid=False)
        self._table.close_span()

    def _down(self, point: Point, z_mm: float, rapid: bool) -> None:
        if not self._torch.has_z:
            return
        if rapid:
            self._table.rapid((*point, z_mm))
        else:
            self._table.feed((*point, z_mm), self._torch.plunge_mm_min)

    def _power(self, share: float) -> None:
        torch = self._torch
        if not torch.switched:
            return
        if share:
            self._table.set_state(replace(self._off, spindle=torch.spindle, spindle_rpm=torch.power_s * share))
        else:
            self._table.set_state(self._off)

    def _follow(self, cut: Cut) -> None:
        """Run along all of a cut, with the rows of equal power as one piece."""
        first, run = self._table.index, cut.with_leads()
        track = Track([stroke.curve for stroke in run])
        z_mm = np.full(len(track.xy), self._torch.cut_height_mm if self._torch.has_z else 0.0)
        end = np.column_stack([track.xy, z_mm])
        feeds = np.concatenate([stroke.feeds_mm_min for stroke in run])[track.moves]
        begun = 0
        for power, group in groupby(zip(run, track.rows, strict=True), key=lambda one: one[0].power):
            some = slice(begun, begun := list(group)[-1][1])
            self._power(power * cut.power)
            self._table.add_cuts(track.kind[some], end[some], track.centre[some], feeds[some])
        self._mark_leads(cut, first)

    def _mark_leads(self, cut: Cut, first: int) -> None:
        """Note which rows are leads; each is of one row."""
        if cut.lead_in is not None:
            self._table.add_span("lead-in", cut.title, first, first + len(cut.lead_in))
        if cut.lead_out is not None:
            self._table.add_span("lead-out", cut.title, self._table.index - len(cut.lead_out), self._table.index)


def torch_of(setup: Setup, delay_s: float, depth_mm: float, dynamic: bool) -> Torch:
    """Return heights, delay and power of a setup; a process without power goes down to its depth."""
    data, process = setup.cut_data, setup.process
    switched = process.power != "none"
    pierce_mm, cut_mm = (data.pierce_height_mm, data.cut_height_mm) if data else (0.0, 0.0)
    if data and switched:
        delay_s = delay_s or data.preheat_s + data.pierce_delay_s
    if not switched:
        pierce_mm, cut_mm = setup.retract_mm, -depth_mm
    return Torch(
        setup.clearance_mm,
        pierce_mm or cut_mm,
        cut_mm,
        (data and data.plunge_mm_min) or min(setup.tool.plunge_mm_min or setup.tool.feed_mm_min, PLUNGE_MM_MIN),
        delay_s,
        setup.power_s,
        "ccw" if dynamic else "cw",
        switched,
        setup.has_z,
    )
