# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut where the play of the axes is taken up in the lines sent, judged by where the tool really was."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.session.command import Command
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath
from helpers.control.jog_in_hold import SAMPLE_MM, jogged, led, off_path
from helpers.control.retract_bench import ROUNDING_MM, STEP_MM, Cut, path_of, polyline, worst_distance_mm

pytestmark = pytest.mark.slow
NEAR_MM = STEP_MM + ROUNDING_MM
GAP_MM = 0.6
ZIGZAG = (
    "G21 G90\nG0 Z-2\nG1 X-5 Y-5 F600\nM3 S8000\nG1 Z-3 F300\nX-9 Y-7 F600\nX-6 Y-9 F100\nG2 X-10 Y-9 I-2 J0 F900\nM2\n"
)
PAUSED = ZIGZAG.replace("G2 X", "M0\nG2 X")


def loose() -> Machine:
    machine = load_machine("table-a")
    axes = {name: axis.model_copy(update={"backlash_mm": GAP_MM}) for name, axis in machine.axis.items()}
    return machine.model_copy(update={"axis": axes})


def gap_mm(cut: Cut) -> float:
    """How far the motor of X stands ahead of its tool."""
    return cut.table.board.axes.position_mm[0] - cut.trace[-1][0]


def held_in_the_gap(cut: Cut):
    """Hold while the motor of X crosses its gap at the corner, and the tool stands there."""
    yield lambda: cut.trace[-1][0] < -8.99 and gap_mm(cut) > 0.02
    yield from cut.hold()
    assert 0.05 < gap_mm(cut) < GAP_MM - 0.05


def whole(cut: Cut, person, program: str) -> None:
    """Let the job run with a person at it, and judge its way and its end."""
    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    assert np.allclose(cut.trace[-1], polyline(path_of(program))[-1], atol=STEP_MM)


@pytest.mark.parametrize("legs", [("rest",), ("back", "rest"), ("aside", "back", "back", "rest")])
def test_hold_in_the_gap_leads_anywhere_along_the_cut(tmp_path: Path, legs: tuple[str, ...]) -> None:
    cut = Cut(tmp_path, ZIGZAG, loose())

    def person():
        yield from held_in_the_gap(cut)
        for leg in legs:
            yield from led(cut, leg, 1.5)

    whole(cut, person, ZIGZAG)
    assert worst_distance_mm(cut.trace, polyline(path_of(ZIGZAG))) <= NEAR_MM


def test_way_back_that_is_held_in_a_gap_of_its_own_goes_on_from_there(tmp_path: Path) -> None:
    cut = Cut(tmp_path, ZIGZAG, loose())

    def person():
        yield lambda: cut.trace[-1][0] > -8.0 and cut.trace[-1][1] < -7.1
        yield from cut.hold()
        found = []
        yield from cut.find(found)
        yield from cut.go(found[0].along(found[0].back_by(4.0)))
        yield lambda: gap_mm(cut) < GAP_MM - 0.1
        yield from cut.hold()
        assert 0.05 < gap_mm(cut) < GAP_MM - 0.05
        yield from led(cut, "back", 0.5)
        yield from led(cut, "rest")

    whole(cut, person, ZIGZAG)
    assert worst_distance_mm(cut.trace, polyline(path_of(ZIGZAG))) <= NEAR_MM


@pytest.mark.parametrize(
    "jogs", [[(0.0, 0.0, 0.4)], [(0.0, 0.0, 1.5), (3.0, -2.0, 0.0)], [(0.9, 0.9, 0.0), (-0.9, -0.9, 0.0)]]
)
def test_jogged_tool_is_back_on_its_cut_whichever_side_its_motors_come_from(tmp_path: Path, jogs: list) -> None:
    """Out of a hold and back to where the motors stood too: they may be on the other side of their gaps."""
    cut = Cut(tmp_path, ZIGZAG, loose())

    def person():
        yield lambda: cut.trace[-1][1] < -7.5
        yield from cut.hold()
        yield from led(cut, "aside")
        for x_mm, y_mm, z_mm in jogs:
            yield from jogged(cut, x_mm=x_mm, y_mm=y_mm, z_mm=z_mm)
        yield from led(cut, "rest")

    whole(cut, person, ZIGZAG)
    (away,) = off_path(cut, ZIGZAG)
    assert np.linalg.norm(away[0] - away[-1]) < SAMPLE_MM


def test_way_back_begins_at_a_pause_from_which_a_loose_machine_was_jogged(tmp_path: Path) -> None:
    cut = Cut(tmp_path, PAUSED, loose())

    def person():
        yield cut.arrived
        yield from jogged(cut, z_mm=1.0)
        yield from jogged(cut, x_mm=2.0, y_mm=-2.0)
        yield from led(cut, "back", 3.0)
        yield from led(cut, "rest")
        yield lambda: cut.phase == "paused"
        cut.sender.resume()

    whole(cut, person, PAUSED)
    (away,) = off_path(cut, PAUSED)
    assert np.linalg.norm(away[0] - away[-1]) < SAMPLE_MM


RISEN = ZIGZAG.replace("G2 X", "M0\nG2 X").replace("G1 Z-3 F300", "G1 Z-4 F300\nZ-3")
ROUND = ZIGZAG.replace("M2", "M0\nG1 X-12 Y-8 F600\nM2")
HIGH = -2.0  # to which these programs go up
UP_AND_ASIDE = [(0.0, 0.0, 1.5), (2.0, -2.0, 0.0)]
THERE_AND_BACK = [(0.0, 0.0, 1.5), (0.3, -0.7, 0.0), (-0.3, 0.7, 0.0), (0.0, 0.0, -1.5)]


@pytest.mark.parametrize(
    ("program", "jogs"),
    [
        (PAUSED, UP_AND_ASIDE),  # X was left forwards, Y backwards
        (PAUSED, THERE_AND_BACK),
        (ROUND, [(0.0, 0.0, 1.5), (-2.0, 2.0, 0.0)]),  # X backwards, Y forwards
        (RISEN, [(0.0, 0.0, 1.0)]),  # Z upwards
    ],
)
def test_job_itself_goes_on_from_its_pause_with_each_axis_on_its_side_of_the_gap(
    tmp_path: Path, program: str, jogs: list
) -> None:
    cut, moments = Cut(tmp_path, program, loose()), []

    def person():
        yield cut.arrived
        moments.append(cut.mark())
        for x_mm, y_mm, z_mm in jogs:
            yield from jogged(cut, x_mm=x_mm, y_mm=y_mm, z_mm=z_mm)
        moments.append(cut.mark())
        cut.sender.resume()
        yield lambda: cut.phase == "running"
        moments.append(cut.mark())

    whole(cut, person, program)
    (paused, place, aheads), (back, _, _), (on, again, aheads_again) = moments
    assert again == pytest.approx(place, abs=STEP_MM) and aheads_again == pytest.approx(aheads, abs=STEP_MM)
    line, points = polyline(path_of(program)), cut.points
    assert max(worst_distance_mm(points[:paused], line), worst_distance_mm(points[on:], line)) <= NEAR_MM
    way = points[back:on]
    far = np.abs(way[1:, :2] - place[:2]).max(axis=1) > STEP_MM
    aside = far & (np.diff(way[:, :2], axis=0) != 0.0).any(axis=1)
    assert way[1:][aside, 2].min(initial=HIGH) > HIGH - STEP_MM, "the tool went aside in the work"
    assert way[:, 2].min() > place[2] - STEP_MM, "the tool went down into the work"


def test_stepping_by_line_goes_on_after_a_jog_with_each_axis_on_its_side_of_the_gap(tmp_path: Path) -> None:
    """Jogged before each line, those of the motors alone too."""
    cut, marks = Cut(tmp_path, ZIGZAG, loose(), by_line=True), []

    def person():
        for index in range(len(cut.job.lines)):
            yield lambda index=index: cut.sender.status().sent == index and cut.phase == "paused"
            marks.append(cut.mark())
            yield from jogged(cut, x_mm=0.4, y_mm=-0.3)
            cut.sender.resume()
            yield lambda: cut.phase in ("running", "done")
            marks.append(cut.mark())

    whole(cut, person, ZIGZAG)
    for (_, place, aheads), (_, again, aheads_again) in zip(marks[::2], marks[1::2], strict=True):
        assert again == pytest.approx(place, abs=STEP_MM) and aheads_again == pytest.approx(aheads, abs=STEP_MM)


def test_zero_set_at_a_pause_moves_what_follows_with_each_axis_on_its_side_of_the_gap(tmp_path: Path) -> None:
    """Touched off in the sense in which a zero is true, 3 mm beside the old one."""
    cut = Cut(tmp_path, PAUSED, loose())

    def person():
        yield cut.arrived
        for way_mm in ({"z_mm": 2.0}, {"x_mm": 4.0}, {"x_mm": -1.0}):
            yield from jogged(cut, **way_mm)
        moments.append(cut.mark())
        cut.sender.ask(Command("set_zero", {"axes": "X"}))
        yield lambda: ("message", "zero of X set in G54") in cut.told
        cut.sender.resume()
        yield lambda: cut.phase == "running"
        moments.append(cut.mark())

    moments: list[tuple] = []
    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    (_, (zero_x_mm, _, _), _), (on, _, _) = moments
    moved = polyline(path_of(PAUSED)) + np.array([zero_x_mm, 0.0, 0.0])
    assert worst_distance_mm(cut.points[on:], moved) <= NEAR_MM
    assert np.allclose(cut.trace[-1], moved[-1], atol=STEP_MM)


def test_pause_behind_a_way_back_is_left_with_each_axis_on_its_side_of_the_gap(tmp_path: Path) -> None:
    """Z stands there as it was left before the way back, which did not move it."""
    cut, marks = Cut(tmp_path, RISEN, loose()), []

    def person():
        yield lambda: cut.trace[-1][1] < -7.5
        yield from cut.hold()
        yield from led(cut, "back", 0.8)
        yield from led(cut, "rest")
        yield lambda: cut.phase == "paused"
        marks.append(cut.mark())
        yield from jogged(cut, z_mm=1.0)
        cut.sender.resume()
        yield lambda: cut.phase == "running"
        marks.append(cut.mark())

    whole(cut, person, RISEN)
    (_, place, aheads), (_, again, aheads_again) = marks
    assert aheads[2] == pytest.approx(GAP_MM, abs=STEP_MM)
    assert again == pytest.approx(place, abs=STEP_MM) and aheads_again == pytest.approx(aheads, abs=STEP_MM)


def gone_mm(way: RetractPath, place: Place) -> float:
    """How far X has gone, there and back, up to a place of straight moves."""
    parts = [way.move(row).part(0.0, place.share if row == place.row else 1.0) for row in range(place.row + 1)]
    return sum(abs(part.end[0] - part.begin[0]) for part in parts)


@pytest.mark.parametrize("seed", range(8))
def test_reversal_in_doubt_is_cut_again_and_nothing_is_left_out(tmp_path: Path, seed: int) -> None:
    """There and back again on one line, where motors at one place may have their tool at two, and no `Bf:` is told."""
    print("seed", seed)
    rng = random.Random(seed)
    end, begin = rng.choice((("X-4", "X-3"), ("X-4 Y-4", "X-3 Y-3"), ("X-4 Y-1", "X-3 Y-.75")))
    lines = f"{end} F{rng.choice((300, 1500))}\n{begin}\n{end}\n{begin}\nX-6 Y-5\n"
    program = f"G21 G90\nG1 Z-3 F300\n{lines}M2\n"
    cut, motors_mm = Cut(tmp_path, program, loose(), settings={10: 1.0}), [0.0]
    follow = cut.table.board.on_step

    def look(board) -> None:
        follow(board)
        motors_mm.append(board.axes.position_mm[0])

    def person():
        wanted_mm = rng.uniform(3.5, 9.0)
        yield lambda: np.abs(np.diff(motors_mm)).sum() > wanted_mm
        yield from cut.hold()
        gone, found = np.abs(np.diff(motors_mm)).sum(), []
        yield from cut.find(found)
        early, late = (gone_mm(found[0].motors, place) for place in found[0].found)
        assert early - NEAR_MM < gone < late + NEAR_MM
        yield from led(cut, "back", rng.uniform(0.1, 2.0))
        yield from led(cut, "rest")

    cut.table.board.on_step = look
    whole(cut, person, program)
    assert worst_distance_mm(cut.trace, polyline(path_of(program))) <= NEAR_MM
