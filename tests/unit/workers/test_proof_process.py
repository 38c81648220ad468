# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that proves: its answer in a folder, its refusals, and its end when nobody waits any more."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.control.program.certificate import sendable
from CNCStepper.errors import CNCStepperError
from CNCStepper.job import prove
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.proof_folder import PART, RESULT, read_answer, read_part, write_question
from CNCStepper.job.prove import prove_job
from CNCStepper.job.start_state_file import read_start, write_start
from CNCStepper.simulation.tip_track import TipTrack
from CNCStepper.state import Start
from CNCStepper.workers.proof import answer as answer_question

JOBS = Path(__file__).parents[3] / "examples" / "jobs"
LIMIT_S = 120
TOLD = ["read", "cut", "part", "make", "time", "judge", "check", "report"]
START = Start.with_work_zero((-200.0, -180.0, -60.0))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    path = tmp_path / "à parte"
    path.mkdir()
    return path


def asked(folder: Path, text: str | None = None) -> str:
    job, machine = load_job(JOBS / "elliptical-pocket.toml")
    program = make_program(job, machine).program if text is None else text
    write_question(folder, program, job, machine)
    return program


def started(folder: Path, *, loaded: bool = False) -> subprocess.Popen[str]:
    words = command(sys.executable, "CNCStepper.workers.proof")
    process = subprocess.Popen(
        words, env=environment(), stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8"
    )
    assert process.stdout
    if loaded:
        assert process.stdout.readline() == "ready\n"
    ask(process, folder)
    return process


def ask(process: subprocess.Popen[str], folder: Path) -> None:
    assert process.stdin
    process.stdin.write(json.dumps([str(folder), "pocket.nc"]) + "\n")
    process.stdin.flush()


def ended(process: subprocess.Popen[str]) -> tuple[int, list[str]]:
    """Wait for its end while its standard input stays open."""
    assert process.stdout and process.stdin
    told = process.stdout.read().split()
    status = process.wait(LIMIT_S)
    process.stdin.close()
    process.stdout.close()
    return status, told


@pytest.mark.slow
@pytest.mark.parametrize("loaded", [False, True])
def test_the_answer_is_that_of_prove_job(folder: Path, loaded: bool) -> None:
    program = asked(folder)
    assert ended(started(folder, loaded=loaded)) == (0, TOLD)
    answer = read_answer(folder)
    proof = prove_job(*load_job(JOBS / "elliptical-pocket.toml"), program, "pocket.nc")
    assert answer.report == proof.report and answer.findings == proof.findings and not answer.refused
    assert answer.moves.duration_s == proof.times_s[-1]
    assert (answer.part.heights_mm == proof.part.heights_mm).all()
    sent = sendable(answer.send_file)
    assert tuple(sent.lines) == proof.wire.lines and list(sent.file_lines) == proof.wire.file_lines.tolist()


@pytest.mark.slow
def test_the_part_is_there_before_the_program_is_judged(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def part_alone(*_: object) -> None:
        assert {PART} == {path.name for path in folder.iterdir()} - asked_files
        raise CNCStepperError("judge", "as far as this")

    program = asked(folder)
    asked_files = {path.name for path in folder.iterdir()}
    part = prove_job(*load_job(JOBS / "elliptical-pocket.toml"), program).part
    monkeypatch.setattr(prove, "judge", part_alone)
    with pytest.raises(CNCStepperError, match="as far as this"):
        answer_question(folder, "pocket.nc")
    assert capsys.readouterr().out.split() == TOLD[: TOLD.index("judge") + 1]
    seen = read_part(folder)
    assert (seen.heights_mm == part.heights_mm).all() and len(seen.corners) == len(seen.rgba) > 0
    assert not (folder / RESULT).exists()


@pytest.mark.slow
def test_a_refusal_comes_back_as_it_was_raised(folder: Path) -> None:
    asked(folder, "G21 G90\nG0 X1 X2\n")
    assert ended(started(folder))[0] == 1
    with pytest.raises(CNCStepperError) as refusal:
        read_answer(folder)
    assert refusal.value.place is not None and refusal.value.place.line == 2


@pytest.mark.slow
def test_it_ends_and_takes_its_folder_away_when_nobody_waits(folder: Path) -> None:
    asked(folder)
    process = started(folder)
    assert process.stdout and process.stdin
    process.stdout.readline()
    process.stdin.close()
    assert process.wait(LIMIT_S) == 1 and not folder.exists()
    process.stdout.close()


def test_no_answer_is_said(folder: Path) -> None:
    with pytest.raises(CNCStepperError, match="without an answer"):
        read_answer(folder)


@pytest.mark.slow
def test_a_known_start_is_proven_from_and_stands_in_the_certificate(folder: Path) -> None:
    program = asked(folder)
    write_start(folder, START)
    assert read_start(folder) == START
    assert ended(started(folder))[0] == 0
    answer = read_answer(folder)
    job, machine = load_job(JOBS / "elliptical-pocket.toml")
    at_home = prove_job(job, machine, program, "pocket.nc")
    assert "place-unknown" in {finding.code for finding in at_home.findings}
    assert "place-unknown" not in {finding.code for finding in answer.findings} and not answer.refused
    sent = sendable(answer.send_file)
    assert sent.work_system == "G54" and tuple(sent.work_offsets_mm["G54"]) == (-200, -180, -60)
    assert answer.part.heights_mm == pytest.approx(at_home.part.heights_mm, abs=1e-9)  # all in work coordinates
    assert answer.part.low_mm.tolist() == list(job.stock.stock().low_mm)
    assert answer.moves.end[-1][:2] == pytest.approx(TipTrack.of(at_home.toolpath, at_home.times_s).end[-1][:2])
    deepest, widest = answer.feeds.points.min(axis=0), answer.feeds.points.max(axis=0)
    assert deepest[2] == pytest.approx(-10) and (abs(widest[:2]) < 50).all() and (abs(deepest[:2]) < 50).all()


@pytest.mark.slow
def test_a_start_too_near_to_the_table_s_edge_is_refused(folder: Path) -> None:
    asked(folder)
    write_start(folder, replace(START, work_offsets_mm={"G54": (-10.0, -180.0, -60.0)}))
    assert ended(started(folder))[0] == 0
    answer = read_answer(folder)
    assert answer.refused
    (finding,) = [finding for finding in answer.findings if finding.severity == "error"]
    assert finding.code == "travel" and "travel of X" in finding.text


def test_a_start_comes_back_as_it_was(tmp_path: Path) -> None:
    assert read_start(tmp_path) is None
    write_start(tmp_path, None)
    assert read_start(tmp_path) is None
    start = replace(START, position_mm=(1.0, 2.0, 3.0), tool=2, tool_lengths_mm={2: 5.5}, parameters={100: 1.0})
    write_start(tmp_path, start)
    assert read_start(tmp_path) == start and read_start(tmp_path).sha256() == start.sha256()
