# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process of a controller and the link to it: start, refusals, answers in time, its end, and its being killed."""

from __future__ import annotations

import json
import os
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from CNCStepper.control.transport import controller_link
from CNCStepper.control.transport.link import Link, open_link
from CNCStepper.errors import JobError, LinkError
from CNCStepper.workers.controller import Inbox

TESTS = Path(__file__).resolve().parents[2]
LIMIT_S = 60.0


@pytest.fixture(autouse=True)
def fake_process(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(controller_link, "MODULE", "helpers.controllers.served_fake")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(TESTS), os.environ.get("PYTHONPATH", "")]))


@pytest.fixture
def told(tmp_path: Path) -> Path:
    return tmp_path / "told.json"


@pytest.fixture
def link(told: Path) -> Iterator[Link]:
    opened = open_link(str(told), machine="thesis-table")
    assert _until(opened, b"help]\r\n").endswith(b"Grbl 1.1h ['$' for help]\r\n")
    yield opened
    opened.close()


def _until(link: Link, end: bytes) -> bytes:
    said, end_s = b"", time.monotonic() + LIMIT_S
    while end not in said:
        assert time.monotonic() < end_s, said
        said += link.read(0.1)
    return said


def _ask(link: Link, line: bytes) -> bytes:
    link.write(line + b"\n")
    return _until(link, b"ok\r\n")


def test_lines_are_answered_and_moves_are_made(link: Link, told: Path) -> None:
    assert b"[FIRMWARE:CNCStepper parport]" in _ask(link, b"$I")
    _ask(link, b"G21G90G1X2F1800")
    while b"<Idle" not in (said := _asked_status(link)):
        time.sleep(0.02)
    assert b"MPos:2.000,0.000,0.000" in said
    link.close()
    assert json.loads(told.read_text("utf-8"))["place"] == [80, 0, 0]


def _asked_status(link: Link) -> bytes:
    link.write(b"?")
    return _until(link, b">\r\n")


def test_a_status_is_answered_at_once(link: Link) -> None:
    _ask(link, b"G21G91G1X30F900")
    waits_s = []
    for _ in range(40):
        begin_s = time.monotonic()
        _asked_status(link)
        waits_s.append(time.monotonic() - begin_s)
        time.sleep(0.01)
    print(f"answers after {[round(1000 * wait_s, 1) for wait_s in sorted(waits_s)]} ms")
    assert sorted(waits_s)[20] < 0.005


def test_the_end_of_the_link_brakes_and_switches_off(link: Link, told: Path) -> None:
    _ask(link, b"M8")
    _ask(link, b"G21G90G1X90F1800")
    time.sleep(1.0)
    link.close()
    end = json.loads(told.read_text("utf-8"))
    assert end["commands"][0] == "hold" and "stop_at_once" not in end["commands"]
    assert not end["moving"] and end["on"] == []
    assert 400 < end["place"][0] < 3600


def test_a_polite_signal_brakes_too(link: Link, told: Path) -> None:
    _ask(link, b"G21G90G1X90F1800")
    time.sleep(0.5)
    link._port._process.send_signal(signal.SIGTERM)
    with pytest.raises(LinkError) as lost:
        _until(link, b"never")
    assert lost.value.code == "link-lost"
    assert not json.loads(told.read_text("utf-8"))["moving"]


def test_a_signal_ends_the_input_whatever_its_reader_is_at() -> None:
    """A signal's handler runs between any two instructions of the loop: it must not wait for a lock that it holds."""
    read, write = os.pipe()
    inbox = Inbox(read)
    ended = threading.Thread(target=inbox.close, daemon=True)
    with inbox._arrived._cond, inbox._lock:
        ended.start()
        ended.join(5.0)
        assert not ended.is_alive() and inbox.closed
    os.close(write)


def test_a_killed_process_is_a_lost_link(link: Link) -> None:
    link._port._process.kill()
    begin_s = time.monotonic()
    with pytest.raises(LinkError) as lost:
        _until(link, b"never")
    assert lost.value.code == "link-lost" and time.monotonic() - begin_s < 5.0


def test_nothing_that_is_written_waits(link: Link) -> None:
    link.write(b"$$\n")
    time.sleep(0.01)
    assert link.waiting_bytes() == 0


def test_wake_ends_a_read(link: Link) -> None:
    link.wake()
    begin_s = time.monotonic()
    assert link.read(5.0) == b"" and link.woken and time.monotonic() - begin_s < 1.0


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="this system has no /proc")
def test_an_idle_controller_leaves_the_processor_alone(link: Link) -> None:
    ticks = _processor_s(link)
    time.sleep(2.0)
    share = (_processor_s(link) - ticks) / 2.0
    print(f"{100 * share:.1f} % of a core")
    assert share < 0.05


def _processor_s(link: Link) -> float:
    fields = Path(f"/proc/{link._port._process.pid}/stat").read_text("utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def test_a_port_that_cannot_be_had_is_refused_in_its_own_words() -> None:
    with pytest.raises(LinkError) as refused:
        open_link("missing", machine="thesis-table")
    assert refused.value.code == "port-missing" and refused.value.advice == "plug it in"


def test_a_profile_that_is_not_there_is_refused() -> None:
    with pytest.raises(JobError) as refused:
        open_link("missing", machine="no-such-table")
    assert refused.value.code == "machine-missing"


def test_a_process_that_ends_at_its_start_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(controller_link, "MODULE", "helpers.no_such_module")
    with pytest.raises(LinkError) as refused:
        open_link("missing", machine="thesis-table")
    assert refused.value.code == "controller-start"


def test_a_machine_with_a_controller_is_opened_as_a_serial_port() -> None:
    with pytest.raises(LinkError) as refused:
        open_link("/dev/no-such-port", machine="table-a")
    assert refused.value.code == "port-missing"
