# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates of programs that are sent in another language: they name both, and prove the lines that are sent."""

from __future__ import annotations

from CNCStepper.control.program.certificate import digest_of_lines
from CNCStepper.gcode.wire.translation import translate
from CNCStepper.job.make_certificate import certificate_of, proven_wire, send_job
from CNCStepper.job.prove import prove
from CNCStepper.job.prove_file import prove_file
from CNCStepper.machine.profile import load_machine

THESIS = "G0\nX15 Y10\nG90\nX35\nX25 Y17\nX15 Y10\n"


def test_certificate_names_the_programs_language_and_that_of_the_wire() -> None:
    machine = load_machine("thesis-table")
    certificate = certificate_of(prove(THESIS, machine, file="p.nc"))
    assert certificate.dialect == machine.wire_language() and certificate.program_dialect == machine.language()
    job = certificate.send_job()
    assert job.program_dialect == machine.language(), "by which the journal's reader reads the program"
    assert job.dialect == machine.wire_language() and list(job.lines)[2:4] == ["G0X15Y10", "G1X35F900"]
    wire = proven_wire(certificate, THESIS, certificate.program_dialect, "p.nc", None)
    assert wire.sha256 == certificate.content["wire"]["sha256"] == digest_of_lines(job.lines)


def test_program_that_is_sent_as_it_is_has_the_certificate_that_it_had() -> None:
    certificate = certificate_of(prove("G21G90\nG1X10F300\nM2\n", load_machine("table-a"), file="p.nc"))
    assert "dialect" not in certificate.content["program"] and certificate.program_dialect == "grbl"


def test_proof_of_a_file_sends_what_the_proof_of_its_text_does(tmp_path) -> None:
    machine, program = load_machine("thesis-table"), tmp_path / "p.nc"
    program.write_text(THESIS)
    (tmp_path / "sent").mkdir()
    proof = prove_file(program, machine, sent=tmp_path / "sent")
    whole = prove(THESIS, machine, file=str(program))
    assert tuple(proof.wire.lines) == tuple(whole.wire.lines)
    assert (
        proof.wire.sha256
        == whole.wire.sha256
        == translate(THESIS, machine.language(), machine.wire_language()).wire.sha256
    )
    assert proof.report["time_s"] == whole.report["time_s"] and proof.plan == whole.plan
    assert [finding.code for finding in proof.findings] == [finding.code for finding in whole.findings]


def test_times_are_those_of_the_interpolation_of_the_profile(tmp_path) -> None:
    table = load_machine("thesis-table")
    dda, program = table.model_copy(update={"interpolation": "dda"}), tmp_path / "p.nc"
    program.write_text(THESIS)
    planned, own = (prove(THESIS, machine, file=str(program)) for machine in (table, dda))
    assert own.report["time_s"] > planned.report["time_s"], "each move is from rest to rest"
    assert prove_file(program, dda).report["time_s"] == own.report["time_s"]


def test_job_of_a_machine_whose_dialect_is_left_out_is_of_its_own_language() -> None:
    wire = translate(THESIS, "thesis-a", "grbl").wire
    job = send_job(wire, load_machine("table-a"), "p.nc")
    assert job.dialect == "grbl" and job.program_dialect == ""
    table = load_machine("thesis-table")
    assert send_job(wire, table, "p.nc").program_dialect == table.language()
