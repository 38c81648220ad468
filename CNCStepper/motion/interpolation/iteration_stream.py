# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all interpolators share: a kernel that writes pulses round by round becomes a stream of bounded chunks."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from CNCStepper.motion.signals.pulse_stream import PULSE_ROWS, PulseChunk, PulseStream, check_axes, moves_of

Write = Callable[[np.ndarray, np.ndarray, np.ndarray], int]


def iteration_stream(write: Write, begin_steps: Sequence[int], rows: int = PULSE_ROWS) -> PulseStream:
    """Return the stream of what `write` fills into ticks, step and back; it returns the rows filled, 0 at the end.

    A tick is the number of a round, from 1; rounds without a pulse have no row. Each chunk is valid until the next.
    Raises MachineRefusal for too many axes.
    """
    return PulseStream(_chunks(write, rows), check_axes(len(begin_steps)), None, tuple(begin_steps))


def _chunks(write: Write, rows: int) -> Iterator[PulseChunk]:
    ticks = np.empty(rows, np.int64)
    step, back = np.empty(rows, np.uint8), np.empty(rows, np.uint8)
    while count := write(ticks, step, back):
        yield PulseChunk(ticks[:count], step[:count], back[:count])


def positions_of(stream: PulseStream) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield ticks int64[k] and the positions int64[k, axes] after each pulse, chunk by chunk."""
    position = np.array(stream.begin_steps, np.int64)
    for chunk in stream:
        positions = position + np.cumsum(moves_of(chunk, stream.axes), axis=0)
        position = positions[-1] if len(positions) else position
        yield chunk.ticks.copy(), positions
