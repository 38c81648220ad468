# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual table at a parallel port: pins from registers, pulses from edges, relays, inputs, faults."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.wiring import Input, Signals
from CNCStepper.virtual.faults.plan import Fault, FaultPlan
from CNCStepper.virtual.motors.rotor import limits_of
from CNCStepper.virtual.parport.machine import Parport
from CNCStepper.virtual.parport.pins import pin_levels
from CNCStepper.virtual.server.twin_faults import FaultyTwin
from helpers.control.twin_bench import play

PINS = {"x_step": 2, "x_direction": 3, "y_step": 4, "y_direction": 5, "flood": 14, "output_0": -1}
X, X_BACK, Y, Y_BACK = 1, 2, 4, 8  # bits of the data register
IDLE = 0b1011 ^ 1  # control register: 1, 14, 17 are turned round; output_0 on pin 1 is active low
FIGURE_13 = ((13, "x"), (26, "x"), (39, "x"), (44, "y"))  # published: iterations of the first pulses of the arc
Writes = list[tuple[float, bytes]]


def machine(pins: dict[str, int] = PINS, steps_per_mm: float = 1.0, **signals: object) -> Machine:
    base = load_machine("thesis-table")
    axis = {name: one.model_copy(update={"steps_per_mm": steps_per_mm}) for name, one in base.axis.items()}
    wired = Signals(motors=("x", "y"), pins=pins, **signals)  # type: ignore[arg-type]
    return base.model_copy(update={"axis": axis, "signals": wired})


def write(at_s: float, data: int, control: int = IDLE) -> tuple[float, bytes]:
    return at_s, bytes((data, control))


def pulse(at_s: float, step: int, back: int = 0, width_s: float = 20e-6, setup_s: float = 20e-6) -> Writes:
    """Return the writes of a pulse whose directions are set before it."""
    return [write(at_s - setup_s, back), write(at_s, back | step), write(at_s + width_s, back)]


def test_registers_become_pins():
    levels = pin_levels(np.array([0x00, 0xFF, 0x01], np.uint8), np.array([0x00, 0x0F, 0x04], np.uint8))
    high = [{pin for pin in range(1, 26) if level >> pin & 1} for level in levels.tolist()]
    assert high[0] == {1, 14, 17}  # a 0 makes the turned ones high
    assert high[1] == {2, 3, 4, 5, 6, 7, 8, 9, 16}
    assert high[2] == {2, 1, 14, 16, 17}


def test_pulses_of_figure_13_move_by_a_resolution_each():
    twin = Parport(machine())
    writes = [write(0.0, 0)]
    for iteration, axis in FIGURE_13:
        step, back = (X, 0) if axis == "x" else (Y, Y_BACK)
        writes += pulse(iteration * 0.01, step, back)
    path = play(twin, writes)
    assert path[:, 0] == pytest.approx([0.13, 0.26, 0.39, 0.44])
    assert path[:, 1:].tolist() == [[1, 0, 0], [2, 0, 0], [3, 0, 0], [3, -1, 0]]
    assert not twin.lost


def test_both_axes_in_one_write_and_resolution_of_the_profile():
    twin = Parport(machine(steps_per_mm=40.0))
    play(twin, [write(0.0, 0), *pulse(0.01, X | Y, X_BACK), *pulse(0.02, X, X_BACK)])
    assert twin.places_mm == (-2 / 40, 1 / 40, 0.0)


def test_active_low_lines_and_reversed_motors():
    pins = {"x_step": -16, "x_direction": -17, "y_step": 4, "y_direction": 5}
    twin = Parport(machine(pins).model_copy(update={"signals": Signals(motors=("-x", "y"), pins=pins)}))
    rest = 0x4  # pins 16 and 17 high: 16 is plain, 17 turned
    assert pin_levels(np.array([0], np.uint8), np.array([rest], np.uint8))[0] >> 16 & 3 == 3
    play(twin, [write(0.0, 0, rest), write(0.01, 0, rest ^ 0x4), write(0.0101, 0, rest)])
    assert twin.places_mm[0] == -1.0  # forwards of a motor that is mounted the other way round
    play(twin, [write(2.0, 0, rest | 0x8), write(2.01, 0, 0x8), write(2.0101, 0, rest | 0x8)])
    assert twin.places_mm[0] == 0.0


def test_before_the_first_write_the_registers_are_0():
    twin = Parport(machine())
    play(twin, [write(0.01, X), write(0.02, 0)])
    assert twin.places_mm == (1.0, 0.0, 0.0)
    twin = Parport(machine({"x_step": -2, "x_direction": 3}))  # low at first, so that its pulse ends
    play(twin, [write(0.01, X), write(0.02, 0), write(0.03, X)])
    assert twin.places_mm == (1.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("writes", "reason"),
    [
        (pulse(0.01, X, width_s=9e-6), "the pulse is too short"),
        (pulse(0.01, X, X_BACK, setup_s=9e-6), "the direction changes too late"),
        ([write(0.01, X | X_BACK), write(0.02, 0)], "the direction changes too late"),
    ],
)
def test_pulses_that_the_drive_cannot_see_are_lost_and_counted(writes, reason):
    twin = Parport(machine(pulse_us=10, direction_setup_us=10))
    play(twin, [write(0.0, 0), *writes, *pulse(0.05, X)])
    assert dict(twin.lost) == {("x", reason): 1} and twin.places_mm[0] == 1.0
    assert [text for _, text in twin.take_notes()] == [f"motor x loses a pulse: {reason}"]


def test_pulses_too_close_are_lost():
    twin = Parport(machine())
    writes = [write(0.0, 0), write(0.01, X), write(0.01002, 0), write(0.010025, X), write(0.01005, 0)]
    play(twin, writes)
    assert dict(twin.lost) == {("x", "the pulses are too close"): 1} and twin.places_mm[0] == 1.0


def test_a_pulse_of_the_published_width_counts_while_it_lasts():
    twin = Parport(machine(pulse_us=1000))
    play(twin, [write(0.0, 0), write(0.01, X)], rest_s=0.05)
    assert twin.places_mm[0] == 1.0
    play(twin, [write(0.2, 0)])
    assert twin.places_mm[0] == 1.0 and not twin.lost


def test_a_batch_is_never_called_too_quick():
    """What the system hands over in one piece may have come with any times within the span."""
    twin = Parport(machine())
    play(twin, [write(0.0, 0)])
    data = b"".join(piece for n in range(50) for _, piece in pulse(float(n), X))
    twin.receive(data, 1.0, 1.02)
    twin.advance(1.02)
    twin.advance(2.0)
    (rows,) = twin.take_path()
    assert twin.places_mm[0] == 50.0 and not twin.lost
    assert (np.diff(rows[:, 0]) > 0).all() and rows[0, 0] >= 1.0 and rows[-1, 0] <= 1.02


def test_a_late_edge_in_a_span_is_certain_where_no_time_would_do():
    twin = Parport(machine(pulse_us=1000))
    play(twin, [write(0.0, 0)])
    twin.receive(bytes((X, IDLE)), 1.0, 1.0002)
    twin.receive(bytes((0, IDLE)), 1.0002, 1.0006)  # at most 0.6 ms of the millisecond
    twin.advance(2.0)
    assert dict(twin.lost) == {("x", "the pulse is too short"): 1}


def test_what_the_cable_delays_is_no_fault_and_a_turn_with_its_step_is():
    twin = Parport(machine(pulse_us=1000), carried_s=0.02)
    play(twin, [write(0.0, 0), *pulse(0.1, X), write(0.3, X | X_BACK), write(0.4, 0)])
    assert dict(twin.lost) == {("x", "the direction changes too late"): 1} and twin.places_mm[0] == 1.0


def test_a_torn_write_waits_for_its_second_byte():
    twin = Parport(machine())
    for n, byte in enumerate(b"".join(data for _, data in [write(0, 0), *pulse(0, X), *pulse(0, X)])):
        twin.receive(bytes((byte,)), n * 0.01, n * 0.01)
        twin.advance(n * 0.01)
    twin.advance(10.0)
    assert twin.places_mm[0] == 2.0
    twin.receive(b"\x01", 10.0, 10.0)
    twin.open()  # another client begins with a data register
    play(twin, [write(11.0, 0), *pulse(11.1, X)])
    assert twin.places_mm[0] == 3.0


def test_drives_that_are_off_do_not_turn():
    twin = Parport(machine({**PINS, "enable": 16}))
    on = IDLE | 0x4
    play(twin, [write(0.0, 0), write(0.1, X), write(0.2, 0), write(0.3, 0, on), write(0.4, X, on), write(0.5, 0, on)])
    assert twin.places_mm[0] == 1.0 and twin.lost["x", "the drives are off"] == 1


def test_relays_are_told_by_name_with_their_times():
    twin = Parport(machine())
    assert twin.relays == {"flood": False, "output_0": False}
    play(twin, [write(0.0, 0), write(0.25, 0, IDLE ^ 0x2), write(0.5, 0, IDLE ^ 0x3), write(1.0, 0)])
    assert twin.switched == [
        (0.25, "flood", True),
        (0.5, "output_0", True),
        (1.0, "flood", False),
        (1.0, "output_0", False),
    ]
    assert [text for _, text in twin.take_notes()] == ["flood on", "output_0 on", "flood off", "output_0 off"]


def test_inputs_are_sent_as_the_status_register_when_they_change():
    stop = Input(pin=13, port="/dev/parport0", act="stop", level="low")
    twin = Parport(machine().model_copy(update={"input": (stop,)}))
    twin.open()
    assert twin.take_output() == bytes((0x80 | 0x10,))  # pin 11 is turned round, pin 13 high while it is not pressed
    twin.press("13")
    twin.press("13")
    twin.press("11")
    assert twin.take_output() == bytes((0x80, 0x00)) and twin.pins() == "11, 13"
    twin.release("13")
    assert twin.take_output() == bytes((0x10,))
    for pin, bit in ((10, 6), (12, 5), (15, 3)):
        twin.press(str(pin))
        assert twin.take_output()[0] & 1 << bit
    with pytest.raises(MachineRefusal, match="no input"):
        twin.press("2")


def faulty(**fault: object) -> tuple[Parport, FaultyTwin]:
    twin = Parport(machine())
    return twin, FaultyTwin(twin, FaultPlan(fault=(Fault(**fault),)))  # type: ignore[arg-type]


def ten_pulses() -> Writes:
    return [write(0.0, 0), *(one for n in range(10) for one in pulse(0.1 + n * 0.1, X))]


@pytest.mark.parametrize(
    ("fault", "place"),
    [
        ({"kind": "dead_pin", "pin": 2, "at_s": 0.55}, (5.0, 0.0, 0.0)),
        ({"kind": "dead_pin", "pin": 4, "at_s": 0.55}, (10.0, 0.0, 0.0)),
        ({"kind": "swapped_pins", "pin": 2, "other_pin": 4, "at_s": 0.55}, (5.0, 5.0, 0.0)),
        ({"kind": "stall", "motor": "x", "at_s": 0.55, "for_s": 0.3}, (7.0, 0.0, 0.0)),
        ({"kind": "power", "at_s": 0.55, "for_s": 0.2}, (8.0, 0.0, 0.0)),
    ],
)
def test_faults_of_the_machine_lose_or_move_pulses(fault, place):
    twin, spoiled = faulty(**fault)
    play(spoiled, ten_pulses())
    assert twin.places_mm == place and spoiled.fired == {fault["kind"]: 1}


def test_random_paths_end_where_they_lead():
    for seed in range(10):
        random = Random(seed)
        twin, writes, want, level = Parport(machine()), [write(0.0, 0)], np.zeros(2, int), set[int]()
        for n in range(300):
            step, back = random.choice((X, Y, X | Y)), random.choice((0, X_BACK, Y_BACK, X_BACK | Y_BACK))
            level.add(step << 4 | back)
            writes += pulse(0.001 * (n + 1), step, back)
            want += [(step & X > 0) * (-1 if back & X_BACK else 1), (step & Y > 0) * (-1 if back & Y_BACK else 1)]
        assert len(level) == 12, seed  # each of the steps in each of the directions
        play(twin, writes)
        assert twin.places_mm[:2] == tuple(want) and not twin.lost, f"seed {seed}"


def ramped(twin: Parport, speed_up: float) -> float:
    """Drive 400 pulses with the profile's ramp, so many times as hard; return how many are missing."""
    axis = twin_machine().axes[0]
    acceleration, fastest = axis.acceleration_mm_s2 * axis.steps_per_mm, axis.max_rate_mm_min / 60 * axis.steps_per_mm
    count, way = 400, min(fastest**2 / 2 / acceleration, 200.0)
    x = np.arange(1, count + 1.0)
    up, top = np.sqrt(2 * np.minimum(x, way) / acceleration), np.sqrt(2 * acceleration * way)
    down = np.sqrt(2 * np.clip(x - (count - way), 0, way) / acceleration)
    at = up + np.clip(x - way, 0, count - 2 * way) / top
    full = top / acceleration
    at = np.where(x > count - way, 2 * full + (count - 2 * way) / top - np.sqrt(2 * (count - x) / acceleration), at)
    assert down.max() > 0 and (np.diff(at) > 0).all()
    play(twin, [write(0.0, 0), *(one for time_s in at for one in pulse(0.1 + time_s / speed_up, X))])
    return count - twin.places_mm[0] * axis.steps_per_mm


def twin_machine() -> Machine:
    return machine(steps_per_mm=40.0)


def test_real_motors_follow_the_profile_and_lose_steps_beyond_their_margin():
    limits = [limits_of(axis) for axis in twin_machine().axes[:2]]
    assert ramped(Parport(twin_machine(), limits), 1.0) == pytest.approx(0.0, abs=0.01)
    missing = ramped(Parport(twin_machine(), limits), 4.0)
    assert missing >= 4 and round(missing) % 4 == 0 and abs(missing - round(missing)) < 0.01
    assert ramped(Parport(twin_machine()), 4.0) == 0.0  # ideal ones follow everything
