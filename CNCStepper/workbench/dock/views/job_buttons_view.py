# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job being cut: progress, line, times, and hold, resume, stop."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot, does, why_not
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.number_format import NOTHING, duration
from CNCStepper.workbench.services.translation import tr

PARTS = 1000  # of the progress bar
LINES_KEPT = 2  # of text, for sentences whose figures grow


class PauseView(QtGui.QWidget):
    """Hold, resume and stop, always in sight; `command` is called with their names."""

    def __init__(self, command: Callable[[str], None]):
        super().__init__()
        widgets.named(self, "Halt")
        self.buttons = {
            "hold": widgets.button("Hold", tr("Hold"), lambda: command("hold"), icon="Hold"),
            "resume": widgets.button("Resume", tr("Resume"), lambda: command("resume"), icon="Resume"),
            "stop": widgets.button("Stop", tr("Stop"), lambda: command("stop"), icon="Stop"),
        }
        self.setLayout(widgets.row(*self.buttons.values()))
        for button in self.buttons.values():
            button.setMinimumHeight(button.sizeHint().height() + 8)

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the buttons that can work.

        A button that was pressed and can work no more leaves the focus to this view; from here only Hold takes it.
        """
        for name, button in self.buttons.items():
            widgets.lock(button, why_not(name, moment), does(name, moment))
        if self.hasFocus() and self.buttons["hold"].isEnabled():
            self.buttons["hold"].setFocus()


class JobView(QtGui.QWidget):
    """The running program and its progress; hidden while no job runs."""

    def __init__(self) -> None:
        super().__init__()
        self.title = widgets.wrapped("JobTitle")
        self.title.setFont(widgets.caption("").font())
        self.progress = widgets.named(QtGui.QProgressBar(), "Progress")
        self.progress.setRange(0, PARTS)
        self.lines = widgets.steady(widgets.wrapped("Lines"), LINES_KEPT)
        self.buffer = widgets.steady(widgets.wrapped("Buffer"), LINES_KEPT)
        self.text = widgets.named(QtGui.QLabel(), "ProgramLine")
        self.text.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont))
        self.text.setTextFormat(QtCore.Qt.TextFormat.PlainText)
        self.text.setMinimumWidth(1)
        self.elapsed, self.remaining = (widgets.figure(name, widest="0:00:00") for name in ("Elapsed", "Remaining"))
        times = widgets.row(QtGui.QLabel(tr("Elapsed")), self.elapsed, QtGui.QLabel(tr("Remaining")), self.remaining)
        times.insertStretch(2, 1)
        layout = widgets.column(self)
        for widget in (self.title, self.progress, self.lines, self.buffer, self.text):
            layout.addWidget(widget)
        layout.addLayout(times)
        self.hide()

    def show_job(self, label: str, status: Any, program_lines: Any) -> None:
        """Show how far a job is; `program_lines` of its file, empty when they are not known here."""
        self.show()
        self.title.setText(tr("Job: {0}").format(label) if label else tr("Job"))
        self.progress.setValue(round(PARTS * status.done))
        self.progress.setFormat(tr("{0} %").format(int(100 * status.done)))
        self.lines.setText(
            tr("{0} of {1} lines, line {2} of the file, sent to line {3}").format(
                status.acknowledged, status.total, status.file_line, status.file_line_sent
            )
        )
        blocks, free_bytes = status.buffer or (NOTHING, NOTHING)
        self.buffer.setText(tr("Controller's buffer: {0} blocks and {1} bytes free").format(blocks, free_bytes))
        known = 0 < status.file_line <= len(program_lines)
        self.text.setText(program_lines[status.file_line - 1].strip() if known else "")
        self.text.setVisible(bool(program_lines))  # also before the first line, and after the last: rows must not jump
        self.elapsed.setText(duration(status.elapsed_s))
        self.remaining.setText(duration(status.remaining_s))
