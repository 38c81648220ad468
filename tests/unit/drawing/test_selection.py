# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chains selected by their attributes; levels of nesting; chains as plain data."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from CNCStepper.drawing.chain_list import chain_rows, counts_of, drawing_box_mm
from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.nesting_levels import nesting_levels
from CNCStepper.drawing.selection import Selection
from CNCStepper.geometry.curve import circle, straight

ROUND = Chain(circle((0, 0), 10), Attributes("Corte 1", "#ff0000", "anel[1]", ("Placa", "furos"), True))
LINE = Chain(straight((-5, 2), (5, 2)), Attributes("notas"))


@pytest.mark.parametrize(
    ("keys", "taken"),
    [
        ({}, (True, True)),
        ({"layer": "corte*"}, (True, False)),
        ({"layer": ["x", "NOTAS"]}, (False, True)),
        ({"layer": "Corte"}, (False, False)),
        ({"layer": "Corte ?"}, (True, False)),
        ({"colour": "#FF0000"}, (True, False)),
        ({"colour": ""}, (False, True)),
        ({"name": "anel[1]"}, (True, False)),
        ({"group": "fur*"}, (True, False)),
        ({"closed": True}, (True, False)),
        ({"closed": False, "filled": False}, (False, True)),
        ({"layer": "*", "filled": True}, (True, False)),
    ],
)
def test_a_chain_is_taken_by_its_attributes(keys: dict, taken: tuple[bool, bool]) -> None:
    selection = Selection(**keys)
    assert (selection.takes(ROUND), selection.takes(LINE)) == taken
    assert selection.words


@pytest.mark.parametrize("keys", [{"layer": 3}, {"closed": 1}, {"layer": "x" * 300}, {"size": 3}])
def test_what_is_no_selection_is_refused(keys: dict) -> None:
    with pytest.raises(ValidationError):
        Selection(**keys)


def test_a_pattern_of_many_stars_takes_no_time() -> None:
    assert not Selection(layer="*a" * 20 + "b").takes(Chain(LINE.curve, Attributes("a" * 60)))


def test_levels_count_the_curves_around_each_one() -> None:
    rings = [circle((0, 0), radius) for radius in (40, 10, 30, 20)]
    levels = nesting_levels([*rings, circle((100, 0), 5), straight((0, 0), (1, 0))])
    assert levels.tolist() == [0, 3, 1, 2, 0, 0]
    assert nesting_levels([]).tolist() == []


def test_a_row_has_what_the_reader_found() -> None:
    row, line = chain_rows(Drawing((ROUND, LINE)))
    assert row == {
        "layer": "Corte 1", "colour": "#ff0000", "name": "anel[1]", "groups": ["Placa", "furos"], "closed": True,
        "filled": True, "length_mm": 62.831853, "area_mm2": 314.159265, "box_mm": [-10.0, -10.0, 10.0, 10.0],
    }  # fmt: skip
    assert line["area_mm2"] == 0 and line["length_mm"] == 10 and line["closed"] is False
    assert drawing_box_mm((ROUND, LINE)) == (-10, -10, 10, 10)
    assert [(count.layer, count.closed, count.open) for count in counts_of((ROUND, LINE, LINE))] == [
        ("Corte 1", 1, 0), ("notas", 0, 2),
    ]  # fmt: skip
