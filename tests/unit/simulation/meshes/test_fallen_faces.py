# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of fallen pieces: their area, no holes, their moments, and what a proof's folder keeps of them."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import shapely

from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.proof_folder import read_answer, write_question
from CNCStepper.simulation.exact.free_pieces import FreePiece
from CNCStepper.simulation.meshes.fallen_faces import ABOVE_MM, FLAT_MM, FallenFaces, fallen_faces
from CNCStepper.workers.proof import answer as answer_question

ROOT = Path(__file__).parents[4]
PLATE = shapely.box(0, 0, 40, 30).difference(
    shapely.union_all([shapely.Point(x, y).buffer(4, quad_segs=64) for x, y in ((10, 10), (30, 10), (20, 22))])
)
SLUG = shapely.Point(10, 10).buffer(3, quad_segs=64)


def piece(shape: shapely.Geometry, end_s: float) -> FreePiece:
    return FreePiece(shape, 0, 1, end_s, 0, False, [])


def areas(faces: FallenFaces) -> list[float]:
    """The area of each piece, from the corners that are drawn."""
    found = []
    for points, counts in faces:
        rings = np.split(points.astype(float), np.cumsum(counts)[:-1])
        found.append(sum(shapely.Polygon(ring).area for ring in rings))
        assert all(shapely.Polygon(ring).is_valid for ring in rings)
    return found


def test_a_piece_with_holes_becomes_faces_without_and_keeps_its_area() -> None:
    faces = fallen_faces([piece(PLATE, 9.0), piece(SLUG, 2.0)], 0.0)
    assert areas(faces) == pytest.approx([SLUG.area, PLATE.area], abs=FLAT_MM * PLATE.length)
    assert faces.points[:, 2] == pytest.approx(ABOVE_MM) and len(faces.counts) > 2


def test_pieces_fall_in_their_order_and_those_of_earlier_programs_at_once() -> None:
    both = shapely.MultiPolygon([shapely.box(50, 0, 60, 10), shapely.box(70, 0, 80, 10)])
    faces = fallen_faces([piece(PLATE, 9.0), piece(SLUG, 2.0), piece(both, math.nan)], 3.0)
    assert areas(faces)[0] == pytest.approx(200.0)
    assert [faces.fallen_at(time_s) for time_s in (0.0, 1.9, 2.0, 8.0, 9.0)] == [1, 1, 2, 2, 3]


def test_nothing_falls_where_nothing_is_cut_free(tmp_path: Path) -> None:
    faces = fallen_faces([], 0.0)
    assert len(faces) == 0 == faces.fallen_at(1e9) and list(faces) == []
    faces.save(tmp_path / "fallen.npz")
    assert len(FallenFaces.load(tmp_path / "fallen.npz")) == 0


@pytest.mark.slow
def test_the_folder_of_a_proof_keeps_them_with_the_moments_of_the_report(tmp_path: Path) -> None:
    job, machine = load_job(ROOT / "examples" / "jobs" / "gasket-plasma.toml")
    write_question(tmp_path, make_program(job, machine).program, job, machine)
    answer_question(tmp_path, "gasket.nc")
    found = read_answer(tmp_path)
    told = found.report["pieces"]
    assert len(found.fallen) == len(told) > 6
    assert found.fallen.falls_s == pytest.approx([one["falls_at_s"] for one in told], abs=1e-5)
    assert areas(found.fallen) == pytest.approx([one["area_mm2"] for one in told], rel=0.03)
    assert set(found.fallen.falls_s) <= set(found.moves.ends_s)
