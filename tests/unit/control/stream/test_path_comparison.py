# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path as it is planned, and the comparison of reported positions with it.

A work zero that changes while a program runs: what the program itself changes is no fault, all else is one.
"""

from __future__ import annotations

import subprocess
import sys
import tracemalloc

import numpy as np
import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.status_reports import Status, Unknown, parse
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE
from CNCStepper.control.stream.path_comparison import OffsetWatch, held_modes
from CNCStepper.control.stream.planned_path import PlannedPath, arc_points
from CNCStepper.state import Start
from helpers.control.fake_controller import FakeClock, FakeController, FakeLink
from helpers.control.workshop import Workshop

NEAR_MM = (0.027, 0.027, 0.007)
SQUARE = ("G21G90G94G17", "G1X10F600", "Y10", "X0", "Y0")


def path_of(lines, sent: int) -> PlannedPath:
    path = PlannedPath(lines, Start.at_zero())
    path.read(sent)
    return path


@pytest.mark.parametrize(
    ("place", "there"),
    [((5, 0, 0), True), ((10, 7, 0), True), ((5, 0.02, 0), True), ((5, 0.04, 0), False), ((5, 0, 0.01), False)],
)
def test_place_is_compared_with_the_lines_that_were_sent(place, there):
    assert path_of(SQUARE, 3).drop_to(place, NEAR_MM) is there


def test_line_that_was_not_sent_is_no_part_of_the_path():
    assert not path_of(SQUARE, 3).drop_to((5, 10, 0), NEAR_MM)
    assert path_of(SQUARE, 4).drop_to((5, 10, 0), NEAR_MM)


def test_machine_never_comes_back_behind_a_place_it_was_seen_at():
    path = path_of(SQUARE, 5)
    assert path.drop_to((5, 10, 0), NEAR_MM) and path.line == 3
    assert not path.drop_to((10, 5, 0), NEAR_MM)


def test_lines_that_fill_the_queue_push_the_others_out():
    path = path_of(("G21G90G1X1F600", *(f"X{number}" for number in range(2, 60))), 59)
    path.drop_planned_before(59, 20)
    assert path.line == 39
    assert not path.drop_to((30, 0, 0), NEAR_MM) and path.drop_to((45.5, 0, 0), NEAR_MM)


def test_line_by_line_and_all_at_once_the_path_is_the_same():
    lines = ("G21G90G94G17", "G1X10F600", "G2X20Y0I5J0", "G0Z5", "G28", "G91G1X-3F50", "G3X-4I-2")
    at_once, by_line = path_of(lines, len(lines)), path_of(lines, 0)
    for sent in range(len(lines) + 1):
        by_line.read(sent)
    for place in ((4, 0, 0), (15, 5, 0), (20, 0, 3), (0, 0, 0), (-2, 0, 0), (-5, 2, 0)):
        assert at_once.drop_to(place, NEAR_MM) and by_line.drop_to(place, NEAR_MM), place
        assert at_once.line == by_line.line


def test_line_after_a_stand_goes_on_with_the_arc_that_is_modal():
    path = PlannedPath(
        ("G0Y1", "G2Y0J-.5F600", "X10I5"), Start.at_zero(), held_modes({}, "G2 G54 G17 G21 G90 G94 F600"), 2
    )
    path.read(3)
    assert path.refused is None and path.line == 1
    assert path.drop_to((5, 5, 0), NEAR_MM) and path.line == 2


def test_planner_is_as_large_as_the_controller_has_said_it_is():
    clock = FakeClock()
    driver = Grbl(FakeLink(controller := FakeController(clock), clock), clock)
    controller.say("[OPT:V,15,1024]")
    controller.say("<Idle|MPos:0.000,0.000,0.000|Bf:35,1023|FS:0,0>")
    driver.receive(0.1)
    assert driver.planner_blocks == 35


def test_path_needs_no_kernels():
    code = "import sys, CNCStepper.control.stream.planned_path; sys.exit('numba' in sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_end_is_that_of_the_last_line():
    path = path_of(SQUARE, 5)
    assert path.ends_at((0.0, 0.0, 0.0), NEAR_MM) and not path.ends_at((0.0, 0.1, 0.0), NEAR_MM)


@pytest.mark.parametrize("line", ["G38.2Z-5F100", "$H", "G7X3"])
def test_beyond_a_line_that_only_the_controller_knows_every_place_is_right(line):
    path = path_of((*SQUARE, line, "G1X5"), 7)
    assert path.refused and path.drop_to((77, 77, 0), NEAR_MM) and path.ends_at((1, 2, 3), NEAR_MM)


@pytest.mark.parametrize(("clockwise", "sweep"), [(False, 90), (True, 270)])
def test_arc_has_its_points_on_its_circle_and_ends_at_its_end(clockwise, sweep):
    begin, end, centre = np.array([10.0, 0, 0]), np.array([0.0, 10, 3]), np.zeros(3)
    points = arc_points(begin, end, centre, 0, 1, clockwise)
    assert np.hypot(*points[:, :2].T) == pytest.approx(10.0)
    length = np.linalg.norm(np.diff(np.vstack([begin, points])[:, :2], axis=0), axis=1).sum()
    assert length == pytest.approx(np.radians(sweep) * 10, rel=1e-3)
    assert points[-1].tolist() == [0, 10, 3] and np.all(np.diff(points[:, 2]) > 0)


def test_full_circle_comes_back_to_its_begin():
    points = arc_points(np.array([1.0, 0, 0]), np.array([1.0, 0, 0]), np.zeros(3), 0, 1, False)
    assert len(points) > 40 and points[:, 0].min() == pytest.approx(-1.0, abs=0.01)


@pytest.mark.parametrize("text", ["<Idle|FS:0,0>", "<Idle|MPos:1.000,2.000|FS:0,0>", "<Run|MPos:1.0,x,3.0>"])
def test_status_whose_position_is_damaged_is_none(text):
    assert isinstance(parse(text), Unknown)
    assert isinstance(parse("<Idle|MPos:1.000,2.000,3.000|FS:0,0>"), Status)


# --- in a job ----------------------------------------------------------------------------------------------


def sent(controller: FakeController, clock: FakeClock, lines, **job):
    told = []
    sender = Sender(
        SendJob("fake", lines, zero_confirmed=True, **job),
        opener=lambda name, baud: FakeLink(controller, clock),
        clock=clock,
        tell=lambda kind, text: told.append((kind, text)),
    )
    return sender.run(), told


LINES = ("G21G90G94", *(f"G1X{number}Y{number % 7}F600" for number in range(60)))


@pytest.mark.parametrize(("state", "rpm", "known"), [("Run", 8000, True), ("Run", 0, False), ("Door:1", 8000, True)])
def test_report_off_the_path_ends_the_job_unless_the_controller_moves_by_itself(state, rpm, known):
    clock = FakeClock()
    controller = FakeController(clock, line_s=0.05)
    report = f"<{state}|MPos:-60.000,-20.000,-10.000|FS:0,{rpm}>"
    controller.actions[20] = lambda: controller.say(report)
    outcome, _ = sent(controller, clock, LINES)
    assert outcome.position_known is known
    if state == "Run":
        assert outcome.kind == "failed" and outcome.error.code == "path-left"
        assert "\x18" in controller.realtime and len(controller.lines) < len(LINES)
    else:
        assert outcome.error is None or outcome.error.code != "path-left"


def test_path_that_is_not_known_is_told_once_and_the_job_goes_on():
    clock = FakeClock()
    controller = FakeController(clock)
    outcome, told = sent(controller, clock, (*LINES[:5], "G38.2Z-5F100", *LINES[5:]))
    assert outcome.done
    assert sum(kind == "warning" and "not compared" in text for kind, text in told) == 1


@pytest.mark.parametrize("lost", [1, 2])
def test_reset_that_is_lost_on_its_way_is_sent_again(lost):
    clock = FakeClock()
    controller = FakeController(clock)
    controller.on_line[7] = "error:20"
    reset, left = controller.reset, [lost]

    def deaf() -> None:
        if left[0]:
            left[0] -= 1
        else:
            reset()

    controller.reset = deaf
    outcome, _ = sent(controller, clock, LINES)
    assert outcome.position_known and controller.realtime.count("\x18") == lost + 1


def test_memory_of_the_path_does_not_grow_with_the_program():
    def most_bytes(count: int) -> int:
        path = PlannedPath([f"G1X{number}F{600 + number % 2}" for number in range(count)], Start.at_zero())
        tracemalloc.start()
        for sent in range(0, count, 50):
            path.read(sent)
            path.drop_planned_before(sent - 10, 16)
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return most

    few, many = most_bytes(1000), most_bytes(4000)
    assert many < few + 3000 * 8, (few, many)


SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59")
ENDS = ("M2", "M30", "M02", "G1X-4M30")
ZERO_MM, OTHER_MM = (-1.0, -2.0, 0.0), (0.0, 0.0, 0.0)
# Each leaves an offset behind that the program's end takes away, or a reset before it.
LEFT = {
    "tool length": ("G43.1Z1", "G1X-2F2000"),
    "G92": ("G92X0Y0Z0", "G1X-2F2000"),
    "both, in another system": ("G55", "G43.1Z1", "G92X0Y0Z0", "G1X-2F2000"),
}


@pytest.fixture
def shop(tmp_path) -> Workshop:
    workshop = Workshop(tmp_path)
    workshop.greet_nobody()
    for number, place in workshop.board.memory.places.items():
        if 54 <= number <= 59:
            place[:] = [54.0 - number, 0.0, 0.0]
    return workshop


def cut(shop: Workshop, *lines: str) -> str:
    outcome = shop.send(lines=("G21G90G94", *lines))
    assert outcome.kind == DONE, outcome.text
    return outcome.text


@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("system", SYSTEMS)
def test_a_program_in_any_work_system_may_end(shop, system, end):
    cut(shop, system, "G1X-3Y-3Z-1F2000", "X-2", "G4P.5", end)
    assert shop.board.axes.position_mm[1] == -3.0


@pytest.mark.parametrize("end", ["M2", "M30"])
@pytest.mark.parametrize("left", LEFT)
def test_an_offset_that_is_left_ends_with_the_program(shop, left, end):
    cut(shop, *LEFT[left], "G4P.5", end)


@pytest.mark.parametrize(
    ("line", "is_own"),
    [("M2", True), ("m030", True), ("M 3 0", True), ("T1M6", True)]
    + [(line, False) for line in ("G1X-2", "M20", "M3S200", "M300", "M62P1", "G1X2M5", "G0X30")],
)
def test_only_a_line_that_may_change_the_zero_excuses_a_change(line, is_own):
    watch = OffsetWatch(["G90", line], ZERO_MM)
    changed = watch.take(OTHER_MM, acknowledged=2, sent=2)
    assert changed == (None if is_own else (ZERO_MM, OTHER_MM))
