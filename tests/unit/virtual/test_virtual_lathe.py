# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual mini-lathe by the published records: line, buffer, manual and automatic mode, steps and their times."""

from __future__ import annotations

from itertools import pairwise
from random import Random

import numpy as np
import pytest

from CNCStepper.errors import MachineRefusal
from CNCStepper.virtual.faults.plan import Fault, FaultPlan
from CNCStepper.virtual.lathe.machine import Lathe, Mode
from CNCStepper.virtual.lathe.receiver import BYTE_S
from CNCStepper.virtual.lathe.records import Reader, Steps
from CNCStepper.virtual.lathe.stepping import PULL_OUT_TICKS, TICK_S, braking_ticks, feed_wait_ticks, line, rapid_ticks
from CNCStepper.virtual.server.twin_faults import FaultyTwin
from helpers.control.twin_bench import send

RAPIDS = b"N30 G00 X-10. # N40 Z-50. # N50 X5000 Z50. #?"
FEEDS = b"N30 G01X-10. F1. # N40 Z-50. # N50 X5000 Z50. F2500 #?"


def rapid_s(steps: int) -> float:
    """Return the time of a rapid by the published list, summed as a person would."""
    ticks = [101, 42, 32, 27, 24, 22, 20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4]
    return sum(ticks[min(n, steps - 1 - n, 22)] for n in range(steps)) * 135e-6


def automatic(**options: object) -> Lathe:
    twin = Lathe(**options)  # type: ignore[arg-type]
    send(twin, b"Y")
    return twin


def read(reader: Reader, text: str) -> list[Steps | None]:
    return [reader.read(record) for record in text.split("#")]


def test_the_published_rapids_end_where_they_lead_in_the_tables_time():
    twin = automatic()
    begin_s = twin.time_s + BYTE_S * len(RAPIDS)
    path = send(twin, RAPIDS)
    assert twin.places == [-800 + 40, 0] and twin.places_mm == (-9.5, 0.0)
    ends = begin_s + np.cumsum([rapid_s(800), rapid_s(4000), rapid_s(4000)])
    at = {tuple(row[1:]): row[0] for row in path}
    assert at[-10.0, 0.0] == pytest.approx(ends[0], abs=1e-6)
    assert at[-10.0, -50.0] == pytest.approx(ends[1], abs=1e-6)
    assert path[-1] == pytest.approx([ends[2], -9.5, 0.0], abs=1e-6)
    assert not twin.refused


def test_the_published_feeds_end_where_they_lead_in_the_right_time():
    twin = automatic()
    begin_s = twin.time_s + BYTE_S * len(FEEDS)
    path = send(twin, FEEDS)
    assert twin.places_mm == (-9.5, 0.0)
    ticks_1, ticks_quarter = round(1 / 80 / TICK_S), round(1 / (0.25 * 80) / TICK_S)
    assert (ticks_1, ticks_quarter) == (93, 370)  # 1 mm/s and 0.25 mm/s in ticks of 135 µs
    took_s = (800 + 4000) * 93 * TICK_S + 4000 * 370 * TICK_S
    assert path[-1, 0] == pytest.approx(begin_s + took_s, abs=1e-6)
    waits = np.diff(path[:, 0])
    assert set(np.round(waits / TICK_S, 3)) == {93.0, 370.0}  # no ramp


def test_the_longer_axis_steps_evenly_and_the_other_between():
    places = line(40, -4000)
    assert (np.abs(np.diff(places[:, 1])) == 1).all() and places[-1].tolist() == [40, -4000]
    assert np.abs(places[:, 0] - places[:, 1] * -0.01).max() <= 0.5
    assert line(0, 0).shape == (0, 2) and line(-3, 3).tolist() == [[-1, 1], [-2, 2], [-3, 3]]


def test_ramps_turn_back_where_there_is_no_room():
    assert rapid_ticks(1).tolist() == [101]
    assert rapid_ticks(5).tolist() == [101, 42, 32, 42, 101]
    long = rapid_ticks(100)
    assert long[:23].tolist() == PULL_OUT_TICKS.tolist() == long[:-24:-1].tolist() and set(long[23:-23]) == {4}
    assert braking_ticks(0).size == 0 and braking_ticks(2).tolist() == [42, 101] and len(braking_ticks(500)) == 23
    assert feed_wait_ticks(1000.0, 80.0) == 1


def test_numbers_units_and_modes_of_the_published_table():
    reader = Reader()
    moves = read(reader, "G00 X5000 #X-10.5#Z.25# G01 F2500 Z1. # X1.# F1. Z1.")
    assert moves[:3] == [Steps(40, 0, None), Steps(-840, 0, None), Steps(0, 20, None)]
    assert moves[3:] == [Steps(0, 80, 0.25, True), Steps(80, 0, 0.25), Steps(0, 80, 1.0)]
    assert read(Reader(), "G21 G00 X10.")[0] == Steps(400, 0, None)
    assert read(Reader(), "G71 G00 Z1.")[0] == Steps(0, 2032, None)
    assert read(Reader(g20="diameter"), "G20 G00 X10.")[0] == Steps(400, 0, None)
    assert read(Reader(g70="inch"), "G70 G00 Z1.")[0] == Steps(0, 2032, None)
    assert read(Reader(g20="diameter"), "G21 G00 X10.")[0] == Steps(800, 0, None)


def test_absolute_coordinates_keep_an_axis_that_is_absent():
    moves = read(Reader(), "G90 G00 X10. # Z-5. # G00 X10. Z0. # G91 G00 X-10.")
    assert moves == [Steps(800, 0, None), Steps(0, -400, None), Steps(0, 400, None), Steps(-800, 0, None)]


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("X10.", "no motion is in force"),
        ("G01 X10.", "needs its F"),
        ("G00 X1. # G90 # X1.", "no motion is in force"),
        ("G01 F1. X1. # G01 X1.", "needs its F"),
        ("G02 X1.", "no such code"),
        ("G00 Y1.", "not for here"),
        ("G00 X1. X2.", "not for here"),
        ("G00 x1.", "cannot be read"),
        ("G00 X", "cannot be read"),
        ("M30", "no such code"),
        ("G01 F0 X1.", "needs its F"),
    ],
)
def test_records_that_it_leaves_out(text, why):
    reader = Reader()
    with pytest.raises(MachineRefusal, match=why):
        read(reader, text)


def test_skipped_records_and_comments():
    assert read(Reader(), "G00 ; quick # / X99. # X1. ; out X2. # N5 # ")[0:5] == [
        None,
        None,
        Steps(80, 0, None),
        None,
        None,
    ]


def test_a_refused_record_is_left_out_and_the_rest_is_done():
    twin = automatic()
    send(twin, b"G00 X1. # Q2 # Z1. #?X1.#?")
    assert twin.places_mm == (1.0, 1.0)
    assert len(twin.refused) == 2 and "no motion" in twin.refused[1]  # a piece opens with its own G word
    assert any("it cannot be read" in text or "not for here" in text for _, text in twin.take_notes())


def test_nothing_moves_before_the_end_of_the_piece():
    twin = automatic()
    assert not len(send(twin, RAPIDS[:-1])) and twin.quiet
    assert len(send(twin, b"?"))


def test_bytes_take_the_time_of_the_line():
    twin = Lathe()
    twin.receive(b"A", 0.0, 0.0)
    twin.advance(1.0)
    (path,) = twin.take_path()
    assert path[0] == pytest.approx([11 / 9600 + 101 * TICK_S, -1 / 80, 0.0])
    assert twin.room == 64


def test_a_buffer_too_small_loses_bytes_and_says_so():
    twin = automatic(buffer_bytes=64)
    send(twin, b"G00 X10. #?" + b"Z-1.#" * 40 + b"?", limit_s=20.0)
    assert twin.buffer.lost > 0 and twin.places_mm[0] == 10.0
    assert any("the buffer of 64 bytes is full" in text for _, text in twin.take_notes())


def test_pieces_within_the_buffer_all_arrive_while_the_lathe_moves():
    twin = automatic()
    for _ in range(20):
        send(twin, b"G01 F20. Z-1. # X-1. #?")
    assert twin.places_mm == (-20.0, -20.0) and twin.buffer.lost == 0


def test_manual_rapid_speeds_up_by_the_table_and_stops_by_it():
    twin = Lathe()
    twin.receive(b"A", 0.0, 0.0)
    twin.advance(0.5)
    twin.receive(b"P", 0.5, 0.5)
    twin.advance(2.0)
    path = np.concatenate(twin.take_path())
    ticks = np.diff(path[:, 0], prepend=BYTE_S) / TICK_S
    assert np.round(ticks[:23]).tolist() == PULL_OUT_TICKS.tolist()
    assert np.round(ticks[-23:]).tolist() == PULL_OUT_TICKS[::-1].tolist()
    assert set(np.round(ticks[23:-23])) == {4.0} and twin.quiet
    assert (np.diff(path[:, 1]) < 0).all() and not path[:, 2].any()


@pytest.mark.parametrize(
    ("letter", "axis", "way"), [("A", 0, -1), ("B", 0, 1), ("C", 1, -1), ("D", 1, 1), ("E", 0, -1), ("F", 0, 1)]
)
def test_manual_letters_move_their_axis(letter, axis, way):
    twin = Lathe()
    twin.receive(letter.encode(), 0.0, 0.0)
    twin.advance(1.0)
    twin.receive(b"P", 1.0, 1.0)
    twin.advance(2.0)
    assert np.sign(twin.places[axis]) == way and twin.places[1 - axis] == 0 and not twin.moving


def test_manual_feed_goes_at_the_speed_that_was_set_and_stops_at_once():
    twin = Lathe()
    send(twin, b"I2.5?")
    begin_s = twin.time_s
    twin.receive(b"G", begin_s, begin_s)
    twin.advance(begin_s + 2.0)
    twin.receive(b"P", begin_s + 2.0, begin_s + 2.0)
    twin.advance(begin_s + 3.0)
    path = np.concatenate(twin.take_path())
    assert set(np.round(np.diff(path[:, 0]) / TICK_S)) == {37.0}  # 2.5 mm/s: 200 steps/s
    assert path[-1, 0] <= begin_s + 2.0 + BYTE_S and twin.places_mm[1] == pytest.approx(-5.0, abs=0.02)


def test_while_a_manual_move_runs_only_its_stop_is_taken():
    twin = Lathe()
    twin.receive(b"AY", 0.0, 0.0)
    twin.advance(0.5)
    assert twin.mode is Mode.MANUAL and twin.moving
    twin.receive(b"PY", 0.5, 0.5)  # the Y waits until the ramp has ended
    twin.advance(0.505)
    assert twin.mode is Mode.MANUAL and twin.moving
    twin.advance(1.0)
    assert twin.mode is Mode.AUTOMATIC and not twin.moving


def test_there_is_no_way_back_and_a_program_cannot_be_stopped():
    twin = automatic()
    send(twin, b"G00 X1. #?")
    send(twin, b"B")
    assert twin.places_mm == (1.0, 0.0) and twin.mode is Mode.AUTOMATIC
    twin = automatic()
    twin.receive(b"G00 Z-50. #?", twin.time_s, twin.time_s)
    twin.advance(twin.time_s + 1.0)
    twin.receive(b"P", twin.time_s, twin.time_s)
    send(twin, b"")
    assert twin.places_mm == (0.0, -50.0)


@pytest.mark.parametrize("last", [b"YM02 #?", b"Z"])
def test_after_its_end_it_takes_nothing(last):
    twin = Lathe()
    send(twin, last)
    assert twin.mode is Mode.ENDED
    send(twin, b"YG00 X1. #?A")
    assert twin.places == [0, 0]


def test_the_zero_of_a_program_is_where_the_tool_was_driven_by_hand():
    twin = Lathe()
    twin.receive(b"A", 0.0, 0.0)
    twin.advance(0.5)
    send(twin, b"PY")
    driven = twin.places_mm[0]
    assert driven < -1.0
    send(twin, b"G90 G00 X2. #?")
    assert twin.places_mm[0] == pytest.approx(driven + 2.0)


def test_threads_begin_at_the_encoders_index():
    angles = []
    for wait_s in (0.0, 0.013, 0.171):
        twin = automatic(thread_start=True, spindle_rpm=85.7)
        twin.advance(twin.time_s + wait_s)
        path = send(twin, b"G00 Z1. # G01 Z-5. F2. # Z-1. # G00 X1. # Z6. # G01 Z-5. F2. #?")
        first = [row[0] for before, row in pairwise(path) if before[2] == pytest.approx(1.0) and row[2] < 1.0]
        angles.append((first[0] - feed_wait_ticks(2.0, 80.0) * TICK_S) * 85.7 / 60.0 % 1.0)
    assert [min(angle, 1 - angle) for angle in angles] == pytest.approx([0.0, 0.0, 0.0], abs=1e-6)
    standing = automatic(thread_start=True)
    standing.receive(b"G01 F1. X1. #?", standing.time_s, standing.time_s)
    standing.advance(standing.time_s + 60.0)
    assert standing.places == [0, 0] and standing.moving


@pytest.mark.parametrize(
    ("fault", "verdict"),
    [
        ({"kind": "drop", "at_byte": 8}, lambda twin: twin.places_mm[0] == -1.0),  # the 0 of "-10."
        ({"kind": "corrupt", "at_byte": 4, "bits": 2}, lambda twin: twin.refused),
        ({"kind": "stall", "motor": "z", "at_s": 0.0, "for_s": 3.0}, lambda twin: twin.places_mm[1] > 1.0),
        ({"kind": "power", "at_s": 2.0}, lambda twin: twin.mode is Mode.MANUAL and not twin.moving),
        ({"kind": "delay", "at_byte": 3, "for_s": 4.0}, lambda twin: twin.time_s > 9.0),
    ],
)
def test_faults_on_the_way(fault, verdict):
    twin = Lathe()
    spoiled = FaultyTwin(twin, FaultPlan(fault=(Fault(**fault),)))
    send(spoiled, b"YG00 X-10. # Z-50. # Z50.#?")
    assert verdict(twin) and sum(spoiled.fired.values()) == 1


def test_random_programs_end_where_they_lead():
    for seed in range(10):
        random = Random(seed)
        twin, want, kinds = automatic(), np.zeros(2), set[str]()
        for _ in range(30):
            kind = random.choice(("G00", "G01"))
            x, z = (random.randrange(-400, 400) for _ in range(2))
            f = " F20." if kind == "G01" else ""
            kinds.add(kind)
            send(twin, f"{kind} X{x * 125} Z{z * 125}{f} #?".encode())  # steps of 1/80 mm in 1/10000
            want += (x, z)
        assert kinds == {"G00", "G01"} and (want != 0).any()
        assert twin.places == want.tolist(), f"seed {seed}"
        assert not twin.refused and not twin.buffer.lost
