# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a program's text: clean examples are clean, and a program broken on purpose is caught."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from CNCStepper.job.make import Made, make_program
from CNCStepper.job.model import Job, load_job
from CNCStepper.job.prove import Proof, prove_job
from CNCStepper.machine.profile import Machine
from CNCStepper.recovery.restart.prove_restart import restart_job
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.state import Start

JOBS = Path(__file__).parents[3] / "examples" / "jobs"


@pytest.fixture(scope="module")
def pocket() -> tuple[Job, Machine, Made]:
    job, machine = load_job(JOBS / "elliptical-pocket.toml")
    return job, machine, make_program(job, machine)


@pytest.fixture(scope="module")
def clean(pocket: tuple[Job, Machine, Made]) -> Proof:
    return proven(pocket, pocket[2].program)


def proven(pocket: tuple[Job, Machine, Made], text: str) -> Proof:
    job, machine, _ = pocket
    return prove_job(job, machine, text, "pocket.nc", Start.with_work_zero((-200, -200, -40)))


def lines_of(pocket: tuple[Job, Machine, Made]) -> list[str]:
    return pocket[2].program.splitlines()


def test_the_pocket_is_clean_and_within_its_tolerance(clean: Proof) -> None:
    assert not clean.findings
    assert clean.report["gouge_mm"] <= 0.01
    assert clean.report["left_over_mm"] <= 0.01
    assert not clean.report["islands"]
    volume_mm3 = math.pi * 40 * 25 * 10
    assert abs(clean.report["removed_volume_mm3"] / volume_mm3 - 1) < 0.002


def test_the_engraving_is_clean() -> None:
    job, machine = load_job(JOBS / "brazil-engraving.toml")
    proof = prove_job(job, machine, make_program(job, machine).program, start=Start.with_work_zero((-300, -300, -40)))
    assert not proof.findings
    assert len(proof.toolpath) > 202


def test_rows_name_the_files_lines_and_its_operations(pocket: tuple[Job, Machine, Made], clean: Proof) -> None:
    lines = lines_of(pocket)
    last_arc = max(number for number, line in enumerate(lines, 1) if line.startswith("G3"))
    assert last_arc in clean.toolpath.table().line
    assert [span.name for span in clean.toolpath.spans if span.kind == "operation"] == ["elliptical pocket"]


@pytest.mark.slow
def test_a_missing_finishing_pass_is_caught(pocket: tuple[Job, Machine, Made]) -> None:
    lines = lines_of(pocket)
    end = max(number for number, line in enumerate(lines) if line.startswith("G3"))
    begin = max(number for number in range(end) if not lines[number].startswith("G3"))
    proof = proven(pocket, "\n".join(lines[:begin] + lines[end + 1 :]))
    assert proof.refused
    assert proof.report["left_over_mm"] > 0.2


@pytest.mark.slow
def test_a_shifted_arc_centre_is_caught(pocket: tuple[Job, Machine, Made]) -> None:
    """Move the centre of one finishing arc along the bisector of its chord: a valid arc that cuts 0.05 mm too far."""
    lines = lines_of(pocket)
    last = max(number for number, line in enumerate(lines) if line.startswith("G3"))
    lines[last] = bulged(lines[last - 1], lines[last], 0.05)
    proof = proven(pocket, "\n".join(lines))
    gouges = [finding for finding in proof.findings if finding.code == "gouge"]
    assert gouges and proof.refused
    assert 0.03 < proof.report["gouge_mm"] < 0.07


@pytest.mark.slow
def test_a_work_zero_off_the_table_is_caught(pocket: tuple[Job, Machine, Made]) -> None:
    job, machine, made = pocket
    proof = prove_job(job, machine, made.program, start=Start.with_work_zero((-36.99, -200, -40)))
    assert [finding.code for finding in proof.findings if finding.severity == "error"] == ["travel"]
    assert not prove_job(job, machine, made.program, start=Start.with_work_zero((-37.0, -200, -40))).refused


def bulged(before: str, arc: str, more_mm: float) -> str:
    """Return an arc block with the same ends whose apex lies `more_mm` farther out."""
    begin, words = numbers(before), numbers(arc)
    centre = (begin["X"] + words["I"], begin["Y"] + words["J"])
    chord = (words["X"] - begin["X"], words["Y"] - begin["Y"])
    length, radius = math.hypot(*chord), math.hypot(words["I"], words["J"])
    sagitta = radius - math.sqrt(radius**2 - length**2 / 4) + more_mm
    radius = (length**2 / 4 + sagitta**2) / (2 * sagitta)
    inwards = (-chord[1] / length, chord[0] / length)  # the centre of a counter-clockwise arc lies on the left
    middle = (begin["X"] + chord[0] / 2, begin["Y"] + chord[1] / 2)
    centre = tuple(middle[k] + inwards[k] * (radius - sagitta) for k in (0, 1))
    i, j = centre[0] - begin["X"], centre[1] - begin["Y"]
    return f"G3 X{words['X']:.3f} Y{words['Y']:.3f} I{i:.3f} J{j:.3f}"


def numbers(block: str) -> dict[str, float]:
    return {word[0]: float(word[1:]) for word in block.split() if word[0] in "XYIJ"}


def test_a_shape_beside_the_stock_is_told(pocket: tuple[Job, Machine, Made]) -> None:
    job, machine, _ = pocket
    aside = job.model_copy(update={"operation": (job.operation[0].model_copy(update={"centre_mm": (1000.0, 0.0)}),)})
    proof = prove_job(aside, machine, make_program(aside, machine).program)
    assert "beside-stock" in [finding.code for finding in proof.findings]


@pytest.mark.slow
def test_the_published_method_tells_how_far_its_wall_is_off(pocket: tuple[Job, Machine, Made]) -> None:
    job, machine, _ = pocket
    change = {"method": "dda", "resolution_mm": 0.2}
    dda = job.model_copy(update={"operation": (job.operation[0].model_copy(update=change),)})
    proof = prove_job(dda, machine, make_program(dda, machine).program)
    assert [finding.code for finding in proof.findings if finding.severity == "warning"] == ["not-exact"]
    assert not proof.refused


@pytest.mark.slow
def test_a_pocket_through_the_stock_leaves_nothing(pocket: tuple[Job, Machine, Made]) -> None:
    job, machine, _ = pocket
    through = job.model_copy(update={"operation": (job.operation[0].model_copy(update={"depth_mm": 20.5}),)})
    proof = prove_job(through, machine, make_program(through, machine).program)
    assert [finding.code for finding in proof.findings if finding.severity != "info"] == ["below-stock"]
    assert not proof.report["islands"]


def test_another_program_is_proven_with_stock_and_tools_alone(pocket: tuple[Job, Machine, Made]) -> None:
    job, machine, _ = pocket
    alone = job.model_copy(update={"operation": ()})
    slot = "G21 G90\nT1\nM3 S9000\nG4 P3\nG0 Z10\nX-20 Y0\nG1 Z-2 F200\nX20 F600\nG0 Z10\nM5\nM2\n"
    proof = prove_job(alone, machine, slot)
    assert not proof.refused and proof.report["gouge_mm"] is None and proof.part.heights_mm.min() < -1.9
    assert prove_job(alone, machine, slot.replace("G1 Z-2 F200", "G0 Z-2")).refused
    rest = restart_job(alone, machine, slot, RequestedPlace(line=8))
    assert not rest.proof.refused and "X20 F600" in rest.restart.text
