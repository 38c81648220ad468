# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compiles the kernels by making and reading small cuts: `python -m CNCStepper.workers.kernel_warm_up`.

A window starts it in a process of its own, so that it need not wait for its first cut. The machine code stays in the
user's cache folder, for this version of Python; the stamp that all is there is written last.
When its standard input is closed the window is gone: it ends, and what is compiled by then is kept.
"""

from __future__ import annotations

import contextlib
import os
import threading
from pathlib import Path

import numpy as np

from CNCStepper import kernel_cache
from CNCStepper.control.pulses.pulse_loop import load_kernels
from CNCStepper.gcode.dialects import dialect_named
from CNCStepper.gcode.interpreter.fast_path.compiled_reader import CompiledReader
from CNCStepper.gcode.interpreter.flow.o_word_kernel import needs_interpreter
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.wire.line_runs import compiled_runs
from CNCStepper.job.make import cut_operations
from CNCStepper.job.model import load_job
from CNCStepper.machine.wiring import Signals
from CNCStepper.motion.signals.parallel_port_registers import RegisterWriter
from CNCStepper.motion.signals.port_bytes import BoardWriter
from CNCStepper.motion.signals.pulse_player import PLAYED_AXES

TEXT = b"G1 X0 F100\nX1\n"
CUTS = (Path(__file__).with_suffix(".toml"), Path(__file__).with_name("kernel_warm_up_wire.toml"))


def warm() -> None:
    """Make the cuts, each as a job of its own; what they call is compiled then, and loaded from the cache later."""
    read_all_ways()
    for writer in (RegisterWriter(Signals(), PLAYED_AXES), BoardWriter()):
        load_kernels(writer)
    cut_each_kind()


def cut_each_kind() -> None:
    """Make one cut of each kind."""
    for cuts in CUTS:
        job, machine = load_job(cuts)
        for operation in job.operation:
            cut_operations(job.model_copy(update={"operation": (operation,)}).on(machine))


def read_all_ways() -> None:
    """Look over a text, read it and prepare it for sending, all by kernels."""
    CompiledReader(Interpreter()).read(TEXT)
    list(compiled_runs(TEXT, dialect_named("grbl")))
    needs_interpreter(np.frombuffer(TEXT, np.uint8))


def _end_when_left() -> None:
    with contextlib.suppress(OSError):
        while os.read(0, 1):  # not sys.stdin: its lock would be held when the interpreter ends
            pass
    os._exit(1)


if __name__ == "__main__":
    threading.Thread(target=_end_when_left, daemon=True).start()
    warm()
    kernel_cache.stamp().touch()
