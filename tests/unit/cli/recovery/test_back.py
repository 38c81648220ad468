# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper back` as a newcomer types it, while `send` runs in a terminal of its own."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.program.send_job import write_job
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.session.files import read_private, sessions
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.job.make_certificate import send_job
from CNCStepper.machine.profile import load_machine
from CNCStepper.workers.path_retract import answered
from helpers.cli.command_line import called, command, forked
from helpers.cli.running_send import attached, being_sent

PROGRAM = "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG4 P3\nG1 Z-5 F300\nG1 X-390 F500\nG0 Z-2\nM5\nM2\n"
VIRTUAL = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "5")
STEP_MM = 0.02


@pytest.fixture
def sent(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[subprocess.Popen[str]]:
    """A program that is being sent to a virtual grbl, by a terminal at which somebody sits."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with being_sent(tmp_path, PROGRAM, VIRTUAL) as (sender, _):
        yield sender


def hold_in_cut(sent: subprocess.Popen[str]) -> None:
    """Hold the machine once the tool is well under way on the long cut."""
    with attached(sent) as client:
        while (client.status().mpos_mm or (0.0,))[0] > -10.0:
            assert client.outcome is None
            time.sleep(0.02)
        client.hold()
        while client.status().phase != "held":
            assert client.outcome is None
            time.sleep(0.02)


@pytest.mark.slow
def test_back_forward_and_resume_end_the_job(sent: subprocess.Popen[str]) -> None:
    hold_in_cut(sent)
    back = called("back", "--distance", "1")
    assert back.returncode == 0, back.stderr
    assert back.stdout.splitlines()[-1].startswith("retreated: line ")
    assert "give one of" in called("back", "--entry", "--resume").stderr
    assert called("back", "--forward", "0.5").returncode == 0
    assert "retreat-line" in called("back", "--line", "9").stderr
    dialogue = called("back", answer="b\nf\nr\n")
    assert "says no length or line" in dialogue.stderr
    assert dialogue.stdout.splitlines()[-1] == "the job goes on from here"
    assert sent.stdin and sent.stdout
    sent.stdin.write("\n")
    sent.stdin.close()
    assert "all 10 lines are cut" in sent.stdout.read()
    assert sent.wait(60) == 0


@pytest.mark.slow
def test_jog_while_it_is_held_and_resume_from_the_cut(sent: subprocess.Popen[str]) -> None:
    hold_in_cut(sent)
    port = (read_private(sessions()[0]) or {})["machine_port"]
    jogged = called("jog", "Z4", "--feed", "2000", "--port", port)
    assert jogged.returncode == 0 and " Z-1.000 " in jogged.stdout, jogged.stderr
    jogged = called("jog", "Y-3", "--feed", "2000", "--port", port)
    assert jogged.returncode == 0 and " Y-8.000 Z-1.000 " in jogged.stdout, jogged.stderr
    assert called("back", "--resume").returncode == 0
    refused = called("jog", "Z4", "--port", port)
    assert refused.returncode == 1 and "hold it first" in refused.stderr
    assert sent.stdin and sent.stdout
    sent.stdin.write("\n")
    sent.stdin.close()
    assert "all 10 lines are cut" in sent.stdout.read()
    assert sent.wait(60) == 0


@pytest.mark.slow
def test_without_a_session_it_says_what_to_do(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    refused = called("back", "--entry")
    assert refused.returncode == 1 and "cncstepper send" in refused.stderr
    assert sys.platform != "linux" or not list(tmp_path.rglob("*.session"))


@pytest.fixture
def service(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[ConnectionClient]:
    """A window's client of a service that cuts the program at a virtual grbl."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    machine = load_machine("table-a")
    job = send_job(prepare(PROGRAM, "grbl", "a part ç.nc"), machine, "a part ç.nc", None, "grbl")
    file = tmp_path / "send ç.json"
    write_job(file, job)
    pipe = {"stdout": subprocess.PIPE, "encoding": "utf-8"}
    with subprocess.Popen(command(*VIRTUAL), preexec_fn=forked(*VIRTUAL), **pipe) as table:
        assert table.stdout
        client = ConnectionClient.launch(table.stdout.readline().rpartition(" ")[2].strip())
        await_service(client, lambda: client.status.phase == "idle")
        client.set_zero()  # a machine that was just switched on
        client.run(file, zero_confirmed=True)
        await_service(client, lambda: (client.status.mpos_mm or (0.0,))[0] < -10.0)
        yield client
        client.stop()
        client.leave()
        table.terminate()


def await_service(client: ConnectionClient, reached: Callable[[], bool]) -> None:
    """Poll until it is reached, as a window does."""
    end_s = time.monotonic() + 60
    while not reached():
        assert time.monotonic() < end_s, (client.status, client.error)
        client.poll()
        assert client.phase != "gone", client.error
        time.sleep(0.02)


@pytest.mark.slow
def test_job_of_a_window_is_led_back_by_the_command_line_and_by_the_windows_process(service: ConnectionClient) -> None:
    back = called("back", "--distance", "1")
    assert back.returncode == 0, back.stderr
    assert back.stdout.splitlines()[-1].startswith("retreated: line 7")
    ask = {"service": str(service.session_file)}
    found = answered(ask | {"find": True})
    assert found == {"line": 7, "behind_mm": pytest.approx(1.0, abs=STEP_MM), "doubt": ""}
    assert answered(ask | {"line": 9})["refused"]["code"] == "retreat-line"
    assert answered(ask | {"forward_mm": 0.25})["behind_mm"] == pytest.approx(0.75, abs=STEP_MM)
    assert answered(ask | {"aside": True})["behind_mm"] == pytest.approx(0.75, abs=STEP_MM)
    assert answered(ask | {"resume": True}) == {"resumed": True}
    assert answered(ask | {"find": True})["refused"]["code"] == "not-held"
    await_service(service, lambda: service.status.phase == "running")
    service.stop()
    await_service(service, lambda: service.outcome is not None)
    assert "no job runs" in called("back", "--entry").stderr
    assert answered(ask | {"back_mm": 1.0})["refused"]["code"] == "not-held"
