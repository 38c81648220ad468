# SPDX-License-Identifier: LGPL-2.1-or-later
"""The `$` commands."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.virtual.grbl import homing, report, suspend
from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.board import Board, Waiting
from CNCStepper.virtual.grbl.firmware import HELP
from CNCStepper.virtual.grbl.gcode import execute
from CNCStepper.virtual.grbl.gcode.words import read_number
from CNCStepper.virtual.grbl.settings import HOMING
from CNCStepper.virtual.grbl.states import State

LARGEST_SETTING = 255
COMMAND_LETTERS = "#SIRN"


def run(machine: Board, line: str) -> Waiting:
    """Carry out a `$` line; raises MachineRefusal."""
    state = machine.state
    if line.startswith("$J"):
        if state not in (State.IDLE, State.JOG, State.TOOL):
            raise refused(8)
        if not line.startswith("$J="):
            raise refused(3)
        yield from execute.jog(machine, line)
    elif line[:2] in AT_ANY_TIME:
        if len(line) > 2:
            raise refused(3)
        AT_ANY_TIME[line[:2]](machine)
    elif line in machine.firmware.named:
        machine.send(machine.firmware.named[line])
    elif line == "$":
        machine.send(HELP)
    elif state not in (State.IDLE, State.ALARM) and (state, line) != (State.TOOL, "$#"):
        raise refused(8)
    elif line.startswith("$H"):
        yield from _home(machine, line)
    elif line.startswith("$N") and len(line) > 2:
        yield from _store_startup_line(machine, line)
    else:
        _run_at_rest(machine, line)


def _list_settings(machine: Board) -> None:
    if machine.state in (State.RUN, State.HOLD):
        raise refused(8)
    for line in machine.memory.settings.lines(machine.firmware.shown_settings):
        machine.send(line)


def _show_parser(machine: Board) -> None:
    machine.send(report.parser_state(machine.parser, machine.memory.settings, machine.firmware))


def _toggle_check(machine: Board) -> None:
    if machine.state is State.CHECK:
        machine.afterwards(machine.reset)
        machine.send("[MSG:Disabled]")
    elif machine.state is State.IDLE:
        machine.state = State.CHECK
        machine.send("[MSG:Enabled]")
    else:
        raise refused(8)


def _unlock(machine: Board) -> None:
    if machine.state is State.ALARM:
        machine.state = State.IDLE
        machine.send("[MSG:Caution: Unlocked]")


AT_ANY_TIME: dict[str, Callable[[Board], None]] = {
    "$$": _list_settings,
    "$G": _show_parser,
    "$C": _toggle_check,
    "$X": _unlock,
}


def _home(machine: Board, line: str) -> Waiting:
    if not machine.memory.settings.on(HOMING):
        raise refused(5)
    if line != "$H":
        raise refused(3)
    yield from homing.run(machine)
    yield from machine.run_startup_lines()


def _run_at_rest(machine: Board, line: str) -> None:
    """Commands that need the machine idle or locked."""
    if line.startswith("$RST="):
        _restore(machine, line)
    elif line.startswith("$I="):
        machine.memory.build_text = line[3:]
    elif line in LISTS:
        for answer in LISTS[line](machine):
            machine.send(answer)
    elif line == "$SLP":
        machine.afterwards(lambda: suspend.sleep(machine))
    elif line[1] in COMMAND_LETTERS:
        raise refused(3)
    else:  # any other letter is read as the number of a setting, hence error 2
        _store_setting(machine, line)


LISTS: dict[str, Callable[[Board], list[str]]] = {
    "$#": report.parameters,
    "$I": lambda machine: report.build_info(machine.memory, machine.firmware),
    "$N": lambda machine: [f"$N{number}={line}" for number, line in enumerate(machine.memory.startup_lines)],
}


def _restore(machine: Board, line: str) -> None:
    memory = machine.memory
    whats = {"$": memory.settings.restore, "#": memory.clear_places, "*": memory.clear_all}
    what = line[len("$RST=") :]
    if what not in whats:
        raise refused(3)
    whats[what]()
    machine.send("[MSG:Restoring defaults]")
    machine.afterwards(machine.reset)


def _store_startup_line(machine: Board, line: str) -> Waiting:
    """`$N0=` and `$N1=`: the line is run to see that it is valid, then kept."""
    if machine.state is not State.IDLE:
        raise refused(8)
    number, value_at = _number_before_equals(line, 2)
    if number >= len(machine.memory.startup_lines):
        raise refused(3)
    if line[value_at:]:
        yield from execute.run(machine, line[value_at:])
    machine.memory.startup_lines[int(number)] = line[value_at:]


def _store_setting(machine: Board, line: str) -> None:
    number, value_at = _number_before_equals(line, 1)
    if machine.firmware.read_only:
        raise refused(162)
    value, end = read_number(line, value_at)
    if end < len(line) or number > LARGEST_SETTING:
        raise refused(3)
    machine.memory.settings.store(int(number), value)
    machine.axes.adopt_settings()
    machine.override_motion()
    machine.status.offset_changed()


def _number_before_equals(line: str, position: int) -> tuple[float, int]:
    number, position = read_number(line, position)
    if line[position : position + 1] != "=":
        raise refused(3)
    return number, position + 1
