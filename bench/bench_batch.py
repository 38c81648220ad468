# SPDX-License-Identifier: LGPL-2.1-or-later
"""An order of jobs apart, by one process and by two: wall time, ratio, cores for 100 000 parts a day."""

from __future__ import annotations

import os
import resource
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from CNCStepper.job.batch.local_workers import LocalWorkers
from CNCStepper.job.batch.order_rows import read_rows
from CNCStepper.job.batch.run_batch import NestOptions, run_batch
from helpers.batch.small_orders import bytes_in, jobs_apart, write_order

JOBS = int(os.environ.get("CNCSTEPPER_CASES", "60"))
SHEET = ["ring.dxf,laser.toml,plywood,6,12", "square.dxf,laser.toml,plywood,6,18"]
PARTS_A_DAY = 100_000
S_A_DAY = 86_400.0


def main() -> None:
    """Run both orders and print the figures."""
    with tempfile.TemporaryDirectory() as name:
        root = Path(name)
        order = write_order(root / "in", jobs_apart(JOBS))
        timed(order, root / "warm", 2)  # files and kernels in the caches
        one_s, _ = timed(order, root / "one", 1)
        two_s, _ = timed(order, root / "two", 2)
        same = bytes_in(root / "one") == bytes_in(root / "two")
        print(
            f"{JOBS} jobs: one process {one_s:.1f} s, two {two_s:.1f} s, ratio {one_s / two_s:.2f}, same bytes: {same}"
        )
        sheet = write_order(root / "sheet", SHEET)
        _, busy_s = timed(sheet, root / "nested", 1)
        parts = sum(row.count for row in read_rows(sheet))
        each_s = busy_s / parts
        cores = PARTS_A_DAY * each_s / S_A_DAY
        print(f"nested: {busy_s:.1f} s of processor for {parts} parts, {each_s:.3f} s a part")
        print(f"{PARTS_A_DAY} parts a day: {cores:.2f} cores")


def timed(order: Path, folder: Path, workers: int) -> tuple[float, float]:
    """Return wall time and processor time of an order, the start of the processes included."""
    folder.mkdir()
    begun_s, used_s = time.perf_counter(), _used_s()
    with LocalWorkers(workers) as runs:
        result = run_batch(read_rows(order), folder, runs, NestOptions(sheet_mm=None))
    assert result.is_whole
    return time.perf_counter() - begun_s, _used_s() - used_s


def _used_s() -> float:
    """Return the processor time of this process and of those that have ended."""
    told = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in told)


if __name__ == "__main__":
    main()
