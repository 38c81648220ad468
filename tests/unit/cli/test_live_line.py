# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `cncstepper send` shows beside its progress bar."""

from __future__ import annotations

from CNCStepper.cli.live import live
from CNCStepper.control.outcome import SenderStatus


def test_all_that_is_reported_is_shown():
    status = SenderStatus(
        file_line=120,
        file_line_sent=135,
        wpos_mm=(1.0, 2.5, -3.0),
        mpos_mm=(-99.0, -47.5, -23.0),
        feed_mm_min=600.0,
        spindle_rpm=8000.0,
        buffer=(2, 17),
        overrides=(110, 100, 90),
        outputs="SF",
        remaining_s=3725.4,
    )
    assert live(status) == (
        "1:02:05 to go  line 120, sent 135  work X1.000 Y2.500 Z-3.000  machine X-99.000 Y-47.500 Z-23.000  "
        "F600 S8000  free 2 blocks 17 bytes  110/100/90 % SF"
    )


def test_what_is_not_reported_is_left_out():
    assert live(SenderStatus()) == ""
