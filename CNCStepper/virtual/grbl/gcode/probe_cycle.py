# SPDX-License-Identifier: LGPL-2.1-or-later
"""The probing moves, G38.2 to G38.5."""

from __future__ import annotations

from CNCStepper.virtual.grbl import report
from CNCStepper.virtual.grbl.board import Board, Waiting
from CNCStepper.virtual.grbl.error_codes import ALARM_PROBE_NO_CONTACT, ALARM_PROBE_START
from CNCStepper.virtual.grbl.gcode.block import PROBE_AWAY, PROBE_AWAY_QUIET, PROBE_TOWARD_QUIET, Block

QUIET = (PROBE_TOWARD_QUIET, PROBE_AWAY_QUIET)  # G38.3 and G38.5 raise no alarm
AWAY = (PROBE_AWAY, PROBE_AWAY_QUIET)


def run(machine: Board, block: Block) -> Waiting:
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
