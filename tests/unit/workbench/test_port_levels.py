# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motors' lines of a parallel port: worked out of the positions of status reports."""

from __future__ import annotations

from dataclasses import replace

from CNCStepper.control.session.status import SenderStatus
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.workbench.machines.port_levels import MotorLines

TABLE = load_machine("thesis-table")  # X step 2, direction 3; Y step 4, direction 5
AT = SenderStatus("running", mpos_mm=(1.0, 1.0, 0.0))


def lines_after(*places_mm: tuple[float, float], machine: Machine = TABLE, phase: str = "running") -> MotorLines:
    lines = MotorLines()
    for x_mm, y_mm in places_mm:
        lines.take(machine, replace(AT, mpos_mm=(x_mm, y_mm, 0.0), phase=phase))
    return lines


def test_the_direction_is_the_sign_of_the_change_and_stays() -> None:
    assert lines_after((1, 1)).levels == {}, "nothing is known before it has moved"
    away = lines_after((1, 1), (2, 0.5))
    assert away.levels == {3: False, 5: True} and away.pulsing == {2, 4}
    stays = lines_after((1, 1), (2, 0.5), (1.5, 0.5), (1.5, 0.5))
    assert stays.levels == {3: True, 5: True} and stays.pulsing == frozenset()


def test_the_same_status_again_changes_nothing_and_none_forgets_all() -> None:
    lines = lines_after((1, 1), (2, 1))
    last = lines._last
    lines.take(TABLE, last)
    assert lines.pulsing == {2}
    lines.take(TABLE, None)
    assert (lines.levels, lines.pulsing) == ({}, frozenset())


def test_nothing_pulses_at_rest() -> None:
    at_rest = lines_after((1, 1), (2, 1), phase="idle")
    assert at_rest.levels == {3: False} and at_rest.pulsing == frozenset()


def test_active_low_lines_and_motors_mounted_the_other_way_round() -> None:
    """The second motor of Y is mounted the other way round; the direction line of X is active low."""
    pins = {"x_step": -2, "x_direction": -3, "y_step": 4, "y_direction": 5, "y2_step": 6, "y2_direction": 7}
    signals = TABLE.signals.model_validate({"motors": ["x", "y", "-y"], "pins": pins})
    lines = lines_after((1, 1), (2, 2), machine=TABLE.model_copy(update={"signals": signals}))
    assert lines.levels == {3: True, 5: False, 7: True} and lines.pulsing == {2, 4, 6}


def test_a_motor_without_pins_has_no_lines() -> None:
    signals = TABLE.signals.model_validate({"motors": ["x", "y"], "pins": {"x_step": 2, "x_direction": 3}})
    lines = lines_after((1, 1), (2, 2), machine=TABLE.model_copy(update={"signals": signals}))
    assert lines.levels == {3: False} and lines.pulsing == {2}
