# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a program's file, piece by piece: memory stays the same however long the program is.

    WireFile ─chunks─► tool's way ─► planner ─► parts of PART_ROWS rows ─► Checks · Figures · the cut part
        └── wire text ─► columns of a bundle, for the certificate

It finds and reports what `prove.prove` does of the whole text. Where shapes are judged, the path that cuts lies on the
disk until all of it is known, and is judged block by block.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from itertools import repeat
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Unpack

import numpy as np

from CNCStepper.gcode.interpreter.program_file import text_pieces
from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.gcode.wire.wire_file import WireFile, WireOptions, wire_of_file
from CNCStepper.gcode.wire.wire_text import WireText
from CNCStepper.input_file import Unchanged
from CNCStepper.job.planned_times import Milestones
from CNCStepper.job.proof_inputs import Given
from CNCStepper.job.wire_round_trip import translated_to
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import MILLING, Process
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.backlash_moves import ToolMoves
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.chunk_window import ChunkWindow
from CNCStepper.motion.planner.plan import Run, begun_chunks
from CNCStepper.motion.planner.standstills import StopEvents
from CNCStepper.simulation.check_context import CheckContext, Cutting
from CNCStepper.simulation.checks.check_program import Checks
from CNCStepper.simulation.checks.program_report import Figures
from CNCStepper.simulation.finding import MOST_LISTED, Finding, refused
from CNCStepper.simulation.first_lines import FirstLines
from CNCStepper.simulation.table_parts import PART_ROWS, TableParts
from CNCStepper.state import Start
from CNCStepper.toolpath import Chunk, Event, Span, Toolpath, straight_chunks

if TYPE_CHECKING:  # modules for the stock are loaded where there is one: a short check takes half the time without
    from shapely.geometry.base import BaseGeometry

    from CNCStepper.control.program.program_columns import ColumnWriter
    from CNCStepper.cycles.cycle import Removal
    from CNCStepper.gcode.wire.translation import TranslatedFile
    from CNCStepper.simulation.checks.clamps import Clamp
    from CNCStepper.simulation.cutter_solid import Tools
    from CNCStepper.simulation.exact.cutting_path import JudgedPath
    from CNCStepper.simulation.exact.free_pieces import SheetVerdict
    from CNCStepper.simulation.exact.sheet_cuts import SheetCuts
    from CNCStepper.simulation.exact.stored_cuts import StoredCuts
    from CNCStepper.simulation.exact.swept_area import Judgement
    from CNCStepper.simulation.removal.heightmap import HeightMap
    from CNCStepper.simulation.stock import Stock


@dataclass(frozen=True)
class FileProof:
    """What is known of a program's file on a machine; as `prove.Proof`, but for what holds the whole program.

    wire: what would be sent; its lines are read from the folder `sent`, and there are none where none was given.
    start: of the table. plan: as `milestones` gives it. cell_mm: of the cut part, None without stock. unchanged:
    whether the file is still the one that was proven. spans: of its operations, whose first lines `lines` knows.
    """

    path: Path
    wire: StoredWire
    start: Start
    plan: list[list[float]]
    findings: list[Finding]
    report: dict[str, Any]
    given: Given
    cell_mm: tuple[float, float] | None
    unchanged: Unchanged
    spans: list[Span]
    lines: FirstLines

    @property
    def refused(self) -> bool:
        """Whether a finding forbids sending it."""
        return refused(self.findings)

    @property
    def program_sha256(self) -> str:
        """The fingerprint of the program's text; raises JobError where it is another one than was proven."""
        from CNCStepper.control.program.certificate import digest_of_pieces

        digest = digest_of_pieces(text_pieces(self.path))
        self.unchanged.check()
        return digest


@dataclass(frozen=True)
class StoredWire:
    """What is sent of a program; lines and messages are in files, and read when they are asked for. Without these
    there are neither."""

    lines: Sequence[str]
    file_lines: Sequence[int]
    messages: Mapping[int, str]
    sha256: str
    count: int


def prove_file(
    path: Path,
    machine: Machine,
    *,
    dialect: str = "",
    start: Start | None = None,
    stock: Stock | None = None,
    tools: Tools | None = None,
    removals: Sequence[Removal] = (),
    keep_out: Sequence[Clamp] = (),
    edge_mm: float | None = None,
    process: Process = MILLING,
    cut_data: CutData | None = None,
    parts: Sequence[BaseGeometry] = (),
    sent: Path | None = None,
    name: str = "",
    share: Callable[[float], None] = lambda share: None,
    tell: Callable[[str], None] = lambda stage: None,
) -> FileProof:
    """Return the proof of a program's file; raises ProgramError as `prove` does.

    tools: by number, or one that stands for every number. The rest to `parts`, and tell: as `prove` takes them.
    sent: an empty folder for what is sent. name: of the file, for people; its path where left out. share: called with
    the share that is done.
    """
    against: dict[str, Any] = {"process": process, "cut_data": cut_data, "parts": parts}
    given = Given("", machine.language(dialect), machine, stock, tools, removals, keep_out, edge_mm, **against)
    return _FileProof(path, given, start, sent, name or str(path), share, tell).run()


class _FileProof:
    """One proof on its way through a program's file."""

    def __init__(
        self,
        path: Path,
        given: Given,
        start: Start | None,
        sent: Path | None,
        name: str,
        share: Callable[[float], None],
        tell: Callable[[str], None],
    ):
        self._path, self._given, self._machine, self._name, self._tell = path, given, given.machine, name, tell
        self._unchanged = Unchanged(path)
        self._stock, self._tools, self._folder = given.stock, given.tools, sent
        self._play = backlash_of(self._machine, given.dialect)
        self._wire = self._reading(path, start, sink=self._keep, progress=share, name=name)
        self._kept: StoredCuts | None = None
        self._part: HeightMap | None = None
        self._judged: JudgedPath | None = None
        if given.stock is not None and given.tools is not None:
            from CNCStepper.simulation.exact.stored_cuts import StoredCuts
            from CNCStepper.simulation.removal.heightmap import HeightMap

            self._kept, self._part = StoredCuts(), HeightMap(given.stock)
            if given.removals:
                from CNCStepper.simulation.exact.cutting_path import JudgedPath

                self._judged = JudgedPath(given.tools, given.stock)
        cutting = Cutting(given.process, given.cut_data, given.parts)
        self._sheet: SheetCuts | None = None
        if given.tools is not None and cutting.is_through_sheet:
            from CNCStepper.simulation.exact.sheet_cuts import SheetCuts

            self._sheet = SheetCuts(cutting, given.tools, given.stock)
        self._checks = Checks(given.stock, given.tools, given.keep_out, given.edge_mm, kept=self._kept, cutting=cutting)
        self._figures, self._milestones, self._lines = Figures(given.tools), Milestones(), FirstLines()
        self._writer: ColumnWriter | None = None
        table = self._wire.table
        self._motors, self._tool_parts = (TableParts(table.start, table.states) for _ in range(2))
        self._tool_moves = ToolMoves(self._play, table.start.position_mm) if self._play else None
        table.events = StopEvents(MOST_LISTED)
        self._stops: tuple[list[Event], list[Event]] = [], []  # at which the motion stops, of each pass through it
        self._rows = 0  # read so far
        self._whole_s = 0.0

    def _reading(self, path: Path, start: Start | None, **options: Unpack[WireOptions]) -> WireFile | TranslatedFile:
        """Return the reading of the file through its wire text."""
        dialect = self._given.dialect
        if (target := translated_to(self._machine, dialect)) is not None:
            from CNCStepper.gcode.wire.translation import TranslatedFile

            return TranslatedFile(path, start, dialect, target, self._play, **options)
        return wire_of_file(path, start, dialect, self._play, **options)

    def run(self) -> FileProof:
        """Read the file and prove it."""
        with ExitStack() as files:
            if self._kept:
                files.callback(self._kept.close)
            if self._judged:
                files.callback(self._judged.close)
            if self._folder:
                from CNCStepper.control.program.program_columns import ColumnWriter

                self._writer = files.enter_context(ColumnWriter(self._folder, self._name))
            self._tell("read")
            for group, is_last in _groups(self._planned()):
                self._see(group, is_last)
            if self._writer:
                self._writer.close()
            self._unchanged.check()
            return self._proof()

    def _keep(self, wire: WireText) -> None:
        if self._writer:
            self._writer.add(wire.file_lines, wire.lines, wire.messages)

    def _planned(self) -> Iterator[_Planned]:
        """Yield the chunks as the motors go them, each once it is planned."""
        table = self._wire.table
        waiting = deque[Chunk]()
        path, of_speeds = (Toolpath(table.start, [], table.states, stops) for stops in self._stops)
        chunks = self._chunks(waiting)
        speeds: Iterator[np.ndarray | None] = repeat(None)
        if any(axis.motor for axis in self._machine.axes):
            chunks, again = _twice(chunks)
            again_path = replace(of_speeds, chunks=ChunkWindow(again))  # type: ignore[arg-type]
            speeds = Run(again_path, self._machine, forgets=True).row_speeds_mm_s()
        begun, known = begun_chunks(path, chunks)
        if self._machine.interpolation != "planner":
            from CNCStepper.motion.interpolation.dda_stream import DdaTimes

            times = DdaTimes(begun, self._machine, known)
            for ends_s in times.row_ends_s():
                yield _Planned(waiting.popleft(), ends_s, next(speeds))
            self._whole_s = times.whole_s
        else:
            run = Run(replace(begun, chunks=ChunkWindow(known)), self._machine, forgets=True)  # type: ignore[arg-type]
            for ends_s in run.row_ends_s():
                yield _Planned(waiting.popleft(), ends_s, next(speeds))
            self._whole_s = run.clock / TICKS_PER_S
        if not self._rows:
            yield _Planned(table.empty(), np.zeros(0), None)

    def _chunks(self, waiting: deque[Chunk]) -> Iterator[Chunk]:
        """Yield the motors' chunks, which then wait to be planned; their events are in both lists when they are out."""
        for chunk in straight_chunks(self._wire.chunks(), self._wire.table, self._name):
            self._take_events()
            if len(chunk):
                self._rows += len(chunk)
                waiting.append(chunk)
                yield chunk
        self._take_events()

    def _take_events(self) -> None:
        events = self._wire.take_events()
        of_planning, of_speeds = self._stops
        of_planning += events
        if any(axis.motor for axis in self._machine.axes):
            of_speeds += events
        for parts in (self._motors, self._tool_parts) if self._tool_moves else (self._motors,):
            parts.events += events

    def _see(self, group: list[_Planned], is_last: bool) -> None:
        """Check, measure and cut the next part of the program."""
        file, lines = self._name, np.concatenate([one.chunk.line for one in group])
        ends_s = np.concatenate([one.ends_s for one in group])
        speeds = [one.speeds_mm_s for one in group if one.speeds_mm_s is not None]
        motors = self._motors.part([one.chunk for one in group], is_last)
        of_motors = of_tool = CheckContext.of(motors, self._machine, file, np.concatenate(speeds) if speeds else None)
        if self._tool_moves:
            moved = [self._tool_moves.moved(one.chunk) for one in group]
            of_tool = CheckContext.of(self._tool_parts.part(moved, is_last), self._machine, file)
        self._checks.see(of_motors, of_tool)
        marks = list(self._wire.table.span_marks("operation"))
        self._figures.see(of_tool.toolpath, ends_s, marks)
        self._lines.see(of_tool.toolpath, marks)
        self._milestones.see(lines, ends_s)
        if self._judged:
            self._judged.see(of_tool.toolpath)
        if self._sheet:
            self._sheet.see(of_tool, ends_s)
        if self._part is not None and self._stock is not None and self._tools is not None:
            from CNCStepper.simulation.removal.heightmap import HeightMap
            from CNCStepper.simulation.removal.removal_moves import moves_of

            moves = moves_of(of_tool.toolpath, self._tools, self._stock)
            self._part = HeightMap(self._stock, part=self._part.part.after(moves))
        spans = self._wire.table.spans
        spans[:] = [span for span in spans if span.kind == "operation"]  # a drilled hole each has a cycle's
        if len(group[-1].chunk):  # what follows names the state of the last row, or a later one
            self._wire.table.states.forget(int(group[-1].chunk.state[-1]))

    def _proof(self) -> FileProof:
        table, judgement = self._wire.table, self._judgement()
        self._tell("check")
        sheet = self._sheet_verdict()
        findings = self._checks.end(judgement, self._judged.line if self._judged else None, sheet)
        toolpath = Toolpath(table.start, [], table.states, spans=table.spans)
        return FileProof(
            path=self._path,
            wire=self._sent(),
            start=table.start,
            plan=self._milestones.all(),
            findings=findings,
            report=self._figures.report(
                toolpath,
                whole_s=self._whole_s,
                file=self._name,
                findings=findings,
                judgement=judgement,
                part=self._part,
                pieces=sheet.told() if sheet else [],
            ),
            given=self._given,
            cell_mm=None if self._part is None else self._part.cell_mm,
            unchanged=self._unchanged,
            spans=table.spans,
            lines=self._lines,
        )

    def _judgement(self) -> Judgement | None:
        """Return how far the shapes that are cut are from those wanted, where there are some."""
        if not self._judged:
            return None
        self._tell("judge")
        return self._judged.judged(self._given.removals)

    def _sheet_verdict(self) -> SheetVerdict | None:
        """Return the pieces cut free of the sheet, of a process that cuts through."""
        if not self._sheet:
            return None
        from CNCStepper.simulation.exact.free_pieces import SheetVerdict, freed_pieces

        return SheetVerdict(self._sheet, freed_pieces(self._sheet))

    def _sent(self) -> StoredWire:
        """Return what would be sent."""
        wire = self._wire
        lines, file_lines, messages = self._writer.columns() if self._writer else ((), (), {})
        return StoredWire(lines, file_lines, messages, wire.sha256, wire.count)


def _twice(chunks: Iterator[Chunk]) -> tuple[Iterator[Chunk], Iterator[Chunk]]:
    """Return the chunks for two readers; `itertools.tee` would keep up to 57 of them that both have read."""
    lags = deque[Chunk](), deque[Chunk]()

    def reader(own: deque[Chunk]) -> Iterator[Chunk]:
        while True:
            if not own:
                chunk = next(chunks, None)
                if chunk is None:
                    return
                for lag in lags:
                    lag.append(chunk)
            yield own.popleft()

    return reader(lags[0]), reader(lags[1])


class _Planned(NamedTuple):
    """A chunk of the motors' way, the end of each row in s, and where motors are checked their speeds."""

    chunk: Chunk
    ends_s: np.ndarray
    speeds_mm_s: np.ndarray | None


def _groups(planned: Iterator[_Planned]) -> Iterator[tuple[list[_Planned], bool]]:
    """Yield the chunks in groups of PART_ROWS rows at least, and whether it is the last group."""
    group: list[_Planned] = []
    for one in planned:
        if sum(len(before.chunk) for before in group) >= PART_ROWS:
            yield group, False
            group = []
        group.append(one)
    yield group, True
