# SPDX-License-Identifier: LGPL-2.1-or-later
"""The threads of a sender go before other programs where the system permits it; where it does not nothing fails."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from CNCStepper.control.processes.thread_priority import SLICE_NS, go_first
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import read_private
from helpers.control.fake_controller import FakeServer

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="Linux's scheduler")
LIMIT_S = 20.0
LINES = [f"G1X{10 + number / 1000:.3f}F60" for number in range(4000)]
ASK = "from CNCStepper.control.processes.thread_priority import go_first; print(go_first())"
SESSION_AND_SENDER_AND_JOURNAL = 3
CHILDS_POLICY = (sys.executable, "-c", "import os; print(os.sched_getscheduler(0))")


def policy(thread: int = 0) -> int:
    return os.sched_getscheduler(thread) & ~os.SCHED_RESET_ON_FORK


def in_a_thread(work):
    with ThreadPoolExecutor(1) as another:
        return another.submit(work).result()


def real_time(threads: Path) -> int:
    """Return how many of a process' threads are of real time."""
    return [policy(int(thread.name)) for thread in threads.iterdir()].count(os.SCHED_RR)


def slice_ns() -> int | None:
    """Return the slice of this thread, where this Linux tells it."""
    told = Path("/proc/thread-self/sched")
    lines = [line for line in told.read_text().splitlines() if line.startswith("se.slice")] if told.exists() else []
    return int(lines[0].split()[-1]) if lines else None


def test_only_the_thread_that_asks_is_of_real_time():
    def ask() -> tuple[str, int, int, int]:
        child = int(subprocess.run(CHILDS_POLICY, capture_output=True, check=True).stdout)
        return go_first(), policy(), in_a_thread(policy), child

    how, own, threads, childs = in_a_thread(ask)
    assert own == (os.SCHED_RR if how == "real time" else os.SCHED_OTHER)
    assert (threads, childs, policy()) == (os.SCHED_OTHER,) * 3


def test_where_real_time_is_refused_a_short_slice_is_asked_for(monkeypatch):
    def refuse(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr("os.sched_setscheduler", refuse)
    how, slice_now_ns = in_a_thread(lambda: (go_first(), slice_ns()))
    assert how in ("short slice", "neither")
    if how == "short slice" and slice_now_ns is not None:
        assert slice_now_ns == SLICE_NS


def test_nothing_is_asked_of_a_processor_whose_system_calls_are_not_known(monkeypatch):
    monkeypatch.setattr("os.sched_setscheduler", lambda *_: (_ for _ in ()).throw(PermissionError()))
    monkeypatch.setattr("platform.machine", lambda: "vax")
    assert in_a_thread(go_first) == "neither"


def test_no_real_time_where_the_system_would_kill_a_thread_for_using_it_long(monkeypatch):
    monkeypatch.setattr("resource.getrlimit", lambda limit: (200_000, 200_000))
    how, own = in_a_thread(lambda: (go_first(), policy()))
    assert how != "real time" and own == os.SCHED_OTHER


@pytest.mark.slow
def test_sender_session_and_journal_are_of_real_time_where_it_is_permitted(tmp_path):
    asked = subprocess.run([sys.executable, "-c", ASK], capture_output=True, check=True, text=True).stdout.strip()
    wanted = SESSION_AND_SENDER_AND_JOURNAL if asked == "real time" else 0
    with FakeServer(line_s=0.03) as server:
        job = SendJob(server.url, LINES, zero_confirmed=True)
        client = SessionClient.start(job, python=sys.executable, folder=tmp_path)
        try:
            threads = Path(f"/proc/{read_private(client.session_file)['process']}/task")
            end_s = time.monotonic() + LIMIT_S
            while client.status().acknowledged < 100 or real_time(threads) < wanted:
                assert time.monotonic() < end_s and client.outcome is None, (asked, real_time(threads))
            assert real_time(threads) == wanted
        finally:
            client.stop()
            client.wait(limit_s=LIMIT_S)
