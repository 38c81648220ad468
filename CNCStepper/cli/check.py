# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper check`: what is wrong with a program on a machine, before it moves anything."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.options import (
    check_stock,
    dialect_name,
    dialect_option,
    job_option,
    machine_option,
    program_argument,
    read_program,
    start_of,
    stock_of,
    stock_options,
    work_zero_option,
)
from CNCStepper.cli.show import show_figures, show_findings, write_json
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tool import Tool


@click.command("check")
@program_argument
@machine_option(required=True)
@stock_options(required=False)
@job_option
@work_zero_option
@dialect_option
@click.option("--json", "json_path", type=click.Path(path_type=Path), help="Also write the report there.")
@click.option("--certificate", type=click.Path(path_type=Path), help="Also write the certificate there, for `send`.")
def command(
    program: Path,
    machine: Machine,
    stock: tuple[float, float, float] | None,
    origin: str,
    tool: Tool | None,
    job_path: Path | None,
    work_zero: tuple[float, float, float] | None,
    dialect: str | None,
    json_path: Path | None,
    certificate: Path | None,
) -> None:
    """Check PROGRAM against a machine: travel, feeds, spindle; with --stock and --tool also rapids and plunges, with
    --job gouge and material left, clamps and the sheet's edge too.

    Exit 0 clean, 1 refused; each finding is file:line:column: text. Where --work-zero is not given, the place of
    the program on the table is reported as unknown.
    """
    from CNCStepper.gcode.read_back import refused_lines
    from CNCStepper.job.certify import certificate_of
    from CNCStepper.job.model import read_job
    from CNCStepper.job.prove import prove, prove_job

    check_stock(stock, tool, job_path)
    text, language = read_program(program), dialect_name(dialect, machine)
    start = start_of(work_zero)
    unreadable = list(refused_lines(text, start, language, str(program)))
    if unreadable:
        for error in unreadable:
            click.echo(str(error))
        click.echo(f"{program}: refused; it cannot be read")
        sys.exit(1)
    words: dict[str, Any] = {"file": str(program), "dialect": language, "start": start}
    if job_path:
        proof = prove_job(read_job(job_path), machine, text, **words)
    else:
        proof = prove(text, machine, stock=stock_of(stock, origin), tools=tool, **words)
    show_findings(proof.findings)
    if json_path:
        write_json(json_path, proof.report)
    if certificate:
        certificate.write_text(certificate_of(proof).to_json(), encoding="utf-8")
    show_figures(proof.report)
    verdict = "refused" if proof.refused else "clean"
    click.echo(f"{program}: {verdict}; {proof.report['blocks']} blocks, {proof.report['time_s']:.1f} s")
    sys.exit(1 if proof.refused else 0)
