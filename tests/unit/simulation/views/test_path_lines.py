# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polylines in pieces: no segment is lost, doubled or made, and no piece is longer than it may be."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.simulation.views.path_lines import Lines


def segments_of(lines: Lines) -> list[tuple[float, ...]]:
    """Return begin and end of every segment, in order."""
    assert lines.counts.sum() == len(lines.points)
    found, first = [], 0
    for count in lines.counts.tolist():
        line = lines.points[first : first + count]
        found += [(*begin, *end) for begin, end in zip(line[:-1].tolist(), line[1:].tolist(), strict=True)]
        first += count
    return found


@pytest.mark.parametrize("seed", range(20))
def test_pieces_hold_every_segment_once(seed: int) -> None:
    random = np.random.default_rng(seed)
    counts = random.integers(2, 9, random.integers(1, 12)).astype(np.int32)
    lines = Lines(random.random((counts.sum(), 3), dtype=np.float32), counts)
    most = int(random.integers(2, 12))
    pieces = list(lines.pieces(most))
    assert all(len(piece.points) <= most for piece in pieces)
    assert [segment for piece in pieces for segment in segments_of(piece)] == segments_of(lines)
    assert len(pieces) > 1 or len(lines.points) <= most


def test_nothing_has_no_pieces() -> None:
    assert list(Lines(np.zeros((0, 3), np.float32), np.zeros(0, np.int32)).pieces(10)) == []
