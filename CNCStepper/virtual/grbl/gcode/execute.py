# SPDX-License-Identifier: LGPL-2.1-or-later
"""A checked block is carried out, word by word in the order that the standard gives.

The probing moves, G38.2 to G38.5.
"""

from __future__ import annotations

from math import ceil, dist

from CNCStepper.virtual.grbl import report, suspend
from CNCStepper.virtual.grbl.alarms_and_errors import ALARM_PROBE_NO_CONTACT, ALARM_PROBE_START, refused
from CNCStepper.virtual.grbl.board import Board, Waiting
from CNCStepper.virtual.grbl.gcode import canned_cycles, checks, parser
from CNCStepper.virtual.grbl.gcode.block import (
    ARCS,
    CLEAR_OFFSET,
    CYCLES,
    DWELL,
    FEED,
    GO_HOME,
    PROBE_AWAY,
    PROBE_AWAY_QUIET,
    PROBE_TOWARD_QUIET,
    PROBES,
    RAPID,
    SET_DATA,
    SET_HOME,
    SET_OFFSET,
    AxisCommand,
    Block,
    Modal,
)
from CNCStepper.virtual.grbl.gcode.words import f32
from CNCStepper.virtual.grbl.settings import LASER, SOFT_LIMITS
from CNCStepper.virtual.grbl.spindle_control import OFF
from CNCStepper.virtual.grbl.states import State

QUIET = (PROBE_TOWARD_QUIET, PROBE_AWAY_QUIET)  # G38.3 and G38.5 raise no alarm
AWAY = (PROBE_AWAY, PROBE_AWAY_QUIET)


def run_probe_cycle(machine: Board, block: Block) -> Waiting:
    """Make a probing move and print its result."""
    yield from machine.wait_for_stop()
    if not machine.probe.await_change(machine.axes, block.modal.motion in AWAY):
        machine.alarm(ALARM_PROBE_START)
        return
    machine.override_motion()
    yield from machine.queue(block.target, block.feed)
    machine.start_cycle()
    while not machine.axes.stopped:
        yield
    _finish(machine, block)


def _finish(machine: Board, block: Block) -> None:
    probe = machine.probe
    if not probe.found and block.modal.motion in QUIET:
        probe.contact_steps = machine.axes.position_steps
    probe.searching = False
    machine.axes.reset()
    machine.finish_cycle()
    if not probe.found and block.modal.motion not in QUIET:
        machine.alarm(ALARM_PROBE_NO_CONTACT)
    machine.send(report.probe_result(machine.axes.mm_of(probe.contact_steps), probe.found, machine.memory.settings))
    if probe.found:
        block.target = machine.axes.position_mm


PAUSE = 0  # M0
DWELL_STEP_S = 0.05


def run(machine: Board, line: str) -> Waiting:
    """Read, check and carry out one line of g-code; raises MachineRefusal, then nothing has changed."""
    block = parser.read_block(line, machine.parser.modal, machine.firmware)
    checks.complete(block, machine.parser, machine.memory.places, machine.firmware.digital_outputs)
    if machine.state is State.TOOL and block.axis_command is AxisCommand.MOTION:
        raise refused(40)
    if block.changes_tool and machine.state is not State.CHECK:
        yield from _change_tool(machine)
    yield from _set_spindle(machine, block)
    yield from _set_coolant(machine, block)
    yield from _switch_output(machine, block)
    if block.action == DWELL and machine.state is not State.CHECK:
        yield from machine.wait_for_stop()
        yield from machine.wait(_dwell_s(block.words["P"]))
    yield from _set_offsets(machine, block)
    machine.parser.modal = block.modal
    machine.parser.drilling = block.drilling or (machine.parser.drilling if block.modal.motion in CYCLES else None)
    yield from _act(machine, block)
    if block.axis_command is AxisCommand.MOTION:
        yield from _make_motion(machine, block)
    if block.flow is not None:
        yield from _stop_program(machine, block.flow)


def _dwell_s(seconds: float) -> float:
    """Return how long the firmware waits: whole steps of 50 ms, rounded up."""
    return ceil(f32(f32(1 / DWELL_STEP_S) * seconds)) * DWELL_STEP_S


def jog(machine: Board, line: str) -> Waiting:
    """Check and queue a `$J=` line; of the parser only the position changes."""
    block = parser.read_block(line, machine.parser.modal)
    checks.complete(block, machine.parser, machine.memory.places)
    settings = machine.memory.settings
    if settings.on(SOFT_LIMITS) and settings.outside_travel(block.target):
        raise refused(15)
    yield from machine.queue(block.target, block.feed)
    if machine.state in (State.IDLE, State.TOOL) and not machine.axes.idle:
        machine.state = State.JOG
        machine.override_motion()
    machine.parser.position = block.target


def _change_tool(machine: Board) -> Waiting:
    """Enter the state Tool; the line itself is done then."""
    yield from machine.wait_for_stop()
    machine.tool_change.begin()
    machine.state = State.TOOL


def _set_spindle(machine: Board, block: Block) -> Waiting:
    """F, S, T and M3 to M5. A new speed or direction waits for the moves before it to end."""
    state, laser = machine.parser, machine.memory.settings.on(LASER)
    state.feed = block.feed
    with_motion = laser and block.axis_command is AxisCommand.MOTION  # a laser's power rides on its moves
    speed_changes = block.rpm != state.rpm and state.modal.spindle != OFF and not with_motion
    state.rpm = block.rpm
    state.tool = int(block.words.get("T", 0))  # the firmware forgets the tool with the next block
    if speed_changes or block.modal.spindle != state.modal.spindle:
        if machine.state is not State.CHECK:
            yield from machine.wait_for_stop()
            machine.spindle.switch(block.modal.spindle, block.rpm)
            machine.status.overrides_changed()
        state.modal.spindle = block.modal.spindle
    elif with_motion and machine.state is not State.CHECK:
        machine.spindle.switch(block.modal.spindle, block.rpm)


def _set_coolant(machine: Board, block: Block) -> Waiting:
    now, modal = machine.parser.modal, block.modal
    if (modal.flood, modal.mist) != (now.flood, now.mist) and machine.state is not State.CHECK:
        yield from machine.wait_for_stop()
        machine.flood, machine.mist = modal.flood, modal.mist
        machine.status.overrides_changed()
    now.flood, now.mist = modal.flood, modal.mist


def _switch_output(machine: Board, block: Block) -> Waiting:
    """M62 to M65: every move before it has been made when an output is switched."""
    if block.switches is None or machine.state is State.CHECK:
        return
    yield from machine.wait_for_stop()
    change = machine.outputs.add if block.switches else machine.outputs.discard
    change(int(block.words["P"]))


def _set_offsets(machine: Board, block: Block) -> Waiting:
    """G43.1, G49 and G54 to G59; each change waits for the moves before it, so that reports stay true."""
    state = machine.parser
    if block.axis_command is AxisCommand.TOOL_LENGTH:
        length = block.words["Z"] if block.modal.tool_length == 43 else 0.0
        if length != state.tool_length:
            yield from _note_offset(machine)
            state.tool_length = length
    if block.modal.system != state.modal.system:
        yield from _note_offset(machine)
        state.system_offset = list(machine.memory.places[block.modal.system])


def _note_offset(machine: Board) -> Waiting:
    yield from machine.wait_for_stop()
    machine.status.offset_changed()


def _act(machine: Board, block: Block) -> Waiting:
    """G10, G28, G30 and G92 in all their forms."""
    state, places = machine.parser, machine.memory.places
    if block.action == SET_DATA:
        yield from _note_offset(machine)
        places[block.system] = block.centre
        if block.system == state.modal.system:
            state.system_offset = list(block.centre)
    elif block.action in GO_HOME:
        if block.axis_words:
            yield from machine.queue(block.target, 0.0, rapid=True)
        yield from machine.queue(block.centre, 0.0, rapid=True)
        state.position = block.centre
    elif block.action in SET_HOME:
        yield from machine.wait_for_stop()
        places[block.action // 10] = list(state.position)
    elif block.action == SET_OFFSET:
        yield from _note_offset(machine)
        state.g92 = block.target
    elif block.action == CLEAR_OFFSET:
        yield from _note_offset(machine)
        state.g92 = [0.0, 0.0, 0.0]


def _make_motion(machine: Board, block: Block) -> Waiting:
    state = machine.parser
    if block.modal.motion in (RAPID, FEED):
        feed = _feed_of_line(block, state.position)
        yield from machine.queue(block.target, feed, rapid=block.modal.motion == RAPID)
    elif block.modal.motion in ARCS:
        yield from machine.queue_arc(block, state.position)
    elif block.modal.motion in CYCLES:
        yield from canned_cycles.run(machine, block)
    elif block.modal.motion in PROBES and machine.state is not State.CHECK:
        yield from run_probe_cycle(machine, block)
    state.position = block.target


def _feed_of_line(block: Block, start_mm: list[float]) -> float:
    """Return mm/min; in inverse time (G93) F says how many such moves a minute would hold."""
    return block.feed * dist(start_mm, block.target) if block.modal.feed_mode == 93 else block.feed


def _stop_program(machine: Board, flow: int) -> Waiting:
    """M0 holds until cycle start; M2 and M30 put most modal words back and switch the outputs off."""
    yield from machine.wait_for_stop()
    check = machine.state is State.CHECK
    if flow == PAUSE:
        if not check:
            suspend.pause(machine)
            yield
        return
    modal = machine.parser.modal
    machine.parser.modal = Modal(motion=FEED, units=modal.units, tool_length=modal.tool_length)
    if not check:
        machine.parser.system_offset = list(machine.memory.places[54])
        machine.status.offset_changed()
        suspend.switch_off(machine)
    machine.overrides.normalize()
    machine.override_motion()
    machine.send("[MSG:Pgm End]")
