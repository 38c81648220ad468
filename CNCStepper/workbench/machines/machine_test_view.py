# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine test in the window: pulses, a square and a circle, relays, inputs, travel, backlash, squareness.

It moves the machine that the dock is connected to, by the profile that is chosen; what is measured is proposed as a
value of that profile, which is saved as any other change.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.control.operator import machine_test_lines as lines
from CNCStepper.control.protocol.grbl.capabilities import reason
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.axis_tests import axis_of, length_of_pulses_mm
from CNCStepper.machine.controller_family import family_of
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.relays import relays_of
from CNCStepper.workbench.machines.declaration import Path
from CNCStepper.workbench.machines.labels import choice_label
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.machines.machine_test_results import Play, Travel, squareness_words
from CNCStepper.workbench.machines.port_levels import MotorLines, levels_of, pins_of
from CNCStepper.workbench.machines.port_picture import PortPicture
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, note_label
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.button_row import ButtonRow
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_MachineTest"
FARTHEST_MM = 10_000.0
MOST_PULSES = 10_000_000
FASTEST_MM_MIN = 100_000.0
NOTHING = "–"
TOLD = ("stop", "position")  # of what a machine cannot do, what counts while it is tested
Propose = Callable[[Path, float], None]


class MachineTest(QtGui.QWidget):
    """`machine` gives the machine of the profile that is shown, None while it is none; `propose` takes a value."""

    def __init__(self, machine: Callable[[], Machine | None], propose: Propose):
        super().__init__()
        self._machine, self._propose = machine, propose
        self.bench = Bench(self)
        self.travel, self.play = Travel(), Play()
        self._motor_lines = MotorLines()
        self._locked: list[Any] = []
        self._in_plane: list[Any] = []  # what needs X and Y
        self._axis_boxes: list[Any] = []
        self._relays: dict[str, Any] = {}
        self.state = QtGui.QLabel(self)
        self.state.setObjectName(f"{NAME}_state")
        self.state.setWordWrap(True)
        self.note = note_label(f"{NAME}_error", ERROR_COLOUR, self)
        column = QtGui.QVBoxLayout(self)
        column.addWidget(self.state)
        column.addWidget(self.note)
        grid = QtGui.QGridLayout()
        column.addLayout(grid)
        boxes = (self._motion(), self._switching(), self._travel_box(), self._play_box(), self._square_box())
        for place, box in enumerate(boxes):
            grid.addWidget(box, place // 2, place % 2)
        self.picture = QtGui.QLabel(self)
        self.picture.setObjectName(f"{NAME}_plot")
        self.picture.setAlignment(QtCore.Qt.AlignmentFlag.AlignCenter)
        grid.addWidget(self.picture, 2, 1)
        for place in range(2):
            grid.setColumnStretch(place, 1)
        self.port = PortPicture()
        column.addWidget(self.port, 0, QtCore.Qt.AlignmentFlag.AlignHCenter)
        column.addStretch(1)
        self.bench.changed.connect(guarded(self.refresh))

    def showEvent(self, event: Any) -> None:
        """Follow the machine while this is seen."""
        super().showEvent(event)
        self.bench.watch(True)
        self.show_profile()

    def hideEvent(self, event: Any) -> None:
        """Let the machine go."""
        super().hideEvent(event)
        self.bench.watch(False)

    def show_profile(self) -> None:
        """Offer the relays of the profile that is shown."""
        while self._relay_row.count():
            self._relay_row.takeAt(0).widget().deleteLater()
        self._relays = {}
        machine = self._machine()
        for place, relay in enumerate(relays_of(machine) if machine else ()):
            words = relay.name if relay.name != relay.device else choice_label(("device",), relay.device)
            button = QtGui.QPushButton(words, self)
            button.setObjectName(f"{NAME}_relay_{relay.name}")
            button.setCheckable(True)
            button.clicked.connect(guarded(partial(self._switch, relay, button)))
            self._relay_row.addWidget(button, place // 2, place % 2)
            self._relays[relay.name] = button
        self.port.setVisible(family_of(machine) == "parport")
        if machine:
            self._offer_axes(tuple(machine.own_axes))
            self.port.show_pins(*pins_of(machine))
        self.refresh()

    def refresh(self) -> None:
        """Show the present moment."""
        why, machine, status = self.bench.why_not(), self._machine(), self.bench.status
        if machine is None:
            why = tr("The profile has a value that is none: mend it first.")
        state = tr(why) if why else tr("Connected and idle. Take the tool out, or lift it.")
        lacks = [translated(reason(word)) + "." for word in TOLD if status and word in status.cannot]
        self.state.setText("\n".join([state, *(words[0].upper() + words[1:] for words in lacks)]))
        self.note.setText(self.bench.trouble)
        self.note.setVisible(bool(self.bench.trouble))
        for widget in (*self._locked, *self._relays.values()):
            widget.setEnabled(not why)
            widget.setToolTip(tr(why) if why else "")
        self._lock_plane(machine)
        self.stop_button.setEnabled(self.bench.is_busy)
        self.inputs.setText(tr("Inputs that are on: {0}").format(_inputs(machine, status)) if status else NOTHING)
        for relay in relays_of(machine) if machine else ():
            on = lines.is_on(relay.device, status.outputs if status else None)
            if on is not None and relay.name in self._relays:
                self._relays[relay.name].setChecked(on)
        if machine:
            self._motor_lines.take(machine, status)
            self.port.show_levels(levels_of(machine, status) | self._motor_lines.levels, self._motor_lines.pulsing)
        self.travel_words.setText(self.travel.words(machine) if machine else "")
        self.play_words.setText(self.play.words())
        self.travel_take.setEnabled(bool(machine and self.travel.correction(machine)))

    def _offer_axes(self, axes: tuple[str, ...]) -> None:
        """List the axes that the machine has; the one that was chosen stays where it is there."""
        for box in self._axis_boxes:
            chosen = box.currentData()
            box.clear()
            for axis in axes:
                box.addItem(axis.upper(), axis)
            box.setCurrentIndex(max(box.findData(chosen), 0))

    def _lock_plane(self, machine: Machine | None) -> None:
        """Lock what lies in X and Y on a machine without them, and the lift on one without Z."""
        self.size.setEnabled(True)  # nothing else does so after a lathe
        self.size.setToolTip("")
        try:
            if machine:
                lines.check_plane(machine)
        except CNCStepperError as error:
            for widget in self._in_plane:
                widget.setEnabled(False)
                widget.setToolTip(translated(error.what))
        has_z = machine is None or "z" in machine.own_axes
        self.height.setEnabled(has_z)
        self.height.setToolTip("" if has_z else tr("This machine has no axis Z."))

    # --- the boxes ---------------------------------------------------------------------------------

    def _motion(self) -> Any:
        box, form = _box(tr("Motion in air"))
        self.axis = self._axes("axis")
        self.count = _number(f"{NAME}_pulses", 400, MOST_PULSES, 0, "")
        self.feed = _number(f"{NAME}_feed", 600.0, FASTEST_MM_MIN, 1, " mm/min")
        self.size = _number(f"{NAME}_size", 50.0, FARTHEST_MM, 3, " mm")
        self.height = _number(f"{NAME}_height", 0.0, FARTHEST_MM, 3, " mm", least=0.0)
        form.addRow(tr("Axis"), self.axis)
        form.addRow(tr("Pulses"), self.count)
        back = self._button("back", tr("Pulses −"), partial(self._pulses, -1))
        forward = self._button("forward", tr("Pulses +"), partial(self._pulses, 1))
        form.addRow(self._row(back, forward))
        form.addRow(tr("Feed"), self.feed)
        form.addRow(tr("Size of square and circle"), self.size)
        form.addRow(tr("Lift before"), self.height)
        square = self._button("square", tr("Square"), self._square)
        circle = self._button("circle", tr("Circle"), self._circle)
        self.stop_button = self._button("stop", tr("Stop"), self.bench.stop)
        self._locked.remove(self.stop_button)
        self._in_plane += [self.size, square, circle]
        form.addRow(self._row(square, circle, self.stop_button))
        return box

    def _switching(self) -> Any:
        box, form = _box(tr("Relays and inputs"))
        self._relay_row = QtGui.QGridLayout()
        form.addRow(self._relay_row)
        self.inputs = QtGui.QLabel(NOTHING, self)
        self.inputs.setObjectName(f"{NAME}_inputs")
        form.addRow(self.inputs)
        return box

    def _travel_box(self) -> Any:
        box, form = _box(tr("Travel"))
        self.travel_axis = self._axes("travel_axis")
        self.travel_length = _number(f"{NAME}_length", 100.0, FARTHEST_MM, 3, " mm")
        self.measured = _number(f"{NAME}_measured", 100.0, FARTHEST_MM, 4, " mm")
        self.travel_words = _words(f"{NAME}_travel_words", self)
        form.addRow(tr("Axis"), self.travel_axis)
        form.addRow(tr("Commanded length"), self.travel_length)
        start = self._button("start", tr("To the start"), self._to_start)
        along = self._button("along", tr("Drive the length"), self._drive)
        form.addRow(self._row(start, along))
        form.addRow(tr("Measured"), self.measured)
        take = self._button("reading", tr("Take the reading"), self._take_reading)
        self.travel_take = self._button("correct", tr("Put into the profile"), self._correct)
        self._locked.remove(take)
        self._locked.remove(self.travel_take)
        form.addRow(self._row(take, self.travel_take))
        form.addRow(self.travel_words)
        return box

    def _play_box(self) -> Any:
        box, form = _box(tr("Backlash"))
        self.play_axis = self._axes("play_axis")
        self.dial = _number(f"{NAME}_dial", 0.0, FARTHEST_MM, 4, " mm", least=-FARTHEST_MM)
        self.distance = _number(f"{NAME}_distance", 5.0, FARTHEST_MM, 3, " mm")
        self.play_words = _words(f"{NAME}_play_words", self)
        form.addRow(tr("Axis"), self.play_axis)
        form.addRow(tr("Entry from"), self.distance)
        below = self._button("below", tr("Come from below"), partial(self._come, 0))
        above = self._button("above", tr("Come from above"), partial(self._come, 1))
        form.addRow(self._row(below, above))
        form.addRow(tr("Dial"), self.dial)
        take = self._button("play_correct", tr("Put into the profile"), self._correct_play)
        self._locked.remove(take)
        form.addRow(self._row(*self._dial_buttons(), take))
        form.addRow(self.play_words)
        return box

    def _dial_buttons(self) -> list[Any]:
        """Return the buttons that take the dial's reading for the side it came from."""
        buttons = [
            self._button("dial_below", tr("From below"), lambda: self._take_dial(self.play.below_mm)),
            self._button("dial_above", tr("From above"), lambda: self._take_dial(self.play.above_mm)),
        ]
        for button in buttons:
            self._locked.remove(button)
        return buttons

    def _square_box(self) -> Any:
        box, form = _box(tr("Squareness"))
        self.side_x = _number(f"{NAME}_side_x", 300.0, FARTHEST_MM, 3, " mm")
        self.side_y = _number(f"{NAME}_side_y", 400.0, FARTHEST_MM, 3, " mm")
        self.falling = _number(f"{NAME}_falling", 500.0, FARTHEST_MM, 4, " mm")
        self.rising = _number(f"{NAME}_rising", 0.0, FARTHEST_MM, 4, " mm", least=0.0)
        self.square_words = _words(f"{NAME}_square_words", self)
        form.addRow(tr("Side along X"), self.side_x)
        form.addRow(tr("Side along Y"), self.side_y)
        corners = [self._button(f"corner_{n}", text, partial(self._corner, n)) for n, text in _corners()]
        for corner in corners:
            corner.setAccessibleName(tr("Side {0} of the rectangle").format(corner.text()))
        self._in_plane += corners
        form.addRow(self._row(*corners))
        form.addRow(tr("Lower right to upper left"), self.falling)
        form.addRow(tr("Other diagonal (0: none)"), self.rising)
        show = self._button("angle", tr("Work out the angle"), self._angle)
        self._locked.remove(show)
        form.addRow(show)
        form.addRow(self.square_words)
        return box

    # --- what they do ------------------------------------------------------------------------------

    def _go(self, room: tuple[tuple[str, float, float], ...], found: list[str], done: Any = None) -> None:
        """Send lines after a look at the travel of each axis in `room`: how far it goes down and up."""
        machine, status = self._machine(), self.bench.status
        if machine is None or status is None:
            return
        for axis, low_mm, high_mm in room:
            axis_of(machine, axis)
            lines.check_room(machine, status.mpos_mm if status.homed else None, axis, low_mm, high_mm)
        self.bench.run(found, done)

    def _pulses(self, sense: int) -> None:
        axis = self.axis.currentData()
        length = length_of_pulses_mm(self._shown(), axis, sense * int(self.count.value()))
        self._go(((axis, min(length, 0.0), max(length, 0.0)),), [lines.way(axis, length, self.feed.value())])

    def _square(self) -> None:
        side = self.size.value()
        self._go((("x", 0.0, side), ("y", 0.0, side)), self._lifted(lines.square(side, self.feed.value())))

    def _circle(self) -> None:
        size, feed = self.size.value(), self.feed.value()

        def drive(modes: str) -> None:
            lines.check_no_power(modes)
            self.bench.run(self._lifted([lines.circle(size, feed), lines.modes_back(modes)]))

        self._go((("x", 0.0, size), ("y", -size / 2, size / 2)), [lines.ASK_MODES], drive)

    def _lifted(self, found: list[str]) -> list[str]:
        height, feed = self.height.value(), self.feed.value()
        return [lines.way("z", height, feed), *found, lines.way("z", -height, feed)] if height else found

    def _switch(self, relay: Any, button: Any) -> None:
        machine, on = self._shown(), button.isChecked()
        button.setChecked(not on)  # until it is switched, which may be refused

        def switch(modes: str) -> None:
            found = lines.switching(machine, relay.device, on, lines.outputs_of(modes))
            self.bench.run(found, lambda _: button.setChecked(on))

        self.bench.run([lines.ASK_MODES], switch)

    def _to_start(self) -> None:
        axis, length = self.travel_axis.currentData(), self.travel_length.value()
        play = axis_of(self._shown(), axis).backlash_mm
        start, _, _ = lines.arrivals(axis, length, play, self.feed.value())
        self._go(((axis, -play - lines.LEAD_MM, length),), start)

    def _drive(self) -> None:
        axis, length = self.travel_axis.currentData(), self.travel_length.value()
        self.travel.begin(axis, length)
        self._go(((axis, 0.0, length),), [lines.way(axis, length, self.feed.value())])

    def _take_reading(self) -> None:
        self.travel.begin(self.travel_axis.currentData(), self.travel_length.value())
        self.travel.take(self.measured.value())
        self.refresh()
        self._plot()
        axis, length = self.travel.axis, self.travel.length_mm
        if not self.bench.why_not():
            self._go(((axis, -length, 0.0),), [lines.way(axis, -length, self.feed.value())])

    def _correct(self) -> None:
        found = self.travel.correction(self._shown())
        if found:
            self._propose(*found)
            self.travel.values_mm.clear()
            self.refresh()

    def _come(self, side: int) -> None:
        axis, distance = self.play_axis.currentData(), self.distance.value()
        self.play.begin(axis)
        self._go(((axis, -distance, distance),), lines.both_sides(axis, distance, self.feed.value())[side])

    def _take_dial(self, readings: list[float]) -> None:
        self.play.begin(self.play_axis.currentData())
        readings.append(self.dial.value())
        self.refresh()

    def _correct_play(self) -> None:
        found = self.play.correction()
        if found is None:
            messages.note(tr("Take the dial's reading from both sides first."))
            return
        self._propose(*found)

    def _corner(self, number: int) -> None:
        axis, sense = (("x", 1), ("y", 1), ("x", -1), ("y", -1))[number]
        length = sense * (self.side_x if axis == "x" else self.side_y).value()
        self._go(((axis, min(length, 0.0), max(length, 0.0)),), [lines.way(axis, length, self.feed.value())])

    def _angle(self) -> None:
        rising = self.rising.value() or None
        self.square_words.setText(
            squareness_words(self.side_x.value(), self.side_y.value(), self.falling.value(), rising)
        )

    def _plot(self) -> None:
        from io import BytesIO

        from CNCStepper.simulation.views.readings_plot import readings_figure

        readings = self.travel.readings
        if readings is None:
            return
        data = BytesIO()
        figure = readings_figure(self.travel.axis.upper(), self.travel.length_mm, readings.values_mm,
                                 readings.mean_mm, readings.deviation_mm)  # fmt: skip
        figure.savefig(data, format="png", dpi=60)
        picture = QtGui.QPixmap()
        picture.loadFromData(QtCore.QByteArray(data.getvalue()))
        self.picture.setPixmap(picture)

    def _shown(self) -> Machine:
        """Return the machine that is shown; raises CNCStepperError while it is none."""
        machine = self._machine()
        if machine is None:
            raise CNCStepperError("bad-value", "the profile has a value that is none", advice="mend it first")
        return machine

    def _axes(self, name: str) -> Any:
        box = QtGui.QComboBox(self)
        box.setObjectName(f"{NAME}_{name}")
        self._axis_boxes.append(box)
        return box

    def _button(self, name: str, text: str, clicked: Callable[[], None]) -> Any:
        button = QtGui.QPushButton(text, self)
        button.setObjectName(f"{NAME}_{name}")
        button.setAutoDefault(False)
        button.clicked.connect(guarded(lambda: clicked()))
        self._locked.append(button)
        return button

    def _row(self, *buttons: Any) -> ButtonRow:
        row = ButtonRow(self)
        for button in buttons:
            row.add(button)
        return row


def _inputs(machine: Machine | None, status: SenderStatus) -> str:
    """Return the inputs that are on: those of a parallel port by what they do, else the letters of the status."""
    found = lines.inputs_on(machine, status) if machine else []
    return ", ".join(f"{choice_label(('act',), one.act)} ({one.pin})" for one in found) or status.pins or NOTHING


def _corners() -> tuple[tuple[int, str], ...]:
    return tuple(enumerate(("X+", "Y+", "X−", "Y−")))


def _box(title: str) -> tuple[Any, Any]:
    box = QtGui.QGroupBox(title)
    return box, QtGui.QFormLayout(box)


def _words(name: str, parent: Any) -> Any:
    label = QtGui.QLabel(parent)
    label.setObjectName(name)
    label.setWordWrap(True)
    return label


def _number(name: str, value: float, most: float, decimals: int, suffix: str, least: float = 0.001) -> Any:
    box = QtGui.QDoubleSpinBox()
    box.setObjectName(name)
    box.setDecimals(decimals)
    box.setRange(least if decimals else 1.0, most)
    box.setValue(value)
    box.setSuffix(suffix)
    return box
