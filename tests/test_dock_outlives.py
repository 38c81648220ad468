# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cut outlives its window: killed, closed with the cut kept or stopped, closed without one; nothing stays behind."""

from __future__ import annotations

import subprocess
import time
import uuid
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.service.connection_client import ConnectionClient, running_services
from window_helpers import start_window

HELPERS = Path(start_window.__file__).parent
START_S, END_S = 120.0, 30.0
pytestmark = [pytest.mark.freecad, pytest.mark.slow]


def wait(condition: Callable[[], object], seconds: float, what: str) -> None:
    until_s = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < until_s, f"waited {seconds} s in vain for {what}"
        time.sleep(0.05)


@pytest.fixture
def mark() -> Iterator[str]:
    name = uuid.uuid4().hex
    yield name
    start_window.end_all(name)


@pytest.fixture
def display() -> Iterator[str]:
    with start_window.screen() as name:
        yield name


def window(display: str, mark: str, folder: Path, end: str) -> subprocess.Popen[bytes]:
    """Start FreeCAD and wait until it cuts (or is connected, for "idle")."""
    start_window.make_home(folder / "home")
    variables = {"CNCSTEPPER_END": end, "CNCSTEPPER_FOLDER": str(folder), "XDG_STATE_HOME": str(folder / "state")}
    freecad = start_window.start("host", display, folder / "home", HELPERS / "cut_and_end.py", variables, mark)
    wait(lambda: (folder / "cutting").exists() or freecad.poll() is not None, START_S, "the cut to begin")
    return freecad


def services(folder: Path) -> list[Path]:
    return running_services(folder / "state" / "cncstepper" / "sessions")


def goes_on(folder: Path) -> ConnectionClient:
    """Return a client of the service that was left, after more of its job has been cut."""
    [session_file] = services(folder)
    client = ConnectionClient.attach(session_file)
    wait(lambda: client.poll() is not None and client.phase == "connected", 10, "the service")
    before = client.status.acknowledged
    wait(lambda: client.poll() is not None and client.status.acknowledged > before + 3, 20, "the cut to go on")
    return client


def stop(client: ConnectionClient) -> None:
    client.stop()
    wait(lambda: client.poll() is not None and client.outcome, 20, "the stop")
    assert client.outcome.kind == "stopped" and client.outcome.position_known
    client.leave()


def test_a_killed_freecad_does_not_stop_the_cut(display: str, mark: str, tmp_path: Path) -> None:
    freecad = window(display, mark, tmp_path, "killed")
    freecad.kill()
    freecad.wait()
    stop(goes_on(tmp_path))
    assert start_window.wait_until_gone(mark, END_S) == {}


def test_keep_cutting_and_close(display: str, mark: str, tmp_path: Path) -> None:
    assert window(display, mark, tmp_path, "keep").wait(END_S) == 0
    stop(goes_on(tmp_path))
    assert start_window.wait_until_gone(mark, END_S) == {}


def test_stop_the_cut_and_close(display: str, mark: str, tmp_path: Path) -> None:
    assert window(display, mark, tmp_path, "stop").wait(END_S) == 0
    assert start_window.wait_until_gone(mark, END_S) == {}
    assert services(tmp_path) == []


def test_without_a_job_nothing_is_asked_and_nothing_stays(display: str, mark: str, tmp_path: Path) -> None:
    assert window(display, mark, tmp_path, "idle").wait(END_S) == 0
    assert start_window.wait_until_gone(mark, END_S) == {}
