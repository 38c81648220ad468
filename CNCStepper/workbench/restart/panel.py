# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a restart: the place, the steps of the restart, and the findings of its proof."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.restart.place_table import PlaceList
from CNCStepper.workbench.restart.restart_places import Row, chosen, line_of, row_of
from CNCStepper.workbench.services.findings_list import FindingsList
from CNCStepper.workbench.services.icons import icon
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.restart_places import RequestedPlace
    from CNCStepper.workbench.proving.proof_process import ProofResult

NAME = "CNCStepper_Restart_"
LONGEST_MM = 1000.0
PROPOSED_HEIGHT_MM = 5.0  # of who gives one: what most programs cross at
MOST_RUNS = 9999
FINDINGS_PX = 110


class EntryFields(QtCore.QObject):
    """The rows of a form; `changed` is sent when a value of theirs is another one."""

    changed = QtCore.Signal()

    def __init__(self, form: Any, parent: Any):
        super().__init__(parent)
        self._overlap = _lengths("overlap", 0.0)
        self._overlap.setToolTip(tr("Begin so much earlier on the same cut, so that no ridge stays"))
        self._gives_height = QtGui.QCheckBox(tr("Height"))
        self._gives_height.setObjectName(f"{NAME}gives_height")
        self._gives_height.setToolTip(
            tr("Go up to this Z first; where none is given: the program's highest crossing rapid")
        )
        self._height = _lengths("height", -LONGEST_MM)
        self._height.setToolTip(self._gives_height.toolTip())
        self._height.setSpecialValueText(tr("as the program"))
        self._overlap.setAccessibleName(tr("Overlap"))
        self._height.setAccessibleName(tr("Height"))
        form.addRow(tr("Overlap"), self._overlap)
        form.addRow(self._gives_height, self._height)
        self._show_height()
        self._overlap.valueChanged.connect(lambda _: self.changed.emit())
        self._gives_height.toggled.connect(lambda _: self._ask_height())
        self._height.valueChanged.connect(lambda _: self.changed.emit())

    @property
    def overlap_mm(self) -> float:
        """How many mm are cut again."""
        return float(self._overlap.value())

    @property
    def height_mm(self) -> float | None:
        """The Z in work coordinates to which the tool goes up first; None is as the program's own rapids go."""
        return float(self._height.value()) if self._gives_height.isChecked() else None

    def _ask_height(self) -> None:
        """Let the height be given, or take it away again."""
        self._show_height()
        self.changed.emit()

    def _show_height(self) -> None:
        given = self._gives_height.isChecked()
        self._height.blockSignals(True)
        self._height.setValue(PROPOSED_HEIGHT_MM if given else self._height.minimum())
        self._height.blockSignals(False)
        self._height.setEnabled(given)


def _lengths(what: str, least_mm: float) -> Any:
    spin = QtGui.QDoubleSpinBox()
    spin.setObjectName(f"{NAME}{what}")
    spin.setRange(least_mm, LONGEST_MM)
    spin.setSingleStep(0.5)
    spin.setSuffix(f" {tr('mm')}")
    spin.setKeyboardTracking(False)
    return spin


class RestartPanel(QtGui.QWidget):
    """The widget of the task.

    place_chosen: sent with a Row of the list. line_chosen: with a line, and which of its runs, 0 where that is not
    said. entering_chosen: when `entering` has another value. send: to send what is shown.
    """

    place_chosen = QtCore.Signal(object)
    line_chosen = QtCore.Signal(int, int)
    entering_chosen = QtCore.Signal()
    send = QtCore.Signal()

    def __init__(self, label: str, said: Sequence[tuple[str, str]], parent: Any = None):
        super().__init__(parent)
        self.setObjectName(f"{NAME}panel")
        self.setWindowTitle(tr("Restart: {0}").format(label))
        f1_key.attach(self, "sending/restart.md")
        self.setWindowIcon(icon("CNCStepper_Send"))
        layout = QtGui.QVBoxLayout(self)
        if said:
            layout.addWidget(_said(said))
        layout.addWidget(_wrapped("advice", _advice()))
        layout.addLayout(self._place())
        self.places = PlaceList()
        self.places.setAccessibleName(tr("Operations and contours from which the program can be restarted"))
        self.places.chosen.connect(self.place_chosen)
        layout.addWidget(self.places, 1)
        for widget in self._answer():
            layout.addWidget(widget)

    # ---- the place ----

    def show_lines(self, count: int) -> None:
        """Let a line be chosen among so many."""
        self.line.setMaximum(max(count, 1))
        self.line.setEnabled(True)

    def show_rows(self, rows: list[Row], more: int) -> None:
        """Show the operations and contours, of which `more` were left out."""
        self.places.show_rows(rows)
        self._more.setText(
            tr("{0} more contours: choose them by line, or in the 3D view.").format(more) if more else ""
        )
        self._more.setVisible(bool(more))

    def show_choice(self, where: RequestedPlace) -> None:
        """Show the chosen place, and mark it in the list."""
        text, values = chosen(where, self.places.rows)
        self._choice.setText(tr(text).format(*values))
        self.places.mark(row_of(where, self.places.rows))
        if line := line_of(where, self.places.rows):
            self._set(self.line, line)

    def ask_time(self, asked: bool) -> None:
        """Ask which run of a line is meant, for a line that is run more than once."""
        if not asked:
            self._set(self.time, 0)
        for widget in (self.time, self._time_label):
            widget.setVisible(asked)

    # ---- the answer ----

    def say(self, text: str, *, busy: bool = False) -> None:
        """Show a sentence instead of an answer; `busy`: it is being found out."""
        self._message.setText(text)
        self._message.setVisible(bool(text))
        self._busy.setVisible(busy)
        for widget in (self._words, self.findings):
            widget.setVisible(False)
        self._lock(tr("There is no restart to send yet."))

    def show_result(self, result: ProofResult) -> None:
        """Show what the restart does, and what was found."""
        self.say("")
        self._words.setText("\n".join(f"•  {translated(sentence)}" for sentence in result.words))
        self.findings.show(result.findings)
        for widget in (self._words, self.findings):
            widget.setVisible(True)
        self._lock(tr("The checks found errors: this restart must not be sent.") if result.refused else "")

    def _lock(self, why_not: str) -> None:
        self._send.setEnabled(not why_not)
        self._send.setToolTip(why_not or tr("Next, in the controller's panel: connect, work zero, start."))

    def _place(self) -> Any:
        self.line = _spin("line", 1, 1)
        self.line.setEnabled(False)
        self.time = _spin("time", 0, MOST_RUNS)
        self.time.setSpecialValueText(tr("choose"))
        self.line.setToolTip(tr("The first line that is not certainly cut"))
        self.line.valueChanged.connect(lambda line: self.line_chosen.emit(line, 0))
        self.time.valueChanged.connect(lambda time: self.line_chosen.emit(self.line.value(), time))
        form = QtGui.QFormLayout()
        form.setRowWrapPolicy(QtGui.QFormLayout.RowWrapPolicy.WrapLongRows)
        self.line.setAccessibleName(tr("Line"))
        self.time.setAccessibleName(tr("Time that it is run"))
        form.addRow(tr("Line"), self.line)
        self._time_label = QtGui.QLabel(tr("Time that it is run"))
        form.addRow(self._time_label, self.time)
        self.entering = EntryFields(form, self)
        self.entering.changed.connect(self.entering_chosen)
        self.ask_time(False)
        return form

    def _answer(self) -> list[Any]:
        self._more, self._choice = _wrapped("more"), _wrapped("choice")
        font = self._choice.font()
        font.setBold(True)
        self._choice.setFont(font)
        self._message, self._words = _wrapped("message"), _wrapped("words")
        self._busy = QtGui.QProgressBar()
        self._busy.setObjectName(f"{NAME}busy")
        self._busy.setRange(0, 0)
        self._busy.setTextVisible(False)
        self.findings = FindingsList()
        self.findings.setMaximumHeight(FINDINGS_PX)
        self._send = QtGui.QPushButton(icon("CNCStepper_Send"), tr("Send this restart…"))
        self._send.setObjectName(f"{NAME}send")
        self._send.clicked.connect(self.send)
        self._more.hide()
        self.say(tr("Reading the program…"), busy=True)
        return [self._more, self._choice, self._message, self._busy, self._words, self.findings, self._send]

    def _set(self, spin: Any, value: int) -> None:
        spin.blockSignals(True)
        spin.setValue(value)
        spin.blockSignals(False)


def _advice() -> str:
    return tr(
        "Choose a line, an entry of the list, or click a cut in the 3D view. Everything before it counts as cut; if"
        " unsure, choose an earlier one."
    )


def _said(told: Sequence[tuple[str, str]]) -> Any:
    """Return what is known of the job that did not end: each name in bold before its words."""
    box = QtGui.QGroupBox(tr("The job that did not end"))
    layout = QtGui.QVBoxLayout(box)
    lines = (f"<b>{escape(name)}:</b> {escape(text)}" for name, text in told)
    label = _wrapped("said", "<br>".join(lines))
    label.setTextFormat(QtCore.Qt.TextFormat.RichText)
    layout.addWidget(label)
    return box


def _spin(what: str, least: int, most: int) -> Any:
    spin = QtGui.QSpinBox()
    spin.setObjectName(f"{NAME}{what}")
    spin.setRange(least, most)
    spin.setKeyboardTracking(False)
    return spin


def _wrapped(what: str, text: str = "") -> Any:
    label = QtGui.QLabel(text)
    label.setObjectName(f"{NAME}{what}")
    label.setWordWrap(True)
    label.setMinimumWidth(1)  # a path is a long word
    label.setTextFormat(QtCore.Qt.TextFormat.PlainText)
    label.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
    return label
