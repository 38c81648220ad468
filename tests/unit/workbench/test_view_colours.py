# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that are drawn together are told apart by all, also by people who see red, green or blue poorly.

What they see is computed after Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color
vision deficiency", IEEE TVCG 15 (2009), for whom one kind of cones is missing; the distance is that of CIE L*a*b*.
"""

from __future__ import annotations

import ast
import re
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.simulation.views.comparison_picture import COLOURS as COMPARED
from CNCStepper.simulation.views.picture_style import COLOURS as PICTURE
from CNCStepper.workbench.services import view_colours as view

WORKBENCH = Path(__file__).parents[3] / "CNCStepper" / "workbench"
LEAST = 20.0  # of two thin lines beside each other; 2.3 is just seen on large areas
SEEN_BY = {
    "all cones": np.eye(3),
    "no red cones": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "no green cones": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "no blue cones": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
XYZ = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)
WHITE = np.array([0.95047, 1.0, 1.08883])  # of D65
OF_FREECAD = {"FreeCAD's rapid": (2 / 3, 0.0, 0.0), "FreeCAD's feed": (0.0, 2 / 3, 0.0)}  # its preview of a program
STOCK = {"stock": view.STOCK_RGB, "clamp": view.CLAMP_RGB}
PATH = {"rapid": view.RAPID_RGB, "feed": view.FEED_RGB, "finding": view.MARKER_RGB}


def constants(module: str, *names: str) -> dict[str, tuple[float, ...]]:
    """Return colours of a module that cannot be imported without FreeCAD's 3D view."""
    text = (WORKBENCH / module).read_text("utf-8")
    return {name: ast.literal_eval(re.search(rf"^{name}.* = (\(.*?\))", text, re.MULTILINE)[1]) for name in names}


def of_hex(colours: dict[str, str], *names: str) -> dict[str, tuple[float, ...]]:
    return {name: tuple(part / 255 for part in bytes.fromhex(colours[name][1:])) for name in names}


TOGETHER = {
    "simulation and editor": {**PATH, **STOCK},
    "live": {"reported": view.REPORTED_RGB, "finding": view.MARKER_RGB, **STOCK},
    "preview": {**OF_FREECAD, **STOCK},
    "pictures": of_hex(PICTURE, "rapids", "feeds", "arcs", "plunges", "zero", "limits"),
    "half sections": of_hex(PICTURE, "rapids", "feeds", "wanted", "zero"),
    "comparison": of_hex(COMPARED, "common", "first", "second"),
    "freehand": constants("freehand/preview_wire.py", "LINE", "HANDLE", "HOT"),
    "templates": constants("templates/taken_view.py", "TAKEN", "UNTAKEN"),
}


def lab(rgb: tuple[float, ...], seen_by: str) -> np.ndarray:
    """Return what somebody sees of a colour of sRGB as L*, a*, b*."""
    given = np.array(rgb)
    linear = np.where(given <= 0.04045, given / 12.92, ((given + 0.055) / 1.055) ** 2.4)
    share = XYZ @ np.clip(SEEN_BY[seen_by] @ linear, 0.0, 1.0) / WHITE
    root = np.where(share > 216 / 24389, np.cbrt(share), (24389 / 27 * share + 16) / 116)
    return np.array([116 * root[1] - 16, 500 * (root[0] - root[1]), 200 * (root[1] - root[2])])


def alike(colours: dict[str, tuple[float, ...]]) -> list[str]:
    """Return the pairs that somebody takes for each other."""
    found = []
    for (one, a), (other, b) in combinations(colours.items(), 2):
        for seen_by in SEEN_BY:
            distance = float(np.linalg.norm(lab(a, seen_by) - lab(b, seen_by)))
            if distance < LEAST:
                found.append(f"{one} and {other}, {seen_by}: {distance:.0f}")
    return found


@pytest.mark.parametrize("place", TOGETHER)
def test_colours_that_are_drawn_together_are_told_apart(place: str) -> None:
    assert not alike(TOGETHER[place])


def test_red_and_green_are_found_alike() -> None:
    assert alike({"red": (0.6, 0.3, 0.1), "green": (0.4, 0.42, 0.1)})
    assert lab((1.0, 1.0, 1.0), "all cones") == pytest.approx([100, 0, 0], abs=0.02)
    assert lab((1.0, 0.0, 0.0), "all cones") == pytest.approx([53.24, 80.09, 67.20], abs=0.05)
