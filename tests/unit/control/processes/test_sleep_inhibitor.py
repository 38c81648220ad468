# SPDX-License-Identifier: LGPL-2.1-or-later
"""The computer is kept awake for the time of a job, and told once where it cannot be."""

from __future__ import annotations

import subprocess
import sys

import pytest

from CNCStepper.control.processes import sleep_inhibitor as module
from CNCStepper.control.processes.sleep_inhibitor import CONTINUOUS, SYSTEM_REQUIRED, inhibit_sleep

KEEPER = (sys.executable, "-c", "import sys; sys.stdin.read()")
REFUSED = (sys.executable, "-c", "raise SystemExit(1)")


@pytest.fixture
def children(monkeypatch):
    made = []

    class Child(subprocess.Popen):
        def __init__(self, *arguments, **options):
            super().__init__(*arguments, **options)
            made.append(self)

    monkeypatch.setattr(module.subprocess, "Popen", Child)
    return made


@pytest.mark.parametrize("platform", ["linux", "darwin"])
def test_child_holds_the_lock_as_long_as_the_job_runs(monkeypatch, children, platform):
    monkeypatch.setitem(module.KEEPERS, platform, KEEPER)
    warned = []
    with inhibit_sleep(warned.append, platform):
        assert children[0].poll() is None
    assert children[0].poll() is not None and not warned


def test_lock_is_released_when_the_job_fails(monkeypatch, children):
    monkeypatch.setitem(module.KEEPERS, "linux", KEEPER)
    with pytest.raises(KeyError), inhibit_sleep(lambda text: None, "linux"):
        raise KeyError
    assert children[0].poll() is not None


def test_computer_that_refuses_is_told_once_and_the_job_runs(monkeypatch):
    monkeypatch.setattr(module, "SETTLED_S", 30.0)
    for keeper in (REFUSED, ("no such program, we hope",)):
        monkeypatch.setitem(module.KEEPERS, "linux", keeper)
        warned, ran = [], []
        with inhibit_sleep(warned.append, "linux"):
            ran.append(True)
        assert ran and len(warned) == 1 and "may fall asleep" in warned[0]


def test_unknown_system_is_told():
    warned = []
    with inhibit_sleep(warned.append, "sunos5"):
        pass
    assert len(warned) == 1


@pytest.mark.parametrize("granted", [True, False])
def test_windows_is_asked_and_told_when_it_is_over(granted):
    asked, warned = [], []

    class Kernel:
        def SetThreadExecutionState(self, state):
            asked.append(state)
            return granted

    with module._inhibit_on_windows(warned.append, Kernel()):
        assert asked == [CONTINUOUS | SYSTEM_REQUIRED]
    assert asked[-1] == CONTINUOUS and bool(warned) != granted
