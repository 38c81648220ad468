# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves as curves: points, nearest places, parts in either sense, in all planes."""

from __future__ import annotations

import random
from math import pi

import pytest

from CNCStepper.recovery.retract.move_curve import Move, chords_of
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, XY, YZ, ZX

LINE_MOVE = Move(LINE, (0.0, 0.0, 0.0), (3.0, 4.0, 12.0), feed_mm_min=100.0)
MOVES = {
    "line": LINE_MOVE,
    "circle": Move(ARC_CW, (5.0, 0.0, 1.0), (5.0, 0.0, 1.0), (3.0, 0.0, 1.0), XY, 1, 100.0),
    "helix": Move(ARC_CCW, (5.0, 0.0, 1.0), (1.0, 0.0, -2.0), (3.0, 0.0, 0.0), XY, 3, 100.0),
    "arc ZX": Move(ARC_CCW, (0.0, 2.0, 4.0), (4.0, 2.0, 0.0), (0.0, 0.0, 0.0), ZX, 1, 100.0),
    "helix YZ": Move(ARC_CW, (0.0, 0.0, 4.0), (2.0, 4.0, 0.0), (0.0, 0.0, 0.0), YZ, 1, 100.0),
}


def test_lengths_are_those_of_the_curves() -> None:
    assert MOVES["line"].length_mm == pytest.approx(13.0)
    assert MOVES["circle"].length_mm == pytest.approx(4 * pi)
    assert MOVES["helix"].length_mm == pytest.approx(((5 * pi * 2) ** 2 + 9) ** 0.5)
    assert abs(MOVES["arc ZX"].sweep_rad) == pytest.approx(pi / 2)


@pytest.mark.parametrize("name", MOVES)
def test_parts_lie_on_the_whole_in_both_senses(name: str) -> None:
    move, rng = MOVES[name], random.Random(name)
    for _ in range(50):
        one, other, share = rng.random(), rng.random(), rng.random()
        part = move.part(one, other)
        assert part.at(share) == pytest.approx(move.at(one + (other - one) * share), abs=1e-9)
        assert part.length_mm == pytest.approx(move.length_mm * abs(other - one), rel=1e-6)


@pytest.mark.parametrize("name", MOVES)
def test_nearest_places_hold_the_point_itself(name: str) -> None:
    move, rng = MOVES[name], random.Random(name)
    for share in [0.0, 1.0, *(rng.random() for _ in range(50))]:
        found = [place for place, far in move.nearest(move.at(share)) if far < 1e-6]
        assert any(place == pytest.approx(share, abs=1e-6) for place in found)


def test_a_flat_way_round_twice_passes_a_point_twice() -> None:
    twice = Move(ARC_CCW, (5.0, 0.0, 0.0), (5.0, 0.0, 0.0), (3.0, 0.0, 0.0), XY, 2, 100.0)
    on = [share for share, far in twice.nearest((3.0, 2.0, 0.0)) if far < 1e-6]
    assert on == pytest.approx([1 / 8, 5 / 8])


def test_chords_are_counted_as_the_firmware_does() -> None:
    assert chords_of(LINE_MOVE, 0.002) == 1
    assert chords_of(MOVES["circle"], 0.002) == int(0.5 * 2 * pi * 2 / (0.002 * (4 - 0.002)) ** 0.5)
