# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job's file into a spool by another process: the same job, the same refusals, and no whole program in memory."""

from __future__ import annotations

import tracemalloc

import pytest

from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate, digest_of_lines
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.spool_process import spooled
from CNCStepper.errors import CNCStepperError, Place
from helpers.control.service_bench import Visit

LINES = ("G21G90G94", "G1X-2F1500", "G1Y-2", "G1X0", "G1Y0")
MANY = 50_000
ONE_LIST_BYTES = 8 * MANY  # the least that holds so many lines, their texts not counted


def write_job(path, lines):
    path.write_text(SendJob("nowhere", lines, file="part ç.nc").to_json(), "utf-8")
    return path


def write_certificate(path, lines, findings=()):
    content = {"format": FORMAT, "version": VERSION, "findings": list(findings)}
    content |= {"wire": {"sha256": digest_of_lines(lines), "dialect": "grbl"}}
    content |= {"send": {"lines": list(lines), "file": "part ç.nc", "messages": {"1": "turn it"}}}
    path.write_text(Certificate(content).to_json(), "utf-8")
    return path


@pytest.mark.parametrize("write", [write_job, write_certificate])
def test_job_is_that_of_the_file_with_other_values(tmp_path, write):
    spool = tmp_path / "a desk ç.wire"
    job = spooled(write(tmp_path / "a job ç.json", LINES), spool, port="/dev/é", baud=9600, zero_confirmed=True)
    assert tuple(job.lines) == LINES and job.place(4) == Place("part ç.nc", 5)
    assert (job.port, job.baud, job.zero_confirmed) == ("/dev/é", 9600, True)
    assert sorted(tmp_path.glob("*.wire")) == [spool]
    if write is write_certificate:
        assert job.messages == {1: "turn it"} and job.certificate_sha256


@pytest.mark.slow
def test_refusal_comes_as_it_was_and_leaves_the_job_before(tmp_path):
    spool = tmp_path / "desk.wire"
    before = spooled(write_job(tmp_path / "good.json", LINES), spool)
    error = {"severity": "error", "file": "part.nc", "line": 3, "column": 1, "text": "the spindle stands still"}
    bad = {
        "certificate-errors": write_certificate(tmp_path / "errors.json", LINES, [error]),
        "acting-byte": write_job(tmp_path / "two.json", ["G1X1", "G1X2\nM3"]),
        "send-job": write_job(tmp_path / "numbers.json", [1, 2]),
    }
    refusals = {}
    for code, file in bad.items():
        with pytest.raises(CNCStepperError) as refused:
            spooled(file, spool)
        refusals[code] = refused.value
    assert [error.code for error in refusals.values()] == list(bad)
    assert refusals["certificate-errors"].place == Place("part.nc", 3, 1)
    assert tuple(before.lines) == LINES and list(tmp_path.glob("*.wire")) == [spool]


def test_what_a_killed_spooler_left_is_no_hindrance(tmp_path):
    spool = tmp_path / "desk.wire"
    (tmp_path / "desk.new.wire").write_text("1 G1X99\n")
    assert tuple(spooled(write_job(tmp_path / "job.json", LINES), spool).lines) == LINES


def write_long_job(folder, count: int):
    return write_job(folder / f"{count}.json", ["G21G90G94", *["G1X-1F6000", "G1X0F6000"] * (count // 2)])


def cut_some(folder, file) -> None:
    """Let a desk run a job until some of its lines are cut."""
    visit = Visit(folder)

    def person():
        visit.ask("set_zero", axes="XYZ")
        visit.ask("run", file=str(file), zero_confirmed=True, allow_differences=False)
        yield lambda: visit.desk.status().acknowledged > 100 or bool(visit.outcomes)
        assert not visit.outcomes

    visit.receive(person)


def most_bytes(folder, count: int) -> int:
    """Return the most memory that a desk takes in that time."""
    file = write_long_job(folder, count)
    tracemalloc.start()
    cut_some(folder, file)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return most


@pytest.mark.slow
def test_memory_of_a_desk_does_not_grow_with_the_program(tmp_path):
    cut_some(tmp_path, write_long_job(tmp_path, 1000))  # what is imported only when a machine is there
    few, many = most_bytes(tmp_path, MANY // 10), most_bytes(tmp_path, MANY)
    assert many < few + ONE_LIST_BYTES, (few, many)
