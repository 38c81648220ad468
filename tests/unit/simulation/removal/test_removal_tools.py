# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a tool's shape, and beams: a jet and a wire cut through the sheet wherever they are held."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.profile import validated
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW
from helpers.simulation.programs import begun

SHEET = Stock((40, 30, 3))


@pytest.mark.parametrize(
    ("keys", "match"),
    [
        ({"shape": "flat", "corner_radius_mm": 1}, "a flat tool has no corner_radius_mm"),
        ({"shape": "drill", "tip_angle_deg": 90}, "a drill tool has no tip_angle_deg"),
        ({"shape": "drill", "core_diameter_mm": 1}, "a drill tool has no core_diameter_mm"),
        ({"shape": "v", "taper_deg": 0}, "a v tool has no taper_deg"),
        ({"shape": "bullnose", "corner_radius_mm": 3.5}, "must not exceed half of diameter_mm"),
        ({"shape": "v", "tip_diameter_mm": 6}, "must be below diameter_mm"),
        ({"shape": "v", "tip_angle_deg": 180}, "tip_angle_deg"),
        ({"shape": "jet", "taper_deg": 50}, "taper_deg"),
        ({"shape": "flat", "flute_length_mm": 30, "length_mm": 20}, "must not exceed length_mm"),
    ],
)
def test_keys_that_do_not_fit_the_shape_are_refused(keys: dict, match: str) -> None:
    with pytest.raises(JobError, match=match):
        validated(Tool, {"number": 1, "diameter_mm": 6} | keys, "job.toml")


@pytest.mark.parametrize("shape", ["jet", "wire"])
def test_a_beam_cuts_its_kerf_through_the_sheet(shape: str) -> None:
    beam = Tool(number=1, shape=shape, diameter_mm=0.8)
    program = begun().rapid(-10, -4, 1.5).feed(10, 5, 1.5)
    part = height_map(program.toolpath(), beam, SHEET, 0.05)
    assert part.removed_volume_mm3 == pytest.approx(3 * (np.hypot(20, 9) * 0.8 + np.pi * 0.16), rel=1e-3)
    off = begun(spindle="off").rapid(-10, -4, 1.5).feed(10, 5, 1.5)
    assert height_map(off.toolpath(), beam, SHEET, 0.05).removed_volume_mm3 == 0


@pytest.mark.parametrize("shape", ["jet", "wire"])
@pytest.mark.parametrize("taper_deg", [0.0, 4.0])
@pytest.mark.parametrize("way", ["line", "ramp", "arc", "circle", "helix"])
def test_a_beam_s_kerf_is_exact_on_every_way_and_converges(shape: str, taper_deg: float, way: str) -> None:
    """What is lost of the sheet is the kerf's mean width along the way, and at open ends a frustum."""
    beam = Tool(number=1, shape=shape, diameter_mm=1.6, taper_deg=taper_deg)
    narrow = 0.8 - 3 * np.tan(np.radians(taper_deg))
    program, length, is_open = begun(spindle="off").rapid(9, 0, 1.5).set(spindle="cw"), 0.0, True
    if way in ("line", "ramp"):
        program.feed(-8, 7, 1.5 if way == "line" else 6.0)
        length = np.hypot(17, 7)
    elif way == "arc":
        program.arc(ARC_CCW, (0, 9, 1.5), (0, 0, 1.5))
        length = np.pi / 2 * 9
    else:  # as a beam goes through everywhere, a helix' second turn finds nothing
        turns = 2 if way == "helix" else 1
        program.arc(ARC_CCW, (9, 0, 1.5 if turns == 1 else 4.5), (0, 0, 1.5), turns=turns)
        length, is_open = 2 * np.pi * 9, False
    frustum = np.pi * 3 * (0.8**2 + 0.8 * narrow + narrow**2) / 3 if is_open else 0.0
    want = 3 * length * (0.8 + narrow) + frustum
    toolpath = program.toolpath()
    coarse, fine = (abs(height_map(toolpath, beam, SHEET, c).removed_volume_mm3 / want - 1) for c in (0.4, 0.05))
    assert fine < 1e-3
    assert fine < max(coarse / 4, 3e-4)


def test_a_tapered_kerf_is_narrower_below() -> None:
    beam = Tool(number=1, shape="jet", diameter_mm=1.6, taper_deg=5)
    part = height_map(begun().rapid(-10, 0, 1.5).feed(10, 0, 1.5).toolpath(), beam, SHEET, 0.05)
    narrow = 0.8 - 3 * np.tan(np.radians(5))
    frustum = np.pi * 3 * (0.8**2 + 0.8 * narrow + narrow**2) / 3
    assert part.removed_volume_mm3 == pytest.approx(3 * 20 * (0.8 + narrow) + frustum, rel=1e-3)
