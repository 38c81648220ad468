# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the coils of stepper motors carry: published sequences, each motor's place in its own.

    place      0    1    2    3    0  ...      a pulse forwards goes one place on, one backwards one place back;
    two phases 10   9    5    6    10          the place is kept from move to move

Unipolar words are the coils B4 B3 B2 B1 as bits; bipolar ones the signs on the wires 1a 1b 2a 2b.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from CNCStepper.machine.profile import AXIS_NAMES
from CNCStepper.motion.signals.pulse_stream import PulseStream, moves_of

ONE_PHASE = (8, 4, 2, 1)
TWO_PHASES = (10, 9, 5, 6)
TWO_PHASES_OTHER_WIRING = (12, 6, 3, 9)  # of source A: its coils lie in another order, never mixed with the above
HALF_STEP = (8, 12, 4, 6, 2, 3, 1, 9)
BIPOLAR = ("+--+", "+-+-", "-++-", "-+-+")
SEQUENCES = {
    "one_phase": ONE_PHASE,
    "two_phases": TWO_PHASES,
    "two_phases_a": TWO_PHASES_OTHER_WIRING,
    "half_step": HALF_STEP,
}
WIRES = {name: tuple(f"{word:04b}" for word in words) for name, words in SEQUENCES.items()} | {"bipolar": BIPOLAR}
BEFORE_FIRST = -1  # the place from which a pulse forwards leads to the sequence's begin


@dataclass(frozen=True)
class CoilChunk:
    """The coils after each pulse: ticks int64[k], words uint8[k, motors]."""

    ticks: np.ndarray
    words: np.ndarray


def bipolar_word(signs: str) -> int:
    """Return "+--+" as the bits of wires 1a 1b 2a 2b, 1 where positive."""
    return int(signs.replace("+", "1").replace("-", "0"), 2)


def coil_words(
    stream: PulseStream,
    sequence: Sequence[int] = TWO_PHASES,
    places: np.ndarray | None = None,
    motors: Sequence[str] = (),
) -> Iterator[CoilChunk]:
    """Yield the coil words of every motor after each pulse.

    places: int64[motors], where each motor is in its sequence, kept up to date; BEFORE_FIRST when left out. motors: the
    axis that each turns, "-x" the other way round; one an axis when left out.
    """
    words, turning = np.array(sequence, np.uint8), motors or AXIS_NAMES[: stream.axes]
    axis_of = [AXIS_NAMES.index(motor[-1]) for motor in turning]
    sense = np.array([-1 if motor.startswith("-") else 1 for motor in turning], np.int64)
    at = np.full(len(turning), BEFORE_FIRST, np.int64) if places is None else places
    for chunk in stream:
        run = at + np.cumsum(moves_of(chunk, len(AXIS_NAMES))[:, axis_of] * sense, axis=0)
        if len(run):
            at[:] = run[-1] % len(words)
        yield CoilChunk(chunk.ticks, words[run % len(words)])
