# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tip at any moment: along lines and arcs, standing in dwells, never at a place that nobody knows."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.plan import times_s
from CNCStepper.simulation.tip_track import TipTrack
from CNCStepper.state import Start

PROGRAM = """G21 G90
G0 Z5
G0 X10 Y0
G4 P2
(a word between)
G1 Z-1 F300
G3 X-10 Y0 I-10 J0 F600
G3 X10 Y0 I10 J0 Z-2
G0 Z5
"""


@pytest.fixture(scope="module")
def track() -> TipTrack:
    toolpath = interpret(PROGRAM, Start.at_zero())
    return TipTrack.of(toolpath, times_s(toolpath, load_machine("table-a")))


def test_the_tip_stands_at_the_end_of_every_row_when_it_ends(track: TipTrack) -> None:
    ends = [(0, 0, 5), (10, 0, 5), (10, 0, -1), (-10, 0, -1), (10, 0, -2), (10, 0, 5)]
    for row, end in enumerate(ends):
        assert track.row_at(float(track.ends_s[row])) == row
        assert track.tip_mm(row, 1.0) == pytest.approx(end)
    assert track.row_at(-1) == 0 and track.row_at(1e9) == len(ends) - 1


def test_arcs_and_helices_are_followed_as_arcs(track: TipTrack) -> None:
    for share in np.linspace(0, 1, 21):
        angle = np.pi * share
        assert track.tip_mm(3, share) == pytest.approx((10 * np.cos(angle), 10 * np.sin(angle), -1))
        assert track.tip_mm(4, share) == pytest.approx((-10 * np.cos(angle), -10 * np.sin(angle), -1 - share))


def test_the_tool_stands_while_it_dwells(track: TipTrack) -> None:
    dwelling_s = float(track.ends_s[1]) + 1.9
    row = track.row_at(dwelling_s)
    assert row == 2 and track.share_at(row, dwelling_s) == 0
    assert track.tip_mm(row, 0.0) == pytest.approx((10, 0, 5))
    assert 0 < track.share_at(row, dwelling_s + 0.5) < 1


def test_lines_lead_to_rows_and_back(track: TipTrack) -> None:
    assert [track.row_of_line(line) for line in (1, 2, 3, 4, 5, 6, 9, 99)] == [0, 0, 1, 1, 1, 2, 5, 5]


def test_it_steps_by_line_and_by_move(track: TipTrack) -> None:
    ends_s = track.ends_s.tolist()
    within_s = (ends_s[2] + ends_s[3]) / 2
    assert (track.before_s(within_s, True), track.next_s(within_s, True)) == (ends_s[2], ends_s[3])
    assert (track.before_s(ends_s[0], True), track.next_s(ends_s[5], True)) == (0.0, ends_s[5])
    twice = replace(track, line=np.array([2, 3, 6, 7, 7, 9]))
    assert twice.next_s(ends_s[2], True) == ends_s[4] and twice.before_s(ends_s[4], True) == ends_s[2]
    assert twice.next_s(ends_s[2], False) == ends_s[3] and twice.before_s(ends_s[4], False) == ends_s[3]


def test_an_unknown_position_is_never_guessed() -> None:
    toolpath = interpret("G21 G90\nG0 Z5\nG0 X10 Y4\n", Start())
    track = TipTrack.of(toolpath, np.array([1.0, 2.0]))
    assert np.isnan(track.tip_mm(0, 0.5)[:2]).all()
    assert track.tip_mm(1, 0.5) == pytest.approx((10, 4, 5))


def test_it_survives_its_file(track: TipTrack, tmp_path: Path) -> None:
    track.save(tmp_path / "moves.npz")
    again = TipTrack.load(tmp_path / "moves.npz")
    assert again.duration_s == track.duration_s > 2
    assert again.tip_mm(4, 0.3) == pytest.approx(track.tip_mm(4, 0.3))
