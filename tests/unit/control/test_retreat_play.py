# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut where the play of the axes is taken up in the lines sent, judged by where the tool really was."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from cut_table import ROUNDING_MM, STEP_MM, Cut, path_of, polyline, worst_distance_mm
from test_jog_in_hold import SAMPLE_MM, jogged, led, off_path

from CNCStepper.machine.profile import Machine, load_machine

pytestmark = pytest.mark.slow
NEAR_MM = STEP_MM + ROUNDING_MM
GAP_MM = 0.6
ZIGZAG = (
    "G21 G90\nG0 Z-2\nG1 X-5 Y-5 F600\nM3 S8000\nG1 Z-3 F300\nX-9 Y-7 F600\nX-6 Y-9 F100\nG2 X-10 Y-9 I-2 J0 F900\nM2\n"
)
PAUSED = ZIGZAG.replace("G2 X", "M0\nG2 X")


def loose() -> Machine:
    machine = load_machine("table-a")
    axes = {name: axis.model_copy(update={"backlash_mm": GAP_MM}) for name, axis in machine.axis.items()}
    return machine.model_copy(update={"axis": axes})


def gap_mm(cut: Cut) -> float:
    """How far the motor of X stands ahead of its tool."""
    return cut.table.board.axes.position_mm[0] - cut.trace[-1][0]


def held_in_the_gap(cut: Cut):
    """Hold while the motor of X crosses its gap at the corner, and the tool stands there."""
    yield lambda: cut.trace[-1][0] < -8.99 and gap_mm(cut) > 0.02
    yield from cut.hold()
    assert 0.05 < gap_mm(cut) < GAP_MM - 0.05


def whole(cut: Cut, person, program: str) -> None:
    """Let the job run with a person at it, and judge its way and its end."""
    outcome = cut.run(person)
    assert outcome.done and not cut.refused, outcome.text
    assert np.allclose(cut.trace[-1], polyline(path_of(program))[-1], atol=STEP_MM)


@pytest.mark.parametrize("legs", [("rest",), ("back", "rest"), ("aside", "back", "back", "rest")])
def test_hold_in_the_gap_leads_anywhere_along_the_cut(tmp_path: Path, legs: tuple[str, ...]) -> None:
    cut = Cut(tmp_path, ZIGZAG, loose())

    def person():
        yield from held_in_the_gap(cut)
        for leg in legs:
            yield from led(cut, leg, 1.5)

    whole(cut, person, ZIGZAG)
    assert worst_distance_mm(cut.trace, polyline(path_of(ZIGZAG))) <= NEAR_MM


def test_way_back_that_is_held_in_a_gap_of_its_own_goes_on_from_there(tmp_path: Path) -> None:
    cut = Cut(tmp_path, ZIGZAG, loose())

    def person():
        yield lambda: cut.trace[-1][0] > -8.0 and cut.trace[-1][1] < -7.1
        yield from cut.hold()
        found = []
        yield from cut.find(found)
        yield from cut.go(found[0].along(found[0].back_by(4.0)))
        yield lambda: gap_mm(cut) < GAP_MM - 0.1
        yield from cut.hold()
        assert 0.05 < gap_mm(cut) < GAP_MM - 0.05
        yield from led(cut, "back", 0.5)
        yield from led(cut, "rest")

    whole(cut, person, ZIGZAG)
    assert worst_distance_mm(cut.trace, polyline(path_of(ZIGZAG))) <= NEAR_MM


@pytest.mark.parametrize(
    "jogs", [[(0.0, 0.0, 0.4)], [(0.0, 0.0, 1.5), (3.0, -2.0, 0.0)], [(0.9, 0.9, 0.0), (-0.9, -0.9, 0.0)]]
)
def test_jogged_tool_is_back_on_its_cut_whichever_side_its_motors_come_from(tmp_path: Path, jogs: list) -> None:
    """Out of a hold and back to where the motors stood too: they may be on the other side of their gaps."""
    cut = Cut(tmp_path, ZIGZAG, loose())

    def person():
        yield lambda: cut.trace[-1][1] < -7.5
        yield from cut.hold()
        yield from led(cut, "aside")
        for x_mm, y_mm, z_mm in jogs:
            yield from jogged(cut, x_mm=x_mm, y_mm=y_mm, z_mm=z_mm)
        yield from led(cut, "rest")

    whole(cut, person, ZIGZAG)
    (away,) = off_path(cut, ZIGZAG)
    assert np.linalg.norm(away[0] - away[-1]) < SAMPLE_MM


def test_way_back_begins_at_a_pause_from_which_a_loose_machine_was_jogged(tmp_path: Path) -> None:
    cut = Cut(tmp_path, PAUSED, loose())

    def person():
        yield cut.arrived
        yield from jogged(cut, z_mm=1.0)
        yield from jogged(cut, x_mm=2.0, y_mm=-2.0)
        yield from led(cut, "back", 3.0)
        yield from led(cut, "rest")
        yield lambda: cut.phase == "paused"
        cut.sender.resume()

    whole(cut, person, PAUSED)
    (away,) = off_path(cut, PAUSED)
    assert np.linalg.norm(away[0] - away[-1]) < SAMPLE_MM
