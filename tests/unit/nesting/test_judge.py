# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judge sees each kind of fault that is planted in a sound layout."""

from __future__ import annotations

from dataclasses import replace

import pytest
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.nesting.judge import faults, require_sound
from CNCStepper.nesting.nesting_model import Item, Layout, Placement, Sheet, Spacing, Unplaced

SQUARE = shapely.box(0, 0, 10, 10)
ITEMS = (Item("square", SQUARE, SQUARE, 3, (0.0, 90.0), grain_deg=0.0),)
SHEETS = (Sheet("plate", shapely.box(0, 0, 50, 30), grain_deg=0.0),)
SPACING = Spacing(2.0, 4.0)
SOUND = (Placement(0, 0, 4.0, 4.0, 0.0), Placement(0, 0, 16.0, 4.0, 0.0), Placement(0, 0, 38.0, 26.0, 180.0))
TURNS = (replace(ITEMS[0], rotations_deg=(0.0, 90.0, 180.0)),)


def found(placements: tuple[Placement, ...], **more: object) -> list[str]:
    return list(faults(TURNS, SHEETS, SPACING, Layout(placements, **more)))  # type: ignore[arg-type]


def test_a_sound_layout_has_no_fault() -> None:
    assert found(SOUND) == []
    assert found(SOUND[:2], unplaced=(Unplaced(0, 1, "full"),)) == []
    require_sound(TURNS, SHEETS, SPACING, Layout(SOUND))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"x_mm": 13.999}, "too close"),
        ({"x_mm": 4.5, "y_mm": 4.5}, "too close"),
        ({"x_mm": 37.0, "y_mm": 4.0}, "beyond the sheet"),
        ({"x_mm": 300.0}, "beyond the sheet"),
        ({"x_mm": 34.0, "rotation_deg": 90.0}, "is turned by 90 deg"),
    ],
)
def test_a_planted_fault_is_found(change: dict[str, float], words: str) -> None:
    moved = (SOUND[0], replace(SOUND[1], **change), SOUND[2])
    assert any(words in fault for fault in found(moved))
    with pytest.raises(GeometryError, match=words):
        require_sound(TURNS, SHEETS, SPACING, Layout(moved))


def test_a_part_too_few_and_a_sheet_of_other_stock_are_found() -> None:
    assert any("lies there 2 times" in fault for fault in found(SOUND[:2]))
    other = (replace(SHEETS[0], stock="brass 1 mm"),)
    assert any("other stock" in fault for fault in faults(TURNS, other, SPACING, Layout(SOUND)))


def test_parts_that_touch_without_a_gap_are_sound() -> None:
    touching = (Placement(0, 0, 0.0, 0.0, 0.0), Placement(0, 0, 10.0, 0.0, 0.0), Placement(0, 0, 20.0, 0.0, 0.0))
    assert not list(faults(TURNS, SHEETS, Spacing(), Layout(touching)))
    deep = (touching[0], replace(touching[1], x_mm=9.99999), touching[2])
    assert list(faults(TURNS, SHEETS, Spacing(), Layout(deep)))
