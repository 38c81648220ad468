# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is compiled ahead is all that the cycles need."""

from __future__ import annotations

import gc
import subprocess
import sys
from pathlib import Path

import pytest

from CNCStepper import kernel_cache, kernels
from CNCStepper.gcode.interpreter.fast_path.policy import PAYS
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back
from CNCStepper.job.make import cut_operations
from CNCStepper.job.model import load_job
from CNCStepper.state import Start
from CNCStepper.workers.kernel_warm_up import warm

JOBS = sorted((Path(__file__).parents[3] / "examples" / "jobs").rglob("*.toml"))


def compiled() -> set[tuple[str, str]]:
    """Return the names and types of arguments of all that Python may call compiled by now."""
    dispatcher = type(kernels.njit(compiled))
    ours = [kernel for kernel in gc.get_objects() if type(kernel) is dispatcher]  # dead proxies bear no isinstance
    return {(f"{k.__module__}.{k.__name__}", str(types)) for k in ours for types in k.signatures}  # type: ignore[attr-defined]


@pytest.mark.slow
def test_no_example_needs_a_kernel_that_was_not_compiled_ahead() -> None:
    assert kernels.COMPILED and len(JOBS) > 10
    warm()
    ahead = compiled()
    assert len(ahead) > 10
    text = "G0 X0 Y0 Z0 F100\n" + "G1 X1 Y2\nG2 X0 Y0 R5\n" * PAYS
    read_back(prepare(text), text, Start.at_zero())
    assert compiled() - ahead == set()
    for path in JOBS:
        job, machine = load_job(path)
        cut_operations(job.on(machine))
        assert compiled() - ahead == set(), path


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
