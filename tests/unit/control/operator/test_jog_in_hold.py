# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jogged out of a hold and taken back to the very place of the cut, judged by the virtual machine's own trace."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.session.command import Command
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.states import State
from helpers.control.jog_in_hold import NEAR_MM, SAMPLE_MM, jogged, led, off_path
from helpers.control.retract_bench import Cut, path_of, polyline
from helpers.control.retract_programs import PROGRAMS

pytestmark = pytest.mark.slow
SQUARE = "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG1 Z-5 F600\nG1 X-25 F1200\nY-25\nX-5\nY-5\nG0 Z-2\nM5\nM2\n"
DEEP = -3.0  # no cut is above


def test_who_jogs_out_of_a_hold_is_taken_back_to_the_cut(tmp_path: Path) -> None:
    cut, speeds = Cut(tmp_path, SQUARE), []
    spindle = lambda: cut.sender.status().spindle_rpm  # noqa: E731

    def person():
        yield lambda: cut.trace[-1][1] < -12.0
        yield from cut.hold()
        yield from led(cut, "aside")
        speeds.append(spindle())
        yield from jogged(cut, z_mm=2.0)
        yield from jogged(cut, x_mm=-8.0, y_mm=4.0)
        yield from jogged(cut, z_mm=-4.0)
        yield from led(cut, "rest")
        yield lambda: cut.trace[-1][2] > DEEP
        speeds.append(spindle())

    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    assert speeds == [0.0, 8000.0]
    (away,) = off_path(cut, SQUARE)
    assert np.linalg.norm(away[0] - away[-1]) < SAMPLE_MM
    lowest = away[:, 2].argmin()
    over = away[lowest:]
    sideways = np.flatnonzero(np.linalg.norm(np.diff(over[:, :2], axis=0), axis=1) > 1e-6)
    assert over[sideways, 2].min() == pytest.approx(-2.0)  # the height at which the program itself goes over


def test_jogs_on_the_way_back_and_again_leave_the_path_whole(tmp_path: Path) -> None:
    program = PROGRAMS["arcs in all planes"]  # with G92 and a tool's length
    cut = Cut(tmp_path, program)

    def person():
        yield 4.5
        yield from cut.hold()
        yield from led(cut, "back", 3.0)
        yield from jogged(cut, z_mm=4.0)
        yield from jogged(cut, x_mm=3.0, y_mm=-2.0)
        yield from led(cut, "back", 1.5)
        yield from jogged(cut, z_mm=2.0)
        yield from led(cut, "rest")

    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    ways = off_path(cut, program)
    assert len(ways) >= 2
    for away in ways:
        assert np.linalg.norm(away[0] - away[-1]) < SAMPLE_MM
    assert cut.trace[-1] == pytest.approx(polyline(path_of(program))[-1], abs=NEAR_MM)


def test_beam_that_is_kept_on_the_way_back_is_off_at_its_end(tmp_path: Path) -> None:
    machine = load_machine("table-a")
    changes = {
        "spindle": machine.spindle.model_copy(update={"laser": True, "spin_up_s": 0.0}),
        "retreat": machine.retreat.model_copy(update={"outputs": "keep"}),
    }
    cut, powers, with_beam = Cut(tmp_path, SQUARE, machine.model_copy(update=changes), settings={32: 1.0}), [], []

    def person():
        yield lambda: cut.trace[-1][1] < -12.0
        yield from cut.hold()
        look, board = cut.table.board.on_step, cut.table.board

        def watch(board) -> None:
            look(board)
            powers.append(board.spindle.rpm)
            if board.state is State.JOG and board.spindle.rpm:
                with_beam.append(board.axes.position_mm)

        board.on_step = watch
        yield from led(cut, "back", 2.0)
        yield from jogged(cut, x_mm=-3.0)
        yield from led(cut, "rest")

    assert cut.run(person).done
    assert 8000.0 in powers and not with_beam


def test_beam_is_off_until_it_is_back_on_its_cut(tmp_path: Path) -> None:
    machine = load_machine("table-a")
    laser = machine.model_copy(update={"spindle": machine.spindle.model_copy(update={"laser": True, "spin_up_s": 0.0})})
    cut, away_with_beam = Cut(tmp_path, SQUARE, laser, settings={32: 1.0}), []

    def person():
        yield lambda: cut.trace[-1][1] < -12.0
        yield from cut.hold()
        yield from led(cut, "aside")
        yield from jogged(cut, x_mm=-8.0)
        look, board = cut.table.board.on_step, cut.table.board

        def watch(board) -> None:
            look(board)
            if board.axes.position_mm[0] < -25.5 and cut.sender.status().spindle_rpm:
                away_with_beam.append(board.axes.position_mm)

        board.on_step = watch
        yield from led(cut, "rest")

    assert cut.run(person).done
    assert len(off_path(cut, SQUARE)) == 1 and not away_with_beam


def test_way_over_is_taken_up_again_where_it_was_held(tmp_path: Path) -> None:
    cut = Cut(tmp_path, SQUARE)

    def person():
        yield lambda: cut.trace[-1][1] < -12.0
        yield from cut.hold()
        yield from led(cut, "aside")
        yield from jogged(cut, z_mm=2.0)
        yield from jogged(cut, x_mm=-8.0)
        yield from led(cut, "rest")
        yield lambda: cut.trace[-1][0] > -31.0 and cut.trace[-1][2] > DEEP
        yield from cut.hold()
        yield from led(cut, "rest")

    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    (away,) = off_path(cut, SQUARE)
    assert np.linalg.norm(away[0] - away[-1]) < SAMPLE_MM


def test_beside_the_cut_no_zero_is_set_and_nothing_goes_on_by_itself(tmp_path: Path) -> None:
    cut = Cut(tmp_path, SQUARE)

    def person():
        yield lambda: cut.trace[-1][1] < -12.0
        yield from cut.hold()
        yield from led(cut, "aside")
        cut.sender.ask(Command("set_zero", {"axes": "Z"}))
        cut.sender.resume()
        yield lambda: len(cut.refused) == 2
        yield from led(cut, "rest")

    assert cut.run(person).done
    assert [error.code for error in cut.refused] == ["retreat-zero", "retreated"]


def test_jog_that_nobody_leads_aside_is_refused_in_a_hold(tmp_path: Path) -> None:
    cut = Cut(tmp_path, SQUARE)

    def person():
        yield lambda: cut.trace[-1][1] < -12.0
        yield from cut.hold()
        cut.sender.ask(Command("jog", {"x_mm": 1.0, "y_mm": 0.0, "z_mm": 0.0, "feed_mm_min": 500.0}))
        yield lambda: bool(cut.refused)
        cut.sender.resume()

    assert cut.run(person).done
    assert [error.code for error in cut.refused] == ["held-jog"]
