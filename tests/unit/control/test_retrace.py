# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut and forward again, judged by the trace of the virtual machine's own steps."""

from __future__ import annotations

import os
import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from cut_table import ROUNDING_MM, STEP_MM, Cut, path_of, polyline, worst_distance_mm

from CNCStepper.control.command import Command
from CNCStepper.gcode.retreat.way import Place, Way
from CNCStepper.job.retreat import Held
from CNCStepper.machine.profile import load_machine

pytestmark = pytest.mark.slow
CASES = max(6, int(os.environ.get("CNCSTEPPER_CASES", "6")))  # holds a program
NOISE, CORNERS_MM = 0.01, 1.5  # of the length measured, a hundredth too; every pass is longer
BEGIN = "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG1 Z-5 F600\n"
ONE_PASS = "G1 X-9 F1200\nG2 X-10 Y-6 I0 J-1\nG1 Y-9\nG1 X-5\nG1 Y-5\n"
PROGRAMS = {
    "contour cut three times": BEGIN + 3 * ONE_PASS + "G0 Z-2\nM5\nM2\n",
    "links of a pocket": BEGIN
    + "".join(
        f"G1 Z{z} F400\nG1 X-9 F1500\nG3 X-9 Y-5.5 J-.25 I0\nG1 X-6\nG2 X-6 Y-6 J-.25 I0\nG1 X-9\nG1 X-9 Y-8\nG1 X-5\n"
        "G1 X-5 Y-5 F2000\n"
        for z in (-5.5, -6.0, -6.5)
    )
    + "G0 Z-2\nM5\nM2\n",
    "arcs in all planes": "G21 G90\nG92 X1 Y2 Z3\nG43.1 Z1.5\n"
    + BEGIN
    + "G17 G2 X-5 Y-5 I-2 J0 F900\nX-5 I-2 J0\nX-5 I-2 J0\nG18 G3 X-9 Z-5 I-2 K0\nG19 G2 Y-9 Z-5 J-2 K0\n"
    + "G17 G91 G1 X1 F800\nG20 G1 X.05 Y-.04 F40\nG3 X.04 Y.04 I0 J.04\nG21 X-1 Y-.5 I-.5 J-.25\nG90 G1 X-6 Y-6 F1200\n"
    + "G0 Z-2\nM5\nM2\n",
    "helix": BEGIN
    + "G2 X-5 Y-5 I-1.5 Z-5.5 F700\nX-5 I-1.5 Z-6\nX-5 I-1.5 Z-6.5\nX-5 I-1.5\nG3 X-8 I-1.5 Z-5\nX-5 I1.5 Z-6\n"
    + "G1 Z-7 F300\nG2 X-5 I-1.5 F900\nX-5 I-1.5\nG0 Z-2\nM5\nM2\n",
}


def along_mm(way: Way, place: Place) -> float:
    """Return how far a place lies from the begin of the way."""
    before = sum(way.move(row).length_mm for row in range(place.row))
    return before + way.move(place.row).length_mm * place.share


def somewhere(held: Held, rng: random.Random) -> Place:
    """Return where a person may want to go."""
    lines = [held.file_line(Place(row, 0.0)) for row in range(held.way.begin_before(held.place), held.place.row + 1)]
    return rng.choice(
        [
            lambda: held.back_by(rng.uniform(0.05, 25.0)),
            lambda: held.back_to_line(rng.choice(lines)),
            held.back_to_entry,
            held.forward_by,
            lambda: held.forward_by(rng.uniform(0.05, 10.0)),
        ]
    )()


class Wanderer:
    """Holds now and then, goes back and forth along the cut, and in the end lets the job go on.

    gone_mm: how far the machine should have gone by what is known of its places.
    """

    def __init__(self, cut: Cut, way: Way, rng: random.Random, total_s: float):
        self.cut, self.way, self.rng = cut, way, rng
        self.total_s = total_s
        self.gone_mm = self.last_mm = 0.0
        self.stands = 0

    def person(self):
        for _ in range(self.rng.choice((1, 1, 2))):
            yield self.rng.uniform(0.05, self.total_s)
            yield from self.cut.hold()
            if self.cut.phase == "done":
                return
            for _ in range(self.rng.randint(1, 3)):
                yield from self.wander()
            held = yield from self.find()
            yield from self.cut.go(held.rest())

    def wander(self):
        held = yield from self.find()
        target = somewhere(held, self.rng)
        yield from self.cut.go(held.along(target))
        if self.rng.random() < 0.3:
            yield self.rng.uniform(0.0, 4.0)  # the spindle comes up, then the way is held half done
            yield from self.cut.hold()
        yield self.cut.arrived

    def find(self):
        """Return what a client finds, and compare it with how far the axes have gone."""
        found: list[Held] = []
        yield from self.cut.find(found)
        here_mm = along_mm(self.way, found[0].place)
        self.gone_mm += abs(here_mm - self.last_mm)
        self.last_mm, self.stands = here_mm, self.stands + 1
        assert self.gone_mm == pytest.approx(self.cut.length_mm, rel=NOISE, abs=CORNERS_MM), (
            "another pass than the one cut"
        )
        assert found[0].found.early == found[0].found.late
        return found[0]


@pytest.mark.parametrize("name", PROGRAMS)
def test_way_back_and_forward_again_is_exact_from_any_hold(name: str, tmp_path: Path) -> None:
    program = PROGRAMS[name]
    way, line = Way(path_of(program)), polyline(path_of(program))
    whole = Cut(tmp_path, program)
    assert whole.run(lambda: iter(())).done
    total_s = whole.table.clock() - 100.0
    for seed in range(CASES):
        print(f"{name}, seed {seed}")
        folder = tmp_path / str(seed)
        folder.mkdir()
        cut = Cut(folder, program)
        wanderer = Wanderer(cut, way, random.Random(f"{name} {seed}"), total_s)
        outcome = cut.run(wanderer.person)
        assert outcome.done, outcome.text
        assert not cut.refused
        assert wanderer.stands >= 2 or cut.length_mm == pytest.approx(whole.length_mm, rel=NOISE)
        assert np.array_equal(cut.trace[-1], whole.trace[-1])
        worst = worst_distance_mm(cut.trace, line)
        assert worst <= STEP_MM + ROUNDING_MM


SQUARE = "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG1 Z-5 F600\nG1 X-25 F1200\nY-25\nX-5\nY-5\nG0 Z-2\nM5\nM2\n"
SIDE = 7  # the line Y-25


def held_on_side(cut: Cut):
    """Hold the machine on the second side of the square."""
    yield lambda: cut.trace[-1][1] < -12.0
    yield from cut.hold()


def found_by(cut: Cut):
    found: list[Held] = []
    yield from cut.find(found)
    return found[0]


def test_spindle_turns_on_the_way_back_and_plain_resume_is_refused(tmp_path: Path) -> None:
    cut, speeds = Cut(tmp_path, SQUARE), []

    def person():
        yield from held_on_side(cut)
        held = yield from found_by(cut)
        assert held.file_line(held.place) == SIDE
        yield from cut.go(held.along(held.back_to_line(SIDE - 1)))
        yield cut.arrived
        speeds.append(cut.sender.status().spindle_rpm)
        assert cut.trace[-1] == pytest.approx((-5.0, -5.0, -5.0))
        cut.sender.resume()
        yield lambda: bool(cut.refused)
        yield from cut.go((yield from found_by(cut)).rest())

    outcome = cut.run(person)
    assert outcome.done and speeds == [8000.0]
    assert [error.code for error in cut.refused] == ["retreated"]
    assert outcome.status.total == outcome.status.acknowledged == SQUARE.count("\n")


def test_beam_is_off_on_the_way_back_and_on_again_to_cut(tmp_path: Path) -> None:
    machine = load_machine("table-a")
    laser = machine.model_copy(update={"spindle": machine.spindle.model_copy(update={"laser": True, "spin_up_s": 0.0})})
    cut, speeds = Cut(tmp_path, SQUARE, laser, settings={32: 1.0}), []

    def person():
        yield from held_on_side(cut)
        held = yield from found_by(cut)
        yield from cut.go(held.along(held.back_by(5.0)))
        speeds.append(cut.sender.status().spindle_rpm)
        yield cut.arrived
        speeds.append(cut.sender.status().spindle_rpm)
        yield from cut.go((yield from found_by(cut)).rest())
        yield lambda: cut.trace[-1][1] < -20.0
        speeds.append(cut.sender.status().spindle_rpm)

    assert cut.run(person).done
    assert speeds == [0.0, 0.0, 8000.0]


def test_passes_are_told_apart_without_the_buffers_state(tmp_path: Path) -> None:
    program = PROGRAMS["contour cut three times"]
    way = Way(path_of(program))
    cut = Cut(tmp_path, program, settings={10: 1.0})

    def person():
        yield 6.0  # in the second of the three passes
        yield from cut.hold()
        held = yield from found_by(cut)
        assert way.rows_of(11)[0] <= held.place.row < way.rows_of(16)[0]
        assert along_mm(way, held.place) == pytest.approx(cut.length_mm, abs=CORNERS_MM)
        assert held.found.early == held.found.late
        yield from cut.go(held.along(held.back_by(6.0)))
        yield cut.arrived
        yield from cut.go((yield from found_by(cut)).rest())

    assert cut.run(person).done


def test_way_back_is_refused_in_motion_and_the_job_goes_on(tmp_path: Path) -> None:
    cut = Cut(tmp_path, SQUARE)

    def person():
        yield 1.0
        cut.sender.ask(Command("tell_place", {"file": str(tmp_path / "x.json")}))
        yield lambda: bool(cut.refused)

    assert cut.run(person).done
    assert [error.code for error in cut.refused] == ["not-held"]


def test_leg_of_another_place_is_refused_after_the_reset(tmp_path: Path) -> None:
    cut = Cut(tmp_path, SQUARE)

    def person():
        yield from held_on_side(cut)
        held = yield from found_by(cut)
        moved = replace(held, position_mm=(held.position_mm[0] - 0.1, *held.position_mm[1:]))
        yield from cut.go(moved.along(held.back_by(1.0)))
        assert cut.phase == "retreated"
        yield from cut.go((yield from found_by(cut)).rest())

    assert cut.run(person).done
    assert [error.code for error in cut.refused] == ["retreat-moved"]


def test_changed_leg_is_refused_and_the_machine_stays_held(tmp_path: Path) -> None:
    cut = Cut(tmp_path, SQUARE)

    def person():
        yield from held_on_side(cut)
        held = yield from found_by(cut)
        leg = held.along(held.back_by(1.0))
        leg["certificate"]["send"]["lines"][-1] = "G1X-1Y-1Z-9F100"
        yield from cut.go(leg)
        assert cut.phase == "held"
        cut.sender.resume()

    assert cut.run(person).done
    assert [error.code for error in cut.refused] == ["certificate-changed"]
    assert cut.length_mm == pytest.approx(along_mm(Way(path_of(SQUARE)), Place(7, 1.0)), abs=CORNERS_MM)


PAUSED = SQUARE.replace("X-5\nY-5\nG0 Z-2", "X-5\nM0\nY-5\nG0 Z-2")


def jogged(cut: Cut):
    """Jog at a stand and wait for the end of it."""
    cut.sender.ask(Command("jog", {"x_mm": 2.0, "y_mm": 0.0, "z_mm": 0.0, "feed_mm_min": 2000.0}))
    yield lambda: cut.sender.status().machine_state == "Jog"
    yield lambda: cut.sender.status().machine_state == "Idle"


def test_way_back_begins_at_a_pause_too_and_the_rest_pauses_there_again(tmp_path: Path) -> None:
    cut, phases = Cut(tmp_path, PAUSED), []

    def person():
        yield cut.arrived
        held = yield from found_by(cut)
        yield from cut.go(held.along(held.back_by(3.0)))
        yield cut.arrived
        phases.append(cut.phase)
        yield from cut.go((yield from found_by(cut)).rest())
        yield cut.arrived
        phases.append(cut.phase)
        yield from jogged(cut)
        cut.sender.resume()

    outcome = cut.run(person)
    assert outcome.done, outcome.text
    assert phases == ["retreated", "paused"] and not cut.refused


def test_way_back_is_refused_where_the_machine_was_jogged_off_the_path(tmp_path: Path) -> None:
    cut = Cut(tmp_path, PAUSED)

    def person():
        yield cut.arrived
        yield from jogged(cut)
        cut.sender.ask(Command("tell_place", {"file": str(tmp_path / "x.json")}))
        yield lambda: bool(cut.refused)
        cut.sender.resume()
        yield lambda: cut.trace[-1][1] > -18.0 and cut.trace[-1][0] > -6.0
        yield from cut.hold()
        held = yield from found_by(cut)
        yield from cut.go(held.rest())

    outcome = cut.run(person)
    assert outcome.done, outcome.text
    assert [error.code for error in cut.refused] == ["retreat-jogged"]


def test_way_back_is_refused_once_the_zero_was_set_at_a_pause(tmp_path: Path) -> None:
    cut = Cut(tmp_path, PAUSED)

    def person():
        yield cut.arrived
        cut.sender.ask(Command("set_zero", {"axes": "X"}))
        cut.sender.ask(Command("tell_place", {"file": str(tmp_path / "x.json")}))
        yield lambda: bool(cut.refused)
        cut.sender.stop()

    assert cut.run(person).kind == "stopped"
    assert [error.code for error in cut.refused] == ["retreat-zero"]


def test_rest_is_sent_line_by_line_and_the_way_back_is_not(tmp_path: Path) -> None:
    cut, phases = Cut(tmp_path, SQUARE), []

    def person():
        yield from held_on_side(cut)
        cut.sender.ask(Command("by_line", {"on": True}))
        for part in ("back", "rest"):
            held = yield from found_by(cut)
            yield from cut.go(held.along(held.back_by(3.0)) if part == "back" else held.rest())
            yield cut.arrived
            phases.append(cut.phase)
        cut.sender.ask(Command("by_line", {"on": False}))
        cut.sender.resume()

    outcome = cut.run(person)
    assert outcome.done and phases == ["retreated", "paused"]
