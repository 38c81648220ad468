# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces that have fallen are hatched in every picture that shows them, with their holes, and in the legend."""

import numpy as np
import pytest
import shapely
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch

from CNCStepper.simulation.exact.free_pieces import FreePiece
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.views.fallen_pieces import HATCH, draw_fallen, fallen_until
from CNCStepper.simulation.views.path_lines import Until
from CNCStepper.simulation.views.proof_picture import save_picture
from CNCStepper.simulation.views.scene import scene_at
from helpers.simulation.programs import FLAT, begun

RING = shapely.box(0, 0, 20, 20).difference(shapely.box(5, 5, 15, 15))


def piece(row: int, shape: shapely.Polygon = RING) -> FreePiece:
    return FreePiece(shape, row, row + 1, float(row), 0, False, [])


def test_a_piece_counts_from_the_end_of_its_row() -> None:
    pieces = [piece(3), piece(5)]
    tip = np.zeros(3)
    counts = [
        len(fallen_until(pieces, Until(row, share, tip))) for row, share in ((3, 0.9), (3, 1.0), (4, 0.1), (9, 1.0))
    ]
    assert counts == [0, 1, 1, 2]
    assert fallen_until(pieces, None) == ()


def test_a_patch_has_the_piece_with_its_hole_at_its_height() -> None:
    axes = Figure().add_subplot()
    heights = []

    def project(points: np.ndarray) -> np.ndarray:
        heights.append(points[:, 2])
        return points[:, :2]

    two = shapely.MultiPolygon([RING, shapely.box(30, 0, 40, 9)])
    assert draw_fallen(axes, [two], -3.0, project) == ["fallen"]
    patches = [one for one in axes.patches if isinstance(one, PathPatch)]
    assert len(patches) == 2 and all(one.get_hatch() == HATCH for one in patches)
    assert (np.concatenate(heights) == -3.0).all()
    areas = [shapely.LinearRing(ring).is_ccw for ring in patches[0].get_path().to_polygons()]
    assert areas == [True, False]  # the hole runs the other way, so that it stays empty
    assert draw_fallen(axes, [], 0.0, project) == []


@pytest.mark.slow
def test_a_picture_with_fallen_pieces_says_so(tmp_path) -> None:
    toolpath = begun().feed(10, 0, -1).toolpath()
    part = HeightMap(Stock((60, 50, 3)))
    texts = []
    for pieces in ([], [piece(0)]):
        scene = scene_at(toolpath, np.arange(1.0, len(toolpath) + 1), part, FLAT, pieces=pieces)
        save_picture(tmp_path / "p.svg", scene, "p.nc")
        texts.append((tmp_path / "p.svg").read_text("utf-8"))
    assert ["<!-- piece cut free -->" in text for text in texts] == [False, True]
