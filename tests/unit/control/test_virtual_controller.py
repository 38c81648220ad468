# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender against the virtual grbl, each in a process of its own, over TCP and over a pseudo-terminal."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.status import DONE, REFUSED, STOPPED
from CNCStepper.machine.profile import load_machine
from helpers.control.virtual_process import virtual_grbl

LIMIT_S = 60.0
PROGRAM = [
    "G21G90G94G17",
    "M3S10000",
    *(f"G1X{-0.5 * (number % 40):.1f}Y{-0.25 * (number % 17):.2f}F3000" for number in range(300)),
    "G10L20P1X5",
    "M0",
    "G0X5Y0",
    "M5",
    "M2",
]


def started(port: str, folder: Path, lines=PROGRAM) -> SessionClient:
    expected = expected_settings(load_machine("table-a"))
    job = SendJob(port, lines, zero_confirmed=True, expected=expected)
    return SessionClient.start(job, python=sys.executable, folder=folder)


def resume_at_pauses(client: SessionClient):
    """Wait for the end, going on at every pause; return the outcome and the phases passed."""
    phases = []

    def follow(kind: str, text: str) -> None:
        if kind == "phase":
            phases.append(text)
            if text == "paused":
                client.resume()

    return client.wait(on_event=follow, limit_s=LIMIT_S), phases


@pytest.fixture(scope="module")
def table():
    """One virtual table for the tests that do not mind what the test before left."""
    with virtual_grbl(speed=5.0) as address:
        yield address


def judge_whole_program(address: str, folder: Path) -> None:
    outcome, phases = resume_at_pauses(started(address, folder))
    assert outcome.kind == DONE, outcome.text
    assert outcome.status.sent == outcome.status.acknowledged == len(PROGRAM)
    assert outcome.status.machine_state == "Idle"
    assert outcome.status.wpos_mm == pytest.approx((5, 0, 0), abs=0.013)
    assert phases == ["running", "paused", "running", "finishing", "done"]


@pytest.mark.slow
def test_program_is_cut_to_its_end_over_a_terminal(tmp_path):
    with virtual_grbl("pty", tmp_path / "table") as address:
        judge_whole_program(address, tmp_path)


@pytest.mark.slow
def test_program_is_cut_to_its_end_over_tcp(tmp_path):
    with virtual_grbl() as address:
        judge_whole_program(address, tmp_path)


@pytest.mark.slow
def test_stop_in_motion_keeps_the_position(tmp_path, table):
    zero = ["G21G90G94", "G10L20P1X0Y0Z0", "M3S9000"]
    client = started(table, tmp_path, [*zero, "G1X-100F3000", "G1X0", "M2"])
    while client.status().machine_state != "Run" or client.status().wpos_mm[0] > -3:
        time.sleep(0.01)
    client.stop()
    outcome = client.wait(limit_s=LIMIT_S)
    assert outcome.kind == STOPPED and outcome.position_known
    assert outcome.status.machine_state == "Idle" and outcome.status.spindle_rpm == 0
    assert -100 < outcome.status.wpos_mm[0] < -3
    again = started(table, tmp_path, ["G4P0.01"]).wait(limit_s=LIMIT_S)
    assert again.done and again.status.mpos_mm == outcome.status.mpos_mm


@pytest.mark.slow
def test_hold_and_resume_in_motion_end_at_the_same_place(tmp_path, table):
    client = started(table, tmp_path, ["G21G90G94", "G10L20P1X0Y0Z0", "G1X-40F3000", "G1X-10Y-5", "M2"])
    while client.status().machine_state != "Run":
        time.sleep(0.01)
    client.hold()
    while client.status().machine_state != "Hold:0":
        time.sleep(0.01)
    client.resume()
    outcome = client.wait(limit_s=LIMIT_S)
    assert outcome.done and outcome.status.wpos_mm == pytest.approx((-10, -5, 0), abs=0.013)


@pytest.mark.slow
def test_line_that_the_machine_refuses_is_named(tmp_path, table):
    lines = ["G21G90G94", "G10L20P1X0Y0Z0", "G1X-1F600", "G1X-2", "G2X0Y0I3J9", "G1X-4"]
    outcome = started(table, tmp_path, lines).wait(limit_s=LIMIT_S)
    assert outcome.error.code == "grbl-error-33" and outcome.error.place.line == 5
    assert outcome.position_known and outcome.status.machine_state == "Idle"


@pytest.mark.slow
def test_locked_machine_is_refused(tmp_path):
    with virtual_grbl(homing=True) as address:
        outcome = started(address, tmp_path).wait(limit_s=LIMIT_S)
    assert outcome.kind == REFUSED and outcome.error.code == "machine-alarm" and "$H" in outcome.text
