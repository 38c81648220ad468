# SPDX-License-Identifier: LGPL-2.1-or-later
"""The answers of a lathe's timeline process: what is drawn of a moment, the diameter at a Z, the mesh."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from CNCStepper.job.start_state_file import write_start
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.turned_groups_file import read_groups
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.job.turning.turning_proof_folder import write_job_question
from CNCStepper.workers.turned_timeline import Answers

JOBS = Path(__file__).resolve().parents[3] / "examples" / "jobs"


def answers(name: str, folder: Path, part: int) -> Answers:
    job, machine = load_turning_job(JOBS / f"lathe-{name}.toml")
    program = make_turning(job, machine, name)[part - 1].program
    write_job_question(folder, program, job, machine, part, name)
    write_start(folder, None)
    return Answers(folder, name)


def test_a_moment_has_its_part_and_its_diameter(tmp_path: Path) -> None:
    asked = answers("thread", tmp_path, 2)
    end_s = asked._timeline.duration_s
    profile = np.array(asked._proven.verdict.report()["profile"])
    z_mm = -74.0
    first = asked.to({"at": end_s, "open_deg": 90.0, "z_mm": z_mm})
    assert first["diameter_mm"] == pytest.approx(np.interp(z_mm, *profile.T), abs=1e-5)
    groups = read_groups(tmp_path, first["groups"])
    assert {"section", "chuck", "raw", "tool-2"} <= set(groups)
    assert all(counts.sum() == len(points) == len(normals) for points, normals, counts in groups.values())
    tools = {name for name in groups if name.startswith("cut-")}
    assert tools == {"cut-1", "cut-2"}  # the first tool's surface is behind the thread, which the second has cut
    again = asked.to({"at": 0.0, "open_deg": 90.0, "z_mm": None})
    assert again["diameter_mm"] is None
    assert not {"chuck", "tool-2"} & {name for name, *_ in again["groups"]}
    assert asked.to({"at": 0.0, "open_deg": 180.0, "z_mm": None})["groups"][-1][0] in ("chuck", "jaws")
    assert 0 < first["operations_s"][0] <= end_s


def test_the_mesh_of_a_moment_is_written(tmp_path: Path) -> None:
    asked = answers("cylinder", tmp_path, 1)
    assert asked.to({"mesh": 0.0}) == {"at": 0.0, "mesh": "part.stl"}
    facets = int(np.frombuffer((tmp_path / "part.stl").read_bytes()[80:84], "<u4")[0])
    assert facets == 4 * 180  # a bar: two discs, and two to each step round it
