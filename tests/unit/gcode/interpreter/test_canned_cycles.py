# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canned cycles: read as LinuxCNC reads them, written as blocks or as moves, and the same either way."""

from __future__ import annotations

import os
from pathlib import Path
from random import Random

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls, motion_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE, Span, Toolpath
from helpers.gcode.rs274_runs import rs274_calls

SEEDS = range(1, 1 + int(os.environ.get("CNCSTEPPER_CASES", "25")))
HERE = Start.with_work_zero((0.0, 0.0, 0.0))
OWN = {"G81": "", "G82": " P0.25", "G83": " Q{:.3f}", "G73": " Q{:.3f}"}


def random_program(seed: int, units: str = "G21") -> str:
    """Return runs of all cycles with words that stick, both heights, repeats, and moves between the runs."""
    random = Random(seed)
    lines = [f"{units} G90", "G0 X0 Y0 Z10", f"F{random.randint(50, 400)}"]
    for _ in range(random.randint(2, 6)):
        name = random.choice(list(OWN))
        z, r = random.uniform(-9, -1), random.uniform(-0.5, 12)
        own = OWN[name].format(random.choice([0.1, 0.7, 1.0, 2.0, 20.0]))
        lines.append(f"{random.choice(['G98', 'G99'])} {name} X{random.uniform(-50, 50):.3f} Z{z:.3f} R{r:.3f}{own}")
        lines += [_more(random, name) for _ in range(random.randint(0, 5))]
        lines.append(random.choice(["G80", "G0 Z9.5", "G1 X1 Y2 Z8", "G98"]))
    return "\n".join([*lines, "G80", "M2", ""])


def _more(random: Random, name: str) -> str:
    """Return a block that goes on with the run."""
    words = [f"{axis}{random.uniform(-50, 50):.3f}" for axis in "XY" if random.random() < 0.7] or ["X3"]
    if random.random() < 0.2:
        words.append(f"Z{random.uniform(-9, -1):.3f}")
    if random.random() < 0.2:
        words.append(f"R{random.uniform(0, 12):.3f}")
    if random.random() < 0.15:
        words.append(f"L{random.randint(1, 3)}")
    if random.random() < 0.15:
        words.append(random.choice(["G98", "G99"]))
    if random.random() < 0.15 and name in ("G83", "G73"):
        words.append("Q0.9")
    return " ".join(words)


def rs274_path(text: str, folder: Path) -> list[str]:
    calls, accepted = rs274_calls(text, folder)
    assert accepted
    return motion_calls(calls)


def rs274_way(text: str, folder: Path) -> str:
    """Return the straight moves that LinuxCNC makes of a text from its third on, without those that go nowhere."""
    moves = [call for call in rs274_path(text, folder) if call.startswith("STRAIGHT")]
    return "\n".join([call for call, before in zip(moves[2:], moves[1:], strict=False) if call != before])


def cycles(path: Toolpath) -> list[Span]:
    return [span for span in path.spans if span.kind == "cycle"]


def same_rows(one: Toolpath, other: Toolpath) -> bool:
    a, b = one.table(), other.table()
    if len(a) != len(b) or not np.array_equal(a.kind, b.kind) or not np.allclose(a.feed, b.feed):
        return False
    return np.allclose(a.end, b.end, atol=1e-9, equal_nan=True)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_program_moves_as_linuxcnc_moves(seed, tmp_path):
    text = random_program(seed, ["G21", "G20"][seed % 2])
    ours = [call.rstrip() for call in motion_calls(list(canonical_calls(text)))]
    assert [call.replace("-0.0000", "0.0000") for call in ours] == [
        call.replace("-0.0000", "0.0000") for call in rs274_path(text, tmp_path)
    ]


@pytest.mark.parametrize("seed", SEEDS)
def test_read_write_read_gives_the_same_table_and_holes(seed):
    units = ["mm", "inch"][seed % 2]
    path = interpret(random_program(seed, {"mm": "G21", "inch": "G20"}[units]), HERE, "linuxcnc")
    text = write(path, "linuxcnc", WriteOptions(units=units))
    read = interpret(text, HERE, "linuxcnc")
    again = write(read, "linuxcnc", WriteOptions(units=units))
    assert again == text
    assert len(cycles(path)) >= len(cycles(read)) >= 0.8 * len(cycles(path)) > 1  # few need their run's first height
    second = interpret(again, HERE, "linuxcnc")
    assert same_rows(read, second) and read.spans == second.spans and read.events == second.events


@pytest.mark.parametrize("seed", SEEDS)
def test_blocks_and_moves_are_the_same_rows(seed):
    path = interpret(random_program(seed), HERE, "linuxcnc")
    blocks = interpret(write(path, "linuxcnc"), HERE, "linuxcnc")
    moves = interpret(write(path, "grbl"), HERE, "grbl")
    assert "G8" in write(path, "linuxcnc").replace("G80", "") or "G73" in write(path, "linuxcnc")
    assert not cycles(moves)
    assert same_rows(blocks, moves)
    assert [(e.index, e.value) for e in blocks.events if e.kind == "dwell"] == [
        (e.index, e.value) for e in moves.events if e.kind == "dwell"
    ]


@pytest.mark.parametrize("words", ["Z-3 R2 Q0.05", "Z-1 R2 Q0.05", "Z0.1 R1 Q0.3", "Z-4 R2 Q0.6"])
@pytest.mark.parametrize("name", ["G83", "G73"])
def test_pecks_that_end_at_the_floor_are_summed_as_linuxcnc_sums_them(name, words, tmp_path):
    text = f"G21 G90\nG0 X0 Y0 Z5\nG99 {name} X1 Y1 {words} F100\nG80\nM2\n"
    ours = [call.rstrip() for call in motion_calls(list(canonical_calls(text)))]
    assert ours == rs274_path(text, tmp_path)


@pytest.mark.parametrize("repeats", ["L2", ""])
def test_a_retract_plane_below_the_floor_is_refused_before_anything_is_counted(repeats):
    with pytest.raises(ProgramError) as caught:
        interpret(f"G21 G0 Z5\nG99 G83 X1 Y1 Z-8 R-10 Q2 {repeats} F100\n", HERE, "linuxcnc")
    assert caught.value.code == "retract-low" and caught.value.place.line == 2


def test_a_run_names_its_words_once():
    text = "G21 G0 Z10\nG98 G83 X1 Y2 Z-5 R2 Q2 F100\nX3\nX3 Y4\nZ-6 X9\nG99 X1\nM2\n"
    written = write(interpret(text, Start.at_zero(), "linuxcnc"), "linuxcnc").splitlines()
    first = written.index("G98 G83 X1.000 Y2.000 Z-5.000 R2.000 Q2.000 F100")
    assert written[first + 1 : first + 6] == ["X3.000", "Y4.000", "X9.000 Z-6.000", "G99 X1.000", "G80"]


def test_a_hole_that_the_words_do_not_mean_is_written_row_by_row():
    path = interpret("G21 G0 Z10\nG98 G83 X1 Y2 Z-5 R2 Q2 F100\nX3\nM2\n", Start.at_zero(), "linuxcnc")
    row = next(k for k, kind in enumerate(path.table().kind) if kind == LINE)
    path.chunks[0].end[row, 2] += 0.5  # somebody pecks less deep
    written = write(path, "linuxcnc").splitlines()
    assert "G1 Z0.500 F100" in written
    assert "G98 G83 X3.000 Y2.000 Z-5.000 R2.000 Q2.000" in " ".join(written)


def test_a_pause_ends_the_run():
    path = interpret("G21 G0 Z10\nG98 G81 X1 Y2 Z-5 R2 F100\nM0\nX3\nM2\n", Start.at_zero(), "linuxcnc")
    written = write(path, "linuxcnc").splitlines()
    pause = written.index("M0")
    assert written[pause - 1] == "G80" and written[pause + 1].startswith("G98 G81 X3.000")


def test_a_run_goes_on_over_lines_that_move_nothing(tmp_path):
    text = "G21 G90\nG0 X0 Y0 Z9.5\nG98 G83 X1 Y2 Z-8 R6 Q20 F100\nG80\nG0 Z9.5\nG98 G73 X-4 Z-2 R2 Q1\nG80\nM2\n"
    written = write(interpret(text, HERE, "linuxcnc"), "linuxcnc")
    lines = written.splitlines()
    first = lines.index("G98 G83 X1.000 Y2.000 Z-8.000 R6.000 Q20.000 F100")
    assert lines[first + 1 : first + 3] == ["G73 X-4.000 Z-2.000 R2.000 Q1.000", "G80"]
    assert rs274_way(text, tmp_path) in rs274_way(written, tmp_path)


def test_a_block_takes_the_rapid_up_to_its_retract_plane(tmp_path):
    text = "G21 G90\nG0 X0 Y0 Z10\nF100\nG98 G81 X1 Y2 Z-1 R11\nX5 R4\nG99 X7\nG80\nM2\n"
    path = interpret(text, HERE, "linuxcnc")
    written = write(path, "linuxcnc")
    lines = written.splitlines()
    first = lines.index("G98 G81 X1.000 Y2.000 Z-1.000 R11.000 F100")
    assert lines[first - 1] == "X0.000 Y0.000"
    assert lines[first + 1 : first + 4] == ["X5.000 R4.000", "G99 X7.000", "G80"]
    assert rs274_way(text, tmp_path) in rs274_way(written, tmp_path)


@pytest.mark.parametrize("words", ["R10.086 Q0.1", "R10.020 Q1"])
def test_many_pecks_move_no_retract_plane(words):
    text = f"G21 G90\nG0 X0 Y0 Z10\nF100\nG98 G73 X1 Z-8.8 {words}\nX2 R4\nM2\n"
    path = interpret(text, HERE, "linuxcnc")
    read = interpret(write(path, "linuxcnc", WriteOptions(retract=False)), HERE, "linuxcnc")
    last = 30  # rows: behind the last of them Z is where the run began
    assert np.allclose(read.table().end[-last:], path.table().end[-last:], atol=1e-9)
    assert path.table().end[-1, 2] == 10.0


def test_grbl_refuses_them_with_its_own_answer():
    for code in ("G81", "G82", "G83", "G73", "G98", "G99"):
        with pytest.raises(ProgramError) as caught:
            interpret(f"{code} X1 Z-5 R2 F50")
        assert caught.value.code == "refused-code" and "error:20" in str(caught.value)


def test_the_span_holds_the_words_of_its_hole():
    text = "G21 G54 G0 Z10\nG98 G83 X1 Y2 Z-5 R2 Q2 F100\nM2\n"
    (span,) = cycles(interpret(text, Start.with_work_zero((10, 20, 30)), "linuxcnc"))
    assert (span.name, span.words) == ("G83", {"X": 11, "Y": 22, "Z": 25, "R": 32, "Q": 2, "G": 98})
