# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be cut safely is refused with a sentence that says what to change, and the table stays empty."""

from __future__ import annotations

import math
import random
import time
from typing import Any

import numpy as np
import pytest

from CNCStepper.cycles.catalogue import cycle_class
from CNCStepper.cycles.contours.engrave import Engrave
from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.passes import MOST_BLOCKS, MOST_PASSES, whole_passes
from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.errors import CNCStepperError, CycleError, JobError
from CNCStepper.machine.profile import validated
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder

POCKET = {
    "tool": 1,
    "radius_x_mm": 40,
    "radius_y_mm": 25,
    "depth_mm": 10,
    "stepdown_mm": 2,
    "stepover_mm": 2.4,
    "finish_stepdown_mm": 0.2,
    "finish_stepover_mm": 0.3,
}
LINE = {"tool": 1, "curves": [{"xy": [[0, 0], [10, 0]], "bulge": [0]}], "depth_mm": 1}
TINY = {"radius_x_mm": 0.1, "radius_y_mm": 0.1, "stepover_mm": 0.01, "finish_stepover_mm": 0}
TOOL = {"number": 1, "shape": "flat", "diameter_mm": 6, "feed_mm_min": 800, "plunge_mm_min": 200}


def refusal(
    model: type, values: dict[str, Any], tool: dict[str, Any], heights_mm: tuple[float, float] = (10, 2)
) -> str:
    """Return the sentence with which a job's operation is refused; the table must stay empty."""
    table = TableBuilder(Start())
    with pytest.raises(CNCStepperError) as caught:
        operation = validated(model, values, "job.toml operation 1")
        operation.cut(Setup(validated(Tool, TOOL | tool, "job.toml tool 1"), 10, 2), table)
    assert isinstance(caught.value, (CycleError, JobError))
    assert table.index == 0 and not table.spans and not table._open_spans
    return str(caught.value)


@pytest.fixture(scope="module", autouse=True)
def compiled() -> None:
    """Cut pockets first: where kernels are still to be compiled, that takes longer than a refusal may."""
    for method in ("tolerance", "dda"):
        operation = validated(EllipticalPocket, POCKET | {"method": method}, "job.toml operation 1")
        operation.cut(Setup(validated(Tool, TOOL, "job.toml tool 1"), 10, 2), TableBuilder(Start()))


@pytest.mark.parametrize(
    "values, tool, words",
    [
        ({}, {"diameter_mm": 50}, ["wider than the pocket", "50 mm", "below 50 mm", "smaller tool"]),
        ({"radius_x_mm": 2}, {}, ["wider than the pocket", "6 mm", "below 4 mm"]),
        ({}, {"diameter_mm": math.inf}, ["diameter_mm", "value inf mm", "10000 mm"]),
        ({"stepover_mm": 6.1}, {}, ["stepover_mm (ae)", "larger than the tool", "6.1 mm", "6 mm", "smaller"]),
        ({"finish_stepover_mm": 3.5}, {}, ["finish_stepover_mm", "3.5 mm", "2.99", "less"]),
        ({"finish_stepover_mm": 22}, {}, ["finish_stepover_mm"]),
        ({"finish_stepdown_mm": 10}, {}, ["finish_stepdown_mm", "nothing to rough", "below 10 mm", "smaller"]),
        ({"finish_stepdown_mm": 10 - 1e-12}, {}, ["nothing to rough"]),
        ({}, {"shape": "ball"}, ["ball", "flat floor", "use a flat tool"]),
        ({}, {"feed_mm_min": 0}, ["no feed_mm_min", "0 mm/min", "give the tool"]),
        ({}, {"plunge_mm_min": 0}, ["no plunge_mm_min"]),
        ({}, {"feed_mm_min": math.inf}, ["feed_mm_min"]),
        ({"method": "dda"}, {"diameter_mm": 32}, ["tighter than the tool", "16 mm", "15.625 mm", '"tolerance"']),
        ({"method": "dda", "resolution_mm": 1}, {}, ["resolution_mm", "coarse", "1 mm", "0.938 mm", "smaller"]),
        ({"method": "dda", "resolution_mm": 1e-12}, {}, ["resolution_mm", "0.001", "1e-12"]),
        ({"method": "dda", "resolution_mm": 2e-3}, {}, ["blocks", f"{MOST_BLOCKS} blocks", "larger"]),
        ({"method": "dda", "finish_stepover_mm": 2.5}, {}, ["finish_stepover_mm", "2.5 mm"]),
        ({}, {"diameter_mm": 47}, ["too narrow", "helix", '"plunge"']),
        ({"radius_x_mm": 25, "entry": "ramp"}, {"diameter_mm": 49}, ["too narrow", "ramp", '"plunge"']),
        ({"stepdown_mm": 0.001, "depth_mm": 11}, {}, ["stepdown_mm", f"{MOST_PASSES} passes", "larger"]),
        ({"stepdown_mm": 1e-12}, {}, ["stepdown_mm", "value 1e-12 mm", "0.001 to 10000 mm"]),
        ({"stepdown_mm": 1e-320}, {}, ["stepdown_mm", "value 9.99"]),
        ({"stepover_mm": 0.001}, {}, ["stepover_mm", f"{MOST_PASSES} passes", "at least", "larger"]),
        ({"stepover_mm": 1e-12}, {}, ["stepover_mm", "value 1e-12 mm"]),
        ({"stepdown_mm": 0.0011, "stepover_mm": 0.05}, {}, ["blocks"]),
        ({"entry_angle_deg": 1e-9}, {}, ["entry_angle_deg", "0.1"]),
        (TINY | {"entry_angle_deg": 0.1, "depth_mm": 10_000, "stepdown_mm": 100}, {"diameter_mm": 0.02}, ["blocks"]),
        ({"centre_mm": [1e7, 0]}, {}, ["centre_mm.0", "100000"]),
        ({"depth_mm": -1}, {}, ["depth_mm", "-1 mm", "0.001"]),
        ({"depth_mm": 0}, {}, ["depth_mm", "0 mm", "0.001"]),
        ({"depth_mm": 1e9}, {}, ["depth_mm", "10000"]),
        ({"radius_x_mm": 1e300}, {}, ["radius_x_mm", "100000"]),
        ({"radius_x_mm": 10**400}, {}, ["radius_x_mm"]),
        ({"radius_y_mm": math.nan}, {}, ["radius_y_mm", "nan mm"]),
        ({"rotation_deg": math.inf}, {}, ["rotation_deg", "inf deg"]),
        ({"centre_mm": [math.nan, 0]}, {}, ["centre_mm.0", "nan mm"]),
        ({"centre_mm": [0]}, {}, ["centre_mm", "too few values", "give all of them"]),
        ({"tolerance_mm": 0}, {}, ["tolerance_mm", "0.003"]),
        ({"stepover_mm": -1}, {}, ["stepover_mm"]),
        ({"finish_stepover_mm": -0.1}, {}, ["finish_stepover_mm"]),
        ({"entry": "jump"}, {}, ["entry", "'helix', 'ramp' or 'plunge'"]),
        ({"method": "spline"}, {}, ["method", "'tolerance' or 'dda'"]),
        ({"stepsideways_mm": 1}, {}, ["no key stepsideways_mm", "stepover_mm"]),
        ({"depth_mm": None}, {}, ["depth_mm"]),
        ({"radius_x_mm": "wide"}, {}, ["radius_x_mm", "'wide'"]),
    ],
)
def test_pockets_that_are_refused(values: dict[str, Any], tool: dict[str, Any], words: list[str]) -> None:
    began_s = time.process_time()
    sentence = refusal(EllipticalPocket, POCKET | values, tool)
    assert all(word in sentence for word in words), sentence
    assert time.process_time() - began_s < 3.0


@pytest.mark.parametrize(
    "values, tool, words",
    [
        ({"closed": True}, {}, ["does not end where it began", "closed = false"]),
        ({"depth_mm": -1}, {}, ["depth_mm"]),
        ({"stepdown_mm": 0.001, "depth_mm": 11}, {}, ["stepdown_mm", "10000 passes", "larger"]),
        ({"curves": []}, {}, ["curves"]),
        ({"curves": [{"xy": [[0, 0]], "bulge": []}]}, {}, ["curves.0", "two points"]),
        ({"curves": [{"xy": [[0, 0], [math.nan, 1]], "bulge": [0]}]}, {}, ["curves.0", "length in mm"]),
        ({"curves": [{"xy": [[0, 0], [10**400, 1]], "bulge": [0]}]}, {}, ["curves.0"]),
        ({"curves": [{"xy": "abc", "bulge": [0]}]}, {}, ["curves.0"]),
        ({"curves": ["abc"]}, {}, ["curves.0"]),
        ({"curves": [{"xy": [[1, 1], [1, 1]], "bulge": [0]}]}, {}, ["no length"]),
        ({"offset_mm": [1e7, 0]}, {}, ["offset_mm.0", "100000"]),
        ({"simplify_mm": -1}, {}, ["simplify_mm"]),
        ({"simplify_mm": math.inf}, {}, ["simplify_mm"]),
        ({"points": "a.csv"}, {}, ["no key points", "curves"]),
        ({}, {"feed_mm_min": 0}, ["no feed_mm_min"]),
        ({}, {"plunge_mm_min": 0}, ["no plunge_mm_min"]),
    ],
)
def test_engravings_that_are_refused(values: dict[str, Any], tool: dict[str, Any], words: list[str]) -> None:
    sentence = refusal(Engrave, LINE | values, tool)
    assert all(word in sentence for word in words), sentence


def test_too_many_blocks_of_an_engraving_are_refused() -> None:
    points = [[math.cos(i), i * 0.01] for i in range(5000)]
    values = {"tool": 1, "curves": [{"xy": points, "bulge": [0] * 4999}], "depth_mm": 1, "stepdown_mm": 0.001}
    assert "blocks" in refusal(Engrave, values, {})


@pytest.mark.parametrize("name", ["", "Pocket", "Elliptical_Pocket"])
def test_an_unknown_cycle_is_refused(name: str) -> None:
    with pytest.raises(JobError, match=r"there is no cycle.*use one of: .*elliptical_pocket, engrave"):
        cycle_class(name)
    assert cycle_class("engrave") is Engrave


def test_whole_passes_fill_the_whole() -> None:
    assert whole_passes(10, 2, 0.2, "stepdown_mm") == pytest.approx([1.96] * 5 + [0.2])
    assert whole_passes(10, 2, 0, "stepdown_mm") == pytest.approx([2.0] * 5)
    assert whole_passes(0.3 * 3, 0.3, 0, "stepdown_mm") == pytest.approx([0.3] * 3)  # 0.9 / 0.3 is a little above 3
    assert whole_passes(1, 1e308, 0, "stepdown_mm") == [1]


def extreme(rng: random.Random) -> dict[str, Any]:
    """Return POCKET with up to four values out of the ordinary."""
    odd = [0, -1, 1e-320, 1e-300, 1e-15, 1e-9, 1e-6, 1e-3, 0.1, 1, 5.999999, 6, 24.999, 25, 40, 1e3, 1e5, 1e6, 1e300]
    odd += [math.nan, math.inf, -math.inf, "12", "", None, True, [1, 2]]
    keys = [
        *(key for key in POCKET if key != "tool"),
        "rotation_deg",
        "entry_angle_deg",
        "tolerance_mm",
        "resolution_mm",
    ]
    changes: dict[str, Any] = {key: rng.choice(odd) for key in rng.sample(keys, rng.randint(1, 4))}
    changes["method"], changes["entry"] = rng.choice(["tolerance", "dda"]), rng.choice(["helix", "ramp", "plunge"])
    return POCKET | changes


@pytest.mark.slow
def test_no_extreme_value_ends_in_anything_but_a_cut_or_a_refusal() -> None:
    seed = random.randrange(10**6)
    print("seed", seed)
    rng = random.Random(seed)
    cuts = refusals = 0
    for number in range(250):
        values, diameter_mm = extreme(rng), rng.choice([6, 6, 1e-9, 1e-3, 49.9999, 50, 1e9])
        if number == 0:
            values, diameter_mm = POCKET, 6
        table = TableBuilder(Start())
        try:
            operation = validated(EllipticalPocket, values, "job.toml")
            tool = validated(Tool, TOOL | {"diameter_mm": diameter_mm}, "job.toml")
            operation.cut(Setup(tool, 10, 2), table)
        except CNCStepperError:
            assert table.index == 0, values
            refusals += 1
        else:
            rows = table.toolpath().table()
            assert np.isfinite(rows.end).all() and np.isfinite(rows.centre).all() and np.isfinite(rows.feed).all()
            cuts += 1
    assert cuts and refusals > 100
