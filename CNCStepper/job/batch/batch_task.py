# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tasks of an order, each a function of plain data alone: the same task gives the same bytes on every worker.

    read    a row of the order                ──► whether a job can be made of it; length and number of its lines
    nest    parts of one stock, with a seed   ──► where they lie, and how good that is
    lay     the best of these layouts         ──► drawings of the sheets, remnants, placements, picture
    make    a sheet, or a part alone          ──► job file, program, report, certificate; time, metres, pierces

`run_task` runs in a process of its own or on the worker of a cluster. A task holds the bytes of all files that it
reads; its result those of the files that are written.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from CNCStepper import __version__
from CNCStepper.errors import CNCStepperError, JobError, Text
from CNCStepper.job.batch.job_files import job_files, refusals
from CNCStepper.job.batch.nest_task import laid_out, nested
from CNCStepper.job.batch.sheet_template import cut_chains, for_sheets, template_of
from CNCStepper.job.batch.task_files import below, error_below, unpack
from CNCStepper.job.model import Job
from CNCStepper.job.prove import Proof
from CNCStepper.job.templates.drawing_job import DrawingJob, job_of_drawing
from CNCStepper.machine.profile import Machine, load_machine

Task = dict[str, Any]
Result = dict[str, Any]


def run_task(task: Task) -> Result:
    """Return the result of a task: its figures and `files`, or the `error` that refuses it."""
    with tempfile.TemporaryDirectory(prefix="cncstepper-batch-") as folder:
        root = Path(folder).resolve()
        try:
            if task["version"] != __version__:
                what = Text("the worker has CNCStepper {version}", version=__version__)
                advice = "install the same version on all workers"
                raise JobError("batch-version", what, value=__version__, limit=task["version"], advice=advice)
            unpack(task["files"], root)
            out = below(root, task["folder"])
            out.mkdir(parents=True, exist_ok=True)
            return TASKS[task["kind"]](task, root, out)
        except CNCStepperError as error:
            is_of_job = error.place is not None and Path(error.place.file).parent == out
            return {"error": error_below(root, error.at(None) if is_of_job else error)}  # that file is not kept
        except Exception as error:  # a fault of ours must not cost the other rows: it is told at its own
            what = Text("a fault of the program: {kind}: {error}", kind=type(error).__name__, error=error)
            fault = CNCStepperError("batch-fault", what, advice="please report it, with the drawing")
            return {"error": error_below(root, fault)}


def _read(task: Task, root: Path, out: Path) -> Result:
    """Return length and number of a part's lines, and of what it is made; that a job can be made of it is tried."""
    template = template_of(task, root)
    chains = [chain for _, chain in cut_chains(template, below(root, task["drawing"]))]
    job = _drawn(task, root, out, "part.toml")
    _machine(task, root, job.job, out)
    untaken = sum(count.closed + count.open for count in job.untaken)
    notes = [*job.job.notes, *([f"no rule takes {untaken} chains of the drawing"] if untaken else [])]
    return {
        "length_mm": sum(chain.curve.length_mm for chain in chains),
        "chains": len(chains),
        "material": job.job.material,
        "thickness_mm": job.job.stock.size_mm[2],
        "notes": notes,
    }


def _make(task: Task, root: Path, out: Path) -> Result:
    """Return a sheet's job, made and proven; raises CNCStepperError where no program can be made."""
    drawn = _drawn(task, root, out, f"{task['name']}.toml")
    machine = _machine(task, root, drawn.job, out)
    files, proofs = job_files(task["name"], drawn, machine, out)
    return _figures(drawn.job, machine, proofs) | {"files": files}


def _figures(job: Job, machine: Machine, proofs: list[Proof]) -> Result:
    width_mm, depth_mm = job.stock.size_mm[:2]
    return {
        "time_s": sum(proof.report["time_s"] for proof in proofs),
        "length_mm": sum(proof.report["cut_length_mm"] for proof in proofs),
        "pierces": sum(proof.report["pierces"] for proof in proofs),
        "warnings": sum(proof.report["warnings"] for proof in proofs),
        "refused": refusals(proofs),
        "area_mm2": width_mm * depth_mm,
        "material": job.material,
        "machine": machine.name,
        "rates": machine.rates.model_dump() if machine.rates else None,
    }


def _drawn(task: Task, root: Path, out: Path, file_name: str) -> DrawingJob:
    """Return the job of a task's drawing: of a part by its template, of a sheet by the same for the sheet's layers."""
    template = template_of(task, root)
    if size_mm := task.get("sheet_mm"):
        template = for_sheets(template, (size_mm[0], size_mm[1]))
    drawing = below(root, task["drawing"])
    return job_of_drawing(template, drawing, out / file_name, material=task["material"])


def _machine(task: Task, root: Path, job: Job, out: Path) -> Machine:
    path = out / job.machine
    return load_machine(path if path.is_file() else job.machine)


def _nest(task: Task, root: Path, out: Path) -> Result:
    return nested(task, root)


TASKS: Mapping[str, Callable[[Task, Path, Path], Result]] = {
    "read": _read,
    "nest": _nest,
    "lay": laid_out,
    "make": _make,
}
