# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chunks that are read as they are needed: the same pulses, and few chunks at once."""

from itertools import chain
from weakref import ref

import numpy as np
import pytest

from CNCStepper import toolpath
from CNCStepper.gcode.interpreter.program_file import FileReading, interpret_file
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.backlash_moves import motor_chunks, motor_moves, way_duration_s
from CNCStepper.motion.planner.chunk_window import ChunkWindow
from CNCStepper.motion.planner.plan import duration_s
from CNCStepper.motion.signals.pulse_stream import pulse_stream
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath

MACHINE = load_machine("table-a")


def chunks_of(count):
    table = TableBuilder(Start.at_zero())
    for k in range(count):
        table.feed((k, 0, 0), 100)
        yield from table.take()


def test_a_window_reads_one_ahead_and_keeps_one_behind():
    taken = []
    window = ChunkWindow(chunks_of(5), lambda chunk: taken.append(chunk.first))
    assert len(window) == 1
    for number in range(5):
        assert window[number].first == number
        assert len(window) == min(number + 2, 5) == len(taken)
    assert window[3].first == 3
    with pytest.raises(IndexError):
        window[2]
    with pytest.raises(IndexError):
        window[5]


def test_an_empty_table_has_no_chunk():
    assert len(ChunkWindow([])) == 0


def program(tmp_path, lines=600):
    rng = np.random.default_rng(5)
    text = ["G21 G90"]
    for k, (x, y) in enumerate(rng.uniform(0, 3, (lines, 2))):
        text += [f"M3 S{1000 + k}", "G4 P0.2"] * (k % 97 == 5) + [f"G1 X{x:.3f} Y{y:.3f} F{500 + 10 * (k % 9)}"]
        text += ["M8" if k % 2 else "M9"] * (k % 41 == 0) + ["(note)"] * (k % 50 == 0)
    path = tmp_path / "longo ção.nc"
    path.write_text("\n".join([*text, "G4 P1", "M5", "M2", ""]), "utf-8")
    return path


def everything(stream):
    """Return all pulses, and the switches with the number of the pulse that they come before."""
    rows, switches, count = [], [], 0
    for chunk in stream:
        rows.append(np.column_stack([chunk.ticks, chunk.step, chunk.back]))
        switches += [switch._replace(row=switch.row + count) for switch in chunk.switches]
        count += len(chunk)
    return np.concatenate(rows), switches


@pytest.mark.slow
def test_a_program_that_is_read_meanwhile_gives_the_pulses_of_the_whole_table(tmp_path, monkeypatch):
    path = program(tmp_path)
    whole = FileReading(path, Start.at_zero())
    path_table = Toolpath(whole.interpreter.table.start, list(whole.chunks()), whole.interpreter.table.states)
    path_table.events = whole.interpreter.table.events
    rows, switches = everything(pulse_stream(path_table, MACHINE))
    monkeypatch.setattr(toolpath, "CHUNK_ROWS", 16)
    monkeypatch.setattr("CNCStepper.gcode.interpreter.program_file.PIECE", 300)
    reading = FileReading(path, Start.at_zero())
    table = reading.interpreter.table
    chunks = []
    empty = Toolpath(table.start, [], table.states, table.events)
    again, switched = everything(pulse_stream(empty, MACHINE, (chunks.append(1) or c for c in reading.chunks())))
    assert len(chunks) > 30
    np.testing.assert_array_equal(again, rows)
    assert switched == switches and len(switches) > 20


def test_motors_with_play_are_led_while_the_program_is_read(tmp_path, monkeypatch):
    file = program(tmp_path)
    play = Backlash((0.05, 0.1, 0.0), (-1, 1, -1), tuple(axis.steps_per_mm for axis in MACHINE.axes))
    rows, switches = everything(pulse_stream(motor_moves(interpret_file(file, Start.at_zero()), play), MACHINE))
    monkeypatch.setattr(toolpath, "CHUNK_ROWS", 16)
    monkeypatch.setattr("CNCStepper.gcode.interpreter.program_file.PIECE", 300)
    reading, taken = FileReading(file, Start.at_zero()), []
    table = reading.interpreter.table
    path = Toolpath(table.start, [], table.states, table.events)
    motors, chunks = motor_chunks(path, (taken.append(1) or chunk for chunk in reading.chunks()), play)
    first = next(chunks)
    assert len(taken) == 1 and len(motors.events) < 9
    again, switched = everything(pulse_stream(motors, MACHINE, chain([first], chunks)))
    assert len(taken) > 30
    np.testing.assert_array_equal(again, rows)
    assert switched == switches and len(switches) > 20


@pytest.mark.parametrize("play", [None, Backlash((0.05, 0.1, 0.0), (-1, 1, -1), (80.0, 80.0, 400.0))])
def test_a_way_is_timed_while_it_is_read_and_few_of_its_chunks_are_kept(tmp_path, monkeypatch, play):
    file = program(tmp_path)
    path = interpret_file(file, Start.at_zero())
    whole_s = duration_s(motor_moves(path, play) if play else path, MACHINE)
    monkeypatch.setattr(toolpath, "CHUNK_ROWS", 16)
    monkeypatch.setattr("CNCStepper.gcode.interpreter.program_file.PIECE", 300)
    reading, taken, most = FileReading(file, Start.at_zero()), [], 0

    def watched():
        nonlocal most
        for chunk in reading.chunks():
            taken.append(ref(chunk))
            most = max(most, sum(one() is not None for one in taken))
            yield chunk

    table = reading.interpreter.table
    empty = Toolpath(table.start, [], table.states, table.events)
    assert way_duration_s(empty, watched(), MACHINE, play) == whole_s
    assert len(taken) > 30 and most <= 6
