# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a restart, asked for and answered in a folder."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.control.program.certificate import Certificate, digest_of_text
from CNCStepper.errors import ProgramError
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.proof_folder import read_answer, write_question
from CNCStepper.recovery.restart.description import words_of
from CNCStepper.recovery.restart.prove_restart import EntryOptions, restart_job
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace, read_place, read_restart, write_place
from CNCStepper.workers.proof import answer

JOB = Path(__file__).parents[3] / "examples" / "jobs" / "cycles" / "bore.toml"


@pytest.mark.parametrize(
    "place",
    [
        RestartPlace(RequestedPlace(line=12, time=2), 1.5, 7.25),
        RestartPlace(RequestedPlace(operation="pocket", contour=3)),
        RestartPlace(RequestedPlace(at_mm=(1.0, -2.5, -0.1))),
        None,
    ],
)
def test_a_place_is_read_as_it_was_written(tmp_path: Path, place: RestartPlace | None) -> None:
    write_place(tmp_path, place)
    assert read_place(tmp_path) == place


@pytest.mark.slow
def test_the_answer_is_that_of_restart_job(tmp_path: Path) -> None:
    job, machine = load_job(JOB)
    program = make_program(job, machine).program
    where = RequestedPlace(contour=2)
    write_question(tmp_path, program, job, machine)
    write_place(tmp_path, RestartPlace(where, 0.5, 12.0))
    answer(tmp_path, "bore")
    proven = restart_job(job, machine, program, where, EntryOptions(0.5, 12.0), file="bore")
    told = read_restart(tmp_path)
    assert told is not None and told.program == proven.restart.text
    assert told.words == tuple(words_of(proven.restart))
    found = read_answer(tmp_path)
    assert found.report == proven.proof.report and found.part.heights_mm.shape == proven.proof.part.heights_mm.shape
    content = Certificate.read(found.send_file).content
    assert content["program"]["sha256"] == digest_of_text(told.program)
    assert content["before"] == [digest_of_text(program)]
    assert content["send"]["restart_of"]["program_sha256"] == digest_of_text(program)


def test_a_place_that_is_none_is_refused(tmp_path: Path) -> None:
    job, machine = load_job(JOB)
    write_question(tmp_path, make_program(job, machine).program, job, machine)
    write_place(tmp_path, RestartPlace(RequestedPlace(line=100_000)))
    with pytest.raises(ProgramError, match="nothing moves at line 100000"):
        answer(tmp_path, "bore")
    assert read_restart(tmp_path) is None
