# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controller's panel: its sections below each other, filled from the link twenty times a second."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.dock.connection import Link, error_text
from CNCStepper.workbench.dock.file_sending import FileSending
from CNCStepper.workbench.dock.job_sending import Sending
from CNCStepper.workbench.dock.model import settings
from CNCStepper.workbench.dock.model.button_states import RULES, face, why_not
from CNCStepper.workbench.dock.model.relay_keys import sound_between
from CNCStepper.workbench.dock.model.send_steps import why_not_confirm
from CNCStepper.workbench.dock.outline_sending import OutlineSending
from CNCStepper.workbench.dock.restart_offer import RestartOffer
from CNCStepper.workbench.dock.retract_client import COMMANDS, RetractRun
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.dock.views.big_digits import BigDigits
from CNCStepper.workbench.dock.views.connection_view import ConnectionView
from CNCStepper.workbench.dock.views.console_view import ConsoleView, LogView
from CNCStepper.workbench.dock.views.job_buttons_view import JobView, PauseView
from CNCStepper.workbench.dock.views.jog_view import JogView
from CNCStepper.workbench.dock.views.keyboard import KeyboardArea
from CNCStepper.workbench.dock.views.live_view import LiveView
from CNCStepper.workbench.dock.views.override_view import OverrideView
from CNCStepper.workbench.dock.views.relay_view import RelayView
from CNCStepper.workbench.dock.views.retract_view import RetractView
from CNCStepper.workbench.dock.views.send_steps_view import FlowView
from CNCStepper.workbench.dock.views.state_view import PositionView, StateView
from CNCStepper.workbench.document.machine_of_job import profile_of
from CNCStepper.workbench.features.program import job_behind
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.proving.latest_proof import Sender
from CNCStepper.workbench.services import messages, sounds
from CNCStepper.workbench.services.findings_list import FindingsList
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.plain_words import plain
from CNCStepper.workbench.services.sounds import BEYOND, END
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace

POLL_MS = 50
WIDTH, ROOM = 320, 20
MARGINS = (8, 4, 8, 4)


class Panel(KeyboardArea):
    """All of the dock's content; `link` is its controller, `sending` the job on its way, `language` FreeCAD's then.

    send: begins to send a program, or its restart at a place, with the dock in front.
    """

    def __init__(self, link: Link, send: Sender) -> None:
        super().__init__()
        widgets.named(self, "Panel")
        self.language = FreeCADGui.getLocale()
        self.link, self.log = link, LogView()
        lengths, point = settings.lengths(), settings.decimal_point()
        self.findings = widgets.named(FindingsList(), "Findings")
        self.by_line = widgets.named(QtGui.QCheckBox(tr("Line by line")), "ByLine")
        self.by_line.setToolTip(tr("The machine waits before each line of a job; Resume cuts the next one"))
        self.by_line.clicked.connect(messages.guarded(self._by_line_chosen))
        self.sending = Sending(
            self, self.link, self._show_findings, self.connect_chosen, self.refresh, self.by_line.isChecked
        )
        self.live = LiveView(self, self.sending)
        self.connection = ConnectionView(self.connect_chosen, self._leave, self._ports)
        self.state = StateView(lambda: self.recovery.go_on())
        self.flow = FlowView(self.findings, self.sending.confirm_step, self.sending.away)
        self.file_sending = FileSending(send, lambda: self.connection.profile)
        self.outline = OutlineSending(send)
        self.recovery = RestartOffer(self.link, send, self.state.show_way_on)
        self.position = PositionView(lengths, point, lambda axes: self.link.command("set_zero", axes))
        self._add_digits(BigDigits(self, lengths, point))
        self.backing = RetractRun(self, self.link, self.log.say, self.refresh)
        self.back = RetractView(lengths, point, self.backing.go)
        self.halt, self.job = PauseView(self.backing.command), JobView()
        self.jog = JogView(lengths, point, self.link.command)
        self.overrides = OverrideView(lambda kind, step: self.link.command("override", kind, step))
        self.relays = RelayView(lambda line: self.link.command("type", line))
        self.relays.show_machine(self.connection.profile)
        self.connection.machine.activated.connect(messages.guarded(self._machine_chosen))
        self.sounds = widgets.named(QtGui.QCheckBox(tr("Sounds")), "Sounds")
        self.sounds.setToolTip(tr("A short sound at an alarm, an end, a pause, and for a part beyond the work surface"))
        self.sounds.setChecked(settings.sounds_on())
        self.sounds.clicked.connect(messages.guarded(lambda: settings.switch_sounds(self.sounds.isChecked())))
        self._before = self.link.moment
        self.home = widgets.button("Home", tr("Home"), lambda: self.link.command("home"), icon="Home")
        self.unlock = widgets.button("Unlock", tr("Unlock"), lambda: self.link.command("unlock"), icon="Unlock")
        self.setting_up = widgets.button("SetUp", tr("Set up a machine…"), _open_assistant)
        self.console = ConsoleView(lambda line: self.link.command("type", line))
        self._set_help_pages()
        self._mark: tuple[Any, str] = (None, "")
        self._arrange()
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(messages.guarded(self._tick))
        self._timer.start()
        self.refresh()

    def _add_digits(self, digits: BigDigits) -> None:
        """Have the window of big digits, and the button that shows it."""
        self.digits = digits
        self.digits_button = widgets.button("Digits", tr("Big digits…"), self._show_digits)
        self.digits_button.setToolTip(
            tr("Positions, state and remaining time in a window of their own, to be read across the room")
        )

    def _set_help_pages(self) -> None:
        """Say which page of the guide F1 opens at each part."""
        f1_key.attach(self, "sending/README.md")
        for part, page in (
            (self.connection, "sending/link.md"),
            (self.file_sending.button, "sending/send-file.md"),
            (self.outline.button, "sending/README.md"),
            (self.recovery.view, "sending/restart.md"),
            (self.back, "sending/back.md"),
        ):
            f1_key.set_page(part, page)

    def minimumSizeHint(self) -> Any:
        """Return the narrowest that nothing is cut off at, in any language."""
        bar = self.area.verticalScrollBar().sizeHint().width()
        return QtCore.QSize(max(WIDTH, self.area.widget().minimumSizeHint().width() + bar), 1)

    def sizeHint(self) -> Any:
        """Return a comfortable size."""
        return self.minimumSizeHint() + QtCore.QSize(ROOM, self.area.widget().sizeHint().height())

    # --- asked from outside ----------------------------------------------------------------------

    def attach(self, session_file: Path) -> None:
        """Take up a controller's process that a window before this one has left."""
        self.link.attach(session_file)
        self.sending.forget()
        self.log.say("message", tr("Attached again to the controller at {0}.").format(plain(self.link.port)))
        self.refresh()

    def send(self, program: Any, place: RestartPlace | None = None) -> None:
        """Begin to send a program, or its restart at a place, to its job's machine unless another one is connected."""
        job = job_behind(program)
        self.connection.choose_machine(profile_of(job.Machine, job))
        self.relays.show_machine(self.connection.profile)
        self.sending.send(program, place)

    def connect_chosen(self) -> None:
        """Begin to connect to the port that is chosen, and remember it."""
        port, baud = self.connection.port, self.connection.baud_rate
        settings.remember_port(port, baud)
        self.relays.show_machine(self.connection.profile)
        try:
            self.link.open(port, baud, self.connection.times_faster, self.connection.profile)
        except CNCStepperError as error:
            messages.error(error)
        self.refresh()

    def refresh(self) -> None:
        """Show the present moment in all sections."""
        moment, flow = self.link.moment, self.sending.flow
        shown = face(moment)
        self.state.show_face(shown, tr(shown.sentence))
        senders = (self.file_sending, self.outline, self.recovery.view)
        views: tuple[Any, ...] = (self.connection, *senders, self.position)
        for view in (*views, self.halt, self.jog, self.overrides, self.relays, self.console):
            view.lock(moment)
        for name, button in (("home", self.home), ("unlock", self.unlock)):
            widgets.lock(button, why_not(name, moment), RULES[name].does)
        self.back.show_back(self.backing.flow, moment)
        self.flow.show_flow(flow, why_not_confirm(flow, moment))
        self._show_status(self.link.status, moment.job_runs)
        self.digits.show_moment(moment, self.link.status)

    # --- inside ----------------------------------------------------------------------------------

    def _tick(self) -> None:
        events = self.link.poll()
        for event in events:
            self._on_message(event)
            self.relays.take(event)
            if event["event"] == "outcome" and not event.get("past"):
                self._sound(END)
            self.sending.take(event)
        self.sending.advance()
        self.outline.advance()
        self.live.advance(self.link.status)
        self.backing.advance()
        self.recovery.advance()
        mark = (self.link.moment, self.sending.flow.step)
        self._sound(sound_between(self._before, mark[0]))
        self._before = mark[0]
        if events or mark != self._mark:
            if mark[1] != self._mark[1]:  # a new step must be seen
                self.area.verticalScrollBar().setValue(0)
            self._mark = mark
            self.refresh()

    def _show_findings(self, findings: Any) -> None:
        self.findings.show(findings)
        if any(finding.code == "travel" for finding in findings):
            self._sound(BEYOND)

    def _on_message(self, event: dict[str, Any]) -> None:
        """Let the console say what belongs to a typed line, and the log what concerns all."""
        if event["event"] in ("console", "answer") or event.get("command") == "line":
            self.console.on_message(translated(event["text"]))
        elif event["event"] in ("message", "warning", "refused") and event.get("command") not in COMMANDS:
            self.log.say(
                event["event"], error_text(event["error"]) if event.get("error") else plain(translated(event["text"]))
            )

    def _show_status(self, status: Any, job_runs: bool) -> None:
        self.position.show_status(status)
        self.relays.show_outputs(status and status.outputs)
        self.overrides.show_overrides(overrides_of(status), status and status.outputs)
        if status is not None and job_runs:
            self.job.show_job(Path(status.file).name, status, self.sending.program_lines)
        elif not job_runs:
            self.job.hide()

    def _by_line_chosen(self) -> None:
        if self.link.moment.job_runs:
            self.link.command("by_line", self.by_line.isChecked())

    def _machine_chosen(self) -> None:
        settings.remember_machine(self.connection.profile)
        self.relays.show_machine(self.connection.profile)
        self.refresh()

    def _sound(self, name: str) -> None:
        if name and settings.sounds_on():
            sounds.play(name)

    def _show_digits(self) -> None:
        self.digits.show()
        self.digits.raise_()
        self.digits.show_moment(self.link.moment, self.link.status)

    def _leave(self) -> None:
        self.link.leave()
        self.refresh()

    def _ports(self) -> list[tuple[str, str]]:
        """Return the serial ports with their names; none, and a message, when pyserial is missing."""
        from CNCStepper.control.transport.link import port_list

        try:
            return [(choice.name, choice.text) for choice in port_list()]
        except CNCStepperError as error:
            self.log.say("warning", error_text(error))
            return []

    def _arrange(self) -> None:
        """Put what must always be in sight above what may scroll."""
        content = QtGui.QWidget()
        layout = widgets.column(content)
        layout.setContentsMargins(*MARGINS)
        of_a_job = (self.job, widgets.row(self.by_line, self.live.box), self.back)
        before_a_cut = (self.file_sending.button, self.outline.button, self.recovery.view)
        sections: tuple[list[Any], ...] = (
            [self.flow, *of_a_job, *before_a_cut, self.position, self.digits_button],
            [widgets.caption(tr("Jog")), self.jog, widgets.row(self.home, self.unlock)],
            [widgets.caption(tr("Overrides")), self.overrides],
            [widgets.caption(tr("Relays")), self.relays],
            [widgets.row(widgets.caption(tr("Messages")), self.sounds), self.log],
            [widgets.caption(tr("Console")), self.console, self.setting_up],
        )
        for number, section in enumerate(sections):
            if number:
                layout.addWidget(widgets.line())
            for entry in section:
                layout.addWidget(entry) if isinstance(entry, QtGui.QWidget) else layout.addLayout(entry)
        layout.addStretch(1)
        self.area = QtGui.QScrollArea()
        self.area.setWidget(content)
        self.area.setWidgetResizable(True)
        self.area.setFrameShape(QtGui.QFrame.Shape.NoFrame)
        self.area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        head = widgets.column()
        head.setContentsMargins(*MARGINS)
        for view in (self.connection, self.state, self.halt):
            head.addWidget(view)
        whole = widgets.column(self)
        whole.addLayout(head)
        whole.addWidget(self.area, 1)


def _open_assistant() -> None:
    FreeCADGui.runCommand("CNCStepper_Assistant")


def overrides_of(status: Any) -> dict[str, Any]:
    """Return feed, rapid and spindle in percent as reported, {} when nothing is."""
    return dict(zip(("feed", "rapid", "spindle"), (status and status.overrides) or (), strict=False))
