# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the journal holds a stream back: waits at 576 and 5000 lines a second with every entry synced to the disk,
a look on the sender's thread in ms, then 10 000 000 lines: the file's size and the memory.

    python bench/bench_journal.py [FOLDER]      the folder chooses the disk
"""

from __future__ import annotations

import sys
import tempfile
import time
import tracemalloc
from collections.abc import Sequence
from pathlib import Path

from CNCStepper.control.journal.writer import Journal
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import ControllerInfo
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.status_reports import Feedback, Status

RATES = {115_200: 576, 1_000_000: 5000}  # lines of 20 bytes a second
STREAM_S = 20.0
LOOK_S = 0.002
MANY, LINES_A_LOOK = 10_000_000, 250


class Program(Sequence):
    """Short moves that take no memory."""

    def __init__(self, count: int):
        self.count = count

    def __len__(self) -> int:
        return self.count

    def __getitem__(self, index: int) -> str:
        return f"G1X{index % 900 * 0.05:.2f}Y{index % 7}"


class Link:
    """A link that nobody waits on."""

    name = "none"

    def wake(self) -> None:
        """Do nothing."""


def begun(folder: Path, lines: Sequence[str], clock=time.monotonic) -> Journal:
    """Return the journal of a job that has begun on a machine of 80 steps a mm."""
    driver = Grbl(Link())
    driver.settings = {100: 80.0, 101: 80.0, 102: 400.0}
    driver.status = Status("Run", mpos=(12.345, 67.891, -1.5))
    journal = Journal(folder, clock=clock)
    journal.begin(SendJob("none", lines), driver, ControllerInfo("1.1h"))
    journal.on_message([Feedback("OPT", "V,15,128")])
    return journal


def streamed(folder: Path, rate: int) -> str:
    """Send at a steady rate and return how often and how long the journal made a line wait, and its file's size."""
    journal = begun(folder, Program(int(rate * STREAM_S)))
    sent, waited_s, waits, looks = 0, 0.0, 0, []
    begin_s = last_s = time.monotonic()
    while (now_s := time.monotonic()) - begin_s < STREAM_S:
        due = int((now_s - begin_s) * rate)
        if sent < due and sent == journal.permitted:
            waited_s += now_s - last_s
            waits += 1
        sent, last_s = min(due, journal.permitted), now_s
        begin = time.perf_counter()
        journal.keep(sent, max(sent - 6, 0), False)
        looks.append(time.perf_counter() - begin)
        time.sleep(LOOK_S)
    looks.sort()
    assert journal.path
    return (
        f"{waits} waits, {waited_s * 1000:.1f} ms of {STREAM_S:.0f} s in all; a look takes "
        f"{looks[len(looks) * 99 // 100] * 1000:.2f} ms (99 %), {looks[-1] * 1000:.2f} ms at most; "
        f"{journal.path.stat().st_size / STREAM_S * 3.6:.0f} kB an hour"
    )


def many(folder: Path) -> str:
    """Return size and memory for ten million lines at the higher rate, the time told rather than passed."""
    now_s = 0.0
    journal = begun(folder, Program(MANY), lambda: now_s)
    sent = 0
    tracemalloc.start()
    while sent < MANY:
        before, sent = sent, min(sent + LINES_A_LOOK, journal.permitted)
        now_s += (sent - before) / RATES[1_000_000]
        journal.keep(sent, max(sent - 6, 0), False)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert journal.path
    return f"{journal.path.stat().st_size / 1000:.0f} kB, {peak / 1000:.0f} kB of memory at most"


def main() -> None:
    """Print one line a measurement."""
    with tempfile.TemporaryDirectory(dir=sys.argv[1] if len(sys.argv) > 1 else None) as folder:
        for baud, rate in RATES.items():
            print(f"{baud} baud, {rate} lines/s: {streamed(Path(folder), rate)}")
        print(f"{MANY} lines: {many(Path(folder))}")


if __name__ == "__main__":
    main()
