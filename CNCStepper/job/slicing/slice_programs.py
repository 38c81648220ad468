# SPDX-License-Identifier: LGPL-2.1-or-later
"""The programs of a stack's sheets: a shop's template makes a job of each nested sheet, which is made and proven.

sheet-N.dxf ──► template, its rules by the layers ──► job-N.toml, .nc, -report.json, -certificate.zip
                CUT, REGISTRATION, MARK
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.batch.job_files import job_files, refusals
from CNCStepper.job.templates.drawing_job import job_of_drawing
from CNCStepper.job.templates.template import Template
from CNCStepper.machine.profile import load_machine, profile_names

PROGRAM_NAME = r"job-\d+(-\d+-T\d+)?"
FILES = {  # names that are written, and what they are by output_files.py
    r"job-\d+\.toml": "job",
    rf"{PROGRAM_NAME}\.nc": "program",
    rf"{PROGRAM_NAME}-report\.json": "report",
    rf"{PROGRAM_NAME}-certificate\.zip": "certificate",
}


@dataclass(frozen=True)
class SheetProgram:
    """What became of a sheet. refused: why its program must not run; error: why there is none; time_s: of its cut."""

    number: int
    time_s: float = 0.0
    refused: tuple[str, ...] = ()
    error: CNCStepperError | None = None

    @property
    def is_sound(self) -> bool:
        """Whether the sheet has a program that may run."""
        return self.error is None and not self.refused


def with_machine(template: Template, machine: str) -> Template:
    """Return the template with another machine, a profile's name or a path; "" leaves its own."""
    if not machine:
        return template
    named = machine if machine in profile_names() else str(Path(machine).absolute())
    return template.model_copy(update={"job": template.job | {"machine": named}})


def on_sheets(template: Template, size_mm: tuple[float, float]) -> Template:
    """Return the template for drawings of nested sheets of a size: zero at the sheet's left front corner."""
    keys = {"size_mm": size_mm, "placement": "drawing", "origin": "top-left-front"}
    return template.model_copy(update={"stock": template.stock.model_copy(update=keys)})


def write_programs(
    template: Template, folder: Path, numbers: Sequence[int], thickness_mm: float
) -> Iterator[SheetProgram]:
    """Write job, program, report and certificate of each sheet drawn in a folder; yield what became of it.

    template: of `on_sheets`. A sheet of which no program can be made is told, and costs no other one.
    """
    for number in numbers:
        try:
            yield _written(template, folder, number, thickness_mm)
        except CNCStepperError as error:
            yield SheetProgram(number, error=error)


def _written(template: Template, folder: Path, number: int, thickness_mm: float) -> SheetProgram:
    name = f"job-{number}"
    drawing = folder / f"sheet-{number}.dxf"
    drawn = job_of_drawing(template, drawing, folder / f"{name}.toml", thickness_mm=thickness_mm)
    path = folder / drawn.job.machine
    machine = load_machine(path if path.is_file() else drawn.job.machine)
    files, proofs = job_files(name, drawn, machine, folder)
    for own, content in files.items():
        write_whole(folder / own, content)
    time_s = sum(proof.report["time_s"] for proof in proofs)
    return SheetProgram(number, time_s, tuple(refusals(proofs)))
