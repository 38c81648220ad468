# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job's report as PDF or HTML, which any reader prints: its facts are put together here, the process writes it.

job object ──► facts in the user's language ──► cut process: times, picture of the path, text ──► file
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import api
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.calculation.cut_process import CutRequest, process
from CNCStepper.workbench.document.operation_order import active_operations
from CNCStepper.workbench.document.preferred_values import program_folder
from CNCStepper.workbench.features.base import LATHE_JOB, proxy_type
from CNCStepper.workbench.features.program_job import part_of
from CNCStepper.workbench.panels.tools.tool_words import tree_words
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

WHO = object()  # one report at a time
KINDS = "*.pdf *.html"
MOST_OPERATIONS = 20  # that have a line each: the page has a picture too
Facts = list[tuple[str, str]]


def ask(job: Any, written: Callable[[str], None]) -> None:
    """Ask for the file of a job's report and return at once; `written` is called with its path when it is there."""
    import FreeCADGui
    from PySide import QtCore, QtGui

    dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), tr("Report"), str(program_folder(job.Document)))
    dialog.setObjectName("CNCStepper_Report_file")
    dialog.setAcceptMode(dialog.AcceptMode.AcceptSave)
    dialog.setFileMode(dialog.FileMode.AnyFile)
    dialog.setNameFilters([tr("Reports ({0})").format(KINDS)])
    dialog.setDefaultSuffix("pdf")
    dialog.selectFile(f"{job.Label.replace('/', '-')}.pdf")
    dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(guarded(lambda path: write(job, path, written)))
    dialog.open()


def write(job: Any, path: str, written: Callable[[str], None]) -> None:
    """Let the process write a job's report; raises JobError for a job without a program."""
    job.Document.recompute()
    sheet = {
        "file": path,
        "title": str(job.Label),
        "text": api.program_text(job),
        "facts": facts_of(job),
        "operations": operations_of(job),
        "most": MOST_OPERATIONS,
        "together": tr("Together"),
    }
    key = f"report {time.monotonic_ns()}"  # each is written, also one that says the same as the last
    question = {"sheet": sheet, "of": job.Proxy.program_question(job)}

    def finish() -> None:
        answer = result_cache.known(key)
        if isinstance(answer, CNCStepperError):
            messages.error(answer)
        elif answer is not None:
            written(path)

    process().ask(WHO, CutRequest({key: question}, lambda words: messages.note(tr(words)), guarded(finish)))


def facts_of(job: Any) -> Facts:
    """Return the name and value of each fact of a job, in the user's language."""
    facts = [
        (tr("Document"), Path(job.Document.FileName).name or str(job.Document.Label)),
        (tr("Machine"), str(job.Machine)),
        (tr("Process"), words_of(job.Process)),
        (tr("Material"), words_of(job.Material) if job.Material else tr("not given")),
        (tr("Stock"), f"{words_of(job.StockForm)} {stock_words(job)} mm"),
    ]
    if job.ProgramParts > 1:
        facts.append((tr("Program"), tr("{0} of {1}").format(part_of(job, job.ProgramParts), job.ProgramParts)))
    used = list(dict.fromkeys(operation.Tool for operation in active_operations(job)))
    return [*facts, (tr("Tools"), ", ".join(map(tree_words, used)))]


def stock_words(job: Any) -> str:
    """Return the sizes of a job's stock in mm: of a lathe's bar its diameter, a tube's bore, and its whole length."""
    if proxy_type(job) != LATHE_JOB:
        return " × ".join(f"{length:g}" for length in job.StockSize)
    bore = f" / {float(job.Bore):g}" if job.StockForm == "tube" else ""
    return f"Ø {float(job.Diameter):g}{bore} × {float(job.Length) + float(job.FaceStock):g}"


def operations_of(job: Any) -> Facts:
    """Return for each operation of the program its number, and its label, tool and number of warnings."""
    rows = []
    for number, operation in enumerate(active_operations(job), start=1):
        count = len(operation.Proxy.warnings)
        words = [str(operation.Label), f"T{operation.Tool.Number}"]
        words += [tr("{0} warnings").format(count)] if count else []
        rows.append((f"{number}", " · ".join(words)))
    return rows


def show(path: str) -> None:
    """Say that a report was written, and open it with the system's own program, which prints it."""
    from PySide import QtCore, QtGui

    messages.note(tr("{0} was written").format(path))
    QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(path))
