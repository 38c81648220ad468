# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared parts of the machine verbs: commands to the connection service at a port, and their results.

A service that runs at that port already, a window's for example, is asked; else one is started. It stays open for the
quiet time, for the next verbs, so that the board is not restarted by each.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial, wraps
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.keep_open import keep_option, tell_kept
from CNCStepper.cli.common.language import show_text, translated
from CNCStepper.cli.common.options import Named
from CNCStepper.cli.job.status_text import overrides_changed, overrides_known
from CNCStepper.errors import CNCStepperError, MachineRefusal, Text
from CNCStepper.machine.controller_family import BAUD

if TYPE_CHECKING:
    from CNCStepper.control.service.connection_client import ConnectionClient
    from CNCStepper.control.session.status import SenderStatus

LOOK_EVERY_S = 0.02
END_LIMIT_S = 5.0  # for a service of our own to let go of the port

Event = dict[str, Any]


def named_machine(name: str) -> str:
    """Return a profile's name, or the absolute path of its file; raises JobError where there is no such profile."""
    from CNCStepper.machine.profile import load_machine, profile_names

    if not name:
        return ""
    load_machine(name)
    return name if name in profile_names() else str(Path(name).resolve())


def profile_option(function: Any, is_required: bool = False) -> Any:
    """Add --machine, which the function gets as `machine`: a name or an absolute path, "" where none is given."""
    reader = Named("PROFILE", named_machine)
    text = "The machine's profile, by name or TOML file; needed where this computer itself is the controller."
    default: dict[str, Any] = {"required": True} if is_required else {"default": ""}
    return click.option("--machine", type=reader, help=text, **default)(function)


@dataclass(frozen=True)
class ServicePort:
    """Where a machine is. machine: its profile, by name or absolute path, "" where none is given.

    keep_min: how many minutes its connection stays open after the verb.
    """

    name: str
    baud: int = BAUD
    machine: str = ""
    keep_min: float = 0.0


def port_options(function: Any, needs_machine: bool = False) -> Any:
    """Add --port, --baud, --machine and --keep-open; the function gets them as one `ServicePort`, `at`."""

    @wraps(function)
    def command(*arguments: Any, port: str, baud: int, machine: str, keep_min: float, **more: Any) -> Any:
        return function(*arguments, at=ServicePort(port, baud, machine, keep_min), **more)

    port = click.option(
        "--port",
        required=True,
        help="A serial port (COM3, /dev/ttyUSB0; `cncstepper ports` lists them) or a URL (socket://127.0.0.1:2217, "
        "telnet://fluidnc.local, rfc2217://host:port); of a machine that this computer controls also /dev/parport0 or "
        "record:FILE.",
    )
    baud = click.option("--baud", type=click.IntRange(min=300), default=BAUD, show_default=True)
    return port(baud(profile_option(keep_option(command), needs_machine)))


class ServiceClient:
    """A conversation with the connection service at a port; prints its events and raises its refusals."""

    def __init__(self, at: ServicePort):
        from CNCStepper.control.service.connection_client import ConnectionClient

        self._at = at
        self.client: ConnectionClient = ConnectionClient.launch(
            at.name, at.baud, machine=at.machine, keep_s=60.0 * at.keep_min
        )

    def __enter__(self) -> ServiceClient:
        from CNCStepper.control.service.port_owner import warn_of_closed

        warn_of_closed(partial(show_text, err=True))
        while self.client.phase != "connected":
            self.look()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        path = self.client.session_file
        is_kept = self._at.keep_min > 0 and not self.is_over
        alone = self.client.started_service and not is_kept
        self.client.leave()
        if is_kept:
            tell_kept(self._at.name, self._at.keep_min)
        end_s = time.monotonic() + END_LIMIT_S
        while alone and path and path.exists() and time.monotonic() < end_s:
            time.sleep(LOOK_EVERY_S)

    @property
    def status(self) -> SenderStatus:
        """The last status of the machine."""
        return self.client.status

    @property
    def is_over(self) -> bool:
        """Whether the service has ended, or its link is lost."""
        return self.client.phase == "gone"

    def heard(self) -> list[Event]:
        """Return what has happened since the last call, at once."""
        return [event for event in self.client.poll() if not event.get("past")]

    def check(self) -> None:
        """Raise why the service has ended, if it has."""
        if self.is_over:
            what = "the connection service has ended"
            raise self.client.error or CNCStepperError("service-gone", what, advice="try again")

    def look(self) -> list[Event]:
        """Wait a moment and return what has happened; raises the error when the service has ended."""
        time.sleep(LOOK_EVERY_S)
        events = self.heard()
        for event in events:
            if event["event"] in ("message", "warning"):
                show_text(event["text"])
            elif event["event"] == "refused":
                raise event.get("error") or MachineRefusal("service-refused", event["text"], advice="see --help")
        self.check()
        return events

    def until(self, done: Callable[[Event], bool]) -> Event:
        """Wait for the event that is asked for, and return it; raises what is refused meanwhile."""
        while True:
            for event in self.look():
                if done(event):
                    return event

    def ask_status(self) -> SenderStatus:
        """Ask for the machine's status and return it; a status that does not change is not sent unasked."""
        self.client.ask("status")
        self.until(lambda event: event["event"] == "status")
        return self.status

    def override(self, values: dict[str, str]) -> None:
        """Ask for an override, and wait until the controller reports it."""
        self._await(overrides_known())
        known = self.status
        self.client.ask("override", **values)
        self._await(overrides_changed(known))

    def _await(self, reached: Callable[[SenderStatus], bool]) -> None:
        while not reached(self.status):
            self.ask_status()

    def type(self, text: str) -> str:
        """Send a typed line, print the controller's messages, and return its answer."""
        self.client.type(text)
        event = self.until(self._heard_answer)
        return str(event["text"])

    def home(self) -> None:
        """Let the machine find its own zero, and wait until it has."""
        from CNCStepper.control.service.idle_controller import HOMED

        begun = False

        def over(event: Event) -> bool:
            nonlocal begun
            begun = begun or event == {"event": "phase", "text": "homing"}
            return event.get("text") == HOMED or (begun and event["event"] == "phase" and event["text"] != "homing")

        self.client.home()
        if self.until(over)["text"] != HOMED:
            what = Text("the machine is not homed: {state}", state=self.status.message or self.status.machine_state)
            raise MachineRefusal("not-homed", what, advice="see that the way to the switches is free, then home again")

    def set_zero(self, axes: str) -> None:
        """Make this place the zero of these axes, and wait until that is done."""
        self.client.set_zero(axes)
        self.until(lambda event: event["event"] == "message" and event["text"].startswith("zero of"))

    def _heard_answer(self, event: Event) -> bool:
        if event["event"] == "console":
            click.echo(event["text"])
        return event["event"] == "answer"


def place(status: SenderStatus) -> str:
    """Return state and position in words: "Idle  X-1.000 Y0.000 Z0.000 (machine X...)"."""
    found = [status.machine_state or status.phase]
    if status.wpos_mm:
        found.append(_axes(status.wpos_mm))
    if status.mpos_mm:
        found.append(translated(Text("machine {position}", position=_axes(status.mpos_mm))))
    if status.position_known is False:
        found.append(translated(Text("position unknown")))
    return "  ".join(found)


def _axes(position_mm: tuple[float, ...]) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZABC", position_mm, strict=False))
