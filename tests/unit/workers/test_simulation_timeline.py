# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that knows the part at any moment: only tiles that differ, pulses, a mesh, refusals, and its end."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.job.make import make_program
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.model import load_job
from CNCStepper.job.proof_folder import MESH, RESULT, TILES, write_answer, write_question
from CNCStepper.job.prove import Proof, prove_job
from CNCStepper.job.start_state_file import write_start
from CNCStepper.motion.planner.plan import begun, step_events
from CNCStepper.simulation.meshes.stl_mesh import STL_FACET
from CNCStepper.simulation.removal.timeline import Timeline
from CNCStepper.simulation.views.coloured_faces import LAP_MM
from CNCStepper.state import Start
from CNCStepper.workers.simulation_timeline import Answers

JOBS = Path(__file__).parents[3] / "examples" / "jobs"
LIMIT_S = 120


@pytest.fixture(scope="module")
def proven(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Proof]:
    folder = tmp_path_factory.mktemp("à parte")
    job, machine = load_job(JOBS / "elliptical-pocket.toml")
    program = make_program(job, machine).program
    write_question(folder, program, job, machine)
    start = Start.with_work_zero((60.0, 50.0, -30.0))
    write_start(folder, start)
    proof = prove_job(job, machine, program, "pocket.nc", start)
    write_answer(folder, proof, job, certificate_of(proof))
    return folder, proof


class Worker:
    """A timeline process, asked one thing after another."""

    def __init__(self, folder: Path):
        self.folder = folder
        words = command(sys.executable, "CNCStepper.workers.simulation_timeline", str(folder))
        self.process = subprocess.Popen(
            words, env=environment(), stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8"
        )

    def ask(self, **question: Any) -> dict[str, Any]:
        assert self.process.stdin and self.process.stdout
        with suppress(BrokenPipeError):  # one that cannot answer may have said so and ended
            self.process.stdin.write(json.dumps(question) + "\n")
            self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def tiles(self, time_s: float) -> dict[int, tuple[bytes, bytes]]:
        """Return corners and colours of the tiles that differ."""
        counts = self.ask(at=time_s)["tiles"]
        data = (self.folder / TILES).read_bytes()
        total = sum(count for _, count in counts)
        assert len(data) == 64 * total
        found, first = {}, 0
        for number, count in counts:
            corners = data[48 * first : 48 * (first + count)]
            found[number] = corners, data[48 * total + 16 * first : 48 * total + 16 * (first + count)]
            first += count
        return found

    def end(self) -> int:
        assert self.process.stdin and self.process.stdout
        with suppress(BrokenPipeError):
            self.process.stdin.close()
        status = self.process.wait(LIMIT_S)
        self.process.stdout.close()
        return status


@pytest.fixture
def worker(proven: tuple[Path, Proof]) -> Iterator[Worker]:
    worker = Worker(proven[0])
    yield worker
    assert worker.end() in (0, 1)


def volume_mm3(tiles: dict[int, tuple[bytes, bytes]]) -> float:
    """Return the volume within the faces, which are drawn a trifle larger than they are."""
    faces = [np.frombuffer(corners, np.float32).reshape(-1, 4, 3).astype(float) for corners, _ in tiles.values()]
    corners = np.concatenate(faces)
    corners -= LAP_MM * np.sign(corners - corners.mean(axis=1, keepdims=True))
    area = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]) / 2
    return float((corners.mean(axis=1) * area).sum() / 3)


@pytest.mark.slow
def test_material_vanishes_forwards_and_comes_back_the_same(worker: Worker, proven: tuple[Path, Proof]) -> None:
    proof = proven[1]
    times_s = np.linspace(0, proof.times_s[-1], 7)
    seen: dict[int, tuple[bytes, bytes]] = {}
    there, sizes = [], []
    for time_s in times_s:
        changed = worker.tiles(float(time_s))
        sizes.append(len(changed))
        seen = seen | changed
        there.append(seen)
    volumes = [volume_mm3(tiles) for tiles in there]
    assert (np.diff(volumes) < 0).all()
    assert volumes[0] - volumes[-1] == pytest.approx(proof.part.removed_volume_mm3, rel=0.01)
    assert sizes[0] == len(seen) > max(sizes[1:])
    for time_s, before in zip(times_s[::-1][1:], there[::-1][1:], strict=True):
        seen = seen | worker.tiles(float(time_s))
        assert seen == before
    assert worker.tiles(0.0) == {}


def test_a_program_with_a_subroutine_in_a_file_beside_it_is_shown_too(tmp_path: Path) -> None:
    (tmp_path / "dent.ngc").write_text("o<dent> sub\nG1 Z-1 F100\nG0 Z5\no<dent> endsub\n", encoding="utf-8")
    job, machine = load_job(JOBS / "elliptical-pocket.toml")
    machine = machine.model_copy(update={"controller": "grblhal"})
    program = "G21 G90 G17\nT1\nM3 S9000\nG0 X10 Y5 Z5\no<dent> call\nG0 X20\no<dent> call\nM2\n"
    folder = tmp_path / "proof"
    folder.mkdir()
    write_question(folder, program, job, machine)
    start = Start.with_work_zero((60.0, 50.0, -30.0))
    write_start(folder, start)
    proof = prove_job(job, machine, program, str(tmp_path / "main.ngc"), start)
    write_answer(folder, proof, job, certificate_of(proof))
    assert Answers(folder).to({"at": 0.0})["tiles"]


@pytest.mark.slow
def test_pulses_are_the_planners(worker: Worker, proven: tuple[Path, Proof]) -> None:
    proof = proven[1]
    pieces = step_events(begun(proof.toolpath), proof.given.machine)
    times_s, positions = (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    middle = len(times_s) // 2
    time_s = float(times_s[middle])
    later, earlier = worker.ask(pulse=time_s, sense=1), worker.ask(pulse=time_s, sense=-1)
    assert later == {"pulse": float(times_s[middle + 1]), "steps": positions[middle + 1].tolist()}
    assert earlier == {"pulse": float(times_s[middle - 1]), "steps": positions[middle - 1].tolist()}
    assert worker.ask(pulse=0.0, sense=-1) == {"pulse": None, "steps": None}


@pytest.mark.slow
def test_the_mesh_of_a_moment_has_its_volume(worker: Worker, proven: tuple[Path, Proof]) -> None:
    folder, proof = proven
    given = proof.given
    time_s = float(proof.times_s[-1]) / 2
    assert worker.ask(mesh=time_s) == {"at": time_s, "mesh": MESH}
    data = (folder / MESH).read_bytes()
    points = np.frombuffer(data, STL_FACET, offset=84)["points"].astype(float)
    volume = np.einsum("ij,ij->", points[:, 0], np.cross(points[:, 1], points[:, 2])) / 6
    part = Timeline(proof.toolpath, proof.times_s, given.tools, given.stock).at(time_s)
    assert volume == pytest.approx(np.prod(given.stock.size_mm) - part.removed_volume_mm3, rel=1e-4)


@pytest.mark.slow
def test_what_cannot_be_answered_is_said_and_ends_it(worker: Worker) -> None:
    assert worker.ask(colour=1)["error"]["code"] == "timeline-question"
    assert worker.process.wait(LIMIT_S) == 1


@pytest.mark.slow
def test_a_folder_without_an_answer_is_said(tmp_path: Path, proven: tuple[Path, Proof]) -> None:
    job, machine = load_job(JOBS / "elliptical-pocket.toml")
    write_question(tmp_path, make_program(job, machine).program, job, machine)
    worker = Worker(tmp_path)
    assert RESULT in worker.ask(at=0.0)["error"]["what"]
    assert worker.end() == 1


@pytest.mark.slow
def test_it_ends_at_once_when_nobody_asks_any_more(proven: tuple[Path, Proof]) -> None:
    worker = Worker(proven[0])
    assert worker.ask(at=1.0)["at"] == 1.0
    assert worker.end() == 0
