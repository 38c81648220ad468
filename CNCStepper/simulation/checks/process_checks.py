# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks power, pierce and chart of a process that cuts through the sheet, from the rows alone, part after part.

M3        G4 P0.4          G1            G4 P2        M0      M5
power on  at the pierce    cutting       standing     pause   power off
          no shorter and   feed as the   no longer    power
          no longer than   chart has it  than the     off
          the chart has it               process may
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import Text
from CNCStepper.gcode.dialects import dialect
from CNCStepper.motion.planner.standstills import EventsAsOne
from CNCStepper.simulation.check_context import CheckContext, Cutting, PartCheck
from CNCStepper.simulation.cutter_solid import Tools, tool_numbered
from CNCStepper.simulation.exact.beams import beam_rows
from CNCStepper.simulation.exact.sheet_cuts import is_torch
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.tolerances import NO_LENGTH_MM

STAND_S = 0.1  # which every process bears
SHORTEST, LONGEST = 0.5, 2.0  # shares of the chart's pierce delay, beyond which a program is refused
CLOSE = 0.1  # to the chart, as a share of the delay
SLOWEST, FASTEST = 0.45, 1.2  # shares of the chart's feed: small holes are cut at 60 %, corners slower
HEIGHT_MM, HEIGHT_SHARE = 0.5, 0.5  # how far from the chart's height the torch may be, the larger of the two
KERF_SHARE = 0.25  # how much the tool's width may differ from the chart's kerf


def process_checks(cutting: Cutting, tools: Tools, stock: Stock | None) -> list[PartCheck]:
    """Return the checks of a process that cuts through the sheet; stock: None where the sheet is not known."""
    checks: list[PartCheck] = [PowerStands(cutting, tools, stock), ChartRange(cutting, tools)]
    if cutting.process.entry == "edge" and stock is not None:
        checks.append(WireWays(tools, stock))
    return checks


@dataclass
class _Pierce:
    """A pierce: where it is, the radius of the kerf, and how long the power has been on before the cut moves."""

    line: int
    place_mm: tuple[float, ...]
    radius_mm: float
    waited_s: float = 0.0


class PowerStands(PartCheck):
    """Finds pierces without their delay, and power at rest in one place for longer than the process allows."""

    def __init__(self, cutting: Cutting, tools: Tools, stock: Stock | None):
        self._cutting, self._tools, self._stock = cutting, tools, stock
        self._was_on = False
        self._pierce: _Pierce | None = None  # that the last part has left open

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        yield from self._pauses(subject)
        if not len(subject.table):
            return
        torch = np.array([is_torch(state) for state in subject.toolpath.states], bool)[subject.table.state]
        cuts = beam_rows(subject.toolpath, self._tools)[1] & subject.is_feed & torch
        moves = np.append(np.flatnonzero(cuts & _sideways(subject)), len(cuts))
        firsts = np.flatnonzero(cuts & ~np.append(self._was_on, cuts[:-1]))
        index, value = _dwells(subject)
        used, numbers = np.zeros(len(index), bool), subject.tool_numbers
        if self._pierce:
            firsts = np.append(-1, firsts)
        for first, move in zip(firsts.tolist(), moves[np.searchsorted(moves, firsts)].tolist(), strict=True):
            here = slice(*np.searchsorted(index, [first, move + 1]))
            used[here] = True
            pierce = self._pierce if first < 0 and self._pierce else self._begun(subject, first, int(numbers[first]))
            pierce.waited_s += float(value[here].sum())
            self._pierce = pierce if move == len(cuts) and cuts[-1] else None
            if self._pierce is None:
                yield from self._pierced(subject, pierce)
        spots = ~np.append(cuts, False)[index] & ~np.append(self._was_on, cuts)[index]  # no cut before, none behind
        yield from self._stands(subject, index[~used & ~spots], value[~used & ~spots])
        yield from self._spots(subject, index[~used & spots], value[~used & spots])
        self._was_on = bool(cuts[-1])

    def end(self, last: CheckContext) -> Iterator[Finding]:
        if self._pierce:
            yield from self._pierced(last, self._pierce)

    def _begun(self, subject: CheckContext, row: int, number: int) -> _Pierce:
        tool = tool_numbered(self._tools, number)
        return _Pierce(subject.line(row), tuple(subject.begin[row].tolist()), tool.radius_mm if tool else 0.0)

    def _beside(self, place: tuple[float, ...], radius_mm: float) -> bool:
        """Return whether a beam of that radius does not touch the sheet at a place."""
        if self._stock is None or not np.isfinite(place[:2]).all():
            return False
        return bool(shapely.distance(self._stock.outline, shapely.Point(place[:2])) > radius_mm)

    def _pierced(self, subject: CheckContext, pierce: _Pierce) -> Iterator[Finding]:
        """Yield pierces whose time with power before the cut differs from the chart."""
        data, process = self._cutting.cut_data, self._cutting.process
        if data is None or dialect(subject.machine.controller).plasma:  # which waits by itself
            return
        least_s, waited_s = data.pierce_delay_s, pierce.waited_s
        most_s = least_s + data.preheat_s + process.stand_s
        if (1 - CLOSE) * least_s <= waited_s + 1e-9 <= (1 + CLOSE) * most_s + STAND_S:
            return
        is_beside = self._beside(pierce.place_mm, pierce.radius_mm)  # where nothing is pierced
        if is_beside and (process.power != "always" or waited_s > least_s):
            return
        numbers = {"value": waited_s, "unit": "s", "place_mm": _known(pierce.place_mm)}
        write = Text("write G4 P{delay_s:g} behind M3", delay_s=least_s)
        if waited_s < SHORTEST * least_s - 1e-9:
            text = "the cut begins without its pierce delay"
            if process.power == "always":
                text = "the wire moves before it is hot"
            yield subject.finding_at(pierce.line, "error", "pierce-delay", text, advice=write, limit=least_s, **numbers)
        elif waited_s > LONGEST * most_s + STAND_S:
            text = "the power is on at the pierce for much longer than the chart's delay"
            yield subject.finding_at(
                pierce.line, "error", "power-standing", text, advice=write, limit=LONGEST * most_s, **numbers
            )
        else:
            text = "the pierce delay is not the chart's"
            limit = least_s if waited_s < least_s else most_s
            yield subject.finding_at(
                pierce.line, "warning", "chart-pierce-delay", text, advice=write, limit=limit, **numbers
            )

    def _stands(self, subject: CheckContext, index: np.ndarray, value: np.ndarray) -> Iterator[Finding]:
        """Yield dwells with power that are at no pierce."""
        data = self._cutting.cut_data
        limit_s = self._cutting.process.stand_s + (data.pause_at_end_s if data else 0.0)
        for at in np.unique(index).tolist():
            waited_s = float(value[index == at].sum())
            row = min(at, len(subject.table) - 1)
            place = tuple((subject.begin if at == row else subject.end)[row].tolist())
            if waited_s <= limit_s + STAND_S or self._beside(place, 0.0):
                continue
            yield subject.finding(
                row,
                "error",
                "power-standing",
                "the program waits with the power on in the middle of a cut",
                advice="take out the G4, or switch the power off with M5 before it",
                place_mm=_known(place),
                value=waited_s,
                limit=limit_s,
                unit="s",
            )

    def _spots(self, subject: CheckContext, index: np.ndarray, value: np.ndarray) -> Iterator[Finding]:
        """Yield pierces without a cut (a spot, a pierce only) that last for longer than one with a cut may."""
        data, process = self._cutting.cut_data, self._cutting.process
        if data is None:
            return
        most_s = LONGEST * (data.pierce_delay_s + data.preheat_s + process.stand_s)
        for at in np.unique(index).tolist():
            waited_s, row = float(value[index == at].sum()), min(at, len(subject.table) - 1)
            place = tuple((subject.begin if at == row else subject.end)[row].tolist())
            if waited_s > most_s + STAND_S and not self._beside(place, 0.0):
                text = "the power is on at the pierce for much longer than the chart's delay"
                advice = "switch it off with M5 sooner"
                numbers = {"value": waited_s, "limit": most_s, "unit": "s", "place_mm": _known(place)}
                yield subject.finding(row, "error", "power-standing", text, advice=advice, **numbers)

    def _pauses(self, subject: CheckContext) -> Iterator[Finding]:
        """Yield pauses (M0) with the power on, whose length is unknown."""
        if self._cutting.process.pause_power == "kept":
            return
        states = subject.toolpath.states
        for event in subject.toolpath.events:
            if event.kind == "pause" and states[event.state].spindle_turns:
                text, advice = "the program pauses with the power on", "write M5 before M0, and pierce again behind it"
                count = event.count if isinstance(event, EventsAsOne) else 1
                yield subject.finding_at(event.line, "error", "power-standing", text, advice=advice, count=count)


class ChartRange(PartCheck):
    """Finds feeds, heights and kerfs that are not the cut chart's: one finding of each kind, with its worst value."""

    def __init__(self, cutting: Cutting, tools: Tools):
        self._data, self._tools = cutting.cut_data, tools
        self._was_on = False
        self._numbers: set[int] = set()  # of checked tools

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        if self._data is None or not len(subject.table):
            return
        cuts = beam_rows(subject.toolpath, self._tools)[1] & subject.is_feed
        moving = np.flatnonzero(cuts & _sideways(subject))
        feeds, heights = subject.table.feed[moving], subject.end[moving, 2]
        low, high = SLOWEST * self._data.feed_mm_min, FASTEST * self._data.feed_mm_min
        yield from _beyond(subject, moving, feeds, (low, high), "feed", "mm/min")
        if self._data.cut_height_mm and subject.machine.has_z:
            yield from _beyond(subject, moving, heights, _around(self._data.cut_height_mm), "height", "mm")
        if self._data.pierce_height_mm and subject.machine.has_z:
            rows = np.flatnonzero(cuts & ~np.append(self._was_on, cuts[:-1]))
            pierced = subject.begin[rows, 2]
            yield from _beyond(subject, rows, pierced, _around(self._data.pierce_height_mm), "pierce-height", "mm")
        yield from self._kerfs(subject, moving)
        self._was_on = bool(cuts[-1])

    def _kerfs(self, subject: CheckContext, moving: np.ndarray) -> Iterator[Finding]:
        """Yield each tool whose width is not the chart's kerf."""
        assert self._data is not None
        numbers = subject.tool_numbers[moving]
        for number in sorted(set(np.unique(numbers).tolist()) - self._numbers):
            self._numbers.add(number)
            tool = tool_numbered(self._tools, number)
            row = int(moving[numbers == number][0])
            limits = ((1 - KERF_SHARE) * self._data.kerf_mm, (1 + KERF_SHARE) * self._data.kerf_mm)
            if tool is not None:
                yield from _beyond(subject, np.array([row]), np.array([tool.diameter_mm]), limits, "kerf", "mm")


CHART_TEXTS = {
    "feed": ("the feed is not the cut chart's", "set F by the chart"),
    "height": ("the cut height is not the cut chart's", "set Z by the chart"),
    "pierce-height": ("the pierce height is not the cut chart's", "set Z by the chart"),
    "kerf": ("the tool's width is not the cut chart's kerf", "take the kerf from the chart"),
}


def _beyond(
    subject: CheckContext, rows: np.ndarray, values: np.ndarray, limits: tuple[float, float], name: str, unit: str
) -> Iterator[Finding]:
    """Yield one warning for rows whose values leave the chart's range, with the worst of them."""
    over = np.maximum(limits[0] - values, values - limits[1])
    wrong = np.flatnonzero(over > 1e-9)
    if len(wrong):
        worst = int(wrong[over[wrong].argmax()])
        text, advice = CHART_TEXTS[name]
        yield subject.finding(
            int(rows[wrong[0]]),
            "warning",
            f"chart-{name}",
            text,
            advice=advice,
            value=float(values[worst]),
            limit=limits[0] if values[worst] < limits[0] else limits[1],
            unit=unit,
            count=len(wrong),
            group="",
            rank=float(over[worst]),
        )


def _around(height_mm: float) -> tuple[float, float]:
    aside_mm = max(HEIGHT_MM, HEIGHT_SHARE * height_mm)
    return height_mm - aside_mm, height_mm + aside_mm


class WireWays(PartCheck):
    """Finds a wire that is switched on inside the sheet, and one that is drawn through it cold."""

    def __init__(self, tools: Tools, stock: Stock):
        self._tools, self._stock = tools, stock
        self._was_on = False

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        if not len(subject.table):
            return
        is_wire, on = beam_rows(subject.toolpath, self._tools)
        cuts = on & subject.is_feed
        inside = self._stock.outline.buffer(-NO_LENGTH_MM)
        shapely.prepare(inside)
        firsts = np.flatnonzero(cuts & ~np.append(self._was_on, cuts[:-1]))
        places = subject.begin[firsts, :2]
        firsts = firsts[np.isfinite(places).all(axis=1)]
        begun = firsts[shapely.intersects_xy(inside, subject.begin[firsts, :2])]
        for row in begun.tolist():
            text, advice = "the wire begins to cut inside the sheet", "begin beside the sheet and enter at its edge"
            place = _known(tuple(subject.begin[row].tolist()))
            yield subject.finding(row, "error", "wire-entry", text, advice=advice, place_mm=place)
        self._was_on = bool(cuts[-1])
        yield from self._cold(subject, is_wire & subject.is_feed & ~on & _sideways(subject), inside)

    def _cold(self, subject: CheckContext, feeds: np.ndarray, inside: shapely.Polygon) -> Iterator[Finding]:
        rows = np.flatnonzero(feeds & np.isfinite(subject.begin[:, :2]).all(axis=1))
        ways = np.stack([subject.begin[rows, :2], subject.end[rows, :2]], axis=1)
        rows = rows[shapely.intersects(inside, shapely.linestrings(ways))]
        if len(rows):
            text, advice = "the wire goes through the sheet without power", "switch it on with M3 beside the sheet"
            yield subject.finding(int(rows[0]), "error", "wire-cold", text, advice=advice, count=len(rows), group="")


def _known(place: tuple[float, ...]) -> tuple[float, ...] | None:
    """Return a place of which all is known, else None."""
    return place if np.isfinite(place).all() else None


def _sideways(subject: CheckContext) -> np.ndarray:
    """Return which rows go sideways, bool[n]; one from an unknown place does, and so does a full circle."""
    way = np.hypot(*(subject.end - subject.begin)[:, :2].T)
    return ~(way <= NO_LENGTH_MM) | (subject.table.turns > 0)


def _dwells(subject: CheckContext) -> tuple[np.ndarray, np.ndarray]:
    """Return the rows after the dwells with power, int64[n], and their times in s, float64[n]."""
    states = subject.toolpath.states
    found = [
        (event.index, event.value)
        for event in subject.toolpath.events
        if event.kind == "dwell" and states[event.state].spindle_turns and is_torch(states[event.state])
    ]
    return np.array([index for index, _ in found], np.int64), np.array([value for _, value in found], float)
