# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the kernels that cuts compile though `kernel_warm_up` has run: `python -m helpers.workers.kernels_not_ahead`.

A process of its own, so that nothing which ran before it has compiled them. Prints the number of kernels compiled
ahead, then a line for each that was not.
"""

from __future__ import annotations

import gc
import sys
from pathlib import Path

from CNCStepper import kernels
from CNCStepper.gcode.interpreter.fast_path.policy import PAYS
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back
from CNCStepper.job.make import cut_operations
from CNCStepper.job.model import load_job
from CNCStepper.job.turning import turning_transfer
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.state import Start
from CNCStepper.workers.kernel_warm_up import warm
from helpers.job.example_jobs import LATHE_JOBS


def compiled() -> set[str]:
    """Return the names and types of arguments of all that Python may call compiled by now."""
    dispatcher = type(kernels.njit(compiled))
    ours = [kernel for kernel in gc.get_objects() if type(kernel) is dispatcher]  # dead proxies bear no isinstance
    return {f"{k.__module__}.{k.__name__} {types}" for k in ours for types in k.signatures}  # type: ignore[attr-defined]


def main(jobs: list[str]) -> None:
    """Warm up, read a program, make the jobs' cuts, and print what was compiled only then."""
    warm()
    ahead = compiled()
    print(len(ahead))
    text = "G0 X0 Y0 Z0 F100\n" + "G1 X1 Y2\nG2 X0 Y0 R5\n" * PAYS
    read_back(prepare(text), text, Start.at_zero())
    _print_new("reading", ahead)
    for path in jobs:
        make(Path(path))
        _print_new(path, ahead)


def make(path: Path) -> None:
    """Make what the window makes of a job."""
    if path in LATHE_JOBS:
        turned, lathe = load_turning_job(path)
        for _, text in turning_transfer.program_texts(turned, lathe, path.stem):
            turning_transfer.read_back(turned, lathe, text, path.name)
        return
    job, machine = load_job(path)
    cut_operations(job.on(machine))


def _print_new(what: str, ahead: set[str]) -> None:
    found = compiled() - ahead
    ahead |= found
    for name in sorted(found):
        print(f"{what}: {name}")


if __name__ == "__main__":
    main(sys.argv[1:])
