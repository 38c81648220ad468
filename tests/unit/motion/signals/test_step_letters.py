# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulse letters: the published table, and the round trip of any stream."""

from itertools import pairwise

import numpy as np
import pytest

from CNCStepper.errors import MachineRefusal, ProgramError
from CNCStepper.motion.signals.device_switching import Switch
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream
from CNCStepper.motion.signals.step_letters import LETTERS_A_LINE, letters_of, read_letters

PUBLISHED = (
    "A +X · B +Y · C +Z · D −X · E −Y · F −Z · G +X+Y · H +X+Z · I +Y+Z · J −X−Y · K −X−Z · L −Y−Z · M +X−Y · N −X+Y · "
    "O +X−Z · P −X+Z · Q +Y−Z · R −Y+Z · S +X+Y+Z · T −X−Y−Z · U +X−Y−Z · V −X+Y−Z · W −X−Y+Z · X −X+Y+Z · Y +X−Y+Z · "
    "Z +X+Y−Z"
)


def read(text, pieces=1, **options):
    """Return step, back and the switches with their pulse's number, read in pieces."""
    cuts = np.linspace(0, len(text), pieces + 1).astype(int)
    chunks = list(read_letters([text[a:b] for a, b in pairwise(cuts)], **options))
    before = np.cumsum([0] + [len(chunk) for chunk in chunks])
    switches = [(before[k] + s.row, s.device, s.on) for k, chunk in enumerate(chunks) for s in chunk.switches]
    return *(np.concatenate([getattr(c, name) for c in chunks]) for name in ("ticks", "step", "back")), switches


def stream_of(step, back, switches=()):
    return PulseStream([PulseChunk(np.arange(len(step)), step, back, tuple(switches))], 3, None)


def test_each_letter_moves_what_the_source_says():
    for entry in PUBLISHED.split(" · "):
        letter, move = entry.split(" ")
        _, step, back, _ = read(letter.encode())
        wanted = dict.fromkeys("XYZ", 0) | {
            axis: -1 if sign == "−" else 1 for sign, axis in zip(move[::2], move[1::2], strict=True)
        }
        assert [int(step[0] >> n & 1) - 2 * int(back[0] >> n & 1) for n in range(3)] == list(wanted.values())
        assert b"".join(letters_of(stream_of(step, back))) == letter.encode() + b"\n"


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("pieces", [1, 13])
def test_any_stream_comes_back_from_its_letters(seed, pieces):
    rng = np.random.default_rng(seed)
    print("seed", seed)
    count = int(rng.integers(1, 1000))
    step = rng.integers(1, 8, count).astype(np.uint8)
    back = (step & rng.integers(0, 8, count)).astype(np.uint8)
    rows = sorted(rng.integers(0, count + 1, 6).tolist())
    devices = [("spindle_cw", True), ("mist", True), ("flood", True), ("mist", False), ("flood", False)]
    wanted = [(row, *device) for row, device in zip(rows, [*devices, ("spindle_cw", False)], strict=True)]
    switches = [Switch(row, row, device, on) for row, device, on in wanted]
    text = b"".join(letters_of(stream_of(step, back, switches)))
    assert max(map(len, text.split(b"\n"))) <= LETTERS_A_LINE
    ticks, *again, switched = read(text, pieces, ticks_a_pulse=7)
    np.testing.assert_array_equal(again, [step, back])
    np.testing.assert_array_equal(ticks, 7 * np.arange(1, count + 1))
    assert switched == wanted


def test_blanks_and_line_ends_are_ignored():
    _, step, back, _ = read(b" A a".replace(b"a", b"\r\n\tB  D"))
    assert step.tolist() == [1, 2, 1] and back.tolist() == [0, 0, 1]


def test_lines_are_whole_over_chunks():
    step = np.ones(50, np.uint8)
    chunk = PulseChunk(np.arange(50), step, step * 0)
    text = b"".join(letters_of(PulseStream([chunk] * 4, 3, None)))
    assert text.split(b"\n") == [b"A" * 80, b"A" * 80, b"A" * 40, b""]


def test_a_byte_that_is_no_letter_is_refused_with_its_line():
    with pytest.raises(ProgramError, match=r"pulses\.txt:3: .*'@'"):
        read(b"AAD\nAA\nA@", pieces=2, file="pulses.txt")


def test_more_than_three_axes_have_no_letters():
    with pytest.raises(MachineRefusal, match="axes"):
        list(letters_of(PulseStream([], 4)))
