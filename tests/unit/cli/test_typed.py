# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that are typed while pulses are sent: each is heard once, whole, and in the thread that waits."""

from __future__ import annotations

import os
import sys
import time
from io import BytesIO, TextIOWrapper

import pytest

from CNCStepper.cli.typed import Typed

if os.name != "nt":

    def test_lines_are_heard_whole_and_the_end_of_typing_is_no_hurry() -> None:
        here, there = os.pipe()
        heard: list[str] = []
        typed = Typed(heard.append, here)
        os.write(there, b"!\n~ \r\n5")
        typed.wait(0.0)
        assert heard == ["!", "~"]
        os.write(there, b"0\n")
        os.close(there)
        begin_s = time.monotonic()
        typed.wait(0.05)
        typed.wait(0.05)
        assert heard == ["!", "~", "50"] and time.monotonic() - begin_s >= 0.1
        os.close(here)

    def test_a_terminal_that_is_gone_is_no_error() -> None:
        here, there = os.openpty()
        os.close(here)
        heard: list[str] = []
        typed = Typed(heard.append, there)
        typed.wait(0.01)
        typed.wait(0.01)
        assert heard == []
        os.close(there)


def test_where_nobody_can_type_it_only_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", TextIOWrapper(BytesIO(b"!\n")))
    begin_s = time.monotonic()
    Typed(lambda line: pytest.fail(line)).wait(0.02)
    assert time.monotonic() - begin_s >= 0.02
