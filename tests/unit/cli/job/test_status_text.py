# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `cncstepper send` shows with its progress bar."""

from __future__ import annotations

import re
from dataclasses import replace
from io import StringIO

import pytest
from rich.console import Console

from CNCStepper.cli.job.session_watch import Moving
from CNCStepper.cli.job.status_text import live
from CNCStepper.control.session.status import SenderStatus

WHOLE = SenderStatus(
    phase="running",
    file_line=120,
    file_line_sent=135,
    total=200,
    wpos_mm=(1.0, 2.5, -3.0),
    mpos_mm=(-99.0, -47.5, -23.0),
    feed_mm_min=600.0,
    spindle_rpm=8000.0,
    buffer=(2, 17),
    overrides=(110, 100, 90),
    outputs="SF",
    remaining_s=3725.4,
)
LONG = replace(WHOLE, wpos_mm=(-1234.567,) * 3, mpos_mm=(-1234.567,) * 3, file_line=123456, file_line_sent=123499)


def test_all_that_is_reported_is_shown():
    assert live(WHOLE, 200) == (
        "1:02:05 to go  line 120, sent 135  F600 S8000  110/100/90 % SF  free 2 blocks 17 bytes  "
        "work X1.000 Y2.500 Z-3.000  machine X-99.000 Y-47.500 Z-23.000"
    )


@pytest.mark.parametrize("status", [WHOLE, LONG])
@pytest.mark.parametrize("width", [80, 120])
def test_nothing_is_cut_off_by_a_narrow_terminal(status, width):
    lines = live(status, width).splitlines()
    assert max(map(len, lines)) <= width and len(lines) <= 3
    assert "  ".join(lines) == live(status, 1000)


def test_bar_and_all_that_moves_are_on_the_screen_at_80_columns():
    progress = Moving(Console(file=StringIO(), force_terminal=True, width=80))
    with progress:
        progress.show(WHOLE)
        progress.refresh()
    shown = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", progress.console.file.getvalue())
    assert "running " in shown and "…" not in shown
    assert "110/100/90 % SF  free 2 blocks 17 bytes" not in shown  # does not fit beside the rest: a line below
    for words in ("F600 S8000", "110/100/90 % SF", "free 2 blocks 17 bytes", "machine X-99.000 Y-47.500 Z-23.000"):
        assert words in shown


def test_what_is_not_reported_is_left_out():
    assert live(SenderStatus(), 80) == ""
