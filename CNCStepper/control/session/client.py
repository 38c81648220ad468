# SPDX-License-Identifier: LGPL-2.1-or-later
"""A client of a sender's process: start a session or attach to one, watch it, hold, resume, stop it."""

from __future__ import annotations

import json
import select
import socket
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper import text_json
from CNCStepper.control.processes.process_file import is_alive, is_closed
from CNCStepper.control.processes.python_finder import find_python
from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.session.detached_process import start
from CNCStepper.control.session.files import LOG, OUTCOME, WIRE, new_session, read_private
from CNCStepper.control.session.local_socket import Address, close_in_order
from CNCStepper.control.session.status import Outcome, SenderStatus, take_refusal
from CNCStepper.control.session.unreachable import GARBLED, closed, garbled, lost, silent, unreadable
from CNCStepper.errors import LinkError, Text

WORKER = "CNCStepper.workers.sender"
START_LIMIT_S = 30.0
READ_BYTES = 65_536
ANSWER_LIMIT_S = 10.0
WELCOME_LIMIT_S = 3.0  # from a connection to the first word on it; where it is not let in, it tries again
CLOSE_LIMIT_S = 1.0  # for the session to have read what was asked last
LOOK_EVERY_S = 0.02


class SessionClient:
    """One client; clients may detach and attach at any time while the job runs.

    outcome: None while the session runs. session_file: what `attach` takes. Not for several threads.
    """

    def __init__(self, session_file: Path, process: subprocess.Popen | None = None):
        self.session_file = session_file
        self.outcome: Outcome | None = None
        self._process = process
        self._connection: socket.socket | None = None
        self._token = ""
        self._tail = bytearray()
        self._early: list[dict[str, Any]] = []  # events that came with the welcome
        self._status: SenderStatus | None = None

    @classmethod
    def start(cls, job: SendJob, *, python: str | None = None, folder: Path | None = None) -> SessionClient:
        """Start a process for `job` and attach to it; it may be over already, see `outcome`.

        Raises MissingPackage when no Python can run it, LinkError when it does not come up.
        """
        path = new_session(folder)
        write_job(path.with_suffix(WIRE), job)
        client = cls(path, start(python or find_python(), WORKER, path))
        client._await_start()
        client._connect()
        return client

    @classmethod
    def attach(cls, session_file: Path) -> SessionClient:
        """Attach to a running session, or to the outcome of one.

        Raises LinkError: "session-lost" when there is none, "session-silent" when its process does not answer,
        "session-closed" when its file is not this user's to open.
        """
        client = cls(Path(session_file))
        client._connect()
        return client

    def status(self) -> SenderStatus:
        """Return the session's present status; after its end, the last one."""
        self._status = None
        self._send("status")
        end_s = time.monotonic() + ANSWER_LIMIT_S
        while self._status is None:
            self.poll(LOOK_EVERY_S)
            if time.monotonic() > end_s:
                raise silent(self.session_file)
        return self._status

    def hold(self) -> None:
        """Ask for a feed hold."""
        self._send("hold")

    def resume(self, stand: int | None = None) -> None:
        """Resume from the pause with that id in `SenderStatus`; None: from any."""
        self._send("resume", stand=stand)

    def stop(self) -> None:
        """Ask to end the job safely."""
        self._send("stop")

    def ask(self, command: str, **values: Any) -> None:
        """Send any command to the session; a refusal comes as an event "refused" with its error."""
        self._send(command, **values)

    def poll(self, wait_s: float = 0.0) -> list[dict[str, Any]]:
        """Return the events that came, waiting up to `wait_s` for the first; [] also after the end."""
        if self._early:
            early, self._early = self._early, []
            return early
        if self._connection is None or not select.select([self._connection], [], [], wait_s)[0]:
            return []
        events = self._receive(self._connection)
        if events is None:
            self._ended()
            return self.poll()
        return events

    def wait(
        self,
        on_status: Callable[[SenderStatus], None] = lambda status: None,
        on_event: Callable[[str, str], None] = lambda kind, text: None,
        limit_s: float = float("inf"),
    ) -> Outcome:
        """Wait for the session's end and return its outcome; raises LinkError after `limit_s`.

        on_event(kind, text): "phase", "message" and "warning". An interrupt leaves the session running.
        """
        end_s = time.monotonic() + limit_s
        while self.outcome is None:
            for event in self.poll(LOOK_EVERY_S):
                if event["event"] == "status" and self._status:
                    on_status(self._status)
                elif "text" in event:
                    on_event(event["event"], event["text"])
            if time.monotonic() > end_s:
                raise LinkError("session-runs", "the session still runs", advice="wait longer, hold or stop it")
        on_status(self.outcome.status)
        self._reap()
        return self.outcome

    def close(self) -> None:
        """Detach; earlier commands still arrive, and the session keeps running."""
        self._early = []
        if self._connection:
            self._connection.settimeout(CLOSE_LIMIT_S)
            close_in_order(self._connection)
            self._connection = None

    def __enter__(self) -> SessionClient:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    # --- inside --------------------------------------------------------------------------------

    def _await_start(self) -> None:
        assert self._process
        end_s = time.monotonic() + START_LIMIT_S
        while not is_alive(self.session_file) and not self._outcome_file().exists():
            if self._process.poll() is not None and not self._outcome_file().exists():
                raise LinkError(
                    "sender-start", "the sender's process ended at once", advice=Text("see {log}", log=self._log())
                )
            if time.monotonic() > end_s:
                self._process.terminate()
                raise LinkError(
                    "sender-start", "the sender's process does not start", advice=Text("see {log}", log=self._log())
                )
            time.sleep(LOOK_EVERY_S)

    def _connect(self) -> None:
        """Attach, or take the outcome of a session that has ended; tries again while its process lives."""
        end_s = time.monotonic() + ANSWER_LIMIT_S
        why = ""
        while self.outcome is None and self._connection is None:
            is_over = not is_alive(self.session_file)  # checked first: the outcome is written before the end
            if is_closed(self.session_file):
                raise closed(self.session_file)
            if self._has_outcome(is_over):
                return
            if is_over:
                raise lost(self.session_file)
            if time.monotonic() > end_s:
                raise silent(self.session_file, why)
            try:
                self._welcome(self._address())
            except (OSError, ValueError) as error:
                self.close()
                if getattr(error, "code", "") == GARBLED:
                    raise
                why = str(error)
                time.sleep(LOOK_EVERY_S)

    def _address(self) -> Address:
        content = read_private(self.session_file)
        if content is None:
            raise FileNotFoundError("it removed its file")
        return Address.of(content)

    def _welcome(self, address: Address) -> None:
        """Connect and show the token; raises OSError where the session does not answer."""
        self._token, self._tail = address.token, bytearray()
        self._connection = connection = address.connect(WELCOME_LIMIT_S)
        connection.settimeout(ANSWER_LIMIT_S)
        self._write(connection, json.dumps({"token": self._token, "command": "attach"}))
        end_s = time.monotonic() + WELCOME_LIMIT_S
        while not self._early:
            if not select.select([connection], [], [], max(0.0, end_s - time.monotonic()))[0]:
                raise TimeoutError("it does not answer")
            events = self._receive(connection)
            if events is None:
                raise ConnectionError("it closed the connection")
            self._early = events

    def _receive(self, connection: socket.socket) -> list[dict[str, Any]] | None:
        """Return the events that have come, None at the connection's end."""
        try:
            data = connection.recv(READ_BYTES)
        except OSError:
            return None
        self._tail += data
        *lines, self._tail = self._tail.split(b"\n")
        try:
            events = [text_json.loads(line) for line in lines]
            for event in events:
                self._take(event)
        except (ValueError, TypeError, KeyError, RecursionError) as error:
            raise garbled(self.session_file) from error
        return events if data or events else None

    def _send(self, command: str, **values: Any) -> None:
        if self.outcome is not None:
            self._status = self.outcome.status
        elif self._connection is None:
            raise LinkError("session-detached", "this client is detached", advice="attach to the session again")
        else:
            text = json.dumps({"token": self._token, "command": command, **values})
            try:
                self._write(self._connection, text)
            except OSError:
                self._ended()
                self._send_again(text)

    def _send_again(self, text: str) -> None:
        """Ask on the new connection, unless the session is over."""
        try:
            if self._connection:
                self._write(self._connection, text)
        except OSError as error:
            raise silent(self.session_file, str(error)) from error

    def _write(self, connection: socket.socket, text: str) -> None:
        connection.sendall(text.encode("ascii") + b"\n")

    def _take(self, event: dict[str, Any]) -> None:
        if event["event"] == "status":
            self._status = SenderStatus.from_json(event["status"])
        elif event["event"] == "outcome":
            self.outcome = Outcome.from_json(event["outcome"])
            self._status = self.outcome.status
        elif event["event"] == "refused" and "command" not in event:
            raise LinkError(
                "session-refused", Text("the session refused {text}", text=event["text"]), advice="attach to it again"
            )
        elif event["event"] == "refused":
            take_refusal(event)

    def _ended(self) -> None:
        """The connection is over: take the outcome, or attach again; raises LinkError when neither can be."""
        self.close()
        self._connect()

    def _has_outcome(self, is_over: bool) -> bool:
        """Take the outcome where it is written; one that cannot be read counts only where the session is over."""
        try:
            content = read_private(self._outcome_file())
            found = Outcome.from_json(content) if content is not None else None
        except (OSError, ValueError) as error:
            if is_over:
                raise unreadable(self.session_file, str(error)) from error
            return False
        if found is None:
            return False
        self.outcome = self.outcome or found
        self._status = self.outcome.status
        return True

    def _reap(self) -> None:
        """Let the process that we started go; it ends right after its outcome."""
        self.close()
        if self._process:
            self._process.wait(ANSWER_LIMIT_S)

    def _outcome_file(self) -> Path:
        return self.session_file.with_suffix(OUTCOME)

    def _log(self) -> str:
        return str(self.session_file.with_suffix(LOG))
