# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a CadQuery or build123d script draws, as a DXF file beside the job that names it.

A job file never runs a script: whoever gives away a job would give away a program. The person who names the script runs
it once, and the job follows the DXF.
"""

from __future__ import annotations

from pathlib import Path

from CNCStepper.atomic_file import write_whole
from CNCStepper.drawing.drawing import Share
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.errors import JobError, Place
from CNCStepper.job.drawings.solids import read_script
from CNCStepper.job.templates.drawing_job import reading_of
from CNCStepper.job.templates.template import Template
from CNCStepper.output_files import MADE_BY


def drawing_of_script(template: Template, script: Path, job_path: Path, share: Share) -> Path:
    """Run a script that the person has named and return the DXF file of its outline, written beside the job.

    Raises JobError as `read_script`, and where a DXF of that name is there which CNCStepper has not written.
    """
    path = job_path.with_name(f"{job_path.stem}-{script.stem}.dxf")
    drawing = read_script(script, reading_of(template, script), share)
    if path.exists() and MADE_BY.encode() not in path.read_bytes()[:200]:
        what, advice = "a drawing of that name is there already", "give the job another name"
        raise JobError("drawing-exists", what, advice=advice, place=Place(str(path)))
    write_whole(path, dxf_bytes(drawing))
    return path
