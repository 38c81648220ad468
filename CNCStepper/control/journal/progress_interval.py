# SPDX-License-Identifier: LGPL-2.1-or-later
"""The end of a journal as places on the program's path: the progress interval and the last status report.

lines    certainly cut | first ... ○ ... last | not sent
path     ──────────────●━━━━━━━━━━━○━━━━━━━━━━●─────────     begin and end of the interval, and where it was seen
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from CNCStepper.control.journal.replay import JobReplay
from CNCStepper.control.protocol.grbl.firmware import language_of
from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.stream.path_comparison import ROUNDING_MM, STEP_MM, STEPS, held_modes, start_from
from CNCStepper.control.stream.planned_path import PlannedPath
from CNCStepper.errors import ProgramError
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.translation import translate
from CNCStepper.gcode.wire.wire_text import WireText
from CNCStepper.state import ZERO3, Start

NEAR_MM = (STEPS * STEP_MM + ROUNDING_MM,) * 3
PIECE_LINES = 1000  # read and forgotten at once


@dataclass(frozen=True)
class ProgressInterval:
    """The interval as work positions, mm.

    first_line, last_line: of the file. seen_line: the line of the file on whose way the machine was last seen; 0 where
    it was seen off the way of all lines of the interval.
    """

    begin_mm: Vector
    end_mm: Vector
    first_line: int
    last_line: int
    seen_line: int


def progress_interval(story: JobReplay, text: str) -> ProgressInterval | None:
    """Return where a job was, by the text of its program; None where its path or its machine's place is not known."""
    group = story.group
    if group.mpos_mm is None or group.wpos_mm is None or story.header.get("mpos_mm") is None:
        return None
    try:
        wire = _wire_of(story, text)
    except ProgramError:
        return None
    if len(wire.lines) != story.total or story.may_be_sent <= story.finished:
        return None
    return _on_path(story, wire, group.mpos_mm, group.wpos_mm)


def _wire_of(story: JobReplay, text: str) -> WireText:
    """Return what was sent of a program; raises ProgramError."""
    dialect, file = story.header.get("dialect") or "grbl", story.header["file"]
    sent = story.header.get("wire_dialect") or dialect
    if sent.partition(":")[0] == dialect.partition(":")[0]:
        return prepare(text, dialect, file)
    return translate(text, dialect, sent, file).wire


def _on_path(story: JobReplay, wire: WireText, mpos_mm: Vector, wpos_mm: Vector) -> ProgressInterval | None:
    path = _path_from(story, wire.lines)
    begin_mm = path.end_mm
    path.read(story.may_be_sent)
    end_mm = path.end_mm
    if path.refused or begin_mm is None or end_mm is None:
        return None
    is_seen = path.drop_to(mpos_mm[:3], NEAR_MM)
    zero_mm = tuple(machine - work for machine, work in zip(mpos_mm, wpos_mm, strict=True))
    return ProgressInterval(
        _less(begin_mm, zero_mm),
        _less(end_mm, zero_mm),
        int(wire.file_lines[story.finished]),
        int(wire.file_lines[story.may_be_sent - 1]),
        int(wire.file_lines[max(path.line, story.finished)]) if is_seen else 0,
    )


def _path_from(story: JobReplay, lines: Sequence[str]) -> PlannedPath:
    """Return the path up to the first line that is not certainly cut; of its moves only the last is kept."""
    zero = story.zero or story.header
    offsets_mm, modes = zero["offsets_mm"], zero["modes"]
    start = start_from(offsets_mm, modes, tuple(story.header["mpos_mm"]))
    if story.zero:  # after a new zero, a job continues at the same place of the work
        start = replace(start, position_mm=_moved(start, story.header["offsets_mm"].get(start.work_system)))
    language = language_of(story.header.get("controller", "grbl"))
    path = PlannedPath(lines, start, held_modes(offsets_mm, modes), dialect=language)
    for count in range(0, story.finished, PIECE_LINES):
        done = min(count + PIECE_LINES, story.finished)
        path.read(done)
        path.drop_planned_before(done, 1)
    return path


def _moved(start: Start, before_mm: Sequence[float] | None) -> tuple[float, ...]:
    """Return the position that has in a new work zero the place that it had in the one before."""
    now_mm = start.work_offsets_mm.get(start.work_system, ZERO3)
    moved = zip(start.position_mm, now_mm, before_mm or ZERO3, strict=False)
    return tuple(place + now - before for place, now, before in moved)


def _less(place_mm: Vector, zero_mm: Sequence[float]) -> Vector:
    return tuple(machine - zero for machine, zero in zip(place_mm, zero_mm, strict=False))
