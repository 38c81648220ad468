# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a program is cut, from reports that come late and seldom; the path of the reports takes no more memory."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.simulation.tip_follower import AS_NEAR_MM, MOST_POINTS, ReportedPath, TipFollower
from CNCStepper.simulation.tip_track import TipTrack

TEXT = "G21 G90\nG0 X0 Y0 Z0\nG1 X10 F600\nG3 X10 Y10 I0 J5\nG1 X0\nG1 Y0\nG1 X10\nM2\n"


def track() -> TipTrack:
    path = interpret(TEXT)
    return TipTrack.of(path, np.arange(1.0, len(path) + 1))


def test_every_place_of_the_program_gives_its_time() -> None:
    moves = track()
    follower = TipFollower(moves)
    for time_s in np.linspace(1.1, moves.duration_s, 40):
        row = moves.row_at(time_s)
        tip_mm = moves.tip_mm(row, moves.share_at(row, time_s))
        line = int(moves.line[row])
        assert follower.follow(line - 1, line + 2, tip_mm) == pytest.approx(time_s, abs=0.13)  # an eighth of a row


def test_what_is_not_sent_is_not_cut_and_a_tool_aside_changes_nothing() -> None:
    moves = track()
    follower = TipFollower(moves)
    along_both = np.array([5.0, 0.0, 0.0])
    first_s = follower.follow(2, 3, along_both)
    assert first_s == pytest.approx(1.5, abs=0.13)
    assert follower.follow(2, 7, along_both) == first_s  # the last line is sent: the earlier one counts
    assert follower.follow(2, 7, np.array([5.0, 0.0, 30.0])) == first_s
    assert follower.follow(6, 7, along_both) == pytest.approx(5.5, abs=0.13)
    assert follower.follow(2, 3, np.array([1.0, 0.0, 0.0])) > 5  # it never goes back


def test_the_reported_path_stays_small_and_keeps_its_begin_and_end() -> None:
    path = ReportedPath()
    angle = np.linspace(0, 50 * np.pi, 20_000)
    places = np.stack([30 * np.cos(angle), 30 * np.sin(angle), -angle / 100], axis=1)
    for place in places:
        path.add(place)
    assert MOST_POINTS // 2 <= len(path.points_mm) <= MOST_POINTS
    assert path.points_mm[-1] == pytest.approx(places[-1], abs=1e-3)
    assert np.abs(path.points_mm[0] - places[0]).max() < 1
    assert not path.add(places[-1] + AS_NEAR_MM / 2) and not path.add(np.array([np.nan, 0, 0]))
