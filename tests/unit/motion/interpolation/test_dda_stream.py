# SPDX-License-Identifier: LGPL-2.1-or-later
"""`steps` by the thesis's own interpolators, figure for figure (A2, A3)."""

from __future__ import annotations

import random

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.motion.interpolation.dda_stream import dda_stream, times_and_whole_s
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.signals.pulse_stream import moved_steps
from CNCStepper.state import Start
from helpers.cli.command_line import called
from helpers.controllers.thesis_programs import PROGRAMS

FIGURE_11 = "G0\nX15 Y10\nG90\nX35\nX25 Y17\nX15 Y10\n"
TABLE_8 = "A" * 20  # X15 to X35: a pulse at each of 20 rounds
TABLE_9_X, TABLE_9_Y = "111101111101", "101011010101"  # X35 Y10 to X25 Y17
FIGURE_13 = "G0\nX2 Y11\nG2 X11 Y2 I1 J1\n"


def table(interpolation: str, steps_per_mm: float = 1.0) -> Machine:
    content = load_machine("thesis-table").model_dump() | {"interpolation": interpolation}
    for axis in content["axis"].values():
        axis["steps_per_mm"] = steps_per_mm
    return Machine.model_validate(content)


def letters_of_command(tmp_path, text: str, interpolation: str) -> str:
    """Return the letters that the command line writes for a program at 1 mm a pulse."""
    (tmp_path / "part.nc").write_text(text)
    (tmp_path / "table.json").write_text(table(interpolation).model_dump_json())
    arguments = ["steps", str(tmp_path / "part.nc"), "--machine", str(tmp_path / "table.json"), "--as", "letters"]
    ran = called(*arguments)
    assert ran.returncode == 0, ran.stderr
    return "".join(letter for letter in "".join(ran.stdout.split()) if letter.isupper())


def test_tables_8_and_9_come_out_of_steps_figure_for_figure(tmp_path) -> None:
    letters = letters_of_command(tmp_path, FIGURE_11, "dda")
    rapid = next(place for place in range(len(letters)) if letters[place:].startswith(TABLE_8))
    assert letters[rapid : rapid + 20] == TABLE_8
    both = {("0", "0"): "", ("1", "1"): "N", ("1", "0"): "D", ("0", "1"): "B"}
    table_9 = "".join(both[bits] for bits in zip(TABLE_9_X, TABLE_9_Y, strict=True))
    assert letters[rapid + 20 : rapid + 31] == table_9


def test_figure_13_comes_out_as_table_11_with_the_published_registers(tmp_path) -> None:
    published, own = (letters_of_command(tmp_path, FIGURE_13, kind) for kind in ("published", "dda"))
    rapid = letters_of_command(tmp_path, "G0\nX2 Y11\n", "published")
    arc = published[len(rapid) :]
    assert arc[:3] == "AAA" and arc[3] == "E", "X pulses in rounds 13, 26 and 39, the first Y pulse in round 44"
    assert arc != own[len(rapid) :]


@pytest.mark.parametrize("interpolation", ["dda", "planner"])
def test_forms_with_time_are_written_too(tmp_path, interpolation: str) -> None:
    (tmp_path / "part.nc").write_text(FIGURE_11)
    (tmp_path / "table.json").write_text(table(interpolation).model_dump_json())
    for form in ("csv", "parport"):
        arguments = ["steps", str(tmp_path / "part.nc"), "--machine", str(tmp_path / "table.json"), "--as", form]
        ran = called(*arguments)
        assert ran.returncode == 0 and len(ran.stdout.splitlines()) > 40


@pytest.mark.parametrize("number", PROGRAMS)
def test_each_program_ends_where_it_says_and_its_ticks_rise(number: int) -> None:
    machine = table("dda", 40.0)
    text = PROGRAMS[number].replace("|", "\n") + "\n"
    path = interpret(text, None, machine.language())
    last, total = -1, np.zeros(3, np.int64)
    for chunk in dda_stream(path, machine):
        if len(chunk):
            assert chunk.ticks[0] > last and (np.diff(chunk.ticks) > 0).all()
            last = int(chunk.ticks[-1])
        total += moved_steps(chunk, 3)
    assert total.tolist() == np.rint(path.table().end[-1] * 40).astype(int).tolist()
    ends_s, whole_s = times_and_whole_s(path, machine)
    assert whole_s == ends_s[-1] == last / TICKS_PER_S
    assert len(ends_s) == len(path) and (np.diff(ends_s) > 0).all()


def test_switches_and_dwells_stand_between_the_moves() -> None:
    machine = table("dda", 10.0)
    rng = random.Random(3)
    dwell_s = round(rng.uniform(0.5, 3.0), 1)
    text = f"G21 G90 F900\nG1 X5\nM3\nG4 P{dwell_s}\nG1 X10\nM5\nM2\n"
    path = interpret(text, Start.at_zero(), "grbl:spindle=switch,z=none")
    stream = list(dda_stream(path, machine))
    seen = [switch for chunk in stream for switch in chunk.switches]
    ticks = np.concatenate([chunk.ticks for chunk in stream])
    assert (np.diff(ticks) > 0).all()
    longest_s = float(np.diff(ticks).max()) / TICKS_PER_S
    assert longest_s == pytest.approx(dwell_s, abs=0.3), "nothing moves while the program dwells"
    assert ticks[49] <= seen[0].tick < ticks[50]
    assert [(switch.device, switch.on) for switch in seen] == [("spindle_cw", True), ("spindle_cw", False)]
