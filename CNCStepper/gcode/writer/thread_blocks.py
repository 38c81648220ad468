# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes moves that follow the spindle: as G33 with K, as a whole thread with G76, or as G01 from the encoder's index.

    G33 Z-32 K2.5                                                   a pass, where the dialect has G33
    G32 Z-32 F2.5                                                   where the dialect has G32
    G76 P2.5 Z-32 I-1 J0.3 K1.534 R2 Q29 H1 E1.5 L2                 all passes of a start, where that is asked for
    N50 G01 X-0.75 Z-32. F3.75 #                                    a lathe that begins each run of G01 at the index

In the table a row follows the spindle if an event "synchronised" is before it; its value is the travel a turn.
"""

from __future__ import annotations

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.writer.block_emitter import SYNCHRONISED, BlockEmitter
from CNCStepper.gcode.writer.move_rows import RowWriter
from CNCStepper.toolpath import Event, Toolpath

THREAD = "G76"
LENGTHS = "PE"  # words of G76 in units of the text
DEPTHS = "IJK"  # as X: diameters where that is one
NO_FEED = "the feed does not follow the spindle: choose a machine whose controller has G33"


class ThreadWriter:
    """Writes threads; whole: as G76 where the table says that it means the same rows."""

    def __init__(self, toolpath: Toolpath, page: BlockEmitter, rows: RowWriter, whole: bool):
        self.page, self.rows = page, rows
        self._leads = {event.index: event.value for event in toolpath.events if event.kind == "synchronised"}
        wanted = [span for span in toolpath.spans if span.kind == "turning_cycle" and span.name == THREAD]
        has_cycle = THREAD in page.dialect.codes and not page.dialect.two_block_cycles  # whose words are others
        self._spans = {span.first: span for span in wanted if whole and has_cycle}

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
