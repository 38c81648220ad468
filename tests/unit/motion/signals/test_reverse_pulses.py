# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way back: every pulse again in the opposite order and direction, from any point, to the pulse."""

import io

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner import plan
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.signals import reverse_pulses
from CNCStepper.motion.signals.port_bytes import Board, read_board
from CNCStepper.motion.signals.pulse_stream import PulseChunk, moved_steps, pulse_stream
from CNCStepper.motion.signals.reverse_pulses import ReversePulses, turned_back
from CNCStepper.motion.signals.step_letters import byte_after, letters_back, letters_of, read_letters, steps_to
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, TableBuilder

LIMITS = Limits.of(load_machine("table-a"))


def random_path(seed, moves=40):
    rng = np.random.default_rng(seed)
    print("seed", seed)
    table = TableBuilder(Start(position_mm=(1.0, -2.0, 0.5)))
    for number, end in enumerate(np.cumsum(rng.normal(0, 2.0, (moves, 3)) * (1, 1, 0.1), axis=0)):
        table.feed(end, float(rng.choice([200.0, 3000.0])))
        if number == moves // 2:
            table.event("dwell", 0.3)
            table.arc(ARC_CCW, (*(end[:2]), end[2]), (end[0] + 2, end[1], 0), 900)
    return table.toolpath()


def columns(chunks):
    """Return ticks, step and back of all chunks."""
    kept = [(c.ticks.copy(), c.step.copy(), c.back.copy()) for c in chunks]
    return tuple(np.concatenate(column) for column in zip(*kept, strict=True)) if kept else (np.empty(0),) * 3


@pytest.mark.parametrize("seed", range(5))
def test_from_any_point_the_pulses_lead_back_to_the_begin(seed, monkeypatch):
    monkeypatch.setattr(plan, "SEGMENT_ROWS", 100)
    monkeypatch.setattr(reverse_pulses, "SEGMENTS_AT_ONCE", 7)
    path = random_path(seed)
    way = ReversePulses(path, LIMITS)
    ticks, step, back = columns(pulse_stream(path, LIMITS))
    begin = np.rint(np.array(path.start.position_mm) * LIMITS.steps_per_mm).astype(int)
    rng = np.random.default_rng(seed)
    for tick in [None, 0, int(ticks[-1]) + 5, int(ticks[17]), *rng.integers(0, ticks[-1], 5).tolist()]:
        stream = way.stream(tick)
        count = len(ticks) if tick is None else int(np.searchsorted(ticks, tick, side="right"))
        ahead = PulseChunk(ticks[:count], step[:count], back[:count])
        assert stream.begin_steps == tuple(begin + moved_steps(ahead, 3))
        chunks = [PulseChunk(*columns([chunk])) for chunk in stream]
        returned = stream.begin_steps + sum((moved_steps(chunk, 3) for chunk in chunks), np.zeros(3, int))
        assert returned.tolist() == begin.tolist()
        if count:
            back_ticks, back_step, back_back = columns(chunks)
            np.testing.assert_array_equal(np.diff(back_ticks), np.diff(ticks[:count])[::-1])
            np.testing.assert_array_equal(back_step, step[:count][::-1])
            np.testing.assert_array_equal(back_back, (step & ~back)[:count][::-1])
            assert tick is None or back_ticks[0] == tick - ticks[count - 1] >= 0


def test_back_and_back_again_is_the_way_itself():
    rng = np.random.default_rng(2)
    step = rng.integers(1, 8, 99).astype(np.uint8)
    chunk = PulseChunk(np.cumsum(rng.integers(1, 9, 99)), step, step & rng.integers(0, 8, 99).astype(np.uint8))
    end = int(chunk.ticks[-1])
    again = turned_back(turned_back(chunk, end), end)
    for one, other in zip(columns([chunk]), columns([again]), strict=True):
        np.testing.assert_array_equal(one, other)


def test_a_table_without_moves_has_no_way_back():
    stream = ReversePulses(TableBuilder(Start.at_zero()).toolpath(), LIMITS).stream()
    assert list(stream) == [] and stream.begin_steps == (0, 0, 0)


@pytest.mark.parametrize("block", [3, 64, 65_536])
def test_a_file_of_letters_is_read_backwards_from_any_pulse(block):
    path = random_path(9, 4)
    stream = pulse_stream(path, LIMITS)
    text = b"".join(letters_of(stream))
    file = io.BytesIO(b"s " + text[:200] + b"\n f" + text[200:400])
    letters = [letter for letter in file.getvalue().decode() if letter.isupper()]
    for pulses in (0, 1, 80, 199, 250, len(letters), len(letters) + 9):
        end = byte_after(file, pulses, block)
        ahead = list(read_letters([file.getvalue()[:end]]))
        assert steps_to(file, end, block) == tuple(sum((moved_steps(chunk, 3) for chunk in ahead), np.zeros(3, int)))
        assert sum(map(len, ahead)) == min(pulses, len(letters))
        back = list(read_letters(letters_back(file, end, block)))
        total = sum((moved_steps(chunk, 3) for chunk in [*ahead, *back]), np.zeros(3, int))
        assert total.tolist() == [0, 0, 0] and sum(map(len, back)) == sum(map(len, ahead))


def test_letters_back_are_the_opposite_letters_in_the_opposite_order():
    file = io.BytesIO(b"A G M\nZ")
    assert b"".join(letters_back(file, 7)) == b"WNJD"


def test_the_motors_of_a_board_return_to_their_places():
    path = random_path(4, 3)
    board = Board()
    there = b"".join(board.bytes_of(pulse_stream(path, LIMITS)))
    back = b"".join(board.bytes_of(ReversePulses(path, LIMITS).stream()))
    moves = read_board(there + back)
    assert moves.sum(axis=0).tolist() == [0, 0, 0] and len(moves) > 100


def test_a_stream_holds_less_than_its_pulses(monkeypatch):
    monkeypatch.setattr(plan, "SEGMENT_ROWS", 50)
    monkeypatch.setattr(reverse_pulses, "SEGMENTS_AT_ONCE", 5)
    path = random_path(6)
    assert max(len(chunk) for chunk in ReversePulses(path, LIMITS).stream()) * 10 < sum(
        len(chunk) for chunk in pulse_stream(path, LIMITS)
    )


@pytest.mark.parametrize("block", [1, 3, 100])
def test_a_byte_that_is_no_letter_is_told_with_its_line_on_the_way_back_too(block):
    file = io.BytesIO(b"AAD\nA@A\nAA\n")
    with pytest.raises(ProgramError, match=r"p\.txt:2: .*'@'"):
        steps_to(file, 11, block, "p.txt")
    with pytest.raises(ProgramError, match=r"p\.txt:2: .*'@'"):
        list(letters_back(file, 11, block, "p.txt"))
