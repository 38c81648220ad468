# SPDX-License-Identifier: LGPL-2.1-or-later
"""At most 40 bytes, or 2 ms of a quick line, wait in this computer, and yet the line never waits for the sender."""

from __future__ import annotations

import socket
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.motion_interlock import MotionInterlock
from CNCStepper.control.transport.link import Link
from CNCStepper.control.transport.output_queue import QUEUE_BYTES, WireQueue
from helpers.control.fake_controller import FakeClock

WAKING_S = 0.0003  # what a thread that is woken comes late
UNLOCKED = MotionInterlock(lambda: False)


class Port:
    """A port that forgets what is written."""

    def __init__(self) -> None:
        self.written = b""

    def write(self, data: bytes) -> int:
        self.written += data
        return len(data)

    def read(self, count: int) -> bytes:
        return b""

    def close(self) -> None:
        pass


class TellingPort(Port):
    """A port of which the system says how much waits."""

    out_waiting = 25


class PacedLink(Link):
    """A link whose waits pass in a clock's time; most: how many bytes ever waited. idle_s: how long the line did."""

    def __init__(self, baud: int, clock: FakeClock):
        super().__init__(Port(), "paced", baud, clock)
        self.clock = clock
        self.most = 0
        self.idle_s = 0.0
        self.says = b""
        self._free_s = clock()

    def write(self, data: bytes) -> None:
        if self._port.written:
            self.idle_s += max(self.clock() - self._free_s, 0.0)
        self._free_s = max(self._free_s, self.clock()) + self.leaving_s(len(data))
        super().write(data)
        self.most = max(self.most, self.waiting_bytes())

    def rest(self, wait_s: float) -> None:
        self.clock.now_s += wait_s + WAKING_S

    def read(self, wait_s: float) -> bytes:
        self.clock.now_s += wait_s + WAKING_S if wait_s > 0 else 0.0
        said, self.says = self.says, b""
        return said


@given(
    lengths=st.lists(st.integers(1, 79), min_size=1, max_size=30),
    baud=st.sampled_from([9_600, 115_200, 250_000, 1_000_000]),
    rests=st.booleans(),
)
def test_few_bytes_wait_and_the_line_is_kept_busy(lengths, baud, rests):
    clock = FakeClock()
    link = PacedLink(baud, clock)
    driver = Grbl(link, clock, interlock=UNLOCKED)
    total = sum(lengths) + len(lengths)
    least = 2 * (total - link.queue_bytes)  # a window so small that the line need not be busy begins below
    driver.counting.window = least if rests else 4 * total
    lines = ["1" * length for length in lengths]
    for line in lines:
        driver.send(line)
    driver.receive(1.1 * link.leaving_s(total) + 0.1)
    link.close()
    assert link._port.written == "".join(f"{line}\n" for line in lines).encode()
    assert link.most <= max(QUEUE_BYTES, 0.002 * baud / 10)
    assert link.idle_s < 1e-9


def test_test_of_the_queue_can_fail():
    clock = FakeClock()
    link = PacedLink(115_200, clock)
    link.write(bytes(QUEUE_BYTES + 1))
    clock.now_s += 1.0
    link.write(b"1")
    link.close()
    assert link.most > QUEUE_BYTES and link.idle_s > 0.5


def test_real_time_byte_goes_before_what_is_queued():
    clock = FakeClock()
    link = PacedLink(115_200, clock)
    driver = Grbl(link, clock, interlock=UNLOCKED)
    driver.send("1" * 79)
    driver.flush()
    driver.realtime(b"!")
    link.close()
    assert link._port.written == b"1" * QUEUE_BYTES + b"!"


def test_answered_lines_do_not_wait_whatever_the_baud_rate_says():
    clock = FakeClock()
    link = PacedLink(300, clock)  # of a board on a network: it has answered long before
    driver = Grbl(link, clock, interlock=UNLOCKED)
    driver.send("1" * 30)
    driver.flush()
    link.says = b"ok\r\n"
    driver.receive(0.0)
    driver.send("2" * 30)
    driver.flush()
    link.close()
    assert link._port.written.endswith(b"2\n")


def test_more_of_the_two_counts_what_the_system_says_and_what_the_line_can_have_carried():
    clock = FakeClock()
    queue = WireQueue(TellingPort(), 115_200, clock)
    assert queue.waiting_bytes() == 25
    queue.take(100)
    assert queue.waiting_bytes() == 100
    clock.now_s += queue.leaving_s(60)
    assert queue.waiting_bytes() == 40
    clock.now_s += 1.0
    assert queue.waiting_bytes() == 25


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells it of a socket")
def test_socket_whose_far_end_does_not_read_says_what_waits():
    port = Port()
    with socket.create_server(("127.0.0.1", 0)) as listener, socket.socket() as connection:
        connection.connect(listener.getsockname())
        connection.setblocking(False)
        port._socket = connection
        queue = WireQueue(port, 115_200, FakeClock())
        assert queue.waiting_bytes() == 0
        with pytest.raises(BlockingIOError):
            while True:
                connection.send(bytes(100_000))
        assert queue.waiting_bytes() > QUEUE_BYTES
