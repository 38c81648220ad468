# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program and controller of a held session as the core's own values.

Where on its way a held program's tool is: by the reports, or by the leg on which it was held.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import hypot
from typing import Any

from pydantic import ValidationError

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.stream.retract_handover import REST
from CNCStepper.errors import JobError, Text
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import run_whole
from CNCStepper.gcode.interpreter.flow.subprogram_files import Library
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.job.start_state_file import start_from
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import Machine
from CNCStepper.recovery.retract.path_search import Controller, PositionReport, PossiblePlaces, find
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath
from CNCStepper.state import ZERO3, Start


@dataclass(frozen=True)
class SessionContext:
    """What does not change while a program is held: its lines, where it began, on which machine.

    zero_known: whether the program was proven at its place on the table; else its travel is judged by its size alone.
    play: the backlash of the axes, where the lines sent compensate it.
    """

    program: SendJob
    start: Start
    zero_known: bool
    machine: Machine
    dialect: str
    controller: Controller
    play: Backlash | None = None

    @classmethod
    def of(cls, told: Mapping[str, Any], machine: Machine | None) -> SessionContext:
        """Return the program of a session's status; machine: of a session started without one.

        Raises JobError where there is none.
        """
        program = SendJob.from_content(told["program"])
        known = program.retrace
        machine = _machine(known, machine)
        dialect = machine.language(known.get("dialect", ""))
        start = start_from(known["start"]) if known.get("start") else Start()
        return cls(
            program,
            _started(start, told["origin"]),
            start.zero_known,
            machine,
            dialect,
            _controller(told, machine),
            backlash_of(machine, dialect),
        )

    @property
    def motors(self) -> Machine:
        """The machine as its motors see it, without play: what they are sent has taken that up already."""
        axes = {name: axis.model_copy(update={"backlash_mm": 0.0}) for name, axis in self.machine.axis.items()}
        return self.machine.model_copy(update={"axis": axes})

    def read(self, lines: Sequence[str]) -> Interpreter:
        """Return an interpreter that has read some of the program's first lines."""
        return read_lines(lines, self.start, self.dialect)


def read_lines(lines: Sequence[str], start: Start, dialect: str) -> Interpreter:
    """Return an interpreter that has read wire lines."""
    reader = Interpreter(start, dialect)
    run_whole(reader, "".join(f"{line}\n" for line in lines), Library())
    return reader


def _machine(known: Mapping[str, Any], machine: Machine | None) -> Machine:
    if machine is not None:
        return machine
    if not known.get("machine"):
        what = "the job was sent without a machine profile, so no way back can be checked"
        raise JobError("retreat-machine", what, advice="name the machine (--machine)")
    try:
        return Machine.model_validate(known["machine"])
    except ValidationError as error:
        what = Text("the job's machine profile cannot be read: {error}", error=error)
        advice = "name the machine (--machine)"
        raise JobError("retreat-machine", what, advice=advice) from error


def _started(start: Start, origin: Mapping[str, Any]) -> Start:
    """Return the start of the program with the position and the offsets that the controller itself reported then."""
    offsets = {name: tuple(offset) for name, offset in origin["work_offsets_mm"].items()}
    return replace(
        start,
        position_mm=tuple(origin["position_mm"] or start.position_mm),
        work_system=origin["work_system"],
        work_offsets_mm=offsets,
        g92_mm=tuple(origin["g92_mm"] or ZERO3),
        zero_known=True,
    )


def _controller(told: Mapping[str, Any], machine: Machine) -> Controller:
    """Return the controller's own settings, or those of the profile where it reports none."""
    steps = [said or axis.steps_per_mm for said, axis in zip(told["steps_per_mm"], machine.axes, strict=True)]
    rates = [said or axis.max_rate_mm_min for said, axis in zip(told["max_rate_mm_min"], machine.axes, strict=True)]
    tolerance_mm = told["arc_tolerance_mm"] or machine.planner.arc_tolerance_mm
    return Controller(int(told["blocks"]), (steps[0], steps[1], steps[2]), tolerance_mm, hypot(*rates))


def acknowledged(leg: Mapping[str, Any] | None, reports: Sequence[PositionReport]) -> int:
    """Return how many of the program's own lines the controller has acknowledged, in this leg or before."""
    now = reports[-1].acknowledged if reports else 0
    if leg is None:
        return now
    again = leg["then"] + now - _own(leg) if leg["kind"] == REST else 0
    return max(int(leg["reached"]), again)


def found_of(
    ground: SessionContext, way: RetractPath, told: Mapping[str, Any], reports: Sequence[PositionReport]
) -> tuple[PossiblePlaces, bool]:
    """Return where on the program's way the tool is, and whether it was jogged from there and is not surely back.

    way: of the motors, whose places are reported. Raises ProgramError where the machine does not stand on it.
    """
    leg = told["leg"]
    if leg is None:
        return find(way, reports, ground.controller), told["jogged"]
    if told["stands"]:
        end = Place(*leg["end"])
        return PossiblePlaces(end, end), told["jogged"]
    start = start_from(leg["certificate"]["start"]["state"])
    leg_way = RetractPath(read_lines(told["leg_lines"], start, ground.dialect).toolpath())
    on_leg = find(leg_way, reports, ground.controller)
    places = [_on_program(place, leg_way, way, leg) for place in on_leg]
    return PossiblePlaces(min(places), max(places)), any(_is_beside(place, leg_way, leg) for place in on_leg)


def _own(leg: Mapping[str, Any]) -> int:
    """Return how many lines of a leg are not the program's."""
    return int(leg["heads"]) + len(leg["parts"]) + (leg["kind"] == REST)


def _part(place: Place, leg_way: RetractPath, leg: Mapping[str, Any]) -> int:
    """Return the number of the line that moves along a place of a leg, from 0 behind its head."""
    return int(leg_way.lines[place.row]) - 1 - int(leg["heads"])


def _is_beside(place: Place, leg_way: RetractPath, leg: Mapping[str, Any]) -> bool:
    """Return whether a place of a leg is on its return from a jog."""
    part = _part(place, leg_way, leg)
    return part < len(leg["parts"]) and leg["parts"][part] is None


def _on_program(place: Place, leg_way: RetractPath, way: RetractPath, leg: Mapping[str, Any]) -> Place:
    """Return the place of the program that a place of a leg is, or leads to."""
    if _is_beside(place, leg_way, leg):
        return Place(*leg["begin"])
    part, line = _part(place, leg_way, leg), int(leg_way.lines[place.row])
    if part < len(leg["parts"]):
        row, begin, end = leg["parts"][part]
        return Place(int(row), begin + (end - begin) * place.share)
    rows = way.rows_of(int(leg["then"]) + line - _own(leg))
    return Place(rows[place.row - leg_way.rows_of(line)[0]], place.share)
