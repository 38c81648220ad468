# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restarts of whole jobs, proven against the stock that is already cut and the shapes that are wanted."""

from __future__ import annotations

import os
import random
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.program.certificate import Certificate, digest_of_text
from CNCStepper.errors import ProgramError
from CNCStepper.job.make import make_parts, make_program
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.model import Job, load_job
from CNCStepper.job.prove import prior_proofs
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.recovery.restart import prove_restart as restart_module
from CNCStepper.recovery.restart.description import contour_table, words_of
from CNCStepper.recovery.restart.prove_restart import (
    EntryOptions,
    ProvenRestart,
    restart_job,
    restart_name,
    restart_program,
)
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start

JOBS = Path(__file__).parents[3] / "examples" / "jobs"
QUICK = ("brazil-engraving.toml", "cycles/rectangular-pocket.toml", "cycles/contour.toml", "cycles/bore.toml")
OTHERS = ("plate.toml", "elliptical-pocket.toml", *(f"cycles/{name}.toml" for name in ("face", "pocket", "spiral")))
CASES = int(os.environ.get("CNCSTEPPER_CASES", "0"))  # what `make soak` asks for
NOWHERE = {"restart-at-start", "restart-nothing-left"}
SEED = int(os.environ.get("RESTART_SEED", "0")) or (
    1 if os.environ.get("CI") else random.SystemRandom().randrange(10**9)
)
SQUARE = "G21 G90\nT1\nM3 S12000\nG4 P3\nG0 Z10\nX0 Y0\nG1 Z-2 F200\nX40 F800\nY20\nX0\nY0\nG0 Z10\nM5\nM2\n"
MILL = Tool(number=1, shape="flat", diameter_mm=4, plunge_mm_min=150)


@cache
def made(name: str) -> tuple[Job, Machine, str]:
    job, machine = load_job(JOBS / name)
    return job, machine, make_program(job, machine, name).program


def assert_clean(proven: ProvenRestart, told: str) -> None:
    errors = [str(finding) for finding in proven.proof.findings if finding.severity == "error"]
    assert not errors, (told, errors, proven.restart.text[:500])
    assert proven.proof.report["left_over_mm"] < 0.02, told
    assert proven.proof.report["gouge_mm"] < 0.02, told


def judge_at_random_places(name: str, count: int) -> None:
    print(f"RESTART_SEED={SEED}")
    job, machine, text = made(name)
    pick = random.Random(f"{SEED} {name}")
    for _ in range(count):
        line, overlap_mm = pick.randint(1, text.count("\n")), pick.choice((0.0, 1.0, 5.0))
        try:
            proven = restart_job(job, machine, text, RequestedPlace(line=line), EntryOptions(overlap_mm), file="p.nc")
        except ProgramError as error:
            assert error.code in NOWHERE, error
            continue
        assert_clean(proven, f"{name}, line {line}, overlap {overlap_mm}: {proven.restart.entrance}")


@pytest.mark.slow
@pytest.mark.parametrize("name", [*QUICK, *(OTHERS if CASES else ())])
def test_an_example_restarted_at_a_random_line_is_cut_whole(name: str) -> None:
    judge_at_random_places(name, max(1, CASES // 100))


def test_the_certificate_is_that_of_the_restart_and_names_what_has_cut_before(tmp_path: Path) -> None:
    job, machine, text = made("cycles/rectangular-pocket.toml")
    proven = restart_job(job, machine, text, RequestedPlace(line=60), file="p.nc")
    certificate_of(proven.proof).write(tmp_path / "certificate.zip")
    certificate = Certificate.read(tmp_path / "certificate.zip")
    certificate.check_clean()
    assert certificate.content["before"] == [digest_of_text(text)]
    assert certificate.content["program"] == {"file": "p-restart.nc", "sha256": digest_of_text(proven.restart.text)}
    assert certificate.send_job().lines[0] == "M5M9"


def test_what_is_not_cut_before_the_place_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The judge sees the whole part: with the moves before the place left out, material is left."""
    job, machine, text = made("cycles/rectangular-pocket.toml")

    def forgets(*arguments, **more):
        one = restart_module_restart(*arguments, **more)
        rows = len(one.cut) - 1
        chunk = one.cut.chunks[0]
        lift = type(chunk)(0, *(getattr(chunk, column)[rows:] for column in COLUMNS))
        return replace(one, cut=replace(one.cut, chunks=[lift], events=[], spans=[]))

    restart_module_restart = restart_module.restart_of
    monkeypatch.setattr(restart_module, "restart_of", forgets)
    proven = restart_job(job, machine, text, RequestedPlace(line=120), file="p.nc")
    assert proven.proof.refused
    assert {"left-over", "restart-incomplete"} & {finding.code for finding in proven.proof.findings}


COLUMNS = ("kind", "end", "centre", "plane", "turns", "feed", "state", "line")


def test_a_height_below_what_stands_is_refused_by_the_proof() -> None:
    low = EntryOptions(height_mm=-1.0)
    proven = restart_program(
        SQUARE, machine_a(), RequestedPlace(line=11), low, stock=Stock((100, 100, 10)), tools=MILL, file="p.nc"
    )
    assert proven.proof.refused
    assert "place-unknown-in-stock" in {finding.code for finding in proven.proof.findings}


def machine_a() -> Machine:
    return made("brazil-engraving.toml")[1]


def test_the_plunge_is_the_tools_and_the_wait_the_machines() -> None:
    proven = restart_program(SQUARE, machine_a(), RequestedPlace(line=10), stock=Stock((100, 100, 10)), tools=MILL)
    lines = proven.restart.text.splitlines()
    assert "G1 Z-2 F150" in lines
    assert f"G4 P{machine_a().spindle.spin_up_s:g}" in lines
    assert not proven.proof.refused


@pytest.mark.slow
def test_a_program_of_a_split_job_is_restarted_on_what_the_ones_before_have_cut() -> None:
    job, machine, _ = made("plate.toml")
    machine = machine.model_copy(update={"tool_change": "split"})
    parts = make_parts(job, machine)
    text = parts[1].program
    earlier = prior_proofs(job, machine, text)
    proven = restart_job(job, machine, text, RequestedPlace(line=text.count("\n") // 2), earlier=earlier, file="p.nc")
    assert_clean(proven, "the second part")
    assert len(certificate_of(proven.proof).content["before"]) == 2


def test_words_tell_where_from_what_height_and_with_what() -> None:
    start = Start.with_work_zero((-200.0, -200.0, -40.0))
    proven = restart_program(SQUARE, machine_a(), RequestedPlace(line=11), EntryOptions(overlap_mm=5), start=start)
    assert list(words_of(proven.restart)) == [
        "enters line 10 at X5.000 Y20.000 Z-2.000",
        "with 88% of its move done",
        "cuts 5 mm before the place again",
        "with tool 1 in the spindle",
        "goes to Z 10.000 first, straight up (it is not sent while the tool stands higher), then over the place",
        "starts the spindle at 12000 rpm, turning clockwise (M3)",
        "waits for 3 s",
        "goes down at 200 mm/min",
        "then runs 4 lines of the program unchanged; everything before them counts as cut",
    ]
    assert [row[:2] for row in contour_table(proven.restart.program)] == [(1, 7)]


def test_the_rest_of_the_cut_takes_the_time_that_it_took() -> None:
    """Without the entry the restart takes as long as the program from there on."""
    job, machine, text = made("brazil-engraving.toml")
    proven = restart_job(job, machine, text, RequestedPlace(line=100))
    own = np.flatnonzero(proven.proof.toolpath.table().line > (proven.restart.file_lines == 0).sum())
    assert len(own) == len(proven.restart.program.path) - proven.restart.entrance.row
    assert proven.proof.times_s[-1] > proven.proof.times_s[own[0]] > 0


def test_a_restarts_name_keeps_the_suffix() -> None:
    assert restart_name("a/part.nc") == "a/part-restart.nc"
    assert restart_name("part") == "part-restart"
