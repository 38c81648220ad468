# SPDX-License-Identifier: LGPL-2.1-or-later
"""The core's refusals beside the fields that they speak of."""

from __future__ import annotations

from typing import Any

import pytest

from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.errors import CycleError
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.workbench.panels.field_errors import complaints, key_of, labelled

POCKET = {"radius_x_mm": 40.0, "radius_y_mm": 25.0, "depth_mm": 10.0, "stepdown_mm": 2.0, "stepover_mm": 2.4}
TOOL = {"number": 1, "shape": "flat", "diameter_mm": 6.0, "feed_mm_min": 800.0}


def limit(key: str, number: float) -> str:
    return f"{number:g} of {key}"


@pytest.mark.parametrize(
    ("model", "values", "key", "sentence"),
    [
        (EllipticalPocket, POCKET | {"depth_mm": 0.0}, "depth_mm", "must be at least 0.001 of depth_mm"),
        (EllipticalPocket, POCKET | {"depth_mm": 2e4}, "depth_mm", "must be at most 10000 of depth_mm"),
        (EllipticalPocket, POCKET | {"finish_stepdown_mm": -1.0}, "finish_stepdown_mm", "must be at least 0"),
        (EllipticalPocket, POCKET | {"finish_stepdown_mm": 1e-8}, "finish_stepdown_mm", "must be 0, or at least 0.001"),
        (EllipticalPocket, POCKET | {"centre_mm": (2e5, 0.0)}, "centre_mm", "must be at most 100000"),
        (Tool, TOOL | {"diameter_mm": -6.0}, "diameter_mm", "must be at least 0.001"),
        (Tool, TOOL | {"number": 256}, "number", "must be at most 255"),
    ],
)
def test_a_model_s_limit_stands_at_its_field(model: Any, values: dict[str, Any], key: str, sentence: str) -> None:
    found = complaints(model, values, limit)
    assert list(found) == [key]
    assert sentence in str(found[key])


def test_what_is_good_or_not_in_the_form_is_not_complained_of() -> None:
    assert complaints(EllipticalPocket, POCKET, limit) == {}  # its tool's number is missing: no field of this form


def test_a_sentence_of_the_cut_finds_its_field_and_speaks_its_label() -> None:
    keys = {"stepdown_mm": "Depth per pass", "stepover_mm": "Width per pass", "finish_stepdown_mm": "Last pass: depth"}
    wide = CycleError("stepover-wide", "stepover_mm (ae) is larger than the tool")
    large = CycleError("finish-large", "finish_stepdown_mm leaves nothing to rough")
    tool = CycleError("tool-shape", "a ball tool leaves no flat floor")
    assert [key_of(error, keys) for error in (wide, large, tool)] == ["stepover_mm", "finish_stepdown_mm", ""]
    assert labelled(large.sentence, keys) == "“Last pass: depth” leaves nothing to rough"


def test_a_field_is_found_by_its_word_without_the_unit() -> None:
    error = CycleError("tolerance", "the tolerance must not be negative")
    assert key_of(error, ["points_mm", "tolerance_mm"]) == "tolerance_mm"
