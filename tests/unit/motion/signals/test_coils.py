# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coil sequences: the published tables, forwards and back, places kept."""

import numpy as np
import pytest

from CNCStepper.motion.signals.coils import (
    BIPOLAR,
    HALF_STEP,
    ONE_PHASE,
    SEQUENCES,
    TWO_PHASES,
    bipolar_word,
    coil_words,
)
from CNCStepper.motion.signals.pulse_stream import PulseStream
from CNCStepper.motion.signals.step_letters import read_letters


def letters(text, axes=1):
    return PulseStream(read_letters([text]), axes, None)


def x_words(text, sequence):
    return np.concatenate([chunk.words[:, 0] for chunk in coil_words(letters(text), sequence)]).tolist()


def test_the_published_sequences_run_and_run_back():
    assert x_words(b"AAAAA", ONE_PHASE) == [8, 4, 2, 1, 8]
    assert x_words(b"AAAAA", TWO_PHASES) == [10, 9, 5, 6, 10]
    assert x_words(b"AAAAAAAAA", HALF_STEP) == [8, 12, 4, 6, 2, 3, 1, 9, 8]
    assert x_words(b"AAAADDD", TWO_PHASES) == [10, 9, 5, 6, 5, 9, 10]


def coils_changed(one, other):
    return (one ^ other).bit_count()


@pytest.mark.parametrize("name", SEQUENCES)
def test_from_place_to_place_the_field_turns_evenly(name):
    sequence = SEQUENCES[name]
    changes = {coils_changed(one, other) for one, other in zip(sequence, (*sequence[1:], sequence[0]), strict=True)}
    assert changes == ({1} if name == "half_step" else {2})


def test_a_bipolar_motor_never_has_both_ends_of_a_coil_alike():
    words = [bipolar_word(signs) for signs in BIPOLAR]
    assert words == [0b1001, 0b1010, 0b0110, 0b0101]
    assert all(word >> 3 & 1 != word >> 2 & 1 and word >> 1 & 1 != word & 1 for word in words)
    assert all(coils_changed(one, other) == 2 for one, other in zip(words, [*words[1:], words[0]], strict=True))


def test_motors_keep_their_place_in_the_sequence():
    places = np.array([-1, -1, -1])
    for text in (b"ABB", b"DE"):
        list(coil_words(letters(text, 3), HALF_STEP, places))
    assert (places % 8).tolist() == [7, 0, 7]
