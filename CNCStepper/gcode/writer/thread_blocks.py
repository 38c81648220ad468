# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes moves that follow the spindle: as G33 with K, as a whole thread with G76, or as G01 from the encoder's index.

    G33 Z-32 K2.5                                                   a pass, where the dialect has G33
    G32 Z-32 F2.5                                                   where the dialect has G32
    G76 P010060 Q1 R0.                                              and in two blocks, where the dialect has it so
    G76 X20.319 Z-32. P1534 Q280 F2.5
    G76 P2.5 Z-32 I-1 J0.3 K1.534 R2 Q29 H1 E1.5 L2                 all passes of a start, where that is asked for
    N50 G01 X-0.75 Z-32. F3.75 #                                    a lathe that begins each run of G01 at the index

In the table a row follows the spindle if an event "synchronised" is before it; its value is the travel a turn.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import ceil, copysign, floor, radians, tan

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.writer.block_emitter import LEAD_DECIMALS, SYNCHRONISED, BlockEmitter
from CNCStepper.gcode.writer.move_rows import RowWriter
from CNCStepper.toolpath import RAPID, Event, Span, Toolpath
from CNCStepper.units import LAST_DIGIT

THREAD = "G76"
LENGTHS = "PE"  # words of G76 in units of the text
DEPTHS = "IJK"  # as X: diameters where that is one
EVEN_AREA = 2.0  # R of G76 whose passes are first * sqrt(n) deep
ANGLES_DEG = (0, 29, 30, 55, 60, 80)  # of the infeed in P, 0: straight in
MOST_ANGLE_OFF_DEG = 3.0
LEAST_DIGIT = 1e-6  # of a whole number of digits that is none by rounding alone
NO_FEED = "the feed does not follow the spindle: choose a machine whose controller has G33"


class ThreadWriter:
    """Writes threads; whole: as G76 where the table says that it means the same rows."""

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, rows: RowWriter, whole: bool):
        self.page, self.rows = page, rows
        self._leads = {event.index: event.value for event in toolpath.events if event.kind == "synchronised"}
        wanted = [span for span in toolpath.spans if span.kind == "turning_cycle" and span.name == THREAD]
        self._spans = {span.first: span for span in wanted if whole and THREAD in page.dialect.codes}

    def lead_mm(self, row: int) -> float:
        """Return the travel a turn of a row that follows the spindle, else 0."""
        return self._leads.get(row, 0.0)

    def check(self, event: Event) -> None:
        """Raise ProgramError where the dialect cannot let the next row follow the spindle."""
        dialect = self.page.dialect
        has_threads = dialect.motion_code(MOTION_NAMES.index(SYNCHRONISED)) is not None
        if event.text in (SYNCHRONISED, THREAD) and (has_threads or dialect.waits_for_index):
            return
        what = Text("{dialect} programs are written without '{code}'", dialect=dialect.title, code=event.text)
        advice = dialect.refused.get(event.text, NO_FEED)
        place = Place("", event.line) if event.line else None
        raise ProgramError("no-thread", what, value=event.text, advice=advice, place=place)

    def write(self, row: int, last: int) -> int:
        """Write the thread that begins at `row` as one block and return the row after it; 0 where there is none."""
        span = self._spans.get(row)
        if span is None or span.last > last or self.page.incremental:
            return 0
        if self.page.dialect.two_block_cycles:
            return self._two_blocks(span, row)
        grid, words = self.page.grid, []
        for letter, value in span.words.items():
            if letter == "Z":
                words.append(f"Z{grid.text(self.rows.end_counts(span.last - 1)[2])}")
            elif letter in LENGTHS or letter in DEPTHS:
                factor = self.page.x_factor if letter in DEPTHS else 1
                words.append(f"{letter}{factor * value / grid.unit_mm:.6f}".rstrip("0").rstrip("."))
            else:
                words.append(f"{letter}{value:g}")
        self.page.thread(THREAD, words, self.rows.end_counts(span.last - 1))
        return span.last

    def _two_blocks(self, span: Span, row: int) -> int:
        """Write a thread as G76 in two blocks; 0 where its words cannot express it."""
        words, page, grid = span.words, self.page, self.page.grid
        angle_deg = min(ANGLES_DEG, key=lambda one: abs(one - 2.0 * words["Q"]))
        first = _first_word(words, angle_deg)
        if not first or words["R"] != EVEN_AREA:
            return 0
        x, y, z = self.rows.end_counts(row - 1)
        end_z = self.rows.end_counts(span.last - 1)[2]
        steeper_mm = words["K"] * (tan(radians(angle_deg / 2.0)) - tan(radians(words["Q"])))
        begin = (x, y, z + grid.count(copysign(steeper_mm, z - end_z)))  # the last pass begins where the span's does
        bottom = x + grid.count(words["I"] + copysign(words["K"], words["I"]))
        page.move(RAPID, [*begin])
        page.line(THREAD, first, "Q1", "R0.")
        page.thread(THREAD, [page.coordinate(0, bottom), page.coordinate(2, end_z), *self._depths(words)], begin)
        page.forget_feed()
        return span.last

    def _depths(self, words: Mapping[str, float]) -> list[str]:
        """Return depth, first cut and lead; the cut is rounded upwards, so that the passes reach the depth."""
        grid, page = self.page.grid, self.page
        digit_mm = LAST_DIGIT[grid.units] * grid.unit_mm
        depth = round(words["K"] / digit_mm)
        cut = min(ceil(words["J"] / digit_mm - LEAST_DIGIT), depth)
        lead = f"{words['P'] / grid.unit_mm:.{LEAD_DECIMALS}f}".rstrip("0").rstrip(".")
        return [f"P{depth}", f"Q{cut}", f"F{page.with_point(lead)}"]


def _first_word(words: Mapping[str, float], angle_deg: int) -> str:
    """Return P of the first block: finishing passes, pull-out in tenths of the lead, angle; "" where it has no digits.

    The infeed is steeper than the flank, so that the angle is the next that controls know. One finishing pass is made
    always. The pull-out is rounded down, but never to none, so that the thread is as long as asked for.
    """
    pull_out_mm = words.get("E", 0.0)
    tenths = floor(10.0 * pull_out_mm / words["P"] + LEAST_DIGIT)
    passes = round(words["H"]) + 1
    if abs(angle_deg - 2.0 * words["Q"]) > MOST_ANGLE_OFF_DEG or (pull_out_mm and not tenths):
        return ""
    return f"P{passes:02d}{tenths:02d}{angle_deg:02d}" if passes < 100 and tenths < 100 else ""
