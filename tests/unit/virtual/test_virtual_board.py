# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual USB board by the published bytes: its FIFO, its clock edges, its coils."""

from __future__ import annotations

from itertools import pairwise
from random import Random

import pytest

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.wiring import Signals
from CNCStepper.virtual.board.coil_motor import CoilMotor, field_of
from CNCStepper.virtual.board.latches import FIFO_BYTES
from CNCStepper.virtual.board.machine import Board
from CNCStepper.virtual.faults.plan import Fault, FaultPlan
from CNCStepper.virtual.motors.rotor import limits_of
from CNCStepper.virtual.server.twin_faults import FaultyTwin
from helpers.control.twin_bench import play

FORWARDS = (0x0A, 0x09, 0x05, 0x06)
PUBLISHED = bytes.fromhex("0A 10 09 10 05 10 06 10 05 10 09")  # A A A A D D, a null between each two


def machine(*motors: str) -> Machine:
    return load_machine("table-a").model_copy(update={"signals": Signals(motors=motors or ("x", "y", "z"))})


def board(*motors: str, limits: tuple = ()) -> Board:
    return Board(machine(*motors), limits)


def steps(twin: Board) -> list[float]:
    return [motor.steps for motor in twin.motors]


def every(interval_s: float, data: bytes, begin_s: float = 0.0) -> list[tuple[float, bytes]]:
    return [(begin_s + interval_s * (n + 1), data[n : n + 1]) for n in range(len(data))]


def test_the_published_letters_go_four_forwards_and_two_back():
    twin = board()
    path = play(twin, every(0.001, PUBLISHED))
    per_mm = machine().axes[0].steps_per_mm
    assert [round(row * per_mm) for row in path[:, 1]] == [1, 2, 3, 4, 3, 2]
    assert steps(twin) == [2.0, 0.0, 0.0]
    assert path[:, 0] == pytest.approx([0.001, 0.003, 0.005, 0.007, 0.009, 0.011])
    assert not path[:, 2:].any()


def test_without_null_pulses_nothing_moves_but_the_first():
    twin = board()
    play(twin, every(0.001, bytes.fromhex("0A 09 05 06")))
    assert steps(twin)[0] == 1.0 and twin.latches.unclocked == 3
    assert sum("selected already" in text for _, text in twin.take_notes()) == 3


def test_motors_take_turns_without_null_pulses():
    twin = board()
    play(twin, every(0.001, bytes.fromhex("0A 1A 2A 09 19 29 05 15 26")))
    assert steps(twin) == [3.0, 3.0, 2.0]  # 29 then 26 lies two places on: the field pulls neither way
    assert any("pulls neither way" in text for _, text in twin.take_notes())


def test_a_null_pulse_drops_the_coils_of_the_motor_it_selects():
    twin = board()
    play(twin, every(0.001, bytes.fromhex("1A 0A 10")))
    assert twin.latches.coils[:2] == [0x0A, 0x00]
    assert steps(twin)[:2] == [1.0, 1.0]  # it stays where it was, without current


@pytest.mark.parametrize(
    ("words", "moved"),
    [
        ((0x0A, 0x05), 1.0),  # two places on: nothing
        ((0x0A, 0x05, 0x06), 0.0),  # and the next word pulls from where the rotor is: one back
        ((0x0A, 0x06), 0.0),  # three places on is one back
        ((0x0A, 0x00), 1.0),  # no coils
        ((0x0A, 0x0F), 1.0),  # both coils of both phases: no field
        ((0x0A, 0x08, 0x09), 2.0),  # one phase between two: half steps
        ((0x0A, 0x08), 1.5),
        ((0x0C, 0x06, 0x03, 0x09), None),  # the other wiring's order: not four steps
    ],
)
def test_wrong_orders_move_nothing_or_the_other_way(words, moved):
    motor = CoilMotor()
    for n, word in enumerate(words):
        motor.set_coils(float(n), word)
    assert motor.steps == moved if moved is not None else motor.steps != 4.0


def test_the_fields_of_the_published_sequence_follow_each_other():
    assert [field_of(word) for word in FORWARDS] == [0.0, 1.0, 2.0, 3.0]
    assert field_of(0x0C) is None and field_of(0x00) is None  # L1 against L2


def test_motors_turn_the_axes_of_the_profile():
    twin = board("y", "-x", "x")
    assert twin.places_mm == (0.0, 0.0, 0.0)
    play(twin, every(0.001, bytes.fromhex("0A 1A")))
    per_mm = machine().axes[0].steps_per_mm
    assert twin.places_mm == pytest.approx((-1 / per_mm, 1 / machine().axes[1].steps_per_mm, 0.0))
    with pytest.raises(MachineRefusal, match="no such motors"):
        board("x", "y", "z", "x", "y")


def test_random_pulses_end_where_they_lead():
    for seed in range(20):
        random = Random(seed)
        twin, data, last = board(), bytearray(), -1
        places, want = [-1, -1, -1], [0, 0, 0]
        for _ in range(200):
            motor, way = random.randrange(3), random.choice((1, -1))
            if motor == last:
                data.append(0x30)  # no motor there
            places[motor] += way
            want[motor] += way
            data.append(motor << 4 | FORWARDS[places[motor] % 4])
            last = motor
        assert 0x30 in data and any(a >> 4 != b >> 4 and 0x30 not in (a, b) for a, b in pairwise(data)), seed
        play(twin, every(0.001, bytes(data)))
        assert steps(twin) == want, f"seed {seed}"


def test_fifo_fills_while_the_supply_is_off_and_empties_after():
    twin = board()
    twin.inject(Fault(kind="power", at_s=0.0, for_s=0.5))
    data = (PUBLISHED * 40)[:FIFO_BYTES]
    twin.receive(data, 0.0, 0.0)
    twin.advance(0.4)
    assert twin.room == 0 and steps(twin)[0] == 0.0
    twin.advance(0.6)
    assert twin.room == FIFO_BYTES and twin.received == FIFO_BYTES
    assert twin.take_path()[0][0, 0] == pytest.approx(0.5)


def test_a_stalled_motor_loses_its_pulses():
    plan = FaultPlan(fault=(Fault(kind="stall", motor="x", at_s=0.0, for_s=0.0045),))
    twin = board()
    play(FaultyTwin(twin, plan), every(0.001, PUBLISHED))
    assert steps(twin)[0] == -2.0  # 0A, 09 and 05 are lost, 06 holds it where it began: then two back


def test_a_dropped_byte_costs_a_step():
    plan = FaultPlan(fault=(Fault(kind="drop", at_byte=2),))
    twin = board()
    faulty = FaultyTwin(twin, plan)
    play(faulty, every(0.001, PUBLISHED))
    assert faulty.fired == {"drop": 1} and steps(twin)[0] != 2.0


def test_a_real_motor_follows_a_ramp_and_falls_behind_without_one():
    limits = limits_of(machine().axes[0])
    data = b"".join(bytes((FORWARDS[n % 4], 0x10)) for n in range(400))
    slow, quick = (board(limits=(limits, None, None)) for _ in range(2))
    play(slow, every(0.5 / (0.3 * limits.start_stop_pulses_s), data))
    play(quick, every(0.5 / (8.0 * limits.start_stop_pulses_s), data))
    assert round(steps(slow)[0]) == 400
    assert round(steps(quick)[0]) < 390 and round(steps(quick)[0]) % 4 == 0  # it lost whole turns of the field
