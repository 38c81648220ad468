# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arithmetic of an axis, worked out while a person types: from motor, gear and screw to pulses and speeds.

It changes neither job nor profile: its figures are for the profile's file and for the controller's settings.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.features.base import ANGLE, DISTANCE, FLOAT, INTEGER, SPEED, Property
from CNCStepper.workbench.features.program_job import MACHINE
from CNCStepper.workbench.panels.field_errors import complaints
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, GAP_PX, NAME, note_label
from CNCStepper.workbench.panels.form import align_labels
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.panels.unit_values import text_of, value_of_text, whole_of_text
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

SCREW, BELT, OPEN, CLOSED = "screw", "belt", "open", "closed"
AXES = ("x", "y", "z")
CHOICES = {
    "moved_by": (later("Moved by"), {SCREW: later("Screw"), BELT: later("Toothed belt")}),
    "loop": (later("Pulses of"), {OPEN: later("Stepper motor (open loop)"), CLOSED: later("Encoder (closed loop)")}),
}
TYPED = (
    Property("screw_pitch_mm", "", DISTANCE, MACHINE, later("Pitch"),
             later("Travel for a turn of the screw; with several starts its lead"), 5.0, only=("moved_by", (SCREW,))),
    Property("belt_pitch_mm", "", DISTANCE, MACHINE, later("Belt's pitch"), later("From tooth to tooth"), 2.0,
             only=("moved_by", (BELT,))),
    Property("pulley_teeth", "", INTEGER, MACHINE, later("Pulley's teeth"), later("Of the pulley that drives the belt"),
             20, only=("moved_by", (BELT,))),
    Property("gear_ratio", "", FLOAT, MACHINE, later("Gear ratio"),
             later("Turns of the motor for one of screw or pulley"), 1.0),
    Property("steps_per_turn", "", FLOAT, MACHINE, later("Motor's steps"), later("Full steps a turn"), 200.0,
             only=("loop", (OPEN,))),
    Property("microsteps", "", INTEGER, MACHINE, later("Microsteps"), later("Of the driver, in a full step"), 1,
             only=("loop", (OPEN,))),
    Property("encoder_pulses_per_turn", "", FLOAT, MACHINE, later("Encoder's pulses"),
             later("A turn, as they are counted"), 400.0, only=("loop", (CLOSED,))),
    Property("encoder_gear_ratio", "", FLOAT, MACHINE, later("Encoder's gear"),
             later("Turns of the encoder for one of screw or pulley"), 1.0, only=("loop", (CLOSED,))),
    Property("distance_mm", "", DISTANCE, MACHINE, later("Distance"), later("How far the axis goes"), 100.0),
    Property("feed_mm_min", "", SPEED, MACHINE, later("Feed"), later("How fast the axis goes"), 1000.0),
    Property("rate_hz", "", FLOAT, MACHINE, later("Pulses/s"), later("As many as can be made at most, in Hz"),
             25_000.0),
)  # fmt: skip
BACKLASH = Property("backlash_mm", "", DISTANCE, MACHINE, later("Backlash"),
                    later("Backlash of the axis in the profile; the moves sent compensate it"),
                    0.0)  # fmt: skip
RESULTS = {
    "steps_per_mm": ("", later("Steps/mm")),
    "resolution": (DISTANCE, later("Resolution")),
    "pulses": ("", later("Pulses")),
    "reached": (DISTANCE, later("Reached")),
    "pulse_angle": (ANGLE, later("Pulse angle")),
    "motor_angle": (ANGLE, later("Motor angle")),
    "screw_speed": ("", later("Screw speed")),
    "motor_speed": ("", later("Motor speed")),
    "pulse_rate": ("", later("Pulse rate")),
    "highest_feed": (SPEED, later("Highest feed")),
}
TRIAL = ("distance_mm", "feed_mm_min", "rate_hz")  # what is asked of the drive


class AxisSheet(QtGui.QWidget):
    """Lines to type a drive into, and the results below; the profile's drive of the chosen axis is the default."""

    def __init__(self, job: Any, parent: Any):
        super().__init__(parent)
        self.job = job
        self.lines: dict[str, Any] = {}
        self.boxes: dict[str, Any] = {}
        self.answers: dict[str, Any] = {}
        self.rows: dict[str, tuple[Any, Any]] = {}  # label and what stands beside it
        self._rows = QtGui.QFormLayout(self)
        self._rows.setContentsMargins(0, 0, 0, 0)
        self._rows.setVerticalSpacing(0)  # a row brings its own, so that those that are not seen take no room
        self._rows.setFieldGrowthPolicy(QtGui.QFormLayout.FieldGrowthPolicy.ExpandingFieldsGrow)
        self._add_choice("axis", tr("Axis"), {axis: axis.upper() for axis in AXES})
        for key, (label, words) in CHOICES.items():
            self._add_choice(key, tr(label), {value: tr(word) for value, word in words.items()})
        for entry in TYPED:
            self._add_line(entry)
        self.note = note_label(f"{NAME}_axis_error", ERROR_COLOUR, self)
        self._rows.addRow(self.note)
        for quantity, (_, label) in RESULTS.items():
            self._add_result(quantity, tr(label))
        self._add_result(BACKLASH.key, tr(BACKLASH.label))
        self.rows[BACKLASH.key][0].setToolTip(tr(BACKLASH.text))
        align_labels([self._rows])
        self.boxes["axis"].activated.connect(guarded(lambda _: self.take_axis()))
        self.take_axis()

    def follow(self) -> None:
        """Show the axis of another profile, once the job has one."""
        if self.job.Machine != self._profile:
            self.take_axis()

    def take_axis(self) -> None:
        """Show the profile's values of the chosen axis; values that it lacks stay."""
        self._profile = self.job.Machine
        axis = self._profile_axis()
        drive = axis.drive if axis else None
        self.answers[BACKLASH.key].setText(text_of(axis.backlash_mm, BACKLASH) if axis else "")
        if axis:
            self._write("feed_mm_min", axis.max_rate_mm_min)
        if drive:
            self._choose("moved_by", SCREW if drive.screw_pitch_mm else BELT)
            self._choose("loop", CLOSED if drive.closed_loop else OPEN)
            for key, value in drive.model_dump(exclude_none=True).items():
                self._write(key, value)
        self.work_out()

    def work_out(self) -> None:
        """Show the results of the lines, or their error."""
        chosen = {key: box.currentData() for key, box in self.boxes.items()}
        for box in self.boxes.values():
            box.setToolTip(box.currentText())  # a narrow panel shows its front
        seen = [entry for entry in TYPED if not entry.only or chosen[entry.only[0]] in entry.only[1]]
        for entry in TYPED:
            for widget in self.rows[entry.key]:
                widget.setVisible(entry in seen)
        try:
            self._show(self._answers(seen))
        except Refused as refused:
            self._say(tr(refused.sentence).format(*map(translated, refused.values)))

    def _answers(self, seen: list[Property]) -> Any:
        """Return the worked answers; raises Refused, naming the line."""
        from CNCStepper.machine.axis_drive import Drive, answers

        values = {entry.key: self._read(entry) for entry in seen}
        drive = {key: value for key, value in values.items() if key not in TRIAL}
        entries = {entry.key: entry for entry in seen}
        for key, wrong in complaints(Drive, drive, lambda key, number: text_of(number, entries[key])).items():
            raise _named(entries[key], tr(wrong.sentence).format(*map(translated, wrong.values)))
        return answers(Drive.model_validate(drive), *(values[key] for key in TRIAL))

    def _read(self, entry: Property) -> float:
        read = whole_of_text if entry.type == INTEGER else value_of_text
        try:
            value = read(self.lines[entry.key].text(), entry, self.job)
        except Refused as refused:
            raise _named(entry, tr(refused.sentence).format(*map(translated, refused.values))) from refused
        if entry.key in TRIAL and value <= 0:
            raise _named(entry, tr("must be above {0}").format(text_of(0.0, entry)))
        return value

    def _show(self, found: Any) -> None:
        self._say("")
        for answer in found:
            if label := self.answers.get(answer.quantity):
                label.setText(_words(answer) + self._of_profile(answer.quantity))
                label.setToolTip(answer.working)

    def _of_profile(self, quantity: str) -> str:
        axis = self._profile_axis() if quantity == "steps_per_mm" else None
        return f"  ({tr('profile: {0}').format(_local(axis.steps_per_mm))})" if axis else ""

    def _say(self, sentence: str) -> None:
        self.note.setText(sentence)
        self.note.setVisible(bool(sentence))
        for quantity in RESULTS if sentence else ():
            self.answers[quantity].clear()

    def _profile_axis(self) -> Any:
        """Return the axis of the job's machine, or None while there is no such machine."""
        from CNCStepper.errors import CNCStepperError
        from CNCStepper.workbench.document.machine_of_job import machine_of

        try:
            return machine_of(self.job).axis[self.boxes["axis"].currentData()]
        except CNCStepperError:  # said beside the profile's own field
            return None

    def _tidy(self, entry: Property) -> None:
        """Write a value that is left with its unit, as every other line of the panel does."""
        with suppress(Refused):  # it stays as it was typed, and is told
            self._write(entry.key, self._read(entry))

    def _choose(self, key: str, value: str) -> None:
        self.boxes[key].setCurrentIndex(self.boxes[key].findData(value))

    def _write(self, key: str, value: float) -> None:
        self.lines[key].setText(_typed(value, next(entry for entry in TYPED if entry.key == key)))
        self.lines[key].setCursorPosition(0)  # of what is longer than its line the front is seen

    def _add_choice(self, key: str, label: str, words: dict[str, str]) -> None:
        box = QtGui.QComboBox(self)
        box.setObjectName(f"{NAME}_axis_{key}")
        box.setAccessibleName(label)
        for value, word in words.items():
            box.addItem(word, value)
        box.setMinimumContentsLength(5)
        box.setSizePolicy(QtGui.QSizePolicy.Policy.Expanding, QtGui.QSizePolicy.Policy.Fixed)
        box.activated.connect(guarded(lambda _: self.work_out()))
        self.boxes[key] = box
        self._add_row(key, label, box)

    def _add_line(self, entry: Property) -> None:
        line = QtGui.QLineEdit(self)
        line.setObjectName(f"{NAME}_axis_{entry.key}")
        line.setAccessibleName(tr(entry.label))
        line.setText(_typed(entry.default, entry))
        line.textEdited.connect(guarded(lambda _: self.work_out()))
        line.editingFinished.connect(guarded(lambda: self._tidy(entry)))
        self.lines[entry.key] = line
        self._add_row(entry.key, tr(entry.label), line)
        for widget in self.rows[entry.key]:
            widget.setToolTip(tr(entry.text))

    def _add_result(self, quantity: str, words: str) -> None:
        value = QtGui.QLabel(self)
        value.setObjectName(f"{NAME}_axis_{quantity}")
        value.setWordWrap(True)  # else a long value makes the panel wider than its place
        value.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self.answers[quantity] = value
        self._add_row(quantity, words, value)

    def _add_row(self, key: str, words: str, widget: Any) -> None:
        label, holder = QtGui.QLabel(words, self), QtGui.QWidget(self)
        column = QtGui.QVBoxLayout(holder)
        for part in (label, column):
            part.setContentsMargins(0, GAP_PX, 0, GAP_PX)
        column.addWidget(widget)
        self.rows[key] = label, holder
        self._rows.addRow(label, holder)


def _words(answer: Any) -> str:
    """Return a value in the user's units."""
    kind, label = RESULTS[answer.quantity]
    if kind:
        return text_of(answer.value, Property(answer.quantity, "", kind, MACHINE, label, ""))
    unit = "" if answer.unit == "1/mm" else answer.unit
    return f"{_local(answer.value)} {unit}".rstrip()


def _typed(value: float, entry: Property) -> str:
    """Return a value as it stands in a line."""
    return _local(value) if entry.type == FLOAT else text_of(value, entry)


def _local(value: float) -> str:
    from CNCStepper.machine.axis_drive import shown

    return shown(value).replace(".", str(QtCore.QLocale().decimalPoint()))


def _named(entry: Property, sentence: str) -> Refused:
    """Return a refusal that names its line first."""
    return Refused("{0}", f"“{tr(entry.label)}”: {translated(sentence)}")
