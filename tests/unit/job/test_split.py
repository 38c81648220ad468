# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job as one program a tool: each proven alone, the later ones on the stock that the earlier ones have cut."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.control.program.certificate import Certificate, digest_of_text
from CNCStepper.errors import JobError, ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import is_split, make_parts, make_program
from CNCStepper.job.model import Job, load_job
from CNCStepper.job.prove import prior_proofs, prove_job, prove_parts
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.prior_programs import followed
from CNCStepper.state import Start

MACHINE = (Path(__file__).parents[3] / "examples" / "machines" / "table-a.toml").read_text("utf-8")
JOB = """
machine = "split.toml"
clearance_mm = 10
retract_mm = 2
[stock]
size_mm = [60, 50, 10]
origin = "top-centre"
[[tool]]
number = 1
shape = "flat"
diameter_mm = 6
feed_mm_min = 800
plunge_mm_min = 200
spindle_rpm = 10000
[[tool]]
number = 3
shape = "flat"
diameter_mm = 2
flute_length_mm = 5
feed_mm_min = 300
plunge_mm_min = 100
spindle_rpm = 20000
[[operation]]
cycle = "elliptical_pocket"
tool = 1
radius_x_mm = 20
radius_y_mm = 12
depth_mm = 4
stepdown_mm = 2
stepover_mm = 2.4
[[operation]]
cycle = "engrave"
tool = 3
curves = "line"
depth_mm = 6
stepdown_mm = 1.5
[[shape]]
name = "line"
curve = { xy = [[-4, 0], [4, 0]], bulge = [0] }
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A job whose engraving lies on the pocket's floor: its flutes are too short for uncut stock."""
    (tmp_path / "peça.toml").write_text(JOB, encoding="utf-8")
    split = MACHINE.replace('tool_change = "pause"', 'tool_change = "split"')
    (tmp_path / "split.toml").write_text(split, encoding="utf-8")
    return tmp_path


@pytest.fixture
def loaded(folder: Path) -> tuple[Job, Machine]:
    return load_job(folder / "peça.toml")


def test_there_is_a_program_a_tool_and_the_later_one_says_what_to_do_first(loaded: tuple[Job, Machine]) -> None:
    assert is_split(*loaded)
    first, second = make_parts(*loaded, "peça")
    assert (first.file_name, second.file_name) == ("program-1-T1.nc", "program-2-T3.nc")
    assert first.program.startswith("(peca, program 1 of 2)\n")
    assert second.program.startswith("(peca, program 2 of 2)\n(before it starts set the Z zero with its tool)\n")
    for part, words in ((first, "elliptical pocket"), (second, "engrave")):
        assert part.program.count("T") == part.program.count(f"T{part.tool}") and "M0" not in part.program
        assert f"(begin operation: {words})" in part.program and part.program.endswith("M5\nM9\nM2\n")
        assert len(part.answers) == 1
    with pytest.raises(ProgramError, match="more than one tool"):
        make_program(*loaded)


def test_one_tool_or_another_rule_needs_no_splitting(loaded: tuple[Job, Machine]) -> None:
    job, machine = loaded
    assert not is_split(job, machine.model_copy(update={"tool_change": "pause"}))
    assert not is_split(job.model_copy(update={"operation": job.operation[:1]}), machine)
    assert len(make_parts(job.model_copy(update={"operation": job.operation[:1]}), machine)) == 1


def test_the_tools_may_come_again(loaded: tuple[Job, Machine]) -> None:
    job, machine = loaded
    thrice = job.model_copy(update={"operation": (*job.operation, job.operation[0])})
    assert [part.file_name[8:] for part in make_parts(thrice, machine)] == ["1-T1.nc", "2-T3.nc", "3-T1.nc"]


@pytest.mark.slow
def test_the_later_program_is_proven_on_the_stock_that_the_earlier_one_has_cut(loaded: tuple[Job, Machine]) -> None:
    job, machine = loaded
    parts = make_parts(job, machine)
    first, second = prove_parts(job, machine, parts, Path())
    assert [finding.code for finding in (*first.findings, *second.findings)] == ["place-unknown"] * 2
    assert second.report["gouge_mm"] < 0.01 and second.report["left_over_mm"] < 0.01
    assert second.report["removed_volume_mm3"] > first.report["removed_volume_mm3"] > 0
    assert second.given.before == (digest_of_text(parts[0].program),)
    uncut = prove_job(job, machine, parts[1].program, answers=parts[1].answers)
    assert "shank" in {finding.code for finding in uncut.findings}


def test_a_text_that_is_none_of_the_parts_has_no_place_among_them(loaded: tuple[Job, Machine]) -> None:
    job, machine = loaded
    first, second = (part.program for part in make_parts(job, machine))
    assert prior_proofs(job, machine, first) == ()
    for text in (second.replace("X4.000", "X5.000"), second + "(mine)\n", ""):
        with pytest.raises(JobError, match="none of the job's parts"):
            prior_proofs(job, machine, text)
    paused = machine.model_copy(update={"tool_change": "pause"})
    assert prior_proofs(job, paused, second + "(mine)\n") == ()


@pytest.mark.slow
def test_what_the_later_program_does_wrong_is_found_in_its_own_lines(loaded: tuple[Job, Machine]) -> None:
    job, machine = loaded
    first, second = make_parts(job, machine)
    wrong = second.program.replace("X4.000", "X24.000", 1)
    assert wrong != second.program
    earlier = prove_job(job, machine, first.program, answers=first.answers)
    proof = prove_job(job, machine, wrong, "b.nc", earlier=[earlier])
    gouge = next(finding for finding in proof.findings if finding.code == "gouge")
    assert gouge.place.line > 1 and gouge.place_mm is not None and gouge.place_mm[0] > 20


@pytest.mark.slow
def test_a_program_after_one_that_is_refused_is_refused(loaded: tuple[Job, Machine]) -> None:
    job, machine = loaded
    first, second = make_parts(job, machine)
    wrong = first.program.replace("Z-4.000", "Z-5.000")
    earlier = prove_job(job, machine, wrong, "a.nc", answers=first.answers)
    proof = prove_job(job, machine, second.program, "b.nc", earlier=[earlier], answers=second.answers)
    assert earlier.refused and proof.refused
    assert "a.nc" in next(finding.text for finding in proof.findings if finding.code == "earlier-refused")


def test_two_programs_in_a_row_are_one_table() -> None:
    one = interpret("T1 M3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG0 Z5\nM5\nM2\n", Start())
    other = interpret("T2 M3 S2000\nG0 X9 Y0 Z5\nG1 Z-2 F100\nG0 Z5\nM5\nM2\n", Start())
    both = followed(one, other)
    table = both.table()
    assert len(both) == 6 and table.line.tolist() == [0, 0, 0, 2, 3, 4]
    assert [both.states[state].tool for state in table.state] == [1, 1, 1, 2, 2, 2]
    assert np.array_equal(table.end[3:], other.table().end)
    change = next(event for event in both.events if event.kind == "tool_change")
    assert change.index == 3 and both.states[change.state].spindle == "off"


@pytest.mark.slow
def test_run_writes_program_report_certificate_and_picture_for_each_tool(folder: Path) -> None:
    result = CliRunner().invoke(group, ["run", str(folder / "peça.toml"), "--out", str(folder / "saída")])
    assert result.exit_code == 0, result.output
    names = {path.name for path in (folder / "saída").iterdir()}
    kinds = {"program": "nc", "report": "json", "certificate": "json", "part": "png"}
    assert names == {f"{kind}-{part}.{end}" for kind, end in kinds.items() for part in ("1-T1", "2-T3")}
    for part in ("1-T1", "2-T3"):
        certificate = Certificate.from_json((folder / "saída" / f"certificate-{part}.json").read_text("utf-8"))
        certificate.check_clean()
        program = (folder / "saída" / f"program-{part}.nc").read_text("ascii")
        certificate.compare("program", digest_of_text(program))
        assert json.loads((folder / "saída" / f"report-{part}.json").read_text("utf-8"))["tools"] == [int(part[-1])]
    program = str(folder / "saída" / "program-2-T3.nc")
    check = ["check", program, "--machine", str(folder / "split.toml"), "--job", str(folder / "peça.toml")]
    told = CliRunner().invoke(group, [*check, "--part", "2"])
    assert told.exit_code == 0 and "clean" in told.output
    assert CliRunner().invoke(group, check).exit_code == 2
    assert CliRunner().invoke(group, [*check, "--part", "3"]).exit_code == 2
    sent = CliRunner().invoke(group, ["send", program, "--port", "loop://", *check[2:]])
    assert sent.exit_code == 1 and isinstance(sent.exception, JobError) and sent.exception.code == "send-part"
