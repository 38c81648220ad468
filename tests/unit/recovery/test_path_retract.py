# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut and forward again, judged by the trace of the virtual machine's own steps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.session.command import Command
from CNCStepper.machine.profile import load_machine
from CNCStepper.recovery.retract.path_retract import HeldProgram
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath
from helpers.control.retract_bench import (
    CORNERS_MM,
    ROUNDING_MM,
    STEP_MM,
    Cut,
    along_mm,
    path_of,
    polyline,
    worst_distance_mm,
)
from helpers.control.retract_programs import THRICE

pytestmark = pytest.mark.slow
SQUARE = "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG1 Z-5 F600\nG1 X-25 F1200\nY-25\nX-5\nY-5\nG0 Z-2\nM5\nM2\n"
SIDE = 7  # the line Y-25


def held_on_side(cut: Cut):
    """Hold the machine on the second side of the square."""
    yield lambda: cut.trace[-1][1] < -12.0
    yield from cut.hold()


def found_by(cut: Cut):
    found: list[HeldProgram] = []
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
    program = THRICE
    way = RetractPath(path_of(program))
    cut = Cut(tmp_path, program, settings={10: 1.0})

    def person():
        yield 3.5  # in the second of the three passes
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
        proven = leg["certificate"]
        leg["certificate"] = replace(proven, lines=[*proven.lines[:-1], "G1X-1Y-1Z-9F100"])
        yield from cut.go(leg)
        assert cut.phase == "held"
        cut.sender.resume()

    assert cut.run(person).done
    assert [error.code for error in cut.refused] == ["certificate-wire"]
    assert cut.length_mm == pytest.approx(along_mm(RetractPath(path_of(SQUARE)), Place(7, 1.0)), abs=CORNERS_MM)


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


@pytest.mark.parametrize("by_leg", [False, True])
def test_way_back_begins_at_a_pause_from_which_somebody_jogged(tmp_path: Path, by_leg: bool) -> None:
    """The pause of the program, and the same one again in the rest after a way back."""
    cut, phases = Cut(tmp_path, PAUSED), []

    def person():
        yield cut.arrived
        if by_leg:
            yield from cut.go((yield from found_by(cut)).rest())
            yield cut.arrived
        yield from jogged(cut)
        held = yield from found_by(cut)
        yield from cut.go(held.along(held.back_by(3.0)))
        yield cut.arrived
        phases.append(cut.phase)
        assert along_mm(held.way, held.place) - along_mm(held.way, (yield from found_by(cut)).place) == pytest.approx(
            3.0
        )
        yield from cut.go((yield from found_by(cut)).rest())
        yield cut.arrived
        phases.append(cut.phase)
        cut.sender.resume()

    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    assert phases == ["retreated", "paused"]
    assert cut.trace[-1] == pytest.approx(polyline(path_of(PAUSED))[-1], abs=STEP_MM)
    off = [
        worst_distance_mm(point[None], polyline(path_of(PAUSED))) > STEP_MM + ROUNDING_MM for point in cut.trace[::8]
    ]
    assert np.abs(np.diff(np.array(off, int))).sum() == 2  # it leaves the path once


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


def test_overrides_are_what_they_were_before_each_reset(tmp_path: Path) -> None:
    cut, seen = Cut(tmp_path, SQUARE), []

    def person():
        for kind, step, times in (("feed", "-10", 4), ("feed", "1", 3), ("rapid", "25", 1), ("spindle", "10", 2)):
            for _ in range(times):
                cut.sender.ask(Command("override", {"kind": kind, "step": step}))
                yield 0.3
        yield from held_on_side(cut)
        for part in ("back", "rest"):
            held = yield from found_by(cut)
            yield from cut.go(held.along(held.back_by(3.0)) if part == "back" else held.rest())
            overrides = cut.table.board.overrides
            seen.append((overrides.feed, overrides.rapid, overrides.spindle))
            yield cut.arrived

    assert cut.run(person).done and not cut.refused
    assert seen == [(63, 25, 120)] * 2


def test_status_can_be_asked_at_every_moment_of_a_way_back(tmp_path: Path) -> None:
    """Its leg has fewer lines than were sent before, and brings the overrides back first."""
    cut, lines = Cut(tmp_path, SQUARE), []

    def person():
        cut.sender.ask(Command("override", {"kind": "feed", "step": "-10"}))
        yield from held_on_side(cut)
        held = yield from found_by(cut)
        cut.table.on_write = lambda data: lines.append(cut.sender.status().file_line)
        yield from cut.go(held.along(held.back_by(1.0)))
        yield cut.arrived
        cut.sender.stop()

    assert cut.run(person).kind == "stopped" and lines and max(lines) <= SQUARE.count("\n")


def test_cut_does_not_go_on_at_other_overrides(tmp_path: Path) -> None:
    cut = Cut(tmp_path, SQUARE)

    def person():
        cut.sender.ask(Command("override", {"kind": "feed", "step": "-10"}))
        yield from held_on_side(cut)
        held = yield from found_by(cut)
        write, cut.table.write = cut.table.write, lambda data: write(data.replace(b"\x92", b""))
        yield from cut.go(held.rest())
        assert cut.phase == "retreated" and cut.table.board.overrides.feed == 100
        cut.table.write = write
        cut.sender.stop()

    assert cut.run(person).kind == "stopped"
    assert [error.code for error in cut.refused] == ["overrides-lost"]
