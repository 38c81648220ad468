# SPDX-License-Identifier: LGPL-2.1-or-later
"""Depths in colours: level faces have the scale's own, walls another, and light comes from one side."""

from __future__ import annotations

import numpy as np

from CNCStepper.simulation.views.depth_colours import MATERIAL, colours_of, deepest_shown_mm, shaded


def test_the_scale_goes_from_the_deepest_cut_to_the_top() -> None:
    ends = colours_of(np.array([-9.0, -8.0, 0.0, 1.0]), -8.0, 0.0)
    lowest, highest = (tuple(bytes.fromhex(MATERIAL[place][1:])) for place in (0, -1))
    assert [tuple(colour) for colour in ends.tolist()] == [lowest, lowest, highest, highest]
    assert deepest_shown_mm(-30, -20, 0) == -20 and deepest_shown_mm(0, -20, 0) == -1


def test_floors_keep_their_colour_and_walls_are_lit_from_the_left_front() -> None:
    corners = np.zeros((3, 4, 3), np.float32)
    corners[..., 2] = -4
    normals = np.array([(0, 0, 1), (-1, 0, 0), (1, 0, 0)], np.float32)
    floor, to_light, from_light = shaded(corners, normals, -8.0, 0.0)
    assert (floor == colours_of(np.array(-4.0), -8.0, 0.0)).all()
    assert (to_light > from_light).all()
