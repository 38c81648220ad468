# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper run`: job file in; program, report, certificate and picture out."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.findings_output import save, show_figures, show_findings, write_report
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath, ReproduceOptions, plain_options
from CNCStepper.cli.common.path_types import OutputFolder
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job_file import is_turning_file, job_and_machine
from CNCStepper.errors import Text
from CNCStepper.output_files import MADE_BY

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.job.prove import Proof
    from CNCStepper.machine.profile import Machine


def _names(parameters: Mapping[str, Any]) -> dict[str, str]:
    """Return the names of the results, one of each or one a tool, with their kinds."""
    part = r"(-\d+-T\d+)?"
    return {
        rf"program{part}\.nc": "program",
        rf"report{part}\.json": "report",
        rf"certificate{part}\.zip": "certificate",
        rf"part{part}\.png": "picture",
    }


@click.command("run", cls=Verb)
@click.argument("job", type=FilePath)
@click.option("-o", "--out", type=OutputFolder(_names), required=True, help="Folder for the results.")
def command(job: Path, out: Path) -> None:
    """Make DIR/program.nc, DIR/report.json, DIR/certificate.zip and DIR/part.png from the job file JOB.

    Where the machine wants a file a tool (tool_change = "split"), there is one of each for each tool: program-1-T1.nc,
    report-1-T1.json and so on; run them in their order. Each program is read back, timed, simulated and checked, the
    later ones against the stock that the earlier ones have cut; exit 1 when a check refuses one. The job of a lathe
    (process = "turning") gives the part's profile in report.json and its half section as the picture.
    """
    from CNCStepper.job.estimate import long_work
    from CNCStepper.job.make import is_split

    if is_turning_file(job):
        out.mkdir(parents=True, exist_ok=True)
        sys.exit(1 if _turning(job, out) else 0)
    loaded, machine = job_and_machine(job)
    for sentence in long_work(loaded):
        show_text("cncstepper: {sentence}; Ctrl+C ends it", err=True, sentence=sentence)
    out.mkdir(parents=True, exist_ok=True)
    make = _split if is_split(loaded, machine) else _whole
    sys.exit(1 if make(loaded, machine, job, out) else 0)


def _whole(job: Job, machine: Machine, path: Path, out: Path) -> bool:
    """Make and prove one program; return whether it is refused."""
    from CNCStepper.job.make import make_program
    from CNCStepper.job.prove import prove_job

    file = out / "program.nc"
    with Progress(Text("making {name}", name=file.name)) as progress:
        made = make_program(job, machine, f"{MADE_BY}: {path.stem}")
        _write_program(file, made.program)
        progress.doing(Text("proving {name}", name=file.name))
        proof = prove_job(job, machine, made.program, str(file), share=progress.share, answers=made.answers)
    _conclude(proof, file, "", path.stem, job, plain_options({"--job": [path]}))
    return proof.refused


def _split(job: Job, machine: Machine, path: Path, out: Path) -> bool:
    """Make and prove a program for each tool; return whether one is refused."""
    from CNCStepper.job.make import make_parts
    from CNCStepper.job.prove import prove_parts

    refused = False
    with Progress(Text("making the programs of {name}", name=path.name)):
        parts = make_parts(job, machine, f"{MADE_BY}: {path.stem}")
    for part in parts:
        _write_program(out / part.file_name, part.program)
    for part, proof in zip(parts, prove_parts(job, machine, parts, out), strict=True):
        suffix = part.file_name.removeprefix("program").removesuffix(".nc")
        title = f"{path.stem}, {part.number} of {len(parts)}"
        made_with = plain_options({"--job": [path], "--part": [part.number]})
        _conclude(proof, out / part.file_name, suffix, title, job, made_with)
        refused |= proof.refused
    return refused


def _turning(path: Path, out: Path) -> bool:
    """Make and prove the programs of a lathe's job file; return whether one is refused."""
    from CNCStepper.job.make_certificate import certificate_of
    from CNCStepper.job.turning.make_turning import make_turning
    from CNCStepper.job.turning.prove_turning import prove_turning, whole_report
    from CNCStepper.job.turning.turning_job import load_turning_job

    proofs = []
    with Progress(Text("making the programs of {name}", name=path.name)):
        job, machine = load_turning_job(path)
        programs = make_turning(job, machine, f"{MADE_BY}: {path.stem}")
    for program in programs:
        save(out / program.file_name, program.program.encode("ascii"))
    for proven in prove_turning(job, machine, programs, out):
        proof, file = proven.proof, out / proven.program.file_name
        suffix = file.stem.removeprefix("program")
        report, picture = out / f"report{suffix}.json", out / f"part{suffix}.png"
        write_report(report, proof.report)
        certificate_of(proof).write(out / f"certificate{suffix}.zip")
        proven.verdict.draw(picture, path.stem, f"{proof.report['time_s'] / 60:.1f} min")
        _show_proof(proof, file, report, picture)
        proofs.append(proven)
    if len(proofs) > 1:
        whole = whole_report(proofs)
        write_report(out / "report.json", whole)
        proofs[-1].verdict.draw(out / "part.png", path.stem, f"{whole['time_s'] / 60:.1f} min")
        show_text("the finished part: {json}; {png}", json=out / "report.json", png=out / "part.png")
    return any(proven.proof.refused for proven in proofs)


def _write_program(file: Path, text: str) -> None:
    save(file, text.encode("ascii"))


def _conclude(proof: Proof, file: Path, suffix: str, title: str, job: Job, made_with: ReproduceOptions) -> None:
    """Write report, certificate and picture beside a program, and print the findings."""
    from CNCStepper.job.make_certificate import certificate_of

    report, certificate = file.with_name(f"report{suffix}.json"), file.with_name(f"certificate{suffix}.zip")
    picture = file.with_name(f"part{suffix}.png")
    write_report(report, proof.report)
    certificate_of(proof).sending(made_with=made_with).write(certificate)
    proof.draw(picture, title, ", ".join(job.tools[number].words for number in proof.report["tools"] if number))
    _show_proof(proof, file, report, picture)


def _show_proof(proof: Proof, file: Path, report: Path, picture: Path) -> None:
    """Print the findings and figures of a program, and where its report and picture are."""
    show_findings(proof.findings)
    show_figures(proof.report)
    blocks, minutes = proof.report["blocks"], proof.report["time_s"] / 60
    show_text(
        "{file}: {blocks} blocks that move, {minutes:.1f} min; {report}; {picture}",
        file=file,
        blocks=blocks,
        minutes=minutes,
        report=report,
        picture=picture,
    )
