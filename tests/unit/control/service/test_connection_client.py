# SPDX-License-Identifier: LGPL-2.1-or-later
"""A window's side of a service, each in a process of its own, at a virtual grbl that ends when it is left."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.processes import python_finder
from CNCStepper.control.processes.process_file import ProcessFile
from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service.connection_client import WORKER, ConnectionClient, running_services
from CNCStepper.control.session import detached_process
from CNCStepper.control.session.files import LOG, OUTCOME, SERVICE, new_session, service_at
from CNCStepper.control.session.status import DONE, STOPPED
from CNCStepper.control.transport.link import PortChoice, port_list
from CNCStepper.errors import CNCStepperError, MissingPackage
from helpers.control.fake_controller import FakeServer

LIMIT_S = 40.0
LONG = ("G21G90G94", *(f"G1X{-(number % 2) * 20}F1500" for number in range(400)))
SHORT = ("G21G90G94", "G1X-2F3000", "G1X0")


class Window:
    """A client, looked at again and again as a window's timer does it, with all that it heard."""

    def __init__(self, client: ConnectionClient):
        self.client = client
        self.events: list[dict] = []

    def look(self) -> None:
        self.events += self.client.poll()

    def until(self, reached: Callable[[], bool]) -> None:
        end_s = time.monotonic() + LIMIT_S
        while not reached():
            assert time.monotonic() < end_s, (self.client.phase, self.events[-5:])
            self.look()
            time.sleep(0.005)

    def until_phase(self, *phases: str) -> None:
        self.until(lambda: self.client.status.phase in phases)

    def heard(self, kind: str) -> list[str]:
        return [event["text"] for event in self.events if event["event"] == kind]


@pytest.fixture
def table() -> Iterator[str]:
    """Yield the port of a virtual grbl; it must end by itself once its service has gone."""
    words = ["-m", "CNCStepper.cli.main", "virtual", "grbl", "--tcp", "127.0.0.1:0", "--until-left"]
    with subprocess.Popen([sys.executable, *words], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        try:
            yield process.stdout.readline().split()[-1]
            assert process.wait(LIMIT_S) == 0
        finally:
            process.kill()


@pytest.fixture(autouse=True)
def _nothing_left(tmp_path):
    """No service of a test may outlive it."""
    yield
    end_s = time.monotonic() + LIMIT_S
    while [path for path in running_services(tmp_path) if process_of(path)]:
        assert time.monotonic() < end_s, "a service was left behind"
        time.sleep(0.05)


@pytest.fixture
def window(table, tmp_path) -> Iterator[Window]:
    """A window whose service is connected; it leaves in the end."""
    window = Window(ConnectionClient.launch(table, folder=tmp_path))
    window.until(lambda: window.client.phase == "connected")
    yield window
    window.client.stop()
    window.client.leave()


def job_file(folder: Path, lines: tuple[str, ...]) -> Path:
    path = folder / "a job ç.zip"
    write_job(path, SendJob("", lines, file="part ç.nc"))
    return path


def process_of(path: Path) -> int:
    try:
        return json.loads(path.read_text("utf-8")).get("process", 0)
    except FileNotFoundError:
        return 0


def ended(path: Path) -> bool:
    return not path.exists() and path.with_suffix(OUTCOME).exists()


@pytest.mark.slow
def test_launch_connects_runs_a_job_and_leaves_nothing(window, tmp_path):
    client = window.client
    assert running_services(tmp_path) == [client.session_file]
    if os.name == "posix":
        assert client.session_file.stat().st_mode & 0o777 == 0o600
    client.set_zero("XYZ")
    client.run(job_file(tmp_path, SHORT), zero_confirmed=True)
    assert client.outcome is None
    window.until(lambda: client.outcome is not None)
    assert client.outcome.kind == DONE and client.outcome.status.file == "part ç.nc"
    window.until_phase("idle")
    client.leave()
    assert client.phase == "gone" and client.error is None
    window.until(lambda: ended(client.session_file))
    assert client.session_file.with_suffix(LOG).read_text() == ""


@pytest.mark.slow
def test_everything_a_window_asks_reaches_the_machine(window):
    client = window.client
    client.jog(x_mm=-10.0, feed_mm_min=1500.0)
    window.until_phase("jogging")
    window.until_phase("idle")
    client.set_zero("XYZ")
    window.until(lambda: client.status.wpos_mm == (0, 0, 0) and bool(client.status.position_known))
    client.override("feed", -10)
    client.override("rapid", 50)
    window.until(lambda: client.status.overrides == (90, 50, 100))
    client.override("feed", "reset")
    window.until(lambda: client.status.overrides == (100, 50, 100))
    client.unlock()
    client.home()
    client.resume()
    client.hold()
    window.until(lambda: len(window.heard("refused")) == 4)
    refused = [event for event in window.events if event["event"] == "refused"]
    assert {event["command"] for event in refused} == {"unlock", "resume", "hold", "home"}
    assert all(isinstance(event["error"], CNCStepperError) for event in refused)


@pytest.mark.slow
def test_held_jog_stops_when_the_window_freezes_and_at_once_when_the_button_is_let_go(window):
    client = window.client
    end_s = time.monotonic() + 0.8
    while time.monotonic() < end_s:
        client.jog_on(x=-1.0, feed_mm_min=2000.0)
        window.look()
        time.sleep(0.05)
    window.until_phase("idle")  # frozen: nobody renews
    assert any("button" in text for text in window.heard("warning"))
    client.jog_cancel()
    client.jog_on(x=1.0, feed_mm_min=2000.0)
    window.until_phase("jogging")
    client.jog_cancel()
    window.until_phase("idle")
    assert sum("button" in text for text in window.heard("warning")) == 1


CLIENT = """
import sys, time
from pathlib import Path
from CNCStepper.control.service.connection_client import ConnectionClient
client = ConnectionClient.launch(sys.argv[1], folder=Path(sys.argv[2]))
while client.phase != "connected":
    client.poll(); time.sleep(0.01)
client.set_zero("XYZ")
client.run(Path(sys.argv[3]), zero_confirmed=True)
while client.status.phase != "running":
    client.poll(); time.sleep(0.01)
print(client.session_file, flush=True)
time.sleep(1000)
"""


@pytest.mark.slow
def test_killed_window_does_not_stop_the_cut_and_a_new_one_attaches(table, tmp_path):
    command = [sys.executable, "-c", CLIENT, table, str(tmp_path), str(job_file(tmp_path, LONG))]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as killed:
        assert killed.stdout
        session_file = Path(killed.stdout.readline().strip())
        killed.kill()
    assert running_services(tmp_path) == [session_file]
    window = Window(ConnectionClient.attach(session_file))
    window.until_phase("running")
    before = window.client.status.acknowledged
    assert window.client.port == table and window.client.status.file == "part ç.nc"
    window.until(lambda: window.client.status.acknowledged > before)
    window.client.stop()
    window.until(lambda: window.client.outcome is not None)
    assert window.client.outcome.kind == STOPPED and window.client.outcome.position_known
    told = [(event["text"], "past" in event) for event in window.events if event["event"] == "phase"]
    assert ("running", True) in told and ("stopped", False) in told
    window.client.leave()


@pytest.mark.slow
def test_second_launch_on_one_port_attaches_to_the_service_that_is_there(window, tmp_path):
    second = Window(ConnectionClient.launch(window.client.port, folder=tmp_path))
    second.until(lambda: second.client.phase == "connected")
    assert second.client.session_file == window.client.session_file
    window.client.detach()
    second.client.set_zero("XYZ")
    second.client.run(job_file(tmp_path, SHORT), zero_confirmed=True)
    second.until(lambda: second.client.outcome is not None)
    assert second.client.outcome.done
    second.client.leave()


@pytest.mark.slow
def test_two_services_started_at_one_moment_agree_on_one(window, tmp_path):
    path = new_session(tmp_path, SERVICE).with_name(f"99990101-000000-ff{SERVICE}")
    process = detached_process.start(sys.executable, WORKER, path, window.client.port, "115200")
    assert process.wait(LIMIT_S) == 1
    late = Window(ConnectionClient.attach(path))
    late.until(lambda: late.client.phase == "gone")
    assert late.client.error.code == "port-busy" and "in use" in str(late.client.error)
    window.look()
    assert window.client.phase == "connected"


def test_port_that_is_not_there_is_gone_with_its_sentence(tmp_path):
    window = Window(ConnectionClient.launch("/dev/no-such-port", folder=tmp_path))
    window.until(lambda: window.client.phase == "gone")
    assert window.client.error.code == "port-missing"
    assert window.heard("connection")[-1] == "gone" and window.client.poll() == []


@pytest.mark.slow
def test_controller_that_vanishes_is_gone_with_its_sentence(tmp_path):
    with FakeServer() as server:
        window = Window(ConnectionClient.launch(server.url, folder=tmp_path))
        window.until(lambda: window.client.phase == "connected")
    window.until(lambda: window.client.phase == "gone")
    assert window.client.error.code == "link-lost"


def test_without_a_python_the_launch_says_what_is_missing(monkeypatch, tmp_path):
    monkeypatch.setenv(python_finder.VARIABLE, str(tmp_path / "no python"))
    python_finder.find_python.cache_clear()
    try:
        window = Window(ConnectionClient.launch("/dev/ttyX", folder=tmp_path))
        window.until(lambda: window.client.phase == "gone")
    finally:
        python_finder.find_python.cache_clear()
    assert isinstance(window.client.error, MissingPackage)


def test_folder_that_cannot_be_written_is_said(tmp_path):
    window = Window(ConnectionClient.launch("/dev/ttyX", folder=tmp_path / "none"))
    window.until(lambda: window.client.phase == "gone")
    assert window.client.error.code == "service-start" and "none" in str(window.client.error)


@pytest.mark.slow
def test_killed_service_is_lost_with_its_position(table, tmp_path):
    window = Window(ConnectionClient.launch(table, folder=tmp_path))
    window.until(lambda: window.client.phase == "connected")
    os.kill(process_of(window.client.session_file), signal.SIGKILL)
    window.until(lambda: window.client.phase == "gone")
    assert window.client.error.code == "service-lost" and "position is unknown" in str(window.client.error)
    assert running_services(tmp_path) == []


@pytest.mark.slow
def test_sigterm_stops_the_job_safely(table, tmp_path):
    window = Window(ConnectionClient.launch(table, folder=tmp_path))
    window.until(lambda: window.client.phase == "connected")
    window.client.set_zero("XYZ")
    window.client.run(job_file(tmp_path, LONG), zero_confirmed=True)
    window.until_phase("running")
    os.kill(process_of(window.client.session_file), signal.SIGTERM)
    window.until(lambda: window.client.phase == "gone")
    assert window.client.outcome.kind == STOPPED and window.client.outcome.position_known
    assert window.client.error is None


@pytest.mark.slow
def test_no_call_waits_for_a_service_that_stands_still(window):
    """Stopped by SIGSTOP, a service takes nothing and answers nothing; a window must not notice in its drawing."""
    client, process = window.client, process_of(window.client.session_file)
    longest_s = 0.0
    os.kill(process, signal.SIGSTOP)
    try:
        begin_s = time.monotonic()
        for number in range(600):
            call = (client.poll, client.hold, client.jog, client.jog_cancel, client.unlock)[number % 5]
            before_s = time.monotonic()
            call()
            longest_s = max(longest_s, time.monotonic() - before_s)
        assert time.monotonic() - begin_s < 3.0
    finally:
        os.kill(process, signal.SIGCONT)
    assert longest_s < 0.1
    window.until(lambda: sum("not in alarm" in text for text in window.heard("refused")) == 120)


@pytest.mark.slow
def test_window_that_was_frozen_for_long_is_let_in_again(window):
    """The service drops a client that does not read; the client comes back by itself and sees the present."""
    window.client._socket.close()
    window.look()
    window.until(lambda: window.client.phase == "connected")
    window.client.jog(x_mm=-10.0)
    window.until_phase("jogging")
    window.until_phase("idle")


@pytest.mark.slow
def test_service_that_nobody_visits_ends_by_itself(table, tmp_path):
    window = Window(ConnectionClient.launch(table, folder=tmp_path))
    window.until(lambda: window.client.phase == "connected")
    begin_s = time.monotonic()
    window.client.detach()
    window.until(lambda: ended(window.client.session_file))
    assert 9.0 < time.monotonic() - begin_s < 20.0


def test_file_that_nobody_holds_is_no_running_service(tmp_path):
    path = new_session(tmp_path, SERVICE)
    owner = ProcessFile(path)
    owner.write({})
    assert running_services(tmp_path) == [path]
    owner._file.close()  # as when its process is killed
    assert running_services(tmp_path) == []
    client = ConnectionClient.attach(path)
    client.poll()
    assert client.phase == "gone" and client.error.code == "service-lost" and path.exists()
    new_session(tmp_path, SERVICE)
    assert not path.exists()


def test_service_is_found_by_its_port(tmp_path):
    path = tmp_path / f"a{SERVICE}"
    owner = ProcessFile(path)
    owner.write({"machine_port": "COM3"})
    (tmp_path / f"b{SERVICE}").write_text('{"machine_port": "COM4"}')  # of a killed one
    assert service_at("COM3", tmp_path) == path
    assert service_at("COM4", tmp_path) is None
    owner.remove()
    assert service_at("COM3", tmp_path) is None


def test_ports_are_named_for_people(monkeypatch):
    from CNCStepper.control.transport import link as module

    found = [("/dev/ttyACM0", "Arduino Uno"), ("/dev/ttyS0", "n/a"), ("COM3", "COM3")]
    monkeypatch.setattr(module, "port_names", lambda: found)
    assert port_list() == [
        PortChoice("/dev/ttyACM0", "/dev/ttyACM0 – Arduino Uno"),
        PortChoice("/dev/ttyS0", "/dev/ttyS0"),
        PortChoice("COM3", "COM3"),
    ]
