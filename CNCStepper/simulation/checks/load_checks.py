# SPDX-License-Identifier: LGPL-2.1-or-later
"""The load on the tool along the path: engagement angle and chip load against the tool's limits.

The tip's path of a whole program, kept on the disk until all of it is known, with what each segment belongs to.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Iterator
from itertools import tee
from typing import TYPE_CHECKING

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.check_context import CheckContext, PartCheck
from CNCStepper.simulation.checks.holder_and_shank_checks import HolderAndShank, LargestExcess, names_heights
from CNCStepper.simulation.cutter_solid import Tools, tool_numbered
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments

if TYPE_CHECKING:
    from CNCStepper.simulation.removal.engagement import Area, Engagement

BLOCK = 65_536  # segments that are read at once
RECORD = np.dtype(
    [
        ("begin", "f8", 3),
        ("end", "f8", 3),
        ("row", "i8"),
        ("line", "i4"),
        ("tool", "i4"),
        ("is_feed", "?"),
        ("chip_mm", "f8"),
    ]
)


class TipPathStore:
    """Records of segments in the order in which they are run; iterating reads them, so many at once as a block holds.

    The file has no name, so that nothing is left of a check that is killed.
    """

    def __init__(self) -> None:
        self._file = tempfile.TemporaryFile(prefix="cncstepper-path-")  # noqa: SIM115  closed by close()

    def add(self, records: np.ndarray) -> None:
        """Keep further records; raises OSError on a full disk."""
        self._file.seek(0, 2)
        self._file.write(records.tobytes())

    def __iter__(self) -> Iterator[np.ndarray]:
        self._file.flush()
        place = 0
        while True:
            self._file.seek(place)
            data = self._file.read(BLOCK * RECORD.itemsize)
            if not data:
                return
            place += len(data)
            yield np.frombuffer(data, RECORD)

    def close(self) -> None:
        """Give the disk back."""
        self._file.close()


def path_of_records(records: np.ndarray) -> Segments:
    """Return the segments of records; the row of each is its place among them."""
    return Segments(records["begin"], records["end"], np.arange(len(records)))


ANGLE_ERROR_DEG = 15.0  # of the map in which the angle is measured
CHIP_SHARE = 1.001


class Loads(PartCheck):
    """Finds where each tool is overloaded; limits that a tool does not name are not checked.

    What the tools meet is measured when the whole path is known: it is kept on the disk until then.
    """

    def __init__(self, stock: Stock, tools: Tools):
        self._stock, self._tools = stock, tools
        self._area: Area | None = None
        self._rows = 0
        if _any_says_something([tools] if isinstance(tools, Tool) else tools.values()):
            from CNCStepper.simulation.removal.engagement import Area

            self._area, self._path = Area(stock, tools), TipPathStore()

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        numbers = subject.tool_numbers
        for number in np.unique(numbers).tolist():
            tool = tool_numbered(self._tools, number)
            if tool is not None:
                yield from _thin_chips(subject, number, tool, numbers == number, self._stock)
        if self._area:
            self._keep(subject, self._area)

    def end(self, last: CheckContext) -> Iterator[Finding]:
        if self._area and self._area.used:
            yield from self._above_limits(last, self._area)
        if self._area:
            self._path.close()

    def _keep(self, subject: CheckContext, area: Area) -> None:
        """Keep the path of a part of the program."""
        from CNCStepper.simulation.removal.engagement import path_of

        path, numbers = path_of(subject.toolpath)
        area.see(path, numbers)
        records = np.zeros(len(path), RECORD)
        records["begin"], records["end"], records["tool"] = path.begin, path.end, numbers
        records["row"], records["line"] = path.row + self._rows, subject.table.line[path.row]
        records["is_feed"] = subject.is_feed[path.row]
        for number in np.unique(numbers).tolist():
            tool, mine = tool_numbered(self._tools, number), numbers == number
            if tool is not None:
                records["chip_mm"][mine] = _chip_load_mm(subject, tool)[path.row[mine]]
        self._path.add(records)
        self._rows += len(subject.table)

    def _above_limits(self, last: CheckContext, area: Area) -> Iterator[Finding]:
        """Yield the overloads of the tools along the path."""

        tools = {number: _Load(tool) for number, tool in sorted(area.used.items()) if _says_something(tool)}
        parts, again = tee(self._parts(area))
        paths = ((path_of_records(records), records["tool"]) for records in again)
        for records, met in zip(parts, area.followed(paths), strict=True):
            of_place = records[met.row]
            for number, load in tools.items():
                load.add(met, of_place, of_place["tool"] == number)
        for load in tools.values():
            yield from load.findings(last)

    def _parts(self, area: Area) -> Iterator[np.ndarray]:

        for records in self._path:
            yield from np.split(records, area.split_at(path_of_records(records), records["tool"]))


def _any_says_something(tools: Iterable[Tool]) -> bool:
    return any(map(_says_something, tools))


def _says_something(tool: Tool) -> bool:
    return bool(names_heights(tool) or tool.engagement_max_deg or tool.chip_load_max_mm)


class _Load:
    """The loads of one tool along the path, against its limits."""

    def __init__(self, tool: Tool):
        self._tool = tool
        self._above_edges = HolderAndShank(tool)
        self._angle = LargestExcess(tool.engagement_max_deg, ANGLE_ERROR_DEG)
        self._chip = LargestExcess(tool.chip_load_max_mm, tool.chip_load_max_mm * (CHIP_SHARE - 1))
        self._first_line = 0  # of a feed
        self._is_measured = True  # the angle, which a map's cells may be too large for

    def add(self, met: Engagement, of_place: np.ndarray, mine: np.ndarray) -> None:
        """Take further places; of_place: the record of each one's segment, mine: where it is this tool."""
        tool, feed = self._tool, mine & of_place["is_feed"]
        if not self._first_line and feed.any():
            self._first_line = int(of_place["line"][feed][0])
            self._is_measured = tool.radius_mm >= met.least_radius_mm
        self._above_edges.add(met, of_place, mine)
        self._angle.add(met, of_place, feed, met.angle_deg)
        chip = of_place["chip_mm"] * np.sin(np.radians(np.minimum(np.nan_to_num(met.angle_deg), 90)))
        self._chip.add(met, of_place, feed, chip)

    def findings(self, subject: CheckContext) -> Iterator[Finding]:
        """Yield what was more than the tool may meet."""
        tool = self._tool
        yield from self._above_edges.findings(subject)
        if (tool.engagement_max_deg or tool.chip_load_max_mm) and self._first_line and not self._is_measured:
            text = Text(
                "the {tool} tool is too small against its path for its engagement to be measured", tool=tool.words
            )
            advice, code = "prove parts of the program alone", "engagement-unknown"
            yield subject.finding_at(self._first_line, "info", code, text, advice=advice)
        text = Text("more of the {tool} tool's rim is in the material than it may", tool=tool.words)
        advice = "lower the stepover, enter by a helix, or leave less in the corners"
        yield from self._angle.finding(subject, "warning", "engagement", text, advice, "deg")
        text, advice = (
            Text("a tooth of the {tool} tool takes too thick a chip", tool=tool.words),
            "lower F, or turn the spindle faster",
        )
        yield from self._chip.finding(subject, "warning", "chip-load", text, advice, "mm")


def _thin_chips(subject: CheckContext, number: int, tool: Tool, mine: np.ndarray, stock: Stock) -> Iterator[Finding]:
    """Yield the cut whose chips are so thin that the teeth rub instead of cut."""
    if not tool.chip_load_min_mm:
        return
    chip = _chip_load_mm(subject, tool)
    level = np.hypot(*(subject.end - subject.begin)[:, :2].T) > 0
    rows = mine & subject.is_feed & level & (subject.low_mm < stock.top_mm) & (chip > 0)
    thin = np.flatnonzero(rows & (chip * CHIP_SHARE < tool.chip_load_min_mm))
    if len(thin):
        k = int(thin[chip[thin].argmin()])
        yield subject.finding(
            k,
            "warning",
            "chip-load",
            Text("the {tool} tool rubs: a tooth takes too thin a chip", tool=tool.words),
            advice="raise F, or turn the spindle slower",
            value=float(chip[k]),
            limit=tool.chip_load_min_mm,
            unit="mm",
            count=len(thin),
            group=f"thin-{number}",
            rank=-float(chip[k]),
            at_first=False,
        )


def _chip_load_mm(subject: CheckContext, tool: Tool) -> np.ndarray:
    """Return the feed per tooth on every row, 0 where the spindle is off."""
    rpm = np.array([state.spindle_rpm if state.spindle_turns else 0.0 for state in subject.toolpath.states])
    teeth = rpm[subject.table.state] * tool.flutes
    return np.where(teeth > 0, subject.table.feed / np.where(teeth > 0, teeth, 1.0), 0.0)
