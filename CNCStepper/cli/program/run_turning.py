# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `cncstepper run` does with the job file of a lathe: programs, reports, certificates and pictures of the part."""

from __future__ import annotations

from pathlib import Path

from CNCStepper.cli.common.findings_output import save, show_figures, show_findings, write_report
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.progress import Progress
from CNCStepper.errors import Text
from CNCStepper.output_files import MADE_BY


def run_turning(path: Path, out: Path) -> bool:
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
        told, picture = out / f"report{suffix}.json", out / f"part{suffix}.png"
        write_report(told, proof.report)
        certificate_of(proof).write(out / f"certificate{suffix}.zip")
        proven.verdict.draw(picture, path.stem, f"{proof.report['time_s'] / 60:.1f} min")
        show_findings(proof.findings)
        show_figures(proof.report)
        blocks, minutes = proof.report["blocks"], proof.report["time_s"] / 60
        show_text(
            "{file}: {blocks} blocks that move, {minutes:.1f} min; {told}; {picture}",
            file=file,
            blocks=blocks,
            minutes=minutes,
            told=told,
            picture=picture,
        )
        proofs.append(proven)
    if len(proofs) > 1:
        report = whole_report(proofs)
        write_report(out / "report.json", report)
        proofs[-1].verdict.draw(out / "part.png", path.stem, f"{report['time_s'] / 60:.1f} min")
        show_text("the finished part: {json}; {png}", json=out / "report.json", png=out / "part.png")
    return any(proven.proof.refused for proven in proofs)
