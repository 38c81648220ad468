# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is compiled ahead is all that the cycles need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from CNCStepper import kernel_cache, kernels
from helpers.job.example_jobs import LATHE_JOBS, TABLE_JOBS

TESTS = Path(__file__).parents[2]


@pytest.mark.slow
def test_no_example_needs_a_kernel_that_was_not_compiled_ahead() -> None:
    assert kernels.COMPILED and len(TABLE_JOBS) > 10 and len(LATHE_JOBS) > 3
    words = [sys.executable, "-m", "helpers.workers.kernels_not_ahead", *map(str, TABLE_JOBS + LATHE_JOBS)]
    told = subprocess.run(words, cwd=TESTS, capture_output=True, text=True, timeout=300, check=True).stdout
    ahead, *late = told.splitlines()
    assert int(ahead) > 10
    assert not late


@pytest.mark.slow
def test_it_ends_well_and_leaves_its_stamp() -> None:
    stamp = kernel_cache.stamp()
    stamp.unlink(missing_ok=True)
    with subprocess.Popen(
        [sys.executable, "-m", "CNCStepper.workers.kernel_warm_up"], stdin=subprocess.PIPE
    ) as process:
        assert process.wait(240) == 0  # with kernels to compile on a busy machine
    assert stamp.exists()


@pytest.mark.slow
def test_it_ends_with_the_window_that_started_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    words = [sys.executable, "-m", "CNCStepper.workers.kernel_warm_up"]
    assert subprocess.run(words, stdin=subprocess.DEVNULL, timeout=60).returncode == 1
    assert not list(tmp_path.glob("warm-*"))
