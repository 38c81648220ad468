# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window that compares two programs: jobs and programs of the documents, or files; a picture and figures.

two programs ──► `workers/drawing_reader.py` ("compare") ──► picture · sentences · figures side by side
"""

from __future__ import annotations

import shutil
import tempfile
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.comparison.turned_picture_words import TURNED_WORDS
from CNCStepper.tolerances import SAME_PATH_MM
from CNCStepper.workbench.calculation.drawing_process import DrawingRequest, process
from CNCStepper.workbench.comparison.picture_view import PictureView
from CNCStepper.workbench.features.base import JOB, JOBS, LATHE_JOB, proxy_type
from CNCStepper.workbench.features.program import Program, job_behind
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, named_button, note_label
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import template, translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Comparison"
SIZE = (1120, 680)
GUIDE = "editing.md"
PICTURE = "comparison.png"
LEAST_MM, MOST_MM = 0.001, 10.0


class Comparison(QtGui.QDialog):
    """See the module."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("Compare programs"))
        f1_key.attach(self, GUIDE)
        self.resize(*SIZE)
        self.folder = Path(tempfile.mkdtemp(prefix="cncstepper-compare-"))
        self.destroyed.connect(partial(_remove, self.folder))
        self.sources = [self._source(name) for name in ("first", "second")]
        self.tolerance = QtGui.QDoubleSpinBox(self)
        self.note = note_label(f"{NAME}_error", ERROR_COLOUR, self)
        self.words = QtGui.QLabel(self)
        self.bar = QtGui.QProgressBar(self)
        self.picture = PictureView(f"{NAME}_picture", self)
        self.figures = QtGui.QTableWidget(0, 3, self)
        self.answer: dict[str, Any] | None = None
        self._make_ready()
        self._arrange()

    def offer(self, first: Any = None) -> None:
        """Offer the programs of all documents; an object's becomes the first one, the next other one the second."""
        found = _programs()
        for source in self.sources:
            chosen = source.currentData()
            files = [source.itemData(at) for at in range(source.count()) if isinstance(source.itemData(at), str)]
            source.clear()
            for each in found:
                source.addItem(_label(each), each)
            for file in files:
                source.addItem(Path(file).name, file)
            if chosen is not None and chosen in [*found, *files]:
                source.setCurrentIndex([*found, *files].index(chosen))
        if first is not None and first in found and self.answer is None:
            self.sources[0].setCurrentIndex(found.index(first))
            others = [at for at, each in enumerate(found) if each is not first]
            self.sources[1].setCurrentIndex(others[0] if others else -1)
        self.look()

    def take_file(self, number: int, path: Path) -> None:
        """Compare a file as the first (0) or the second (1) program."""
        source = self.sources[number]
        source.addItem(path.name, str(path))
        source.setCurrentIndex(source.count() - 1)
        self.look()

    def look(self) -> None:
        """Let two programs be compared, once there are two."""
        self.button.setEnabled(all(source.currentData() is not None for source in self.sources))

    def compare(self) -> None:
        """Ask the process; what is shown stays until it has answered."""
        self.note.hide()
        self.bar.setValue(0)
        self.bar.show()
        self.button.setEnabled(False)
        question = {"compare": self._question()}
        request = DrawingRequest(question, guarded(self.show_answer), guarded(self.show_refusal), self._show_share)
        process().ask(self, request)

    def show_answer(self, answer: dict[str, Any]) -> None:
        """Show what differs."""
        self.answer = answer
        self._end()
        self.picture.show_picture(QtGui.QPixmap(str(self.folder / PICTURE)))
        self.words.setText("\n".join(_sentence(each) for each in answer["sentences"]))
        self.figures.setHorizontalHeaderLabels(["", *(source.currentText() for source in self.sources)])
        self.figures.setRowCount(len(answer["rows"]))
        for row, (name, *values) in enumerate(answer["rows"]):
            for column, text in enumerate([_sentence(name), *(_local(value) for value in values)]):
                item = QtGui.QTableWidgetItem(text)
                if column:
                    item.setTextAlignment(QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter)
                self.figures.setItem(row, column, item)
                _emphasize(item, values[0] != values[1])
        self.save_button.setEnabled(True)

    def show_refusal(self, error: CNCStepperError) -> None:
        """Show why the programs cannot be compared."""
        self._end()
        self.note.setText(messages.sentence(error))
        self.note.show()

    def save_picture(self, path: Path) -> None:
        """Write the picture as a file; raises OSError where that fails."""
        write_whole(path, (self.folder / PICTURE).read_bytes())
        messages.note(tr("{0} was written").format(path))

    def closeEvent(self, event: Any) -> None:
        """Ask no more; Qt calls this."""
        process().forget(self)
        self._end()
        event.accept()

    def reject(self) -> None:
        """Close, as Esc does."""
        self.close()

    # --- inside ------------------------------------------------------------------------------------

    def _question(self) -> dict[str, Any]:
        """Return what the process is asked; machine, stock and tools are those of the first program that has a job.

        A lathe's programs have the bar and the tools of their own jobs.
        """
        from CNCStepper.workbench.document.machine_of_job import machine_of
        from CNCStepper.workbench.document.targets import job as meant_job

        chosen = [source.currentData() for source in self.sources]
        owners = [each for each in chosen if not isinstance(each, str)] or list(filter(None, [meant_job()]))
        machine = machine_of(job_behind(owners[0])) if owners else None
        dialect = machine.language() if machine else "grbl"
        return {
            "programs": [_told(each, dialect, owners) for each in chosen],
            "machine": machine.model_dump(mode="json") if machine else None,
            "job": self._job_file(owners[0]) if owners else "",
            "tolerance_mm": self.tolerance.value(),
            "picture": str(self.folder / PICTURE),
            "words": {key: template(text) for key, text in TURNED_WORDS.items()},
        }

    def _job_file(self, program: Any) -> str:
        """Return a file with stock and tools of a program's job, "" where they are not known."""
        from CNCStepper.job.model import save_job
        from CNCStepper.workbench.document.core_job import proven_with

        path = self.folder / "job.json"
        with suppress(CNCStepperError):  # paths are compared without a part, too
            if proxy_type(job_behind(program)) == JOB:
                save_job(proven_with(program), path)
                return str(path)
        return ""

    def _show_share(self, share: float) -> None:
        self.bar.setValue(round(share * 100))

    def _end(self) -> None:
        self.bar.hide()
        self.look()

    def _source(self, name: str) -> Any:
        box = QtGui.QComboBox(self)
        box.setObjectName(f"{NAME}_{name}")
        box.setMinimumContentsLength(12)
        box.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        box.currentIndexChanged.connect(guarded(lambda _: self.look()))
        return box

    def _make_ready(self) -> None:
        self.tolerance.setObjectName(f"{NAME}_tolerance")
        self.tolerance.setDecimals(3)
        self.tolerance.setRange(LEAST_MM, MOST_MM)
        self.tolerance.setSingleStep(0.01)
        self.tolerance.setSuffix(" mm")
        self.tolerance.setValue(SAME_PATH_MM)
        self.tolerance.setToolTip(tr("How far apart paths may be that are one"))
        self.words.setObjectName(f"{NAME}_words")
        self.words.setWordWrap(True)
        self.words.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self.bar.setObjectName(f"{NAME}_share")
        self.bar.hide()
        self.figures.setObjectName(f"{NAME}_figures")
        self.figures.setAccessibleName(tr("Figures"))
        self.figures.setHorizontalHeaderLabels(["", "", ""])
        self.figures.verticalHeader().hide()
        self.figures.setEditTriggers(QtGui.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.figures.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeMode.ResizeToContents)

    def _arrange(self) -> None:
        grid = QtGui.QGridLayout()
        tip = tr("Chooses a G-code file")
        for row, (words, name, source) in enumerate(
            zip((tr("First program"), tr("Second program")), ("first", "second"), self.sources, strict=True)
        ):
            label = QtGui.QLabel(words, self)
            label.setBuddy(source)
            grid.addWidget(label, row, 0)
            grid.addWidget(source, row, 1)
            act = partial(self._ask_file, row)
            ask = named_button(f"{NAME}_{name}_file", tr("File…"), tip, act, self)
            grid.addWidget(ask, row, 2)
        label = QtGui.QLabel(tr("Tolerance"), self)
        label.setBuddy(self.tolerance)
        grid.addWidget(label, 0, 3)
        grid.addWidget(self.tolerance, 0, 4)
        tip = tr("Compares the motion of both programs; comments, units and numbers of lines make no difference")
        self.button = named_button(f"{NAME}_compare", tr("Compare"), tip, self.compare, self)
        grid.addWidget(self.button, 1, 3)
        tip = tr("Writes the picture as a file")
        self.save_button = named_button(f"{NAME}_save", tr("Save picture…"), tip, self._ask_to_save, self)
        self.save_button.setEnabled(False)
        grid.addWidget(self.save_button, 1, 4)
        grid.setColumnStretch(1, 1)
        sides = QtGui.QSplitter(QtCore.Qt.Orientation.Horizontal, self)
        sides.addWidget(self.picture)
        sides.addWidget(self.figures)
        sides.setSizes([SIZE[0] // 2, SIZE[0] // 2])  # room for both columns of figures
        sides.setStretchFactor(0, 1)
        sides.setStretchFactor(1, 1)
        column = QtGui.QVBoxLayout(self)
        column.addLayout(grid)
        for widget in (self.bar, self.note, self.words):
            column.addWidget(widget)
        column.addWidget(sides, 1)

    def _ask_file(self, number: int) -> None:
        from CNCStepper.workbench.editor.file_dialogs import ask_which

        path = ask_which()
        if path is not None:
            self.take_file(number, Path(path))

    def _ask_to_save(self) -> None:
        dialog = QtGui.QFileDialog(self, tr("Save picture…"), str(Path.home()), "*.png")
        dialog.setObjectName(f"{NAME}_save_file")
        dialog.setAcceptMode(dialog.AcceptMode.AcceptSave)
        dialog.setDefaultSuffix("png")
        dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.fileSelected.connect(guarded(lambda path: self.save_picture(Path(path))))
        dialog.open()


def _programs() -> list[Any]:
    """Return the jobs and programs of all documents that have a text."""
    import FreeCAD

    return [obj for document in FreeCAD.listDocuments().values() for obj in document.Objects if _has_text(obj)]


def _has_text(obj: Any) -> bool:
    return proxy_type(obj) in (*JOBS, Program.Type) and bool(obj.Program)


def _label(obj: Any) -> str:
    import FreeCAD

    several = len(FreeCAD.listDocuments()) > 1
    return f"{obj.Label} ({obj.Document.Label})" if several else str(obj.Label)


def _told(source: Any, dialect: str, owners: list[Any]) -> dict[str, Any]:
    """Return a program as the process is told it; raises CNCStepperError for a job whose dialect is not known.

    dialect, owners: of which the first is a file's job.
    """
    if isinstance(source, str):
        job = job_behind(owners[0]) if owners else None
        lathe = _lathe_content(job) if proxy_type(job) == LATHE_JOB else None
        return {"name": Path(source).name, "file": source, "dialect": dialect, "kind": "", "lathe": lathe}
    from CNCStepper.workbench.document.core_job import language_of

    job, name, file = job_behind(source), source.Label, str(source.Program)
    kind, lathe = ("lathe", _lathe_content(job)) if proxy_type(job) == LATHE_JOB else ("mill", None)
    return {"name": name, "file": file, "dialect": language_of(source), "kind": kind, "lathe": lathe}


def _lathe_content(job: Any) -> dict[str, Any] | None:
    """Return bar and tools of a lathe's job; None where they are not known: paths are compared without a part, too."""
    from CNCStepper.workbench.document.turning.core_turning_job import comparison_content

    try:
        return comparison_content(job)
    except CNCStepperError:
        return None


def _sentence(text: str) -> str:
    """Return a sentence of the core in FreeCAD's language, beginning with a capital letter."""
    shown = translated(text)
    return shown[:1].upper() + shown[1:]


def _local(value: str) -> str:
    """Return a figure with the decimal sign of the window's language."""
    return value.replace(".", str(QtCore.QLocale().decimalPoint()))


def _emphasize(item: Any, differs: bool) -> None:
    """Write what differs in bold letters."""
    font = item.font()
    font.setBold(differs)
    item.setFont(font)


def _remove(folder: Path, *_destroyed: Any) -> None:
    shutil.rmtree(folder, ignore_errors=True)
