# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plate of examples/jobs: pocket with islands, bolt circle, grid and outline, from the file to the proven part."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.job.make import cut_operations, make_program
from CNCStepper.job.model import Job, load_job
from CNCStepper.job.prove import Proof, prove_job
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.tip_segments import segments

PLATE = Path(__file__).parents[3] / "examples" / "jobs" / "plate.toml"
MEANT = {"place-unknown", "not-exact", "below-stock"}  # drills and outline go through, corners are round
DIGIT_MM = {"mm": 0.001, "inch": 0.00254}


@pytest.fixture(scope="module")
def plate() -> tuple[Job, Machine]:
    return load_job(PLATE)


@pytest.fixture(scope="module")
def proofs(plate: tuple[Job, Machine]) -> dict[str, Proof]:
    job, machine = plate
    jobs = {units: job.model_copy(update={"units": units}) for units in DIGIT_MM}
    made = {units: make_program(each, machine) for units, each in jobs.items()}
    return {
        units: prove_job(each, machine, made[units].program, answers=made[units].answers)
        for units, each in jobs.items()
    }


def test_the_plate_names_its_shapes(plate: tuple[Job, Machine]) -> None:
    job, _ = plate
    pocket, *drills, contour = job.operation
    assert [len(curve) for curve in (*pocket.outlines, *pocket.islands, *contour.curves)] == [8, 2, 4, 5]
    assert [operation.cycle for operation in drills] == ["drill", "drill"]
    assert job.setup(contour).stock.area_mm2 == 160 * 110
    assert job.notes == ()


@pytest.mark.slow
def test_run_makes_the_whole_plate(tmp_path: Path) -> None:
    result = CliRunner().invoke(group, ["run", str(PLATE), "--out", str(tmp_path)])
    assert result.exit_code == 0, result.output
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["errors"] == 0 and {finding["code"] for finding in report["findings"]} <= MEANT
    assert report["gouge_mm"] <= 0.01 and report["left_over_mm"] <= 0.01
    assert [operation["name"] for operation in report["operations"]] == ["pocket", "drill", "drill", "contour"]
    assert report["tools"] == [1, 3]


@pytest.mark.slow
def test_the_plate_in_inches_is_the_same_part(proofs: dict[str, Proof]) -> None:
    for proof in proofs.values():
        assert not proof.refused and {finding.code for finding in proof.findings} <= MEANT
        assert proof.report["gouge_mm"] <= 0.01 and proof.report["left_over_mm"] <= 0.01
    mm, inch = (proofs[units].part for units in ("mm", "inch"))
    assert mm is not None and inch is not None
    off = np.abs(mm.heights_mm - inch.heights_mm) > sum(DIGIT_MM.values())
    # a wall that moves by a digit shifts the cells on it, and no other
    assert off.mean() < 0.002
    assert inch.removed_volume_mm3 == pytest.approx(mm.removed_volume_mm3, rel=2e-4)


@pytest.mark.slow
@pytest.mark.parametrize("units", DIGIT_MM)
def test_the_text_read_back_is_the_table_of_the_cycles_to_the_written_digit(
    plate: tuple[Job, Machine], proofs: dict[str, Proof], units: str
) -> None:
    wanted, _ = cut_operations(plate[0])
    read = proofs[units].toolpath
    for one, other in ((wanted, read), (read, wanted)):
        points = segments(one, 0.01).known().end
        line = segments(other, 0.001).known()
        points = points[points[:, 2] < 0.0]
        assert len(points) > 500
        assert _distances(points, line.begin, line.end).max() < 2.0 * DIGIT_MM[units] + 0.001


def _distances(points: np.ndarray, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Return how far each point lies from the nearest segment, all in space."""
    along = end - begin
    square = np.maximum((along**2).sum(axis=1), 1e-30)
    nearest = []
    for point in points:
        share = np.clip(((point - begin) * along).sum(axis=1) / square, 0.0, 1.0)
        nearest.append(np.sqrt(((begin + share[:, None] * along - point) ** 2).sum(axis=1).min()))
    return np.array(nearest)
