# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a G-code file to the dock's sending: it is kept in the document, proven with its job's machine, and sent."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.workbench.dock.model.controller_state import ControllerSnapshot
from CNCStepper.workbench.dock.model.unfinished_job import why_not_now
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services import messages, missing_packages
from CNCStepper.workbench.services.translation import later, tr

DOES = later("Check a G-code file with the job's machine, stock, tools and clamps, and send it.")


class FileSending:
    """The button, and what it does."""

    def __init__(self) -> None:
        self.button = widgets.button("SendFile", tr("Send a G-code file…"), self._send)

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the button while nothing is cut."""
        widgets.lock(self.button, why_not_now(moment), DOES)

    def _send(self) -> None:
        """Ask which file, and send it for the job that is meant."""
        from CNCStepper.workbench.document import targets
        from CNCStepper.workbench.editor.file_dialogs import ask_which

        if why_not := missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job():
            messages.notice(
                why_not,
                tr("A file is checked with a job's machine, stock, tools and clamps; no operation is needed."),
            )
            return
        path = ask_which()
        if path is not None:
            self._take(targets.job(), path)

    def _take(self, job: Any, path: Path) -> None:
        from CNCStepper.workbench.commands.send import Send
        from CNCStepper.workbench.editor.active_program import of_file

        Send().take(of_file(job, path))
