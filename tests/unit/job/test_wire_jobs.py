# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shipped jobs of the hot wire: proven, hot only where they cut, read back in the thesis's language."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from shapely import Polygon

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import Made, make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import Proof, prove_job
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, RAPID

JOBS = Path(__file__).resolve().parents[3] / "examples" / "jobs"


@cache
def proven(name: str) -> tuple[Made, Proof]:
    job, machine = load_job(JOBS / f"{name}.toml")
    made = make_program(job, machine)
    return made, prove_job(job, machine, made.program, answers=made.answers)


@pytest.mark.parametrize("name", ["rib-wire", "thesis-a"])
def test_the_job_is_proven_without_an_error(name: str) -> None:
    _, proof = proven(name)
    assert [str(one) for one in proof.findings if one.severity != "info"] == []


def test_the_rib_is_cut_in_one_way_from_the_edge() -> None:
    made, _ = proven("rib-wire")
    lines = made.program.splitlines()
    assert [line for line in lines if line.startswith(("M3", "M5"))] == ["M3 S1000", "M5"]
    assert lines[lines.index("M3 S1000") + 1] == "G4 P5"
    assert not [line for line in lines if re.search(r"\bZ", line)]
    path = interpret(made.program, Start.at_zero(), "grbl")
    table, begins = path.table(), path.begins()
    feeds = np.flatnonzero(table.kind != RAPID)
    assert (np.diff(feeds) == 1).all()
    assert not 0.0 <= begins[feeds[0], 1] <= 50.0
    assert not 0.0 <= table.end[feeds[-1], 1] <= 50.0


def test_the_thesis_language_reads_its_program_back() -> None:
    made, _ = proven("thesis-a")
    lines = [line for line in made.program.splitlines() if not line.startswith("(")]
    assert not [line for line in lines if re.search(r"[MSTZK]", line)]
    after_arcs = [after for line, after in pairwise(lines) if line.startswith(("G2 ", "G3 "))]
    assert after_arcs
    assert all(after.startswith(("G90", "G2 ", "G3 ", "G0")) for after in after_arcs)
    path, cut = interpret(made.program, Start.at_zero(), "thesis-a").table(), made.toolpath.table()
    assert np.array_equal(path.kind, cut.kind)
    assert np.allclose(path.end[:, :2], cut.end[:, :2], atol=0.0006)
    arcs = cut.kind >= ARC_CCW - 1
    assert arcs.any()
    assert np.allclose(path.centre[arcs, :2], cut.centre[arcs, :2], atol=0.0006)


def test_the_thesis_job_frees_both_parts_whole() -> None:
    made, _ = proven("thesis-a")
    disc, plate = sorted(made.answers[0].parts, key=lambda part: part.area)
    assert isinstance(disc, Polygon)
    assert disc.area == pytest.approx(np.pi * 25.0**2, rel=1e-4)
    assert plate.area == pytest.approx(70.0 * 65.0 - (4.0 - np.pi) * 12.0**2, rel=1e-4)
