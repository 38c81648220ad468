# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window of pulse letters: a file drawn in XY and over time, sent through the dock's controller, led back.

The letters begin where the machine stands. While they are sent the pictures follow the pulses; a click in a picture
chooses a pulse, from which the way back to the begin can be sent. Pulses by hand go to the controller one by one.
"""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.control.operator.machine_test_lines import way
from CNCStepper.control.program.send_job import write_job
from CNCStepper.errors import JobError
from CNCStepper.job.letter_file import LETTERS_A_LINE, letter_job, read_letter_text
from CNCStepper.machine.axis_tests import length_of_pulses_mm
from CNCStepper.machine.controller_family import makes_pulses
from CNCStepper.machine.profile import AXIS_NAMES, Machine, load_machine
from CNCStepper.motion.signals.letter_track import LetterTrack, letter_track
from CNCStepper.workbench.dock.connection import error_text
from CNCStepper.workbench.dock.model.send_steps import POSITION_UNKNOWN
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.dock.window import open_dock
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.letters.letter_view import Timeline, WayView, on_words
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, note_label
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.messages import guarded, polled
from CNCStepper.workbench.services.number_format import NOTHING, duration
from CNCStepper.workbench.services.translation import later, tr

NAME = "CNCStepper_Letters"
SIZE = (820, 640)
POLL_MS = 50
MOST_BY_HAND = 1_000_000
NOT_CONNECTED = later("Connect to the machine first, in the controller's panel.")
NO_PULSES = later("In the controller's panel choose a machine whose pulses this computer makes.")
NOT_IDLE = later("The machine must be idle: wait, or home or unlock it first.")
COUNTERS = ("x", "y", "z", "pulse", "elapsed", "total", "on")


class Letters(QtGui.QDialog):
    """See the module; track: of the file that is open, None before."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("Pulse letters"))
        f1_key.attach(self, "freecad.md")
        self.resize(*SIZE)
        self.track: LetterTrack | None = None
        self.path = Path()
        self._folder = tempfile.TemporaryDirectory(prefix="cncstepper-letters-", ignore_cleanup_errors=True)
        self._panel = open_dock().widget()
        self._back_from: int | None = None  # the pulse from which letters that run now lead back
        self._runs = self._is_sent = False
        self.way, self.timeline = WayView("way", (320, 260), self.choose), Timeline("timeline", (320, 150), self.choose)
        self.slider = _named(QtGui.QSlider(QtCore.Qt.Orientation.Horizontal), "slider")
        self.slider.valueChanged.connect(guarded(self._slid))
        self.figures = {name: _named(QtGui.QLabel(NOTHING), name) for name in COUNTERS}
        self.note = note_label(f"{NAME}_error", ERROR_COLOUR, self)
        self.state = _named(QtGui.QLabel(), "state")
        self.open_button = _button("open", tr("Open…"), self._ask)
        self.send_button = _button("send", tr("Send"), self.send)
        self.back_button = _button("back", tr("Back from here to the begin"), self.send_back)
        self.axis = _named(QtGui.QComboBox(), "axis")
        self.count = _named(QtGui.QSpinBox(), "count")
        self.count.setRange(1, MOST_BY_HAND)
        names = ((self.slider, tr("Pulse")), (self.axis, tr("Axis")), (self.count, tr("Pulses")))
        for widget, name in names:
            widget.setAccessibleName(name)
        self.minus = _button("minus", tr("Pulses −"), lambda: self._by_hand(-1))
        self.plus = _button("plus", tr("Pulses +"), lambda: self._by_hand(1))
        self._arrange()
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(polled(self.refresh))

    def showEvent(self, event: Any) -> None:
        """Follow the machine while this is seen."""
        super().showEvent(event)
        self._timer.start()
        self.refresh()

    def hideEvent(self, event: Any) -> None:
        """Rest while it is not seen."""
        super().hideEvent(event)
        self._timer.stop()

    # --- what is asked of it -----------------------------------------------------------------------

    def open_file(self, path: Path) -> None:
        """Show a file of letters; raises JobError, ProgramError for what is none."""
        track = letter_track(read_letter_text(path), str(path))
        if not track.pulses:
            raise JobError("letters-empty", "the file has no pulse letter", advice="choose another")
        self.track, self.path = track, path
        self.setWindowTitle(tr("Pulse letters: {0}").format(path.name))
        for picture in (self.way, self.timeline):
            picture.show_track(track)
        self.slider.setRange(0, track.pulses)
        self.choose(0)
        self.refresh()

    def choose(self, pulse: int) -> None:
        """Show a pulse, unless the machine says where it is."""
        if not self._runs:
            self.slider.setValue(pulse)
            self._slid(pulse)

    def send(self) -> None:
        """Send the letters of the file."""
        if self.track is not None:
            self._send(self.track.text, self.path, None)

    def send_back(self) -> None:
        """Send the letters that lead from the shown pulse back to the begin."""
        pulse = self.slider.value()
        if self.track is not None and pulse:
            path = Path(self._folder.name) / f"{self.path.stem}-back-from-{pulse}.letters"
            self._send(self.track.back_from(pulse), path, pulse)

    def why_not_send(self) -> str:
        """Return why letters cannot be sent now, "" when they can; in English, for `tr`."""
        status = self._panel.link.status
        unknown = status is not None and status.position_known is False
        return self.why_not() or (POSITION_UNKNOWN if unknown else "")

    def why_not(self) -> str:
        """Return why no pulse can be made now, "" when one can; in English, for `tr`."""
        machine, status = self.machine(), self._panel.link.status
        if machine is None or not makes_pulses(machine):
            return NO_PULSES
        if status is None:
            return NOT_CONNECTED
        return "" if status.phase == "idle" else NOT_IDLE

    def machine(self) -> Machine | None:
        """Return the machine that the dock names, None for one that cannot be read."""
        try:
            return load_machine(self._panel.connection.profile)
        except JobError:
            return None

    def refresh(self) -> None:
        """Show the present moment."""
        status, why, why_not_send = self._panel.link.status, self.why_not(), self.why_not_send()
        self._follow(status)
        self.state.setText(tr(why_not_send) if why_not_send and not self._runs else self._state_words(status))
        for button in (self.minus, self.plus):
            widgets.lock(button, why, "")
        for button in (self.send_button, self.back_button):
            widgets.lock(button, why_not_send, "")
            button.setEnabled(not why_not_send and self.track is not None)
        self.slider.setEnabled(self.track is not None and not self._runs)
        self._offer_axes()
        self._show_figures(status)

    # --- inside ------------------------------------------------------------------------------------

    def _ask(self) -> None:
        dialog = QtGui.QFileDialog(self, tr("Open pulse letters"), str(Path.home()))
        dialog.setObjectName(f"{NAME}_file")
        dialog.setNameFilters([tr("Pulse letters ({0})").format("*.letters"), tr("All files ({0})").format("*")])
        dialog.setFileMode(QtGui.QFileDialog.FileMode.ExistingFile)
        dialog.fileSelected.connect(guarded(lambda path: self.open_file(Path(path))))
        dialog.finished.connect(lambda _: dialog.deleteLater())
        dialog.open()

    def _send(self, text: str, path: Path, back_from: int | None) -> None:
        machine = self.machine()
        if machine is None or self.why_not_send():
            return
        job = replace(letter_job(_in_short_lines(text), machine, str(path)), profile=self._panel.connection.profile)
        file = Path(self._folder.name) / "letters.zip"
        write_job(file, job)
        self._back_from, self._is_sent = back_from, True
        self._say("")
        by_line = self._panel.by_line.isChecked()
        self._panel.link.command("run", file, zero_confirmed=True, by_line=by_line)

    def _by_hand(self, sense: int) -> None:
        machine, name = self.machine(), self.axis.currentText().lower()
        if machine is None or self.why_not():
            return
        axis = machine.own_axes[name]
        feed_mm_min = min(machine.feed_mm_min or axis.max_rate_mm_min, axis.max_rate_mm_min)
        length_mm = length_of_pulses_mm(machine, name, sense * self.count.value())
        self._panel.link.command("type", way(name, length_mm, feed_mm_min))

    def _follow(self, status: Any) -> None:
        """Show the pulse that is reached while letters of this window run, and why they were not sent."""
        client = self._panel.link.client
        ours = status is not None and status.total > 0 and Path(status.file).suffix == ".letters"
        if ours and self.track is not None:
            whole = self.track.pulses if self._back_from is None else self._back_from
            done = round(status.done * whole)
            self._show_pulse(done if self._back_from is None else whole - done)
        if self._is_sent and not ours and client is not None and client.outcome is not None:
            self._is_sent = False
            self._say(error_text(client.outcome.error) if client.outcome.error else "")
            if client.outcome.done:
                self._show_pulse(0 if self._back_from is not None or self.track is None else self.track.pulses)
        self._runs = ours

    def _show_pulse(self, pulse: int) -> None:
        self.slider.blockSignals(True)
        self.slider.setValue(pulse)
        self.slider.blockSignals(False)
        self._slid(pulse)

    def _slid(self, pulse: int) -> None:
        for picture in (self.way, self.timeline):
            picture.show_pulse(pulse)
        self._show_figures(self._panel.link.status)

    def _show_figures(self, status: Any) -> None:
        if self.track is None:
            return
        pulse, machine = self.slider.value(), self.machine()
        for name, steps in zip(AXIS_NAMES, self.track.places[pulse].tolist(), strict=True):
            self.figures[name].setText(f"{steps:+d}")
        interval_s = machine.signals.interval_s if machine is not None and makes_pulses(machine) else None
        self.figures["pulse"].setText(tr("{0} of {1}").format(pulse, self.track.pulses))
        elapsed_s = status.elapsed_s if self._runs and status else interval_s and pulse * interval_s
        self.figures["elapsed"].setText(duration(elapsed_s))
        self.figures["total"].setText(duration(interval_s and self.track.pulses * interval_s))
        self.figures["on"].setText(on_words(self.track, pulse))

    def _state_words(self, status: Any) -> str:
        if status is None or not self._runs:
            return tr("The letters start at the machine's position.")
        return tr("Being sent, {0} left").format(duration(status.remaining_s))

    def _offer_axes(self) -> None:
        machine = self.machine()
        names = [name.upper() for name in machine.own_axes] if machine else []
        if [self.axis.itemText(place) for place in range(self.axis.count())] != names:
            self.axis.clear()
            self.axis.addItems(names)

    def _say(self, text: str) -> None:
        self.note.setText(text)
        self.note.setVisible(bool(text))

    def _arrange(self) -> None:
        labels = (tr("X, steps"), tr("Y, steps"), tr("Z, steps"), tr("Pulse"), tr("Elapsed"), tr("Send time"), tr("On"))
        counters = QtGui.QFormLayout()
        for label, name in zip(labels, COUNTERS, strict=True):
            counters.addRow(label, self.figures[name])
        side = QtGui.QVBoxLayout()
        side.addWidget(self.open_button)
        side.addLayout(counters)
        for button in (self.send_button, self.back_button):
            side.addWidget(button)
        side.addSpacing(12)
        side.addWidget(QtGui.QLabel(tr("Pulses by hand")))
        for pair in ((self.axis, self.count), (self.minus, self.plus)):
            row = QtGui.QHBoxLayout()
            for widget in pair:
                row.addWidget(widget)
            side.addLayout(row)
        side.addStretch(1)
        pictures = QtGui.QVBoxLayout()
        pictures.addWidget(self.way, 3)
        pictures.addWidget(self.timeline, 2)
        pictures.addWidget(self.slider)
        upper = QtGui.QHBoxLayout()
        upper.addLayout(pictures, 1)
        upper.addLayout(side)
        whole = QtGui.QVBoxLayout(self)
        whole.addLayout(upper, 1)
        for widget in (self.state, self.note):
            widget.setWordWrap(True)
            whole.addWidget(widget)


def _in_short_lines(text: str) -> str:
    """Return letters in lines as they are sent, of each of which it is known when it is played."""
    letters = "".join(text.split())
    return "".join(letters[at : at + LETTERS_A_LINE] + "\n" for at in range(0, len(letters), LETTERS_A_LINE))


def _named(widget: Any, name: str) -> Any:
    widget.setObjectName(f"{NAME}_{name}")
    return widget


def _button(name: str, text: str, clicked: Any) -> Any:
    button = _named(QtGui.QPushButton(text), name)
    button.setAutoDefault(False)
    button.clicked.connect(messages.guarded(clicked))
    return button
