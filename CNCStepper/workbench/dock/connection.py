# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock's end of the wire: it starts a controller's process, attaches to one, polls it and lets it go.

Every call returns at once; its result is in `moment`, `status` and the events of `poll`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.service.work_zero import start_of
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.controller_family import OWN, family_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.state import Start
from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot, sentences
from CNCStepper.workbench.dock.model.port_choices import VIRTUAL
from CNCStepper.workbench.dock.virtual_controller import VirtualMachine
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.plain_words import plain


class Link:
    """At most one controller at a time.

    client: None while there is none. port: what was asked for, `VIRTUAL` for the machine without hardware.
    """

    def __init__(self) -> None:
        self.client: ConnectionClient | None = None
        self.port = ""
        self._virtual: VirtualMachine | None = None
        self._baud = 0
        self._trouble: CNCStepperError | None = None
        self._reached = False

    # --- coming and going ------------------------------------------------------------------------

    def open(self, port: str, baud: int, speed: float = 1.0, profile: str = "") -> None:
        """Begin to connect to a port; `speed` is that of the virtual grbl, which is started first.

        profile: of the machine there; it counts where this computer itself is the controller. Raises JobError where it
        cannot be read.
        """
        self._forget()
        self.port, self._baud = port, baud
        if port == VIRTUAL:
            self._virtual = VirtualMachine(speed)
        else:
            is_own = bool(profile) and family_of(load_machine(profile)) in OWN
            self.client = ConnectionClient.launch(port, baud, machine=profile if is_own else "")

    def attach(self, session_file: Path) -> None:
        """Take up a controller's process that runs already."""
        self._forget()
        self.client = ConnectionClient.attach(session_file)
        self.port = self.client.port

    def leave(self) -> None:
        """Let the controller go: its process ends when it cuts nothing."""
        if self.client:
            self.client.leave()
        if self._virtual:
            self._virtual.give_up()
        self._forget()

    def detach(self) -> None:
        """Let go of a job that goes on."""
        if self.client:
            self.client.detach()
        self._forget()

    def _forget(self) -> None:
        self.client, self._virtual, self._trouble, self._reached = None, None, None, False

    # --- while it lasts --------------------------------------------------------------------------

    def poll(self) -> list[dict[str, Any]]:
        """Return what happened since the last call; never waits."""
        if self._virtual:
            self._await_virtual(self._virtual)
        if not self.client:
            return []
        events = self.client.poll()
        self._reached = self._reached or self.client.phase == "connected"
        if self.client.phase == "gone":
            self._trouble, self.client = self.client.error, None
        return events

    def command(self, name: str, *arguments: Any, **named: Any) -> None:
        """Pass a command on to the controller: "hold", "jog", …; nothing happens when there is none."""
        if self.client:
            getattr(self.client, name)(*arguments, **named)

    @property
    def address(self) -> str:
        """Where the controller really is, the virtual one too, as its journals name it; "" while there is none."""
        return self.client.port if self.client else ""

    @property
    def status(self) -> Any:
        """The last status of the controller, None when there is none."""
        return self.client.status if self.client and self.client.phase == "connected" else None

    @property
    def stand(self) -> int | None:
        """The id of the shown pause, for the answer to it; None without a controller."""
        return self.status.stand if self.status else None

    @property
    def start(self) -> Start | None:
        """The start state of a program on this machine, None where its place on the table is not known."""
        return start_of(self.status)

    @property
    def moment(self) -> ControllerSnapshot:
        """What the dock is to show now."""
        if self._trouble:
            return ControllerSnapshot("gone" if self._reached else "unreached", message=error_text(self._trouble))
        if not self.client:
            return ControllerSnapshot("starting") if self._virtual else ControllerSnapshot()
        if self.client.phase != "connected":
            return ControllerSnapshot(self.client.phase)
        status = self.client.status
        return ControllerSnapshot(
            status.phase,
            status.machine_state,
            plain(translated(status.message)),
            job=status.total > 0,
            homing=status.homing,
            position_known=status.position_known,
            cannot=status.cannot,
        )

    def _await_virtual(self, virtual: VirtualMachine) -> None:
        try:
            address = virtual.address()
            if address:
                self._virtual = None
                self.client = ConnectionClient.launch(address, self._baud)
        except CNCStepperError as trouble:
            self._virtual, self._trouble = None, trouble


def error_text(trouble: CNCStepperError) -> str:
    """Return the text of an error for people, without its code."""
    return plain(sentences(translated(trouble.what), translated(trouble.advice)))
