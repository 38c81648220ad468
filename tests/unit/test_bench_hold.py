# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark of holds ends with a sentence where what it waits for does not come."""

from __future__ import annotations

import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from CNCStepper.control.session.status import REFUSED, Outcome, SenderStatus

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals")


@pytest.fixture
def bench(monkeypatch):
    monkeypatch.syspath_prepend(str(Path(__file__).parents[2] / "bench"))
    import bench_hold

    monkeypatch.setattr(bench_hold, "WAIT_LIMIT_S", 0.05)
    return bench_hold


def window(bench, monkeypatch, **of_client):
    silent = {"phase": "connected", "status": SenderStatus(), "outcome": None, "error": None, "poll": list}
    client = SimpleNamespace(**silent | of_client)
    monkeypatch.setattr(bench.ConnectionClient, "launch", lambda *_: client)
    return bench.Window("port", 115_200, Path(), SimpleNamespace(poll=lambda: False), lambda: None)


def test_job_that_ended_is_not_waited_for(bench, monkeypatch):
    outcome = Outcome(REFUSED, "the machine's position is unknown", False, SenderStatus(phase=REFUSED))
    with pytest.raises(bench.BenchError, match="the job ended: the machine's position is unknown"):
        window(bench, monkeypatch, outcome=outcome).hold()


def test_service_that_ended_is_not_waited_for(bench, monkeypatch):
    with pytest.raises(bench.BenchError, match="the service ended: the link broke"):
        window(bench, monkeypatch, phase="gone", error="the link broke").hold()


def test_byte_that_does_not_come_is_not_waited_for(bench, monkeypatch):
    monkeypatch.setattr(bench, "FULL_S", 0.0)
    running = SenderStatus(phase="running")
    with pytest.raises(bench.BenchError, match=r"the byte of the hold did not come within 0\.05 s"):
        window(bench, monkeypatch, status=running, hold=lambda: None).hold()
