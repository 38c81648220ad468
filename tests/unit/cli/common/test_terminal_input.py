# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that are typed while other work goes on: each is heard once, whole, and in the thread that waits."""

from __future__ import annotations

import os
import sys
import threading
import time
from io import BytesIO, TextIOWrapper

import pytest

from CNCStepper.cli.common.terminal_input import TerminalInput

LIMIT_S = 30.0


def wait_for(typed: TerminalInput, heard: list[str], lines: list[str]) -> None:
    """Wait until these lines are heard; fails when they never are."""
    end_s = time.monotonic() + LIMIT_S
    while heard != lines and time.monotonic() < end_s:
        typed.wait(0.005)
    assert heard == lines


def test_lines_are_heard_whole_and_the_end_of_typing_is_no_hurry() -> None:
    here, there = os.pipe()
    heard: list[str] = []
    typed = TerminalInput(heard.append, here)
    os.write(there, b"!\n~ \r\n5")
    wait_for(typed, heard, ["!", "~"])
    os.write(there, b"0\n")
    os.close(there)
    wait_for(typed, heard, ["!", "~", "50"])
    begin_s = time.monotonic()
    typed.wait(0.05)
    assert time.monotonic() - begin_s >= 0.05
    os.close(here)


def test_lines_are_heard_in_the_thread_that_waits_and_only_while_it_does() -> None:
    here, there = os.pipe()
    heard: list[threading.Thread] = []
    typed = TerminalInput(lambda line: heard.append(threading.current_thread()), here)
    os.write(there, b"!\n")
    end_s = time.monotonic() + LIMIT_S
    while typed._lines.empty() and time.monotonic() < end_s:
        time.sleep(0.001)
    assert heard == []
    typed.wait(0.0)
    assert heard == [threading.current_thread()]
    os.close(there)


if os.name != "nt":

    def test_a_terminal_that_is_gone_is_no_error() -> None:
        here, there = os.openpty()
        os.close(here)
        heard: list[str] = []
        typed = TerminalInput(heard.append, there)
        typed.wait(0.01)
        typed.wait(0.01)
        assert heard == []
        os.close(there)


def test_where_nobody_can_type_it_only_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(b"!\n")))
    begin_s = time.monotonic()
    TerminalInput(lambda line: pytest.fail(line)).wait(0.02)
    assert time.monotonic() - begin_s >= 0.02
