# SPDX-License-Identifier: LGPL-2.1-or-later
"""Path retract: from the status of a held session to wire text, proven as any program.

report (control/stream/retract_handover.py) ─► Held: the program's path, the place, how far it was cut
                                │ back_by · back_to_line · back_to_entry · forward_by · rest
                                └──► text ──► prove ──► certificate + data for the next client
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise
from math import dist, hypot
from typing import Any

from CNCStepper.control.stream.retract_handover import REST
from CNCStepper.control.stream.return_after_jog import Axes, landed_mm, over, over_backlash
from CNCStepper.errors import JobError, ProgramError, Text
from CNCStepper.gcode.dialects import dialect_named
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.interpreter.state.parameters import offset_number, stored_point
from CNCStepper.gcode.wire.wire_text import FirstMove, WireLines
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.prove import prove
from CNCStepper.machine.backlash import Motors
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.planner.backlash_moves import tool_moves
from CNCStepper.recovery.retract.held_session import SessionContext, acknowledged, found_of
from CNCStepper.recovery.retract.move_curve import Move, Point
from CNCStepper.recovery.retract.path_search import PositionReport, PossiblePlaces
from CNCStepper.recovery.retract.places_on_path import Part, Place, RetractPath, stretch_moves
from CNCStepper.recovery.retract.wire_writer import (
    crossing,
    head_lines,
    modes_line,
    output_lines,
    over_lines,
    taken_up,
    way_lines,
    without_height,
)
from CNCStepper.recovery.tool_power_on import cut_begin, own_wait_s
from CNCStepper.state import WORK_SYSTEMS, ZERO3, State

BACK, FORWARD, ASIDE = "back", "forward", "aside"


@dataclass(frozen=True)
class HeldProgram:
    """A held program: its way, where on it the tool is, and how far it was cut.

    way: of the tool. motors: theirs, the same rows; another one where play is taken up. found.early: where to go on
    from. is_beside: it was jogged since, so nobody knows on which side of their gaps the motors stand. position_mm:
    where they stand, on whole steps. reached: how many of the program's lines were acknowledged. model: what is in
    force after them.
    """

    ground: SessionContext
    way: RetractPath
    motors: RetractPath
    found: PossiblePlaces
    is_beside: bool
    farthest: Place
    position_mm: tuple[float, float, float]
    reached: int
    model: Model

    @property
    def place(self) -> Place:
        """Where the tool is, the earliest place where that is not certain."""
        return self.found.early

    @property
    def behind_mm(self) -> float:
        """How far the tool is behind the end of the cut, along the path."""
        return self.way.length_mm(self.place, self.farthest)

    @property
    def doubt(self) -> str:
        """The warning when the place is uncertain, "" when it is certain."""
        early, late = self.found
        if early == late:
            return ""
        return Text(
            "it is uncertain which of several passes was cut, so the earliest possible one is used: line "
            "{file_line}, not {file_line2}",
            file_line=self.file_line(early),
            file_line2=self.file_line(late),
        )

    def file_line(self, place: Place) -> int:
        """Return the line of the program's file that moves along a place."""
        return self.ground.program.place(int(self.way.lines[place.row]) - 1).line

    def back_by(self, length_mm: float) -> Place:
        """Return the place that lies this far back."""
        return self.way.back_by(self.place, length_mm)

    def back_to_line(self, line: int) -> Place:
        """Return where a line of the file begins, its last run before here; raises ProgramError where there is none."""
        rows = range(self.place.row, self.way.begin_before(self.place) - 1, -1)
        own = [row for row in rows if self.file_line(Place(row, 0.0)) == line]
        if not own:
            what = Text("no move of line {line} lies on the way back", line=line)
            first = self.file_line(Place(rows[-1], 0.0))
            limit = Text("line {first} to {file_line}", first=first, file_line=self.file_line(self.place))
            raise ProgramError("retreat-line", what, limit=limit, advice="name a line that was cut before this one")
        first_run = next((number for number, row in enumerate(own[1:], 1) if row != own[number - 1] - 1), len(own))
        return Place(own[first_run - 1], 0.0)

    def back_to_entry(self) -> Place:
        """Return where the tool last began to go down into the work."""
        return self.way.last_entry(self.place)

    def forward_by(self, length_mm: float = float("inf")) -> Place:
        """Return the place that lies this far ahead, as far as the program was cut at most."""
        return self.way.forward_by(self.place, length_mm, self.farthest)

    def along(self, target: Place) -> dict[str, Any]:
        """Return the leg to another place, proven; raises JobError where the checks refuse it."""
        kind = BACK if target < self.place else FORWARD
        return self._leg(kind, target, self.ground.machine.keeps_outputs_back)

    def aside(self) -> dict[str, Any]:
        """Return the leg that goes nowhere, outputs off: after it the machine is idle and can be jogged."""
        return self._leg(ASIDE, self.place, outputs=False)

    def rest(self) -> dict[str, Any]:
        """Return the leg that cuts from here to the end, proven; raises JobError where the checks refuse it."""
        line = int(self.way.lines[self.place.row])
        end = Place(self.way.rows_of(line)[-1], 1.0)
        lines, parts = self._lines_to(end, outputs=True, leads_on=True, begin=self._run_up())
        reader = self.ground.read(self.ground.program.lines[:line])
        lines.append(modes_line(reader.model.state, reader.model.state.feed_mm_min))
        heads = len(lines) - len(parts) - 1
        file_lines = [*self._file_lines(heads, parts), self.file_line(end)]
        own, program = len(lines), self.ground.program
        lines += _with_motion(program.lines[line:], reader.model, self.ground.dialect)
        content = {
            "kind": REST,
            "heads": heads,
            "parts": parts,
            "then": line,
            "file_lines": file_lines + [program.place(index).line for index in range(line, len(program.lines))],
            "messages": {own + at - line: text for at, text in program.messages.items() if at >= line},
            "end": Place(len(self.way) - 1, 1.0),
        }
        return self._proven(lines, content)

    def _leg(self, kind: str, target: Place, outputs: bool) -> dict[str, Any]:
        """Return a leg after which the machine waits, proven."""
        lines, parts = self._lines_to(target, outputs)
        heads = len(lines) - len(parts)
        content = {
            "kind": kind,
            "heads": heads,
            "parts": parts,
            "then": None,
            "file_lines": self._file_lines(heads, parts),
            "messages": {},
            "end": target,
        }
        return self._proven(lines, content)

    def _run_up(self) -> Place:
        """Return where a torch pierces again: behind its place in its own kerf; the place itself for other tools."""
        run_up_mm = self.ground.machine.run_up_mm
        if not (run_up_mm and self._state(self.place).spindle_turns):
            return self.place
        first = Place(cut_begin(self.way.toolpath, self.place.row), 0.0)
        return max(first, self.way.back_by(self.place, run_up_mm))

    def _lines_to(
        self, target: Place, outputs: bool, leads_on: bool = False, begin: Place | None = None
    ) -> tuple[list[str], list[Part | None]]:
        """Return the lines to another place, and the parts of the way that those after the head are; None is beside it.

        leads_on: the motors end where the program's own next line presumes them. begin: the place behind this one to
        which the tool goes without power first.
        """
        state, begin = self._state(self.place), begin or self.place
        on = output_lines(state, self._wait_s(), dialect_named(self.ground.dialect).power) if outputs else []
        head, over = head_lines(state, self.position_mm), over_lines(self._over(), state)
        lines, parts = way_lines(self._moves_by((self.place, begin, target), leads_on), state)
        if not self.ground.machine.has_z:
            head, over, lines = map(without_height, (head, over, lines))
        back = _count_back(parts) if begin < self.place else 0
        before, after = ([], on) if back or not self.ground.machine.keeps_outputs_back else (on, [])
        first = [*before, *over]
        own: list[Part | None] = [None] * len(first)
        return head + first + lines[:back] + after + lines[back:], own + parts[:back] + [None] * len(after) + parts[
            back:
        ]

    def _wait_s(self) -> float:
        """Return how long to wait once the tool is on: a torch pierces as long as the program waits."""
        machine = self.ground.machine
        if machine.cuts_standing and not machine.spindle.laser:
            return own_wait_s(self.way.toolpath, self.place.row) or machine.spindle.spin_up_s
        return machine.spindle.spin_up_s

    def _moves_by(self, places: Sequence[Place], leads_on: bool) -> Iterator[tuple[Move, Part]]:
        """Yield the moves of the motors along the path from place to place."""
        pairs = [pair for pair in pairwise(places) if pair[0] != pair[1]] or [(places[0], places[-1])]
        moves = chain.from_iterable(stretch_moves(self.way, *pair) for pair in pairs)
        play, target = self.ground.play, places[-1]
        if play is None:
            yield from moves
            return
        motors = Motors(play, landed_mm(self._there_mm, play) if self._is_off else self.position_mm)
        yield from taken_up(moves, motors)
        if leads_on:
            own = self.motors.move(target.row)
            yield crossing(motors.at_mm, own.end, own, play), (*target, target.share)

    def _over(self) -> Iterable[tuple[Axes, float]]:
        """Return positions and speeds of the return to the cut; none for a machine that is on it."""
        if not self._is_off:
            return ()
        if self.ground.play:
            return over_backlash(self.position_mm, self._there_mm, self.way.top_mm, self.ground.play)
        return over(self.position_mm, self._there_mm, self.way.top_mm)

    @property
    def _is_off(self) -> bool:
        """Whether the tool must first return to the path."""
        gaps_mm = hypot(*self.ground.play.backlash_mm) if self.ground.play else 0.0
        is_far = dist(self.position_mm, self._there_mm) > self.ground.controller.tolerance_mm + gaps_mm
        return is_far or (self.is_beside and gaps_mm > 0.0)

    @property
    def _there_mm(self) -> Point:
        """The place of the tool on its way."""
        return self.way.move(self.place.row).at(self.place.share)

    def _state(self, place: Place) -> State:
        return self.way.toolpath.states[int(self.way.toolpath.table().state[place.row])]

    def _file_lines(self, heads: int, parts: Sequence[Part | None]) -> list[int]:
        here = self.file_line(self.place)
        return [here] * heads + [self.file_line(Place(part[0], part[1])) if part else here for part in parts]

    def _proven(self, lines: Sequence[str], content: dict[str, Any]) -> dict[str, Any]:
        """Return a leg with its certificate."""
        text = "".join(f"{line}\n" for line in lines)
        start = replace(
            self.ground.start,
            position_mm=self.position_mm,
            work_system=WORK_SYSTEMS[0],
            work_offsets_mm=_offsets(self.model),
            g92_mm=ZERO3,
            tool=self._state(self.place).tool,
            zero_known=self.ground.zero_known,
        )
        proof = prove(text, self.ground.motors, file="", dialect=self.ground.dialect, start=start)
        certificate = certificate_of(proof)
        certificate.check_clean()
        if len(proof.wire.lines) != len(lines):
            advice = "please report it, with the program"
            raise JobError("retreat-lines", "the retract cannot be sent as it was written", advice=advice)
        return content | {
            "certificate": certificate,
            "begin": self.place,
            "farthest": self.farthest,
            "reached": self.reached,
            "ahead_mm": [motor - tool for motor, tool in zip(self.position_mm, self._there_mm, strict=True)],
        }


def held_program(told: Mapping[str, Any], machine: Machine | None = None) -> HeldProgram:
    """Return the held program of a session's status; raises ProgramError or JobError where no retract is possible."""
    ground = SessionContext.of(told, machine)
    reports = [
        PositionReport(*report)._replace(position_mm=ground.controller.on_step(report[4])) for report in told["reports"]
    ]
    leg = told["leg"]
    reached = acknowledged(leg, reports)
    reader = ground.read(ground.program.lines[: reached + 1])
    path, model = reader.toolpath(), ground.read(ground.program.lines[:reached]).model
    motors = RetractPath(path)
    way = RetractPath(tool_moves(path, ground.play)) if ground.play else motors
    found, is_beside = found_of(ground, motors, told, reports)
    farthest = max(Place(*leg["farthest"]), found.late) if leg else found.late
    position_mm = ground.controller.on_step(told["position_mm"])
    return HeldProgram(ground, way, motors, found, is_beside, farthest, position_mm, reached, model)


def _count_back(parts: Sequence[Part]) -> int:
    """Return how many of the first parts of a way lead back."""
    return max((number for number, (_, begin, end) in enumerate(parts, 1) if end < begin), default=0)


def _with_motion(lines: Sequence[str], model: Model, dialect: str) -> list[str]:
    """Return a program's further lines, the first move of which names the motion that was modal."""
    own = list(lines)
    lines = WireLines("".join(f"{line}\n" for line in own).encode("ascii"))
    index = FirstMove(dialect_named(dialect)).without_motion(lines)
    if index is not None:
        own[index] = MOTION_NAMES[model.motion] + own[index]
    return own


def _offsets(model: Model) -> dict[str, tuple[float, ...]]:
    """Return the work offsets in force, which are the controller's own."""
    return {name: stored_point(model.parameters, offset_number(name), model.unit_mm)[:3] for name in WORK_SYSTEMS}
