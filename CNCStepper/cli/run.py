# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper run`: job file in; program, report, certificate and picture out."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from CNCStepper.cli.options import FilePath
from CNCStepper.cli.show import show_figures, show_findings, write_json


@click.command("run")
@click.argument("job", type=FilePath)
@click.option("--out", type=click.Path(file_okay=False, path_type=Path), required=True, help="Folder for the results.")
def command(job: Path, out: Path) -> None:
    """Make DIR/program.nc, DIR/report.json, DIR/certificate.json and DIR/part.png from the job file JOB.

    The program is read back, timed, simulated and checked; exit 1 when a check refuses it.
    """
    from CNCStepper.job.certify import certificate_of
    from CNCStepper.job.make import make_program
    from CNCStepper.job.model import load_job
    from CNCStepper.job.prove import prove_job

    loaded, machine = load_job(job)
    made = make_program(loaded, machine, title=job.stem)
    out.mkdir(parents=True, exist_ok=True)
    program = out / "program.nc"
    program.write_text(made.program, encoding="ascii", newline="\n")
    proof = prove_job(loaded, machine, made.program, str(program))
    write_json(out / "report.json", proof.report)
    (out / "certificate.json").write_text(certificate_of(proof).to_json(), encoding="utf-8")
    proof.draw(out / "part.png", job.stem, loaded.cutters)
    show_findings(proof.findings)
    show_figures(proof.report)
    blocks, minutes = proof.report["blocks"], proof.report["time_s"] / 60
    click.echo(f"{program}: {blocks} blocks, {minutes:.1f} min; {out / 'report.json'}; {out / 'part.png'}")
    sys.exit(1 if proof.refused else 0)
