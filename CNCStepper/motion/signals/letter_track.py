# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way of a file of pulse letters: where each pulse leads, what is switched, and the letters back from a place.

letters   A A G s D           after pulse   0  1  2  3  4
places                        X             0  1  2  3  2      switches: spindle on, after pulse 3
                              Y             0  0  0  1  1
"""

from __future__ import annotations

from dataclasses import dataclass
from io import BytesIO

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.motion.signals.device_switching import Switch
from CNCStepper.motion.signals.pulse_stream import moves_of
from CNCStepper.motion.signals.step_letters import AXES, LETTERS_A_LINE, byte_after, letters_back, read_letters

MOST_PULSES = 5_000_000  # that are held in memory to be drawn


@dataclass(frozen=True)
class LetterTrack:
    """places: int32[pulses + 1, 3], steps of X, Y and Z from the begin. switches: by rising pulse, as `row`."""

    text: str
    places: np.ndarray
    switches: tuple[Switch, ...]

    @property
    def pulses(self) -> int:
        """How many pulses there are."""
        return len(self.places) - 1

    def on_after(self, pulse: int) -> tuple[str, ...]:
        """Return the devices that are on after so many pulses, in the order of their names."""
        on: dict[str, bool] = {}
        for switch in self.switches:
            if switch.row <= pulse:
                on[switch.device] = switch.on
        return tuple(sorted(name for name, is_on in on.items() if is_on))

    def back_from(self, pulse: int) -> str:
        """Return the letters, in lines, that lead from after a pulse back to the begin; no devices."""
        file = BytesIO(self.text.encode("latin-1"))
        letters = b"".join(letters_back(file, byte_after(file, pulse))).decode("ascii")
        return "".join(letters[at : at + LETTERS_A_LINE] + "\n" for at in range(0, len(letters), LETTERS_A_LINE))


def letter_track(text: str, file: str = "") -> LetterTrack:
    """Return the way of letters; raises ProgramError at a byte that is no letter, and for too many pulses."""
    moves, switches, pulses = [np.zeros((1, AXES), np.int32)], [], 0
    for chunk in read_letters([text.encode("latin-1", "replace")], file=file):
        switches += [Switch(pulses + one.row, one.tick, one.device, one.on) for one in chunk.switches]
        pulses += len(chunk)
        if pulses > MOST_PULSES:
            raise ProgramError(
                "letters-many", "the file has too many pulses to be shown", limit=Text("{most}", most=MOST_PULSES),
                advice="split it, or send it with cncstepper send", place=Place(file),
            )  # fmt: skip
        moves.append(moves_of(chunk, AXES).astype(np.int32))
    return LetterTrack(text, np.cumsum(np.concatenate(moves), axis=0, dtype=np.int32), tuple(switches))
