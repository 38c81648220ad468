# SPDX-License-Identifier: LGPL-2.1-or-later
"""New objects begin with values from which a part can be cut at once."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from CNCStepper.workbench.document import default_values


def box(x_mm: float, y_mm: float, z_mm: float) -> Any:
    centre = SimpleNamespace(x=x_mm / 2, y=y_mm / 2)
    return SimpleNamespace(XLength=x_mm, YLength=y_mm, ZLength=z_mm, ZMax=z_mm, Center=centre)


def test_a_solid_is_the_stock_itself() -> None:
    values = default_values.stock_of_solid(box(80.000000012, 60, 15))
    assert values == {
        "stock_size_mm": (80.0, 60.0, 15.0),
        "stock_origin": "top-centre",
        "work_origin_mm": (40.0, 30.0, 15.0),
    }


def test_a_drawing_lies_on_the_stock_with_a_margin() -> None:
    values = default_values.stock_of_drawing(box(80, 60, 0))
    assert values["stock_size_mm"] == (100.0, 80.0, 20.0)
    assert values["work_origin_mm"] == (40.0, 30.0, 0.0)


@pytest.mark.parametrize(("origin", "centre"), [("top-centre", (0.0, 0.0)), ("top-left-front", (25.0, 15.0))])
def test_a_pocket_from_numbers_lies_in_the_middle_of_the_stock(origin: str, centre: tuple[float, float]) -> None:
    values = default_values.pocket((50.0, 30.0, 4.0), origin, 3.0, drawn=False)
    assert values["centre_mm"] == centre
    assert values["radius_x_mm"] < 25
    assert values["radius_y_mm"] < 15
    assert 0 < values["stepdown_mm"] <= values["depth_mm"] < 4
    assert 0 < values["stepover_mm"] <= 3


def test_a_drawing_gives_a_pocket_its_shape() -> None:
    assert not {"centre_mm", "radius_x_mm", "radius_y_mm"} & set(
        default_values.pocket((50, 30, 4), "top-centre", 3, True)
    )


def test_an_engraving_stays_in_thin_stock() -> None:
    assert default_values.engraving((50, 30, 0.5))["depth_mm"] == 0.25
