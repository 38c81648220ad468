# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controllers that lie, flood or fall silent: said within 2 s, the job ends declared, and a stop is obeyed within 5 s.

The sender is a process of its own, as it is for people.
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.status import FAILED, REFUSED, STOPPED, Outcome
from CNCStepper.control.stream.retract_handover import write_leg
from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import load_machine
from CNCStepper.recovery.retract.retract_client import RetractClient
from helpers.control.hostile_controller import FAULTS, HostileController, HostileServer

TOLD_S, OBEYED_S = 2.0, 5.0
LIMIT_S = 20.0
BACK_MM = 0.03  # which takes longer than a stop may
LINES = [f"G1X{10 + number / 1000:.3f}F60" for number in range(4000)]
MOST_MB = 60.0  # that a flood may cost


@contextmanager
def sent(folder: Path, lines=LINES, port: str = "", **job) -> Iterator[tuple[HostileController, SessionClient]]:
    """A job that is sent to a hostile controller, by a sender in a process of its own."""
    with HostileServer(line_s=0.03) as server:
        job = {"zero_confirmed": True} | job
        client = SessionClient.start(SendJob(port or server.url, lines, **job), python=sys.executable, folder=folder)
        try:
            yield server.controller, client
        finally:
            client._process.kill()
            client._process.wait()
            client.close()


def await_phase(client: SessionClient, *phases: str) -> None:
    end_s = time.monotonic() + LIMIT_S
    while client.status().phase not in phases:
        assert time.monotonic() < end_s and client.outcome is None, client.status()
        time.sleep(0.01)


def outcome_of(client: SessionClient, limit_s: float) -> tuple[Outcome, float | None]:
    """Return how it ended, and after how long the first words of it came."""
    begin_s, told_s = time.monotonic(), []

    def on_message(kind: str, text: str) -> None:
        assert text.isprintable()
        if kind in ("warning", "message") or text.startswith(("stopping", "failed")):
            told_s.append(time.monotonic() - begin_s)

    outcome = client.wait(on_event=on_message, limit_s=limit_s)
    return outcome, told_s[0] if told_s else time.monotonic() - begin_s


def memory_mb(process: subprocess.Popen) -> float:
    status = Path(f"/proc/{process.pid}/status")
    if not status.exists():  # not on this system, or it has ended
        return 0.0
    lines = [line for line in status.read_text().splitlines() if line.startswith("VmHWM")]
    return int(lines[0].split()[1]) / 1000 if lines else 0.0


# --- faults in a job -----------------------------------------------------------------------------

# Of the faults, those with which the machine is still seen to stand before and after its reset.
SEEN_TO_STAND = (
    "wco",
    "damaged",
    "jump",
    "homing-state",
    "starting-state",
    "stray-ok",
    "ok",
    "messages",
    "statuses",
    "settings",
    "noise",
)
QUICK = ("statuses",)  # of the faults, those that every run of the tests sees
EACH_FAULT = [fault if fault in QUICK else pytest.param(fault, marks=pytest.mark.slow) for fault in FAULTS]


@pytest.mark.parametrize("fault", EACH_FAULT)
def test_a_fault_is_told_and_ends_the_job_declared(tmp_path, fault):
    with sent(tmp_path) as (controller, client):
        await_phase(client, "running")
        time.sleep(0.3)
        before_mb, most_mb = memory_mb(client._process), []
        client.poll()
        controller.fault = fault
        begin_s = time.monotonic()
        looking = threading.Thread(target=lambda: look(client._process, most_mb), daemon=True)
        looking.start()
        outcome, told_s = outcome_of(client, LIMIT_S)
        looking.join()
        assert told_s < TOLD_S, f"{told_s:.2f} s"
        assert outcome.kind == FAILED and outcome.error is not None, outcome.text
        assert len(outcome.text) < 1000 and outcome.text.isprintable()
        assert b"!" in controller.heard_since(begin_s) or b"\x18" in controller.heard_since(begin_s)
        if fault not in SEEN_TO_STAND:
            assert outcome.position_known is False, outcome.text
        assert not most_mb or max(most_mb) < before_mb + MOST_MB


def look(process: subprocess.Popen, most_mb: list[float]) -> None:
    while process.poll() is None:
        most_mb.append(memory_mb(process))
        time.sleep(0.05)


def test_a_zero_that_the_program_itself_changes_is_no_fault(tmp_path):
    lines = ["G1X10F600", "G92X5", "G1X6", "G55", "G1X7", "G54"]
    with sent(tmp_path, lines) as (controller, client):
        change = {1: -95.0, 3: -90.0, 5: -95.0}
        for line, zero_mm in change.items():
            controller.actions[line] = lambda zero_mm=zero_mm: controller.zero.__setitem__(0, zero_mm)
        outcome = client.wait(limit_s=LIMIT_S)
        assert outcome.error is None or outcome.error.code != "zero-changed"


# --- a stop in every state -----------------------------------------------------------------------


def running(controller: HostileController, client: SessionClient) -> None:
    await_phase(client, "running")


def held(controller: HostileController, client: SessionClient) -> None:
    running(controller, client)
    client.hold()
    await_phase(client, "held")


def paused(controller: HostileController, client: SessionClient) -> None:
    await_phase(client, "paused")


def turning_back(controller: HostileController, client: SessionClient) -> None:
    """Held, told a way back along the cut, and asked for its settings after the reset with which that begins."""
    held(controller, client)
    controller.answers_questions = False
    begin_s = time.monotonic()
    ask_way_back(client)
    await_heard(controller, b"$", begin_s)


def retracting(controller: HostileController, client: SessionClient) -> None:
    """On the way back along the cut."""
    held(controller, client)
    sent = len(controller.lines)
    ask_way_back(client)
    await_phase(client, "running")
    end_s = time.monotonic() + LIMIT_S
    while len(controller.lines) < sent + 2:
        assert time.monotonic() < end_s
        time.sleep(0.01)


def ask_way_back(client: SessionClient) -> None:
    place = RetractClient(client, load_machine("table-a")).held()
    leg = client.session_file.with_name("leg.zip")
    write_leg(leg, place.along(place.back_by(BACK_MM)))
    client.ask("retrace", file=str(leg))


def asked(begin: bytes) -> Callable[[HostileController, SessionClient], None]:
    """Return what waits until the controller was sent something."""

    def reach(controller: HostileController, client: SessionClient) -> None:
        await_heard(controller, begin, 0.0)

    return reach


def await_heard(controller: HostileController, data: bytes, begin_s: float) -> None:
    end_s = time.monotonic() + LIMIT_S
    while data not in controller.heard_since(begin_s):
        assert time.monotonic() < end_s
        time.sleep(0.01)


def deaf(controller: HostileController) -> None:
    controller.deaf = True


def unanswering(controller: HostileController) -> None:
    controller.answers_questions = False


def not_homing(controller: HostileController) -> None:
    controller.homes = False
    controller.state = "Alarm"


STATES = {  # of the sender: how it comes there, and what the job and the controller are like
    "greeting": (asked(b"?"), deaf, {}),
    "preflight": (asked(b"$"), unanswering, {}),
    "homing": (asked(b"$H"), not_homing, {"home_first": True}),
    "running": (running, None, {}),
    "held": (held, None, {}),
    "paused": (paused, None, {"lines": ["G1X10F600", "M0", *LINES]}),
    "turning back": (turning_back, None, {}),
    "retracting": (retracting, None, {}),
}
THEN = ("obeys", "deaf", "runs-on", "never-slower", "statuses", "ok", "noise", "long-number")
QUICK_STOPS = {("preflight", "obeys")}
PAIRS = 1 if "CNCSTEPPER_FAULT_RUNS" in os.environ else 2  # `make soak` tries all, else each state meets half of them
EACH_STOP = [
    pytest.param(state, then, marks=() if (state, then) in QUICK_STOPS else pytest.mark.slow)
    for row, state in enumerate(STATES, 1)
    for column, then in enumerate(THEN)
    if (state != "greeting" or then in ("deaf", "statuses", "noise")) and (row + column) % PAIRS == 0
]


@pytest.mark.skipif(os.name != "posix", reason="SIGTERM")
@pytest.mark.parametrize(("state", "then"), EACH_STOP)
def test_sigterm_is_obeyed_in_every_state(tmp_path, state, then):
    reach, prepare, job = STATES[state]
    with hostile(tmp_path, prepare, **job) as (controller, client):
        reach(controller, client)
        controller.deaf = then == "deaf"
        controller.fault = then if then != "obeys" else ""
        begin_s = time.monotonic()
        client._process.terminate()
        client._process.wait(LIMIT_S)
        took_s = time.monotonic() - begin_s
        assert took_s < OBEYED_S, f"{took_s:.2f} s"
        client.poll()
        outcome = client.outcome or SessionClient.attach(client.session_file).outcome
        begun = state not in ("greeting", "preflight", "homing")
        assert outcome.kind in (STOPPED, FAILED if begun else REFUSED), outcome.text
        if begun:
            assert b"\x18" in controller.heard_since(begin_s)
            assert outcome.position_known is (then == "obeys") or then in ("ok", "noise", "statuses"), outcome.text
        if state == "homing":
            assert b"\x18" in controller.heard_since(begin_s) and outcome.position_known is False


@contextmanager
def hostile(folder: Path, prepare, **job) -> Iterator[tuple[HostileController, SessionClient]]:
    """As `sent`, the controller being what it is from the beginning."""
    with HostileServer(line_s=0.03) as server:
        if prepare:
            prepare(server.controller)
        made = SendJob(server.url, job.pop("lines", LINES), zero_confirmed=True, **job)
        client = SessionClient.start(made, python=sys.executable, folder=folder)
        try:
            yield server.controller, client
        finally:
            client._process.kill()
            client._process.wait()
            client.close()


@pytest.mark.skipif(os.name != "posix", reason="SIGTERM")
def test_sigterm_is_obeyed_while_a_host_is_called(tmp_path):
    with socket.create_server(("127.0.0.1", 0), backlog=0) as listener:
        callers = [socket.socket() for _ in range(4)]
        for caller in callers:  # until nobody gets through any more
            caller.setblocking(False)
            caller.connect_ex(listener.getsockname())
        port = f"socket://127.0.0.1:{listener.getsockname()[1]}"
        job = SendJob(port, LINES, zero_confirmed=True)
        client = SessionClient.start(job, python=sys.executable, folder=tmp_path)
        time.sleep(0.3)
        begin_s = time.monotonic()
        client._process.terminate()
        client._process.wait(LIMIT_S)
        assert time.monotonic() - begin_s < 2.0  # the call itself goes on for 5 s
        client.poll()
        assert (client.outcome or SessionClient.attach(client.session_file).outcome).kind == STOPPED
        for caller in callers:
            caller.close()


SLOW_DISK = """
import os, sys, time
whole = os.fsync
def slow(descriptor):
    time.sleep(1.0)
    whole(descriptor)
os.fsync = slow
from CNCStepper.workers import sender
sys.exit(sender.main(sys.argv[1:]))
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="SIGTERM")
def test_a_slow_disk_delays_no_stop(tmp_path, monkeypatch):
    script = tmp_path / "slow_disk.py"
    script.write_text(SLOW_DISK)
    monkeypatch.setattr(
        "CNCStepper.control.session.detached_process.command",
        lambda python, module, *words: [python, str(script), *words],
    )
    with sent(tmp_path) as (controller, client):
        await_phase(client, "running")
        time.sleep(0.5)
        begin_s = time.monotonic()
        client._process.terminate()
        while b"\x18" not in controller.heard_since(begin_s):
            assert time.monotonic() - begin_s < OBEYED_S
            time.sleep(0.01)
        client._process.wait(LIMIT_S)
        assert client._process.returncode == 1


class BlockedLink:
    """A link whose port takes nothing any more as soon as `blocked` is set: each write fails after a second."""

    name, woken, queue_bytes, filling_bytes = "blocked", False, 40, 30

    def __init__(self, controller: HostileController):
        self.controller = controller
        self.blocked = False

    def read(self, wait_s: float) -> bytes:
        end_s = time.monotonic() + wait_s
        while not (said := self.controller.read()) and time.monotonic() < end_s:
            time.sleep(0.001)
        return said

    def write(self, data: bytes) -> None:
        if self.blocked:
            time.sleep(1.0)
            raise LinkError("link-lost", "the link broke: Write timeout")
        self.controller.write(data)

    def rest(self, wait_s: float) -> None:
        time.sleep(wait_s)

    def waiting_bytes(self) -> int:
        return 0

    def leaving_s(self, count: int) -> float:
        return 0.0

    def wake(self) -> None:
        pass

    def close(self) -> None:
        pass


def test_a_port_that_blocks_on_write_does_not_keep_a_stop():
    link = BlockedLink(HostileController(time.monotonic, line_s=0.01))
    sender = Sender(SendJob("blocked", LINES, zero_confirmed=True), opener=lambda port, baud: link)
    outcomes: list[Outcome] = []
    thread = threading.Thread(target=lambda: outcomes.append(sender.run()), daemon=True)
    thread.start()
    end_s = time.monotonic() + LIMIT_S
    while sender.status().phase != "running":
        assert time.monotonic() < end_s
        time.sleep(0.01)
    link.blocked = True
    sender.ask(Command("stop"))
    begin_s = time.monotonic()
    thread.join(LIMIT_S)
    assert time.monotonic() - begin_s < OBEYED_S
    assert outcomes[0].position_known is False
