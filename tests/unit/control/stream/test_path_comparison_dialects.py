# SPDX-License-Identifier: LGPL-2.1-or-later
"""Positions are compared with the path in the language of the controller that answers, not only in grbl's."""

from __future__ import annotations

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.stream.path_comparison import held_modes
from CNCStepper.control.stream.planned_path import PlannedPath
from CNCStepper.state import Start
from CNCStepper.virtual.grbl.firmware import FLUIDNC, GRBLHAL
from helpers.control.fake_controller import FakeClock, FakeController, FakeLink
from helpers.control.service_bench import Visit

NEAR_MM = (0.027, 0.027, 0.007)
DRILLING = (
    *("G21G90G94G17", "G59.1", "G0X-1", "G98G81X-2Y-1Z-2R-1F600", "X-4", "G99X-6", "G82X-7Z-2R-1P0.1"),
    *("G83X-8Z-3R-1Q0.5", "G73X-9Z-3R-1Q0.4", "G91X-1L2", "G90G80", "G0Z2", "G43.1Z1", "G1X-9F1500"),
)


def unwatched(visit: Visit) -> list[str]:
    return [text for kind, text in visit.told if kind == "warning" and "not compared" in text]


def cut(visit: Visit, *lines: str, **job) -> None:
    """Send a job, and go on where it pauses."""

    def person():
        visit.job(*lines, **job)
        while not visit.outcomes:
            yield visit.at("paused", "idle", "alarm")
            if visit.phase == "paused":
                visit.ask("resume")
                yield visit.at("running", "finishing", "idle")
            else:
                yield 0.05

    visit.receive(person)


def test_what_grblhal_has_beyond_grbl_is_followed_to_its_end(tmp_path):
    visit = Visit(tmp_path, firmware=GRBLHAL)
    cut(visit, *DRILLING[:3], "T2M6", *DRILLING[3:], dialect="grblhal")
    assert not unwatched(visit) and visit.outcomes[0].done, visit.outcomes
    assert visit.table.x_mm() == pytest.approx(-9.0, abs=0.02)


def test_tool_number_that_grbl_refuses_is_followed_on_fluidnc(tmp_path):
    visit = Visit(tmp_path, firmware=FLUIDNC)
    cut(visit, "G21G90G94", "T300", "G1X-3F1500", dialect="fluidnc")
    assert not unwatched(visit) and visit.outcomes[0].done


@pytest.mark.parametrize(("sent", "read"), [(b"X-4\n", b"X-5\n"), (b"R-1F", b"R-0F"), (b"G0X-1", b"G0X-3")])
def test_byte_damaged_beside_a_drilling_cycle_is_seen(tmp_path, sent, read):
    visit = Visit(tmp_path, firmware=GRBLHAL)
    wire = visit.table._wire
    send = wire.send
    wire.send = lambda data: send(data.replace(sent, read))
    slow = tuple(line.replace("F600", "F100") for line in DRILLING)
    cut(visit, *slow, dialect="grblhal")
    assert visit.outcomes[0].error.code == "path-left", visit.outcomes


def test_retract_mode_is_the_one_that_the_controller_holds():
    lines = ("G21G90G94G17", "G81X5Z-3R-1F300", "X9")
    for held, height_mm in (("G98", 0.0), ("G99", -1.0)):
        path = PlannedPath(lines, Start.at_zero(), [held], dialect="grblhal")
        path.read(3)
        assert path.end_mm == (9.0, 0.0, height_mm)


def test_hole_whose_depth_nobody_told_is_not_followed():
    held = held_modes({}, "G81 G54 G17 G21 G90 G94 G49 G98 F300")
    path = PlannedPath(("X9",), Start.at_zero(), held, dialect="grblhal")
    path.read(1)
    assert path.refused and path.lost_at == 0


def test_holes_that_a_controller_may_still_have_to_drill_are_kept_however_it_pecks():
    lines = ("G21G90G94G17", "G99G83X1Z-9R-1Q0.5F300", *(f"X{number}" for number in range(2, 12)))
    path = PlannedPath(lines, Start.at_zero(), dialect="grblhal")
    path.read(len(lines))
    path.drop_planned_before(len(lines), 11)
    assert path.drop_to((1.0, 0.0, -5.0), NEAR_MM) and path.line == 1
    assert path.drop_to((1.0, 0.0, -3.0), NEAR_MM)  # G83 goes back to R, G73 does not


def test_lines_that_go_nowhere_push_nothing_out_of_the_planner():
    path = PlannedPath(("G21G90G94", "G1X10F60", *["G1X10"] * 60), Start.at_zero())
    path.read(62)
    path.drop_planned_before(62, 27)
    assert path.drop_to((5.0, 0.0, 0.0), NEAR_MM)


def test_line_that_cannot_be_followed_is_named_as_the_job_has_it():
    clock = FakeClock()
    told: list[tuple[str, str]] = []
    lines = ("G21G90G94", "G1X1F600", "G7X3", "X4")
    sender = Sender(
        SendJob("fake", lines, zero_confirmed=True, file="peça 1.nc", file_lines=(1, 4, 7, 8)),
        opener=lambda name, baud: FakeLink(FakeController(clock), clock),
        clock=clock,
        tell=lambda kind, text: told.append((kind, text)),
    )
    assert sender.run().done
    assert ["peça 1.nc:7" in text for kind, text in told if "not compared" in text] == [True]
