# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines with limit switches: which runs have one, where it stands before its job, and faults while it homes.

HOMED     homed in the morning, the tool on the work zero; its port was opened without a reset
LOCKED    just switched on; the job lets it home itself first
"""

from __future__ import annotations

from random import Random

from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.faults.plan import IN, OUT, Fault, FaultPlan
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.settings import DEBOUNCE_MS, HOMING_FEED, HOMING_SEEK
from CNCStepper.virtual.grbl.states import State
from helpers.control.fault_cases import plan_of

NONE, HOMED, LOCKED = "", "homed", "locked"
SHARE = 0.25  # of the runs
QUICK = {HOMING_SEEK: 5000.0, HOMING_FEED: 300.0, DEBOUNCE_MS: 100.0}
ZERO_MM = (-60.0, -60.0, -20.0)  # of the work, from the switches
HOMED_S, OVER_S = 5.0, 8.0  # from power-up to the end of the homing, and until the tool is over the work, about
IN_HOMING = 0.5  # of the faults of a machine that homes first
OPENING_BYTES = {IN: 10, OUT: 300}  # up to the end of the homing, about
STEP_S = 0.01


def switches_of(seed: int) -> str:
    """Return what a run's machine is: without switches, homed, or locked."""
    random = Random(f"switches {seed}")
    return random.choice((HOMED, LOCKED)) if random.random() < SHARE else NONE


def board_of(switches: str) -> Grbl:
    """Return a machine whose tool stands on its work zero."""
    if switches == NONE:
        return Grbl(load_machine("table-a"))
    board = Grbl(load_machine("table-a"), homing=True)
    board.memory.settings.values |= QUICK
    board.memory.places[54] = list(ZERO_MM)
    board.axes.lost_steps = [round(mm / board.axes.step_mm(axis)) for axis, mm in enumerate(ZERO_MM)]
    board.take_output()
    if switches == HOMED:
        _know_place(board)
    board.reset()  # which takes the work zero over
    if switches == HOMED:
        board.take_output()
    return board


def _know_place(board: Grbl) -> None:
    """Let a board count from its switches, as it would after a homing and a way to the work zero."""
    for axis, place_mm in enumerate(ZERO_MM):
        board.axes.set_position(axis, place_mm)
    board.state = State.IDLE


def homed_board() -> Grbl:
    """Return a machine as its homing leaves it."""
    board = board_of(LOCKED)
    board.receive(b"$H\n")
    while b"ok" not in board.take_output():
        board.advance(STEP_S)
    return board


def plan_for(seed: int, switches: str) -> FaultPlan:
    """Return the faults of a run; of a machine that homes first each falls into its homing, or waits until after it."""
    plan = plan_of(seed)
    if switches != LOCKED:
        return plan
    random = Random(f"homing {seed}")
    return plan.model_copy(update={"fault": tuple(_moved(fault, random) for fault in plan.fault)})


def _moved(fault: Fault, random: Random) -> Fault:
    if fault.at_s is not None:
        at_s = random.uniform(0, HOMED_S) if random.random() < IN_HOMING else OVER_S + fault.at_s
        return fault.model_copy(update={"at_s": at_s})
    if random.random() < IN_HOMING:
        return fault.model_copy(update={"at_byte": random.randrange(OPENING_BYTES[fault.way])})
    return fault
