# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller that sends more than was asked for ends the job; one that repeats each line does not."""

from __future__ import annotations

import pytest

from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.motion_interlock import MotionInterlock
from CNCStepper.errors import LinkError
from helpers.control.fake_controller import FakeClock, Unqueued


class Echoing(Unqueued):
    """A link to a firmware built with REPORT_ECHO_LINE_RECEIVED: it repeats each line `times`, then says ok."""

    name = "echoing"

    def __init__(self, clock: FakeClock, times: int):
        self.clock, self._times, self._said = clock, times, b""

    def write(self, data: bytes) -> None:
        for line in data.splitlines():
            self._said += b"[echo: %s]\r\n" % line * self._times + b"ok\r\n"

    def read(self, wait_s: float) -> bytes:
        self.clock.now_s += 0.01
        said, self._said = self._said, b""
        return said

    def close(self) -> None:
        """It holds nothing."""


def cut(times: int) -> None:
    """Send 6000 lines, 100 a second."""
    clock = FakeClock()
    driver = Grbl(Echoing(clock, times), clock=clock, interlock=MotionInterlock(lambda: False))
    for index in range(6000):
        driver.send(f"G1X{index % 10}", index)
        driver.flush()
        driver.receive(0.01)
        assert not driver.unanswered


def test_a_line_may_be_repeated_once() -> None:
    cut(1)


def test_a_line_that_is_repeated_again_and_again_is_a_flood() -> None:
    with pytest.raises(LinkError, match="sends more than was asked for") as refused:
        cut(3)
    assert refused.value.code == "link-flood"
