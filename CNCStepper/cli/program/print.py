# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper print`: a program and its work surface on paper."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import job_option, stock_of
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.editing.edit_options import Opened, reading_options
from CNCStepper.cli.job_file import job_of

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.toolpath import Toolpath


@click.command("print", cls=Verb)
@click.option("-o", "--out", type=OutputPath("sheet"), required=True, help="The sheet: .pdf or .html.")
@click.option("--process", default="", help="What is done, in your words: milling, plasma, engraving.")
@click.option("--material", default="", help="What it is made of, in your words. [default: as the job says]")
@job_option
@reading_options
def command(opened: Opened, out: Path, process: str, material: str, job_path: Path | None) -> None:
    """Print PROGRAM as PDF or HTML: file, process and material, the work surface with the path, and the text.

    With --machine the sheet tells the time too; with --work-zero the picture shows the machine's travel.
    """
    from CNCStepper.gcode.interpreter.interpret import interpret
    from CNCStepper.simulation.views.paper_sheet import Sheet, save_sheet
    from CNCStepper.simulation.views.scene import limits_of

    job = job_of(job_path) if job_path else None
    toolpath = interpret(opened.text, opened.start, opened.dialect, str(opened.path))
    stock = job.stock.stock() if job else stock_of(opened.stock, opened.origin)
    limits = limits_of(toolpath, opened.machine) if opened.machine and toolpath.start.zero_known else None
    facts = tuple(_facts(opened, toolpath, process, material, job))
    out.parent.mkdir(parents=True, exist_ok=True)
    save_sheet(out, Sheet(opened.path.name, facts, opened.text, toolpath, stock, limits))
    show_text("{out}: written", out=out)


def _facts(opened: Opened, toolpath: Toolpath, process: str, material: str, job: Job | None):
    """Yield (name, value) of the known figures."""
    from CNCStepper.gcode.wire.backlash_compensation import backlash_of
    from CNCStepper.motion.planner.backlash_moves import way_duration_s
    from CNCStepper.motion.planner.plan import begun
    from CNCStepper.quantities import duration_text

    yield "File", str(opened.path)
    yield "Process", process or "not named"
    yield "Material", material or (job.material if job else "") or "not named"
    stock = job.stock.stock() if job else stock_of(opened.stock, opened.origin)
    if stock is not None:
        yield "Stock", " × ".join(f"{size:g}" for size in stock.size_mm) + " mm"
    tools = [tool.words for tool in job.tool] if job else [opened.tool.words] if opened.tool else []
    if tools:
        yield "Tools", ", ".join(tools)
    if opened.machine is not None:
        yield "Machine", opened.machine.name
        way, play = begun(toolpath), backlash_of(opened.machine, opened.dialect)
        yield "Time", duration_text(way_duration_s(way, way.chunks, opened.machine, play))
    yield "Lines", f"{len(opened.text.splitlines())}, {len(toolpath)} moves"
