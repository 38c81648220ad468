# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulses that this computer sends: in order, never early, as wide as they are to be, and ended by a stall.

How fast and how even they are is measured in bench/bench_pulse_output.py: a loaded computer must not fail a test, so
that clocks stand in these tests where a rate would count.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.control.pulses import pacing
from CNCStepper.control.pulses.pacing import (
    BINS,
    NEVER_NS,
    Jitter,
    Pacer,
    Write,
    come_first,
    jitter_of,
    lock_memory,
    own_core,
    stall_ns,
)
from CNCStepper.errors import LinkError

STEP_NS = 100  # by which the clock goes on whenever it is read


class Clock:
    """A clock that only goes on where it is read, and a port that is set after `takes` ns and notes it."""

    def __init__(self, takes: Callable[[int], int] = lambda number: 0, step_ns: int = STEP_NS):
        self.now, self.written, self._takes, self._step_ns = 0, [], takes, step_ns

    def __call__(self) -> int:
        self.now += self._step_ns
        return self.now

    def write(self, data: int, control: int) -> None:
        self.now += self._takes(len(self.written))
        self.written.append((self.now, data, control))

    def close(self) -> None:
        raise AssertionError("who opened it closes it")


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Clock]]:
    def make(*how: Any) -> Clock:
        made = Clock(*how)
        monkeypatch.setattr(pacing.time, "perf_counter_ns", made)
        return made

    yield make


def pace(writes: list[Write], port: Clock, keep_ns: int, most_late_ns: int = NEVER_NS) -> Jitter:
    """Write each when it is due, the first at once, and return how late they were."""
    begin_ns = pacing.time.perf_counter_ns()
    pacer = Pacer(port, keep_ns, begin_ns - writes[0][0], [0] * (BINS + 1))
    pacer.write(writes, most_late_ns)
    taken_s = (port.now - begin_ns) / pacing.NS_PER_S
    return jitter_of(pacer.writes, taken_s, pacer.late_ns, pacer.worst_ns, pacer._bins)


def test_writes_are_in_order_and_never_early(clock) -> None:
    writes = [(number * 20_000, number % 256, number % 7) for number in range(2000)]
    port = clock()
    told = pace(writes, port, 10_000)
    assert [(data, control) for _, data, control in port.written] == [(data, control) for _, data, control in writes]
    begin = STEP_NS  # the first time that the clock was read
    late = [at - begin - due for (at, _, _), (due, _, _) in zip(port.written, writes, strict=True)]
    assert min(late) >= 0 and max(late) <= 2 * STEP_NS
    assert told.writes == len(writes) and told.worst_us <= 2 * STEP_NS / 1000 and told.p99_us == 1.0


def test_a_pulse_that_begins_late_is_as_wide_as_it_is_to_be(clock) -> None:
    """Pulses of 20 us with 5 us between them, of which the second rise is 15 us late: its fall was due 5 us later."""
    edges = [start + edge for start in range(0, 2_000_000, 200_000) for edge in (0, 20_000, 25_000, 45_000)]
    port = clock(lambda number: 15_000 if number == 2 else 0)
    pace([(at, number % 2, 0) for number, at in enumerate(edges)], port, 20_000)
    times = [at for at, _, _ in port.written]
    for (earlier, later), (due, due_next) in zip(pairwise(times), pairwise(edges), strict=True):
        assert later - earlier >= min(due_next - due, 20_000)
    assert times[2] - times[0] - edges[2] >= 15_000 - STEP_NS  # it was late indeed
    assert times[-1] - times[0] == pytest.approx(edges[-1], abs=3 * STEP_NS)  # which is made good


def test_a_stall_ends_the_pulses_and_nothing_is_made_good(clock) -> None:
    """A write takes 54 ms, as other programs made it once; the writes behind it came at the least distance then."""
    port = clock(lambda number: 54_000_000 if number == 10 else 0)
    with pytest.raises(
        LinkError, match=r"spindle, beam and drives are off, and steps may be lost.*set it there"
    ) as caught:
        pace([(number * 20_000, number, 0) for number in range(100)], port, 10_000, stall_ns(50_000))
    assert caught.value.code == "pulses-late" and caught.value.limit == "40 µs"
    assert caught.value.value == "54000 µs late" and "after 10 writes" in caught.value.what
    assert [data for _, data, _ in port.written] == list(range(11))


def test_lateness_below_a_pulse_is_no_stall(clock) -> None:
    port = clock(lambda number: 38_000 if number % 10 == 0 else 0)
    told = pace([(number * 20_000, number, 0) for number in range(100)], port, 10_000, stall_ns(50_000))
    assert told.writes == 100 and 38 <= told.worst_us <= 40


@pytest.mark.parametrize(("throttle", "asked"), [("950000\n", "niceness"), ("-1\n", "fifo")])
def test_real_time_rank_is_taken_only_where_nothing_is_taken_from_it(
    throttle: str, asked: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """With the throttle on, Linux stops a busy process of that rank for 50 ms of every second."""
    file, heard = tmp_path / "throttle", []
    file.write_text(throttle, "ascii")
    monkeypatch.setattr(pacing, "THROTTLE", file)
    monkeypatch.setattr(pacing.os, "SCHED_FIFO", 1, raising=False)
    monkeypatch.setattr(pacing.os, "PRIO_PROCESS", 0, raising=False)
    monkeypatch.setattr(pacing.os, "sched_param", int, raising=False)
    monkeypatch.setattr(pacing.os, "sched_setscheduler", lambda *_: heard.append("fifo"), raising=False)
    monkeypatch.setattr(pacing.os, "setpriority", lambda *_: heard.append("niceness"), raising=False)
    assert come_first() and heard == [asked]
    file.unlink()
    assert not come_first()


def test_a_stall_is_a_pulse_at_the_fastest_rate() -> None:
    assert stall_ns(50_000) == 40_000 < NEVER_NS


@pytest.mark.parametrize(("cores", "asked"), [({0, 1}, []), ({0, 1, 2, 3}, [(0, {3})])])
def test_a_core_of_its_own_is_taken_only_of_more_than_two(
    cores: set[int], asked: list[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    heard: list[Any] = []
    monkeypatch.setattr(pacing.os, "sched_getaffinity", lambda process: cores, raising=False)
    monkeypatch.setattr(pacing.os, "sched_setaffinity", lambda *words: heard.append(words), raising=False)
    assert own_core() == bool(asked) and heard == asked


@pytest.mark.parametrize(("answer", "locked"), [(0, True), (-1, False)])
def test_memory_is_locked_where_that_is_allowed(answer: int, locked: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    class Library:
        mlockall = staticmethod(lambda flags: answer)

    monkeypatch.setattr(pacing.ctypes, "CDLL", lambda name: Library)
    assert lock_memory() is locked
    monkeypatch.setattr(pacing.ctypes, "CDLL", lambda name: object())  # Windows' has no such function
    assert not lock_memory()
