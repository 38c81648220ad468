# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender with its job, its zero and its jogs at the mini-lathe's controller, and the virtual lathe behind it."""

from __future__ import annotations

import re

import pytest

from CNCStepper.control.operator.zero_and_unlock import set_zero
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import handshake
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE, REFUSED, STOPPED
from helpers.controllers.lathe_link import LatheLink, sent

PUBLISHED = "N30 G01X-1. F1. # N40 Z-5. # N50 X5000 Z5. F2.0 #\nG00 X-.5 #\nM02 #\n"


def test_a_job_is_cut_to_its_end_on_its_path() -> None:
    told: list[str] = []
    link, outcome = sent(PUBLISHED, told)
    judge = link.bench.judge
    assert outcome.kind == DONE, outcome.text
    assert judge.mm == (-1.0, 0.0) and judge.faults == [] and judge.sent.endswith(b"M02#?")
    assert not any("not compared with the path" in text for text in told), told
    assert any("automatic mode" in text for text in told)


def test_the_progress_of_a_job_is_that_of_the_lathe_and_not_of_the_link() -> None:
    seen: list[tuple[float, int, float]] = []

    def look(time_s: float, sender: Sender) -> None:
        status = sender.status()
        seen.append((time_s, status.acknowledged, status.done))

    _, outcome = sent("G01 Z-5. F1. #\n" + "Z5. #\nZ-5. #\n" * 4, [], look)
    assert outcome.kind == DONE
    halfway = [done for _, acknowledged, done in seen if acknowledged == 9]
    assert min(halfway) <= 1 / 9 + 1e-9 and len({round(done * 9) for done in halfway}) > 5


def test_a_stop_sends_nothing_more_and_says_that_the_lathe_runs_on() -> None:
    told: list[str] = []
    stopped: list[float] = []

    def stop(time_s: float, sender: Sender) -> None:
        if time_s > 3.0 and not stopped:
            stopped.append(time_s)
            sender.stop()

    link, outcome = sent("G01 Z-1. F1. # Z-1. # Z-1. #\n" * 10, told, stop)
    assert outcome.kind == STOPPED and stopped
    assert any("the lathe cannot be stopped over its link: it runs on for" in text for text in told)
    x, z = link.bench.judge.mm
    link.bench.wait(5.0)
    assert link.bench.judge.mm == (x, z) and -7.0 < z < -2.0
    assert link.bench.board.places_mm[2] == pytest.approx(z)


def test_an_outcome_says_how_long_a_long_cut_still_takes() -> None:
    told: list[str] = []
    asked: list[float] = []

    def stop(time_s: float, sender: Sender) -> None:
        if time_s > 3.0 and not asked:
            asked.append(time_s)
            sender.stop()

    link, outcome = sent("G01 Z-60. F1. #\nG01 Z60. F1. #\n", told, stop)
    left_s = 60.0 - (link.clock() - link.begin_s)
    assert outcome.kind == STOPPED and not outcome.position_known and 20.0 < left_s < 50.0
    found = re.search(r"cannot be stopped.*it runs on for (\d+) s", outcome.text)
    assert found and float(found[1]) == pytest.approx(left_s, abs=3.0), outcome.text
    link.bench.board.come_to_rest()
    assert link.bench.judge.mm == (0.0, -60.0) and b"Z60" not in link.bench.judge.sent


def test_another_language_is_refused_before_the_first_byte() -> None:
    told: list[str] = []
    link = LatheLink()
    job = SendJob("lathe", ["G1X1F100"], zero_confirmed=True, dialect="grbl")
    sender = Sender(job, opener=lambda name, baud: link, clock=link.clock)
    outcome = sender.run()
    assert outcome.kind == REFUSED and outcome.error and outcome.error.code == "dialect-differs" and not told
    assert link.bench.judge.sent == b""


def test_the_zero_of_both_axes_is_set_by_hand_and_read_back() -> None:
    link = LatheLink()
    link.bench.send("$J=G91X-2F120\n$J=G91Z3F120\n", 4.0)
    driver = Grbl(link, link.clock)  # type: ignore[arg-type]
    assert handshake(driver, Timing()).firmware.key == "lathe"
    assert {"hold", "stop", "override", "resume"} <= driver.cannot
    assert set_zero(driver, "XYZ", Timing()) == "G54"
    assert driver.wpos_mm == (0.0, 0.0, 0.0) and driver.mpos_mm == pytest.approx((-2.0, 0.0, 3.0))
