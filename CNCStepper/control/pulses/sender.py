# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hands the writes of a port to the process that sends them (`port_writer.py`) and measures their lateness."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import chain, islice
from pathlib import Path
from typing import IO, Any

import numpy as np

from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.control.pulses.pacing import HOME, NS_PER_S, TRIAL_S, Jitter
from CNCStepper.control.pulses.ports import FIELDS
from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError, LinkError, Text
from CNCStepper.motion.signals.parallel_port import PortChunk

AHEAD = 8  # chunks that are made before the first pulse
AHEAD_S = 0.5  # more than this is given only where a single chunk lasts longer: what is given cannot be held back
RECORDS = np.dtype([(name, f"<{code}") for name, code in FIELDS])
NOTHING = np.empty(0, RECORDS)


@dataclass(frozen=True)
class Pace:
    """How writes are sent: writes_per_s at their fastest, by which the trial is made and a stall is told.

    idle: both registers at rest. keep_us: writes that are due no farther apart are kept apart. trial_s: its length.
    """

    writes_per_s: float
    idle: tuple[int, int]
    keep_us: float
    trial_s: float = TRIAL_S

    def words(self) -> list[str]:
        """Return it as the arguments of the worker."""
        keep_ns = round(self.keep_us * 1000)
        return [f"{self.writes_per_s:.6g}", *map(str, self.idle), str(keep_ns), str(self.trial_s)]


def send_pulses(
    chunks: Iterable[PortChunk],
    ticks_per_s: int,
    port: Path,
    pace: Pace,
    ready: Callable[[Jitter], None] = lambda trial: None,
    meanwhile: Callable[[float], None] = time.sleep,
) -> Jitter:
    """Write chunks to a port, each when it is due, and return how late the writes were.

    ready: hears the trial's jitter before the first pulse. meanwhile: is called before each chunk with the seconds for
    which there is nothing to do. Raises LinkError where the port cannot be had and where the
    pulses were stopped, MachineRefusal where this computer cannot keep the rate.
    """
    records = (_records(chunk, ticks_per_s) for chunk in chunks)
    first = list(islice(records, AHEAD))  # what takes long at the begin must not come between two pulses
    starts = command(sys.executable, "CNCStepper.workers.port_writer", str(port), *pace.words())
    with subprocess.Popen(starts, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment()) as worker:
        assert worker.stdin and worker.stdout
        trial = _answer(worker.stdout.readline(), "ready")
        try:
            ready(_jitter(trial))
            _give(worker, chain(first, records), meanwhile)
            _close(worker.stdin)
            return _jitter(_answer(worker.stdout.readline(), "done"))
        except BaseException:  # whoever stops us, or whatever fails: what has been given must not be played to its end
            worker.terminate()
            raise
        finally:
            _close(worker.stdin)


def _give(worker: subprocess.Popen, blocks: Iterable[np.ndarray], meanwhile: Callable[[float], None]) -> None:
    """Give the worker all blocks, or as many as it takes; raises LinkError where they cannot be made."""
    begin_s, given_s, given = time.monotonic(), 0.0, iter(blocks)
    while len(block := _next(given)):
        meanwhile(max(0.0, begin_s + given_s - AHEAD_S - time.monotonic()))
        given_s = float(block["ns"][-1]) / NS_PER_S
        try:
            worker.stdin.write(block.tobytes())  # type: ignore[union-attr]
            worker.stdin.flush()  # type: ignore[union-attr]
        except OSError:  # it has ended: its answer says why
            break


def _close(pipe: IO[bytes]) -> None:
    with suppress(OSError):  # who reads it may have ended: its answer says why
        pipe.close()


def _next(blocks: Iterator[np.ndarray]) -> np.ndarray:
    """Return the next block that is not empty, an empty one behind the last."""
    try:
        return next(filter(len, blocks), NOTHING)
    except CNCStepperError as error:
        raise LinkError(
            "pulses-stopped", Text("the pulses were stopped on the way: {error}", error=error), advice=HOME
        ) from error


def _records(chunk: PortChunk, ticks_per_s: int) -> np.ndarray:
    records = np.empty(len(chunk), RECORDS)
    seconds, ticks = np.divmod(chunk.ticks, ticks_per_s)
    records["ns"] = seconds * NS_PER_S + ticks * NS_PER_S // ticks_per_s
    records["data"], records["control"] = chunk.data, chunk.control
    return records


def _jitter(told: dict[str, Any]) -> Jitter:
    return Jitter(**{name: told[name] for name in Jitter.__dataclass_fields__})


def _answer(line: bytes, wanted: str) -> dict[str, Any]:
    """Return what the worker has told; raises its error, or LinkError where it ended without a word."""
    told = json.loads(line) if line else {}
    if "error" in told:
        raise error_from_json(told["error"])
    if wanted not in told:
        raise LinkError("pulse-worker", "the pulses were stopped before they were all sent", advice=HOME)
    return told[wanted]
