# SPDX-License-Identifier: LGPL-2.1-or-later
"""Board bytes: the published example, null pulses, places kept, every step arrives."""

import numpy as np
import pytest

from CNCStepper.errors import MachineRefusal
from CNCStepper.motion.signals.port_bytes import Board, read_board
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream
from CNCStepper.motion.signals.step_letters import read_letters


def letters(text, axes=1):
    return PulseStream(read_letters([text]), axes, None)


@pytest.mark.slow
def test_the_published_six_pulses():
    made = b"".join(Board("x").bytes_of(letters(b"A A A A D D")))
    assert made.hex(" ").upper() == "0A 10 09 10 05 10 06 10 05 10 09"


@pytest.mark.parametrize(("motors", "wanted"), [("xyz", "0A 30 09"), ("xyzy", "0A 10 09"), (("z", "-x"), "15 20 19")])
def test_the_null_pulse_selects_a_motor_that_is_not_there_where_one_is_free(motors, wanted):
    made = b"".join(Board(motors).bytes_of(letters(b"AA")))
    assert made.hex(" ").upper() == wanted


@pytest.mark.parametrize(("text", "wanted"), [(b"AAAADD", "0A 10 09 10 05 10 06 10 05 10 09"), (b"BB", "1A 20 19")])
def test_a_null_motor_of_the_profile_is_selected_unless_it_is_so_already(text, wanted):
    made = b"".join(Board("xyz", null_motor=1).bytes_of(letters(text, 3)))
    assert made.hex(" ").upper() == wanted


def test_no_null_pulse_where_the_motor_changes_and_none_after_a_null():
    assert b"".join(Board().bytes_of(letters(b"ABACGG", 3))).hex(" ").upper() == "0A 1A 09 2A 05 19 06 15"


def test_two_motors_of_an_axis_need_no_null_pulse():
    made = b"".join(Board(("x", "-x")).bytes_of(letters(b"AAD")))
    assert made.hex(" ").upper() == "0A 15 09 19 0A 15"


def test_places_and_selection_are_kept_from_stream_to_stream():
    text, parts = b"AAABBDDGJJSA", [b"AAA", b"B", b"BDDG", b"JJSA"]
    board, other = Board(), Board()
    whole = b"".join(board.bytes_of(letters(text, 3)))
    assert whole == b"".join(piece for part in parts for piece in other.bytes_of(letters(part, 3)))


@pytest.mark.parametrize("seed", range(10))
def test_the_board_makes_every_step_of_a_stream(seed):
    rng = np.random.default_rng(seed)
    print("seed", seed)
    step = rng.integers(1, 8, 500).astype(np.uint8)
    back = (step & rng.integers(0, 8, 500)).astype(np.uint8)
    data = b"".join(Board().bytes_of(PulseStream([PulseChunk(np.arange(500), step, back)], 3, None)))
    moves = read_board(data)
    wanted = [
        [(s >> n & 1) - 2 * (b >> n & 1) for n in range(3)] for s, b in zip(step.tolist(), back.tolist(), strict=True)
    ]
    for axis in range(3):
        made = moves[moves[:, axis] != 0, axis]
        assert made.tolist() == [row[axis] for row in wanted if row[axis]]
    motors = np.frombuffer(data, np.uint8) >> 4
    assert (np.diff(motors.astype(int)) != 0).all()


def test_a_second_byte_for_the_same_motor_without_a_null_moves_nothing():
    assert read_board(bytes.fromhex("0A09")).tolist() == [[1, 0, 0]]
    with pytest.raises(MachineRefusal, match="board-sequence"):
        read_board(bytes.fromhex("0A1005"))


def test_coils_of_a_motor_that_is_not_there_are_refused():
    assert read_board(bytes.fromhex("0A3009")).tolist() == [[1, 0, 0], [1, 0, 0]]  # a null pulse has no coils
    with pytest.raises(MachineRefusal, match=r"no such motor.*byte 1: 3A"):
        read_board(bytes.fromhex("0A3A"))


def test_a_board_has_four_motors():
    with pytest.raises(MachineRefusal, match="board-motors"):
        Board(("x", "y", "z", "x", "y"))
