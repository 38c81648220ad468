# SPDX-License-Identifier: LGPL-2.1-or-later
"""A window's client of a connection service: launch or attach, poll from a timer, ask. Nothing here blocks.

    client = ConnectionClient.launch("socket://127.0.0.1:2217")
    ... from a timer, about 20 times a second:
    for event in client.poll(): ...
    client.phase, client.status, client.outcome, client.error

What is asked is asked: whether it was done shows in the status and the events, a refusal is an event.

Starts a connection service on a thread: finding a Python and starting it take time.

Finds the job of a command line that holds a machine's port, before a connection service is launched.
"""

from __future__ import annotations

import secrets
import subprocess
import threading
import time
from concurrent.futures import Future
from pathlib import Path
from typing import Any

from CNCStepper.control.processes.process_file import is_alive, is_closed
from CNCStepper.control.processes.python_finder import find_python
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.detached_process import start
from CNCStepper.control.session.files import (
    LOG,
    OUTCOME,
    SERVICE,
    new_session,
    read_private,
    running_services,
    service_at,
    session_folder,
    session_near,
)
from CNCStepper.control.session.local_socket import Address, LineSocket
from CNCStepper.control.session.status import Outcome, SenderStatus, error_from_json, take_refusal
from CNCStepper.control.session.unreachable import closed, garbled, silent, unreadable
from CNCStepper.control.transport.controller_link import has_no_controller
from CNCStepper.errors import CNCStepperError, LinkError, MachineRefusal, Text
from CNCStepper.machine.controller_family import BAUD


def check_no_job(port: str, folder: Path | None = None) -> None:
    """Raise MachineRefusal where a job that was sent from a command line has the port; a killed one has it no more."""
    if session := session_near(port, folder):
        try:
            with SessionClient.attach(session) as client:
                status = client.status() if client.outcome is None else None
        except LinkError as error:  # it was killed, as its journal shows, or it does not answer
            check_over(session, port, error)
            return
        if status:
            raise port_held_by_job(session, port, status)


def check_over(file: Path, port: str, error: LinkError) -> None:
    """Raise MachineRefusal where the process that could not be reached lives: then it has the port."""
    if is_alive(file):
        what = Text("{port} is held by a process of yours that does not answer", port=port)
        raise MachineRefusal("port-held", what, advice=error.advice) from error


def port_held_by_job(file: Path, port: str, status: SenderStatus) -> MachineRefusal:
    """Return the refusal for a port that a job holds, from the file of its session or service."""
    return MachineRefusal(
        "port-held",
        Text(
            "{port} is held by a job of yours, {status_file}, which is {phase}",
            port=port,
            status_file=status.file or Text("a program"),
            phase=status.phase,
        ),
        advice=Text(
            "resume or stop it where it was started, or with: cncstepper back --session {file}", file=file.stem
        ),
    )


WORKER = "CNCStepper.workers.connection_service"
YIELD_S = 0.005  # the window's thread runs first

Launched = tuple[Path, subprocess.Popen | None]


def launch(port: str, baud: int, folder: Path | None, machine: str = "") -> Future[Launched]:
    """Return a future of the service's file at `port` and its process; None when it runs already.

    Its exception is MissingPackage when no Python can be the service's, MachineRefusal while a job that was sent from a
    command line has the port, or a service for another machine than `machine`, LinkError when it cannot be started.
    """
    answer: Future[Launched] = Future()

    def work() -> None:
        time.sleep(YIELD_S)
        try:
            path, process = _launched(port, baud, folder or session_folder(), machine)
        except CNCStepperError as error:
            answer.set_exception(error)
            return
        except Exception as error:  # the disk is full or the folder is missing: the window reports it
            what = Text("the connection service cannot be started: {error}", error=error)
            answer.set_exception(LinkError("service-start", what, advice="try again"))
            return
        answer.set_result((path, process))
        if process:
            process.wait()  # so that nothing is left of it when it has ended

    threading.Thread(target=work, name="launch-service", daemon=True).start()
    return answer


def _launched(port: str, baud: int, folder: Path, machine: str) -> Launched:
    driven = machine if machine and has_no_controller(machine) else ""
    if there := service_at(port, folder):
        if machine:
            _check_machine(there, port, machine, driven)
        return there, None
    check_no_job(port, folder)
    path = new_session(folder, SERVICE)
    return path, start(find_python(), WORKER, path, port, str(baud), driven)


def _check_machine(file: Path, port: str, machine: str, driven: str) -> None:
    """Raise MachineRefusal where the service of a file drives another machine than is asked for.

    driven: the machine, or "" where it has a controller of its own.
    """
    try:
        there = str((read_private(file) or {}).get("machine", ""))
    except (OSError, ValueError):  # its process writes it again; a client that attaches waits for that
        return
    if driven != there:
        raise MachineRefusal(
            "port-machine",
            Text(
                "{port} is connected as {there}, not as {machine}",
                port=port,
                there=there or "a controller with a firmware of its own",
                machine=machine,
            ),
            advice=Text("cncstepper disconnect --port {port}, then connect again", port=port),
        )


__all__ = ["ConnectionClient", "running_services"]

START_LIMIT_S = 30.0
JOG_RENEW_S = 0.1  # how often `jog_on` wants to be called; the service stops after 0.3 s without it
JOG_FEED_MM_MIN = 1000.0


class ConnectionClient:
    """A client of one connection service; a running job does not depend on its clients.

    phase: "starting", "connecting", "connected" or "gone": then `error` says why, None when it was left.
    status: the last one heard. outcome: of the last job, None while one runs. Not for several threads.
    keep_s: how long the connection stays open after this client leaves; None leaves that to the other clients.
    """

    def __init__(
        self,
        port: str,
        launched: Future[Launched] | None = None,
        session_file: Path | None = None,
        keep_s: float | None = None,
    ):
        self.port = port
        self.keep_s = keep_s
        self.session_file = session_file
        self.phase = "starting"
        self.status = SenderStatus()
        self.outcome: Outcome | None = None
        self.error: CNCStepperError | None = None
        self._launched = launched
        self._begin_s = time.monotonic()  # of connecting
        self._process: subprocess.Popen | None = None
        self._socket: LineSocket | None = None
        self._token = ""
        self._caught_up = False
        self._press = secrets.token_hex(4)
        self._waiting: list[dict[str, Any]] = []  # asked before the service has let this client in
        self._told_phase = "starting"

    @classmethod
    def launch(
        cls,
        port: str,
        baud: int = BAUD,
        folder: Path | None = None,
        machine: str = "",
        keep_s: float | None = None,
    ) -> ConnectionClient:
        """Start a connection service for a port and return at once; attach to it if one runs there already.

        machine: its profile, by name or file; "" asks for none, and takes for granted that it has its own controller.
        """
        file = Path(machine)
        profile = str(file.resolve()) if machine and file.is_file() else machine  # one name for one profile
        return cls(port, launch(port, baud, folder, profile), keep_s=keep_s)

    @classmethod
    def attach(cls, session_file: Path) -> ConnectionClient:
        """Attach to a service of `running_services`; its phase is "gone" after the service's end."""
        client = cls("", session_file=session_file)
        client._read_address(session_file)
        return client

    @property
    def is_caught_up(self) -> bool:
        """Whether the service's present status has arrived since this client attached."""
        return self._caught_up

    @property
    def started_service(self) -> bool:
        """Whether the service was started for this client; it ends when its last client leaves, or is kept open."""
        return self._process is not None

    def poll(self) -> list[dict[str, Any]]:
        """Return what has happened since the last call, at once; to be called from a timer.

        Events: {"event": "status"}, {"event": "phase" | "message" | "warning" | "job", "text": ...},
        {"event": "refused", "text": ..., "command": ..., "error": CNCStepperError | None}, {"event": "outcome"};
        and {"event": "connection", "text": phase} when `phase` has changed. What the service had told before this
        client came is told too, and has "past" in it.
        """
        events: list[dict[str, Any]] = []
        if self._socket:
            events = self._receive(self._socket)
        elif self.phase == "starting":
            self._start()
        if self.phase != self._told_phase:
            self._told_phase = self.phase
            events.append({"event": "connection", "text": self.phase})
        return events

    def run(
        self, job_file: Path, zero_confirmed: bool, allow_differences: bool = False, by_line: bool | None = None
    ) -> None:
        """Let the job of a certificate's file, or of a `SendJob` as JSON, run; its port and consents do not count.

        by_line: whether it waits before each line; None: as the job says.
        """
        self.outcome = None
        consents = {"zero_confirmed": zero_confirmed, "allow_differences": allow_differences}
        self.ask("run", file=str(job_file), **consents, by_line=by_line)

    def by_line(self, on: bool) -> None:
        """Ask that the job that runs waits before each line, or does so no more."""
        self.ask("by_line", on=on)

    def send(self, job_file: Path, zero_confirmed: bool, allow_differences: bool) -> None:
        """Run a job as a separate sender would: homed first where the job requires it, from a restart if confirmed."""
        self.outcome = None
        self.ask("send", file=str(job_file), zero_confirmed=zero_confirmed, allow_differences=allow_differences)

    def hold(self) -> None:
        """Ask for a feed hold; a jog ends."""
        self.ask("hold")

    def resume(self, stand: int | None = None) -> None:
        """Request to resume after a hold, a pause of the program or a closed door.

        stand: the number in `SenderStatus` of the one that is meant; None: whichever there is.
        """
        self.ask("resume", stand=stand)

    def stop(self) -> None:
        """Ask to end the job or whatever moves: hold, standstill, reset. It is no emergency stop."""
        self.ask("stop")

    def jog(
        self, x_mm: float = 0.0, y_mm: float = 0.0, z_mm: float = 0.0, feed_mm_min: float = JOG_FEED_MM_MIN
    ) -> None:
        """Ask for one step of that way."""
        self.ask("jog", x_mm=x_mm, y_mm=y_mm, z_mm=z_mm, feed_mm_min=feed_mm_min)

    def jog_on(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, feed_mm_min: float = JOG_FEED_MM_MIN) -> None:
        """Jog in a direction for as long as a button is pressed: call it every JOG_RENEW_S, `jog_cancel` at release.

        The machine stops by itself when the calls stop; then the button must be pressed again.
        """
        self.ask("jog_on", x_mm=x, y_mm=y, z_mm=z, feed_mm_min=feed_mm_min, press=self._press)

    def jog_cancel(self) -> None:
        """Stop jogging now."""
        self._press = secrets.token_hex(4)
        self.ask("jog_cancel")

    def set_zero(self, axes: str = "XYZ") -> None:
        """Make this place the work zero of these axes, in the work system in force."""
        self.ask("set_zero", axes=axes)

    def home(self) -> None:
        """Let the machine find its own zero."""
        self.ask("home")

    def unlock(self) -> None:
        """Take the lock of an alarm away without homing."""
        self.ask("unlock")

    def type(self, text: str) -> None:
        """Send a typed line; its result is an event "answer", or a refusal."""
        self.ask("line", text=text)

    def override(self, kind: str, percent_step: int | str) -> None:
        """Change "feed" or "spindle" by 10, -10, 1, -1 percent, "rapid" to 100, 50, 25; "reset" brings 100 back."""
        self.ask("override", kind=kind, step=str(percent_step))

    def leave(self) -> None:
        """Detach for good: the service ends as soon as no job runs and nothing moves, or `keep_s` later."""
        if self._socket:
            self._socket.send({"token": self._token, "command": "leave"})
        self.detach()

    def detach(self) -> None:
        """Detach; the service keeps running, and ends by itself when no client returns."""
        if self._socket:
            self._socket.close()
            self._socket = None
        self.phase = self._told_phase = "gone"

    def ask(self, command: str, **values: Any) -> None:
        """Send a command of the service, or "status"; a refusal is an event "refused"."""
        request = {"command": command, **values}
        if self._socket and self._caught_up:
            self._socket.send({"token": self._token, **request})
        elif self.phase in ("starting", "connecting") and not command.startswith("jog"):
            self._waiting.append(request)

    # --- inside --------------------------------------------------------------------------------

    def _start(self) -> None:
        """Go one step nearer to a connection: the launch, then the file, then the socket."""
        if self._launched and self._launched.done():
            self._take_launch(self._launched)
        if self.session_file and self.phase == "starting":
            self._connect(self.session_file)
        if self.phase == "starting":
            self._check_attach_timeout()

    def _check_attach_timeout(self) -> None:
        """Give up a service that does not come up, or that lives and does not let this client in."""
        if self._caught_up or time.monotonic() - self._begin_s < START_LIMIT_S:
            return
        if self._socket:
            self._socket.close()
            self._socket = None
        if self.session_file and is_alive(self.session_file):
            self._end(silent(self.session_file))
        else:
            self._end(
                LinkError(
                    "service-start", "the connection service does not start", advice=Text("see {log}", log=self._log())
                )
            )

    def _take_launch(self, launched: Future[Launched]) -> None:
        self._launched = None
        try:
            self.session_file, self._process = launched.result()
        except CNCStepperError as error:
            self._end(error)

    def _connect(self, path: Path) -> None:
        if is_closed(path):
            self._end(closed(path))
            return
        if self._has_ended(path):  # another process may listen at its address now
            self._end(self._cause(path))
            return
        address = self._read_address(path)
        if address is None:
            return
        self.phase, self._caught_up = "connecting", False
        self._token = address.token
        self._socket = LineSocket(address)
        keep = {} if self.keep_s is None else {"keep_s": self.keep_s}
        self._socket.send({"token": self._token, "command": "attach"} | keep)

    def _read_address(self, path: Path) -> Address | None:
        """Return where the service listens, None while its file does not say so."""
        try:
            content = read_private(path) or {}
            address = Address.of(content)
        except (OSError, ValueError):  # not yet written, or damaged: a service that lives writes it again
            return None
        self.port = self.port or str(content.get("machine_port", ""))
        return address

    def _receive(self, line: LineSocket) -> list[dict[str, Any]]:
        try:
            events = [event for event in line.receive() if self._take(event)]
        except (ValueError, TypeError, KeyError, RecursionError):
            line.close()
            self._socket = None
            self._end(garbled(self.session_file or Path()))
            return []
        if line.closed:
            self._lost()
        else:
            self._check_attach_timeout()
        return events

    def _take(self, event: dict[str, Any]) -> bool:
        """Process one event; return whether the window shows it."""
        kind = event["event"]
        if not self._caught_up:
            event["past"] = True
        if kind == "status":
            self._catch_up()
            self.status = SenderStatus.from_json(event["status"])
            self.phase = "connecting" if self.status.phase == "connecting" else "connected"
        elif kind == "job":
            self.outcome = None
        elif kind == "outcome":
            self.outcome = Outcome.from_json(event["outcome"])
        elif kind == "refused":
            take_refusal(event)
        return kind != "accepted"

    def _catch_up(self) -> None:
        """Ask at last what was asked before the service has let this client in: from now on it drops it no more."""
        if self._caught_up or not self._socket:
            return
        self._caught_up = True
        for request in self._waiting:
            self._socket.send({"token": self._token, **request})
        self._waiting.clear()

    def _lost(self) -> None:
        """The connection is over: the service has ended, or it had no room for one more that it did not know."""
        self._socket = None
        path = self.session_file
        assert path
        if self._has_ended(path):
            self._end(self._cause(path))
            return
        self.phase = "starting"
        if self._caught_up:
            self._caught_up, self._begin_s = False, time.monotonic()

    def _has_ended(self, path: Path) -> bool:
        runs = self._process.poll() is None if self._process else is_alive(path)
        return not runs or path.with_suffix(OUTCOME).is_file()

    def _cause(self, path: Path) -> CNCStepperError | None:
        """Return why the service has ended; one that left no word was killed."""
        try:
            content = read_private(path.with_suffix(OUTCOME))
            if content is not None:
                return error_from_json(content["error"]) if content["error"] else None
        except (OSError, ValueError, KeyError) as error:
            return unreadable(path, str(error))
        return LinkError(
            "service-lost",
            Text("the connection service of {port} is not there, or was killed", port=self.port),
            advice=Text(
                "if it was cutting, the position is unknown: look at the machine, then see {log}", log=self._log()
            ),
        )

    def _end(self, error: CNCStepperError | None) -> None:
        self.phase, self.error = "gone", error
        self._launched = None

    def _log(self) -> str:
        return str(self.session_file.with_suffix(LOG)) if self.session_file else "the session's log"
