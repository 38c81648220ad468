# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button that sends a G-code file: for the active job, or for a job made from a person's choices.

Where a process with a cut chart cuts it, material, thickness and consumable are asked first, and the feed is shown that
a program without F takes. Values other than those of the job make a job of their own for the file.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.profile import load_machine
from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot
from CNCStepper.workbench.dock.model.unfinished_job import why_not_now
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services import messages, missing_packages
from CNCStepper.workbench.services.translation import later, tr

DOES = later("Check a G-code file with the job's machine, stock, tools and clamps, and send it.")
SHEET_MM = (500.0, 500.0, 3.0)  # that is offered where there is no job


class FileSending:
    """The button and its action; profile: returns the machine profile of the dock."""

    def __init__(self, send: Callable[[Any], None], profile: Callable[[], str]) -> None:
        self._send, self._profile = send, profile
        self.button = widgets.button("SendFile", tr("Send a G-code file…"), self._ask)

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the button while nothing is cut."""
        widgets.lock(self.button, why_not_now(moment), DOES)

    def _ask(self) -> None:
        """Ask which file, and how it is cut, and send it."""
        from CNCStepper.workbench.document import targets
        from CNCStepper.workbench.editor.file_dialogs import ask_which

        why_not = missing_packages.why_not() or targets.why_no_panel()
        if not why_not and not (targets.jobs() == [] and self._charted()):
            why_not = targets.why_no_job()
        if why_not:
            messages.notice(
                why_not,
                tr("A file is checked with a job's machine, stock, tools and clamps; no operation is needed."),
            )
            return
        path = ask_which()
        if path is not None:
            self._take(targets.job(), path)

    def _take(self, job: Any, path: Path) -> None:
        from CNCStepper.workbench.editor.active_program import of_file
        from CNCStepper.workbench.proving import prove_program

        cutting = self._job_for(job, path)
        if cutting is None:
            return
        program = of_file(cutting, path)
        prove_program.make(program)
        self._send(program)

    def _job_for(self, job: Any, path: Path) -> Any:
        """Return the job that cuts a file, perhaps a new one; None where a person thinks better of it."""
        if job is not None and not PROCESSES[job.Process].uses_chart:
            return job
        from CNCStepper.workbench.dock.views import cut_dialog

        begin = _choice_of(job) if job is not None else _first_choice(self._charted()[0])
        choice = cut_dialog.ask(path.name, [job.Process] if job is not None else self._charted(), begin)
        if choice is None or (job is not None and choice == begin):
            return job if choice else None
        return _new_job(job, choice, path, self._profile())

    def _charted(self) -> list[str]:
        """Return the processes with a cut chart of the machine that the dock names."""
        return [name for name in load_machine(self._profile()).processes if PROCESSES[name].uses_chart]


def _choice_of(job: Any) -> Any:
    """Return how a job cuts."""
    from CNCStepper.workbench.dock.views.cut_dialog import CutChoice
    from CNCStepper.workbench.document.cut_chart_of_job import rows_of
    from CNCStepper.workbench.document.stock_of_job import size_mm

    chart = rows_of(job) if job.Chart else None
    return CutChoice(job.Process, job.Material, round(size_mm(job)[2], 2), job.Consumable, None, chart)


def _first_choice(process: str) -> Any:
    from CNCStepper.workbench.dock.views.cut_dialog import CutChoice

    x_mm, y_mm, thickness_mm = SHEET_MM
    return CutChoice(process, "", thickness_mm, "", (x_mm, y_mm))


def _new_job(job: Any, choice: Any, path: Path, machine: str) -> Any:
    """Return a new job for a file: as another one but for the chosen values, or for a machine alone."""
    import FreeCAD

    from CNCStepper.workbench import api
    from CNCStepper.workbench.document.stock_of_job import size_mm
    from CNCStepper.workbench.document.undo_steps import undo_step

    document = FreeCAD.ActiveDocument or FreeCAD.newDocument()
    values: dict[str, Any] = {"process": choice.process, "material": choice.material, "consumable": choice.consumable}
    if job is None:
        values |= {"machine": machine, "stock_form": "sheet", "stock_size_mm": (*choice.size_mm, choice.thickness_mm)}
    else:
        x_mm, y_mm, _ = size_mm(job)
        values |= {"machine": job.Machine, "chart": job.Chart, "stock_form": job.StockForm}
        values |= {"stock_origin": job.StockOrigin, "stock_size_mm": (x_mm, y_mm, choice.thickness_mm)}
        values |= {"work_origin_mm": tuple(job.WorkOrigin), "clamps": list(job.Clamps)}
    with undo_step(document, tr("New job")):
        made = api.new_job(document, **values)
        made.Label = path.stem
        api.chart_tool(made)
        document.recompute()
    return made
