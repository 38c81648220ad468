# SPDX-License-Identifier: LGPL-2.1-or-later
"""An axis that a machine lacks: a zero of all axes means those it has, a jog of it is refused by its name."""

from types import SimpleNamespace
from typing import Any, cast

import pytest

from CNCStepper.control.operator.jog import Jogger, JogMove
from CNCStepper.control.operator.zero_and_unlock import axes_to_zero
from CNCStepper.control.stream.position_trust import LOST, trust_at_zero
from CNCStepper.errors import MachineRefusal

LATHE = frozenset({"hold", "axis-y"})


@pytest.mark.parametrize(
    ("asked", "cannot", "axes"),
    [("xyz", (), "XYZ"), ("XYZ", LATHE, "XZ"), ("zx", LATHE, "ZX"), ("XYZ", ("axis-z",), "XY"), ("Y", (), "Y")],
)
def test_a_zero_of_all_axes_means_those_there_are(asked: str, cannot: tuple[str, ...], axes: str) -> None:
    assert axes_to_zero(asked, cannot) == axes


@pytest.mark.parametrize(("asked", "named"), [("Y", "Y axis"), ("XY", "Y axis"), ("XA", "no axes"), ("", "no axes")])
def test_a_zero_of_another_axis_is_refused(asked: str, named: str) -> None:
    with pytest.raises(MachineRefusal, match=named):
        axes_to_zero(asked, LATHE)


def test_the_position_is_known_when_all_axes_of_a_lathe_have_their_zero() -> None:
    half = trust_at_zero(LOST, "X", "XZ")
    assert half.position_known is False and trust_at_zero(half, "Z", "XZ").position_known


def test_a_jog_names_the_axis_that_is_missing() -> None:
    driver = SimpleNamespace(status=SimpleNamespace(state="Idle", name="Idle"), cannot=LATHE, clock=lambda: 0.0)
    jogger = Jogger(cast(Any, driver), lambda _: None, lambda *_: None)
    with pytest.raises(MachineRefusal, match="no Y axis"):
        jogger.step(JogMove(1.0, 5.0, 0.0, 100.0))
    assert not jogger.active
