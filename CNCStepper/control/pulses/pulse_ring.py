# SPDX-License-Identifier: LGPL-2.1-or-later
"""Memory that two processes share: a ring of planned pulses, the commands to their player, and what it does.

    | words | reals | bins of lateness | columns of the rows: KEPT behind the place, AHEAD before it |

One process appends, one plays: each word has one writer. The memory is that of a file without a name where the system
allows that, else of one that goes with its owner. Its size does not grow with the job: 30 MB.
"""

from __future__ import annotations

import mmap
import os
import tempfile
from contextlib import suppress
from pathlib import Path

import numpy as np

from CNCStepper.control.pulses.pacing import BINS
from CNCStepper.errors import LinkError, Text
from CNCStepper.motion.signals.pulse_player import REALS, WORDS, PulseRows, begin

KEPT = 1 << 20  # rows behind the place that can be played backwards
AHEAD = 1 << 18
ROWS = KEPT + AHEAD

# words of the appending process, behind those of the kernel
SERIAL, COMMAND, GOAL, RELAYS = range(8, 12)
# words of the player
ACKNOWLEDGED, STATE, INPUTS, WRITES, LATE_NS, WORST_NS, BEGIN_NS = range(40, 47)
BEAT = 47  # rises at each look of the player
PLACES = 48  # of the board's motors, and behind them the selected one
# reals of the appending process, of the player
PEAK_PER_S, TRIAL_PER_S, TRIAL_S = range(8, 11)
SPEED, TAKEN_S = range(24, 26)

HOLD, RESUME, BACK, STOP, TRIAL, CLOSE = range(1, 7)  # commands
IDLE, RUN, BRAKING, AT_HOLD, FAILED = range(5)
STATES = ("idle", "run", "hold", "held", "failed")
NO_INPUTS = -1

_COLUMNS = (("time_ns", "f8"), ("energy", "f8"), ("speed", "f4"), ("step", "u1"), ("back", "u1"), ("flags", "u1"))
_HEADER = (WORDS + REALS + BINS + 1) * 8
SIZE = _HEADER + ROWS * sum(np.dtype(kind).itemsize for _, kind in _COLUMNS)
MEMORY_FOLDER = Path("/dev/shm")


class PulseRing:
    """The memory of one player: `words`, `reals` and `bins` (int64), and the `rows`."""

    def __init__(self, memory: mmap.mmap, path: Path | None = None):
        self._memory, self.path = memory, path
        self.words = np.frombuffer(memory, np.int64, WORDS)
        self.reals = np.frombuffer(memory, np.float64, REALS, WORDS * 8)
        self.bins = np.frombuffer(memory, np.int64, BINS + 1, (WORDS + REALS) * 8)
        at, columns = _HEADER, {}
        for name, kind in _COLUMNS:
            columns[name] = np.frombuffer(memory, kind, ROWS, at)
            at += ROWS * np.dtype(kind).itemsize
        self.rows = PulseRows(**columns)

    @classmethod
    def create(cls) -> PulseRing:
        """Return new memory, of a file that another process opens by its path; raises LinkError where there is none."""
        try:
            descriptor, path = _new_file()
        except OSError as error:
            what = Text("there is no room for the pulses' memory: {error}", error=error)
            raise LinkError("pulse-memory", what, advice=Text("free {size} MB", size=SIZE >> 20)) from error
        try:
            ring = cls(mmap.mmap(descriptor, SIZE), path)
        finally:
            os.close(descriptor)
        begin(ring.words, ring.reals)
        ring.words[INPUTS] = NO_INPUTS
        return ring

    @classmethod
    def open(cls, path: Path) -> PulseRing:
        """Return the memory that another process has made."""
        with path.open("r+b") as file:
            return cls(mmap.mmap(file.fileno(), SIZE))

    def forget_name(self) -> None:
        """Delete the file's name, now if both processes have it open and the system allows it, else at the end."""
        if self.path:
            with suppress(OSError):  # Windows keeps a file that is in use
                self.path.unlink()
                self.path = None


def _new_file() -> tuple[int, Path]:
    """Return a descriptor and the path of a file whose room is there already: a full disk must not end us later."""
    folder = MEMORY_FOLDER if os.access(MEMORY_FOLDER, os.W_OK) else None
    descriptor, name = tempfile.mkstemp(prefix="cncstepper-pulses-", dir=folder)
    try:
        if hasattr(os, "posix_fallocate"):
            os.posix_fallocate(descriptor, 0, SIZE)
        else:
            os.truncate(descriptor, SIZE)
    except OSError:
        os.close(descriptor)
        os.unlink(name)
        raise
    return descriptor, Path(name)
