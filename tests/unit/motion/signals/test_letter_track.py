# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way of pulse letters: places, switched devices, and the way back from any pulse."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.machine.pulse_letters import MOVES, letter_steps
from CNCStepper.motion.signals import letter_track as module
from CNCStepper.motion.signals.letter_track import letter_track


def test_places_and_devices_are_those_of_the_letters() -> None:
    track = letter_track("A A\nG s D\nt f")
    assert track.pulses == 4
    assert track.places[:, :2].tolist() == [[0, 0], [1, 0], [2, 0], [3, 1], [2, 1]]
    assert track.on_after(2) == () and track.on_after(3) == ("spindle_cw",) and track.on_after(4) == ("flood",)


@pytest.mark.parametrize("seed", range(8))
def test_the_way_back_from_any_pulse_ends_at_the_begin(seed: int) -> None:
    chance = np.random.default_rng(seed)
    letters = "".join(chance.choice([*MOVES, "s", "t", "\n"], size=500))
    track = letter_track(letters)
    pulse = int(chance.integers(1, track.pulses))
    steps = np.array([letter_steps(letter) for letter in letters if letter != "\n" and letter.isupper()])
    assert (track.places[1:] == np.cumsum(steps, axis=0)).all()
    back = letter_track(track.back_from(pulse))
    assert back.pulses == pulse and not back.switches
    assert (track.places[pulse] + back.places == track.places[pulse::-1][: pulse + 1]).all()


def test_other_letters_and_too_many_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(ProgramError, match=r"part\.letters:2: .*no pulse letter"):
        letter_track("AAA\nA1", "part.letters")
    monkeypatch.setattr(module, "MOST_PULSES", 3)
    with pytest.raises(ProgramError, match="too many pulses"):
        letter_track("AAAA")
