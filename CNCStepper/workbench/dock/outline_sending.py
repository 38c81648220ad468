# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button that drives round the job in air before the first cut: its outline as a program, checked and sent.

document read ──► a thread: the program's text is read, the outline's is written ──► a program of the job ──► send
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench.dock.model.button_states import RULES, ControllerSnapshot, why_not_outline
from CNCStepper.workbench.dock.model.unfinished_job import Reading
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.proving.latest_proof import Sender
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.translation import tr

NAME = "outline"  # by which a job's outline is found again


class OutlineSending:
    """The button and its action; `advance` is called after every poll of the link."""

    def __init__(self, send: Sender) -> None:
        self._send = send
        self._reading = Reading()
        self.button = widgets.button("Outline", tr("Run the outline"), self._begin)

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the button while the machine is idle and its position is not known to be lost."""
        widgets.lock(self.button, why_not_outline(moment), RULES["outline"].does)

    def advance(self) -> None:
        """Send the outline when it is written; raises what its program is refused for."""
        self._reading.poll()

    def _begin(self) -> None:
        """Write the outline of the program in front beside the window."""
        from CNCStepper.workbench.editor import active_program
        from CNCStepper.workbench.proving import prove_program

        if why_not := active_program.why_not():
            messages.note(why_not)
            return
        program = active_program.take()
        if program is not None:
            prove_program.make(program)
            self._reading.ask(writer_of(program), lambda text: self._take(program, text))

    def _take(self, program: Any, text: str) -> None:
        from CNCStepper.workbench.document.undo_steps import undo_step
        from CNCStepper.workbench.features.program import job_behind, program_of_text
        from CNCStepper.workbench.proving import prove_program

        job = job_behind(program)
        with undo_step(job.Document, tr("Run the outline")):
            outline = program_of_text(job, tr("{0}, outline").format(program.Label), NAME, text)
        prove_program.make(outline)
        self._send(outline)


def writer_of(program: Any) -> Callable[[], str]:
    """Return what writes the outline of a program; the document is read now. Raises JobError for a lathe's."""
    from CNCStepper.workbench import api
    from CNCStepper.workbench.document.core_job import language_of, machine_of, proven_with
    from CNCStepper.workbench.features.base import LATHE_JOB, proxy_type
    from CNCStepper.workbench.features.program import job_behind

    job = job_behind(program)
    if proxy_type(job) == LATHE_JOB:
        what, advice = "a lathe's tool has no outline over the bar", "look at the simulation"
        raise JobError("outline-lathe", what, advice=advice)
    text, machine, language = api.program_text(program), machine_of(job), language_of(program)
    model, process, label = proven_with(program), job.Process, program.Label

    def write() -> str:
        from CNCStepper.job.editing.outline_run import outline_program

        return outline_program(text, machine, process, language, model.started(None, machine), label)

    return write
