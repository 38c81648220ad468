# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program that Check, Send and Restart act on: that of the editor in front, else the one that the tree means.

Asked several times a second, so nothing here loads the editor: where no program was ever edited, none is in front.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.features.base import is_job
from CNCStepper.workbench.proving import prove_program
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.translation import tr


def _none() -> Any:
    return None


dock_in_front: Callable[[], Any] = _none
"""Returns the dock of the editor in front, or None; the editors' window fills this when it is loaded."""


def editor() -> Any:
    """Return the panel of the editor in front, None where the tree counts or the object of its text is gone."""
    dock = dock_in_front()
    return dock.panel if dock is not None and dock.panel.source.alive else None


def why_not() -> str:
    """Return why the program in front cannot be taken further, "" when it can."""
    panel = editor()
    if panel is None:
        return prove_program.why_not()
    obj = panel.source.obj
    if obj is None:
        return missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()
    if is_job(obj):
        return missing_packages.why_not() or targets.why_no_panel() or targets.why_no_program(obj)
    return prove_program.why_not_of(obj)


def name() -> str:
    """Return in words which program that is, "" where there is none."""
    panel = editor()
    if panel is not None:
        return tr("Program: {0}, in the editor").format(panel.source.name)
    meant = prove_program.meant()
    return tr("Program: {0}").format(meant.Label) if meant is not None else ""


def take() -> Any:
    """Return the object of the program in front, what was typed saved first; None where a person thinks better of it.

    A file becomes a program of the job that is meant. Raises JobError for a file that cannot be read or written.
    """
    panel = editor()
    if panel is None:
        return prove_program.meant()
    if panel.modified and not _saved(panel):
        return None
    return panel.source.obj if panel.source.obj is not None else of_file(targets.job(), panel.source.path)


def of_file(job: Any, path: Any) -> Any:
    """Return the program of a G-code file, kept in the job's document in one undo step."""
    from CNCStepper.workbench import api
    from CNCStepper.workbench.document.undo_steps import undo_step

    with undo_step(job.Document, tr("Load {0}").format(path.name)):
        return api.load_program(job, path)


def _saved(panel: Any) -> bool:
    from CNCStepper.workbench.editor.file_dialogs import ask_to_save_first

    return ask_to_save_first(panel.source.name) and panel.save()
