# SPDX-License-Identifier: LGPL-2.1-or-later
"""`hold` and `stop` reach a job whose process is flooded with connections, or whose controller floods messages."""

from __future__ import annotations

import json
import selectors
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import read_private, running_services, sessions
from CNCStepper.control.session.local_socket import LOOPBACK, TRANSPORT, Address
from CNCStepper.control.session.server import UNAUTHENTICATED_LIMIT
from CNCStepper.control.session.status import STOPPED
from helpers.cli.command_line import called, command, forked
from helpers.cli.running_send import attached, being_sent

PROGRAM = "G21 G90\nG0 Z-2\n" + "".join(f"G1 X{-10 * (1 + number % 30)} F600\n" for number in range(300)) + "M2\n"
VIRTUAL = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--baud", "1000000")
NOBODY = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
LIMIT_S = 60.0
ANSWER_S = 2.0  # about one, on a computer that has other work too
MESSAGES, EVERY_S, FOR_S = 4, 0.1, 60.0  # 40 a second: with more the job ends by itself (`link-flood`)
MANY = 60  # of them

TRANSPORTS = [LOOPBACK, *(["unix"] if sys.platform != "win32" else [])]


@pytest.fixture(params=TRANSPORTS)
def transport(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state ç"))
    monkeypatch.setenv(TRANSPORT, request.param)
    return request.param


@contextmanager
def moving(folder: Path, *options: str | Path) -> Iterator[Address]:
    """A job that cuts, and the address of its process."""
    with being_sent(folder, PROGRAM, (*VIRTUAL, *options), pipes=NOBODY) as (sender, _):  # type: ignore[arg-type]
        with attached(sender) as client:
            while (client.status().mpos_mm or (0.0,))[0] > -1.0:
                assert client.outcome is None
                time.sleep(0.02)
        yield Address.of(read_private(sessions()[0]) or {})


def held_then_stopped() -> tuple[float, float]:
    """Hold the job and end it as a person does; return how long each took, s."""
    times_s = []
    for verb, said in (("hold", "held: "), ("stop", "stopped as asked")):
        begin_s = time.monotonic()
        result = called(verb)
        times_s.append(time.monotonic() - begin_s)
        assert result.returncode == 0 and said in result.stdout, (result.stdout[-500:], result.stderr[-500:])
    return times_s[0], times_s[1]


@contextmanager
def strangers(address: Address, count: int) -> Iterator[list[int]]:
    """Keep so many connections without a token open, each renewed at once; yield how many were opened."""
    opened, over = [0], threading.Event()

    def keep() -> None:
        with selectors.DefaultSelector() as waiting:
            while not over.is_set():
                for key, _ in waiting.select(0) if waiting.get_map() else []:
                    waiting.unregister(key.fileobj)
                    key.fileobj.close()  # type: ignore[union-attr]
                with suppress(OSError):
                    while len(waiting.get_map()) < count:
                        waiting.register(address.connect(1.0), selectors.EVENT_READ)
                        opened[0] += 1
                time.sleep(0.001)
            for key in list(waiting.get_map().values()):
                key.fileobj.close()  # type: ignore[union-attr]

    thread = threading.Thread(target=keep)
    thread.start()
    try:
        while opened[0] < count:
            time.sleep(0.01)
        yield opened
    finally:
        over.set()
        thread.join()


@pytest.mark.slow
def test_hold_and_stop_pass_connections_without_a_token(transport: str, tmp_path: Path) -> None:
    with moving(tmp_path) as address:
        assert bool(address.path) == (transport != LOOPBACK)
        with strangers(address, UNAUTHENTICATED_LIMIT + 40) as opened:
            times_s = held_then_stopped()
    assert max(times_s) < ANSWER_S, times_s
    assert opened[0] > 2 * UNAUTHENTICATED_LIMIT  # they were renewed
    assert not sessions()


@pytest.mark.slow
def test_hold_and_stop_pass_them_where_a_window_cuts(transport: str, tmp_path: Path) -> None:
    job = tmp_path / "job.json"
    write_job(job, SendJob("", PROGRAM.splitlines(), file="part.nc"))
    words = (*VIRTUAL, "--until-left")
    pipe = {"stdout": subprocess.PIPE, "encoding": "utf-8"}
    with subprocess.Popen(command(*words), preexec_fn=forked(*words), **pipe) as table:
        assert table.stdout
        try:
            window = ConnectionClient.launch(table.stdout.readline().rpartition(" ")[2].strip())
            until(window, lambda: window.phase == "connected")
            window.set_zero()
            window.run(job, zero_confirmed=True)
            until(window, lambda: window.status.phase == "running" and (window.status.mpos_mm or (0.0,))[0] < -1.0)
            address = Address.of(read_private(running_services()[0]) or {})
            assert bool(address.path) == (transport != LOOPBACK)
            with strangers(address, UNAUTHENTICATED_LIMIT + 40):
                times_s = held_then_stopped()
                until(window, lambda: window.outcome is not None)
            window.leave()
        finally:
            table.terminate()
    assert max(times_s) < ANSWER_S, times_s
    assert window.outcome and window.outcome.kind == STOPPED


def until(window: ConnectionClient, reached: Callable[[], bool]) -> None:
    end_s = time.monotonic() + LIMIT_S
    while not reached():
        assert time.monotonic() < end_s and window.error is None, (window.phase, window.error)
        window.poll()
        time.sleep(0.01)


@pytest.mark.slow
def test_hold_and_stop_pass_messages_that_flood(transport: str, tmp_path: Path) -> None:
    floods = [
        {"kind": "flood", "at_s": number * EVERY_S, "count": MESSAGES} for number in range(1, int(FOR_S / EVERY_S))
    ]
    plan = tmp_path / "flood.json"
    plan.write_text(json.dumps({"fault": floods}), "utf-8")
    with moving(tmp_path, "--faults", plan), SessionClient.attach(sessions()[0]) as unread:
        heard = 0
        while heard < MANY:
            heard += len([event for event in unread.poll(0.1) if event["event"] == "message"])
        times_s = held_then_stopped()
        assert unread.wait(limit_s=10.0).kind == STOPPED  # which has read nothing meanwhile
    assert max(times_s) < ANSWER_S, times_s
    assert not sessions()
