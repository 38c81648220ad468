# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that sends pulses, from its begin to every end that it can have: the port is at rest behind each.

Rates are so low that a loaded computer is no stall.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.pulses.pacing import Jitter
from CNCStepper.control.pulses.ports import RECORD, read_recording
from CNCStepper.control.pulses.sender import Pace, send_pulses
from CNCStepper.errors import LinkError, MachineRefusal
from CNCStepper.motion.signals.parallel_port import PortChunk

REST = (9, 3)
SLOW = Pace(0.5, REST, 10.0, trial_s=0.0)  # four seconds late are no stall
SIGNALS = [name for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGTSTP") if hasattr(signal, name)]


def chunk(ticks: list[int], data: list[int]) -> PortChunk:
    return PortChunk(np.array(ticks, np.int64), np.array(data, np.uint8), np.zeros(len(data), np.uint8))


def written(path: Path) -> list[tuple[int, int]]:
    return [(data, control) for _, data, control in read_recording(path)]


def test_a_process_of_its_own_sends_all_chunks_and_leaves_the_port_at_rest(tmp_path: Path) -> None:
    chunks = [chunk([0, 1000, 2000], [4, 5, 4]), chunk([], []), chunk([3000, 4000], [6, 4])]
    heard = []
    told = send_pulses(chunks, 1_000_000, tmp_path / "pulses", SLOW, heard.append)
    assert told.writes == 5 and told.taken_s >= 0.004
    seen = written(tmp_path / "pulses")
    assert seen[: heard[0].writes] == [REST] * heard[0].writes
    assert seen[heard[0].writes :] == [(4, 0), (5, 0), (4, 0), (6, 0), (4, 0), REST]


def test_the_process_refuses_a_rate_that_no_computer_keeps(tmp_path: Path) -> None:
    with pytest.raises(MachineRefusal, match="cannot keep the rate"):
        send_pulses([chunk([0, 10], [1, 0])], 1_000_000, tmp_path / "pulses", Pace(1e8, REST, 0.0, 0.001))
    assert set(written(tmp_path / "pulses")) == {REST}


def test_a_file_that_is_no_recording_is_told_by_the_process(tmp_path: Path, capfd: pytest.CaptureFixture) -> None:
    (tmp_path / "job.nc").write_bytes(b"G1 X1\n")
    with pytest.raises(LinkError, match="not written over"):
        send_pulses([chunk([0], [1])], 1_000_000, tmp_path / "job.nc", SLOW)
    assert capfd.readouterr().err == ""  # nobody stopped it while it said so


def test_an_error_on_the_way_stops_the_pulses_and_says_so(tmp_path: Path) -> None:
    """What has been given already, half a second of it, is not played to its end, and its end is not called done."""

    def chunks() -> Iterator[PortChunk]:
        yield from (chunk([tenth * 100_000], [tenth]) for tenth in range(10))
        raise MachineRefusal("pulse-rate", "the pulses come too fast")

    with pytest.raises(LinkError, match=r"stopped on the way.*too fast.*home the machine"):
        send_pulses(chunks(), 1_000_000, tmp_path / "pulses", SLOW)
    seen = written(tmp_path / "pulses")
    assert seen[-1] == REST and (9, 0) not in seen


@pytest.mark.slow
def test_no_more_is_made_than_half_a_second_ahead_of_its_time(tmp_path: Path) -> None:
    """A hold would not be heard before what is made already has been sent."""
    made: list[int] = []
    waited: list[float] = []

    def chunks() -> Iterator[PortChunk]:
        for number in range(15):
            made.append(number)
            yield chunk([number * 100], [number])

    def meanwhile(seconds: float) -> None:
        waited.append(seconds)
        time.sleep(seconds)

    assert send_pulses(chunks(), 1000, tmp_path / "pulses", SLOW, meanwhile=meanwhile).writes == 15
    assert made == list(range(15)) and len(waited) == 15
    assert max(waited[:6]) == 0.0 and sum(waited) >= 0.7  # 1.3 s was given when the one before the last was due


def test_a_stall_is_told_though_the_pulses_behind_it_are_not_taken(tmp_path: Path) -> None:
    """The worker ends while it is being given megabytes: its own error is what is heard, not that of its pipe."""
    at_once = chunk([0] * 500_000, [1] * 500_000)
    with pytest.raises(LinkError, match=r"steps may be lost.*home the machine"):
        send_pulses([at_once, at_once], 1_000_000, tmp_path / "pulses", Pace(100.0, REST, 10.0, 0.0))
    assert written(tmp_path / "pulses")[-1] == REST


def worker(path: Path) -> subprocess.Popen:
    words = [str(path), *SLOW.words()]
    module = [sys.executable, "-m", "CNCStepper.workers.port_writer"]
    return subprocess.Popen([*module, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def records(*writes: tuple[int, int, int]) -> bytes:
    return b"".join(RECORD.pack(*write) for write in writes)


if os.name != "nt":

    @pytest.mark.parametrize("name", SIGNALS)
    def test_every_signal_that_is_heard_leaves_the_port_at_rest(tmp_path: Path, name: str) -> None:
        """A beam (1) is on, and the next write is due in an hour: a closed terminal must not leave it burning."""
        with worker(tmp_path / "pulses") as process:
            assert "ready" in json.loads(process.stdout.readline())
            process.stdin.write(records((0, 1, 0), (1000, 1, 1), (3_600_000_000_000, 0, 0)))
            process.stdin.flush()
            process.send_signal(getattr(signal, name))
            process.send_signal(signal.SIGTERM)  # a second one does not come between it and the rest
            assert json.loads(process.stdout.readline()) == {"stopped": {}}
            assert written(tmp_path / "pulses")[-1] == REST  # it was at rest when it said so
            process.stdin.close()
            assert process.wait(10) == 130

    def test_a_sender_that_falls_silent_does_not_leave_the_beam_on(tmp_path: Path) -> None:
        with worker(tmp_path / "pulses") as process:
            assert "ready" in json.loads(process.stdout.readline())
            process.stdin.write(records((0, 1, 0)) + b"\0\0\0")  # and a part of a record
            process.stdin.flush()
            told = json.loads(process.stdout.readline())
            assert told["error"]["code"] == "pulses-late" and "home the machine" in told["error"]["advice"]
            assert written(tmp_path / "pulses")[-2:] == [(1, 0), REST]
            process.stdin.close()
            assert process.wait(10) == 1

    def test_who_is_stopped_while_the_last_pulses_run_stops_them(tmp_path: Path) -> None:
        """All is given, the beam is on, and the last write is due in an hour; the worker hears no Ctrl-C itself."""

        def ready(trial: Jitter) -> None:
            threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()

        before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs ignore it
        begun_s = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            send_pulses([chunk([0, 3600], [1, 2])], 1, tmp_path / "pulses", SLOW, ready)
        while (1, 0) in written(tmp_path / "pulses")[-1:] or not written(tmp_path / "pulses"):
            assert time.monotonic() - begun_s < 60
        assert written(tmp_path / "pulses")[-1] == REST
        signal.signal(signal.SIGINT, before)
