# SPDX-License-Identifier: LGPL-2.1-or-later
"""The step that moves an axis by a known length, takes what was measured, and corrects its steps per mm.

the start ──► the length ──► measured ──► corrected in the draft ──asked──► $100= ──ok──► $$ read back

A controller of this computer's own takes its steps from the profile: there nothing is written to it.
"""

from __future__ import annotations

from CNCStepper.control.operator import machine_test_lines as lines
from CNCStepper.control.protocol.grbl.settings import STEPS_PER_MM
from CNCStepper.control.settings.controller_identity import identity_of
from CNCStepper.control.settings.settings_file import setting_line
from CNCStepper.control.settings.settings_restore import ASK_SETTINGS, check_restored, check_takes_settings
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.axis_tests import axis_of
from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.workbench.assistant.machine_setup import MachineSetup
from CNCStepper.workbench.assistant.widgets import Page, combo, label, number, row
from CNCStepper.workbench.dock.connection import error_text
from CNCStepper.workbench.machines.declaration import NUMBER, Row
from CNCStepper.workbench.machines.draft import text_of
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.machines.machine_test_results import Travel
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.translation import later, tr

TITLE = later("Measure")
FARTHEST_MM, FASTEST_MM_MIN = 10_000.0, 100_000.0


class MeasurePage(Page):
    """See the module."""

    title = TITLE

    def __init__(self, setup: MachineSetup, bench: Bench):
        words = tr(
            "Move each axis by a known length and type what you measure. Take the tool out, or lift it, and keep a "
            "hand at the emergency stop."
        )
        super().__init__(setup, bench, words)
        self.travel = Travel()
        self.axis = combo("axis", tr("Axis"), [(name.upper(), name) for name in AXIS_NAMES], self.refresh)
        self.length = number("length", tr("Length"), 100.0, FARTHEST_MM, " mm")
        self.feed = number("feed", tr("Feed"), 600.0, FASTEST_MM_MIN, " mm/min")
        self.measured = number("measured", tr("Measured"), 100.0, FARTHEST_MM, " mm")
        self.starting = self.button("to_start", tr("1. To the start"), self._to_start)
        self.moving = self.button("move", tr("2. Move"), self._move)
        self.correcting = self.button("correct", tr("3. Correct"), self._correct)
        self.returning = self.button("return", tr("Back"), self._return)
        self.stopping = self.button("stop", tr("Stop"), self.bench.stop)
        self.state, self.said = label("measure_state"), label("measure_said")
        self._arrange()

    def entered(self) -> None:
        """Offer the axes that the machine has."""
        machine = self.setup.machine
        axes = list(machine.own_axes) if machine else []
        chosen = self.axis.currentData()
        self.axis.clear()
        for name in axes:
            self.axis.addItem(name.upper(), name)
        self.axis.setCurrentIndex(max(self.axis.findData(chosen), 0))
        self.refresh()

    def refresh(self) -> None:
        """Show what can be done now, and the present value."""
        why, machine, axis = self.bench.why_not(), self.setup.machine, self.axis.currentData()
        self.state.setText(tr(why) if why else tr("Connected and idle."))
        for button in (self.starting, self.moving, self.correcting, self.returning):
            button.setEnabled(not why and machine is not None)
        self.stopping.setEnabled(self.bench.is_busy)
        self.say_wrong(self.bench.trouble)
        if machine and axis in machine.own_axes:
            steps = machine.own_axes[axis].steps_per_mm
            self.present.setText(tr("{0}: {1:g} steps per mm").format(axis.upper(), steps))

    def _arrange(self) -> None:
        self.present = label("steps_per_mm")
        self.present.setWordWrap(False)
        form = (
            row(label("", tr("Axis")), self.axis, self.present),
            row(label("", tr("Length")), self.length, label("", tr("Feed")), self.feed),
            row(self.starting, self.moving, self.stopping),
            row(label("", tr("Measured")), self.measured, self.correcting, self.returning),
        )
        for line in form:
            self.column.addLayout(line)
        for widget in (self.said, self.state, self.note):
            self.column.addWidget(widget)
        self.column.addStretch(1)

    def _to_start(self) -> None:
        axis, length = self._chosen()
        play = axis_of(self._machine(), axis).backlash_mm
        self._go(-play - lines.LEAD_MM, length, lines.arrivals(axis, length, play, self.feed.value())[0])

    def _move(self) -> None:
        axis, length = self._chosen()
        self.said.setText("")
        self.measured.setValue(length)
        self._go(0.0, length, [lines.way(axis, length, self.feed.value())])

    def _return(self) -> None:
        axis, length = self._chosen()
        self._go(-length, 0.0, [lines.way(axis, -length, self.feed.value())])

    def _go(self, low_mm: float, high_mm: float, way: list[str]) -> None:
        """Send lines of the chosen axis, unless it would leave its travel; raises JobError."""
        status = self.bench.status
        mpos_mm = status.mpos_mm if status and status.homed else None
        lines.check_room(self._machine(), mpos_mm, self._chosen()[0], low_mm, high_mm)
        self.bench.run(way)

    def _correct(self) -> None:
        """Put the corrected steps into the draft, and ask whether the controller is to have them too."""
        axis, length = self._chosen()
        self.travel = Travel(axis, length)
        self.travel.take(self.measured.value())
        found = self.travel.correction(self._machine())
        if found is None:
            self.said.setText(tr("The length is right: nothing to correct."))
            return
        path, steps = found
        self.setup.draft.texts[path] = text_of(steps, Row(path, NUMBER))
        self.setup.draft.texts.update({key: "" for key in self.setup.draft.texts if key[:3] == (*path[:2], "drive")})
        self.said.setText(tr("{0} has {1:g} steps per mm now.").format(axis.upper(), steps))
        self.refresh()
        self._offer(axis, steps)

    def _offer(self, axis: str, steps: float) -> None:
        found = self.setup.identity
        if found is None or found.is_own or not found.settings:
            return
        check_takes_settings(found.firmware)
        setting = STEPS_PER_MM + AXIS_NAMES.index(axis)
        line = setting_line(setting, steps)
        question = tr("Write {0} to the controller?").format(line)
        more = tr("Its position is unknown afterwards: home it, or set its zero.")
        if messages.ask(question, tr("Write"), tr("Not now"), more):
            self.bench.run([line, ASK_SETTINGS], lambda _: self._written(line, {setting: steps}))

    def _written(self, line: str, wanted: dict[int, float]) -> None:
        found = identity_of(word for _, words in self.bench.answered for word in words)
        try:
            check_restored(found.settings, [line], wanted)
        except CNCStepperError as error:
            self.say_wrong(error_text(error))
            return
        if self.setup.identity:
            self.setup.identity = self.setup.identity.with_settings(found.settings)
        self.said.setText(tr("{0} is written and read back.").format(line))

    def _chosen(self) -> tuple[str, float]:
        return str(self.axis.currentData()), self.length.value()

    def _machine(self) -> Machine:
        machine = self.setup.machine
        if machine is None:
            raise CNCStepperError("bad-value", "the profile has a value that is none", advice="mend it first")
        return machine
