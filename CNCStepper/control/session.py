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

from CNCStepper.control.outcome import Outcome, SenderStatus, take_refusal
from CNCStepper.control.own_process import start
from CNCStepper.control.python_finder import find_python
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.session_file import LOG, OUTCOME, WIRE, new_session, read_private
from CNCStepper.control.spool import write_spool
from CNCStepper.errors import LinkError

WORKER = "CNCStepper.control.worker"
START_LIMIT_S = 30.0
ANSWER_LIMIT_S = 10.0
LOOK_EVERY_S = 0.02


class SessionClient:
    """One client; it may close and another attach at any time, the cut goes on.

    outcome: None while the session runs. session_file: what `attach` takes. Not for several threads.
    """

    def __init__(self, session_file: Path, process: subprocess.Popen | None = None):
        self.session_file = session_file
        self.outcome: Outcome | None = None
        self._process = process
        self._connection: socket.socket | None = None
        self._token = ""
        self._tail = b""
        self._status: SenderStatus | None = None

    @classmethod
    def start(cls, job: SendJob, *, python: str | None = None, folder: Path | None = None) -> SessionClient:
        """Start a process for `job` and attach to it; it may be over already, see `outcome`.

        Raises MissingPackage when no Python can run it, LinkError when it does not come up.
        """
        path = new_session(folder)
        told = write_spool(path.with_suffix(WIRE), job).to_json().encode("utf-8")
        client = cls(path, start(python or find_python(), WORKER, path, told=told))
        client._await_start()
        client._connect()
        return client

    @classmethod
    def attach(cls, session_file: Path) -> SessionClient:
        """Attach to a running session, or to the outcome of one; raises LinkError when there is none."""
        client = cls(Path(session_file))
        client._connect()
        return client

    def status(self) -> SenderStatus:
        """Return this moment of the session; after its end, the last one."""
        self._status = None
        self._send("status")
        end_s = time.monotonic() + ANSWER_LIMIT_S
        while self._status is None:
            self.poll(LOOK_EVERY_S)
            if time.monotonic() > end_s:
                raise LinkError("sender-silent", "the sender's process does not answer", advice="see " + self._log())
        return self._status

    def hold(self) -> None:
        """Ask for a feed hold."""
        self._send("hold")

    def resume(self, stand: int | None = None) -> None:
        """Ask to go on from the stand of that number in `SenderStatus`; None: from whichever there is."""
        self._send("resume", stand=stand)

    def stop(self) -> None:
        """Ask to end the job safely."""
        self._send("stop")

    def ask(self, command: str, **values: Any) -> None:
        """Ask for any command of the session; what is refused comes as an event "refused" with its error."""
        self._send(command, **values)

    def poll(self, wait_s: float = 0.0) -> list[dict[str, Any]]:
        """Return the events that came, waiting up to `wait_s` for the first; [] also after the end."""
        if self._connection is None or not select.select([self._connection], [], [], wait_s)[0]:
            return []
        try:
            data = self._connection.recv(65_536)
        except ConnectionError:
            data = b""
        *lines, self._tail = (self._tail + data).split(b"\n")
        events = [json.loads(line) for line in lines]
        for event in events:
            self._take(event)
        if not data:
            self._ended()
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
        """Detach; the session goes on."""
        if self._connection:
            self._connection.close()
            self._connection = None

    def __enter__(self) -> SessionClient:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    # --- inside --------------------------------------------------------------------------------

    def _await_start(self) -> None:
        assert self._process
        end_s = time.monotonic() + START_LIMIT_S
        while not self.session_file.exists() and not self._outcome_file().exists():
            if self._process.poll() is not None and not self._outcome_file().exists():
                raise LinkError("sender-start", "the sender's process ended at once", advice="see " + self._log())
            if time.monotonic() > end_s:
                self._process.terminate()
                raise LinkError("sender-start", "the sender's process does not come up", advice="see " + self._log())
            time.sleep(LOOK_EVERY_S)

    def _connect(self) -> None:
        address = read_private(self.session_file)
        if address is None:
            self._ended()
            return
        self._token = address["token"]
        try:
            self._connection = socket.create_connection((address["host"], address["port"]), ANSWER_LIMIT_S)
        except OSError:
            self._ended()
            return
        self._connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._send("attach")

    def _send(self, command: str, **values: Any) -> None:
        if self.outcome is not None:
            self._status = self.outcome.status
        elif self._connection is None:
            raise LinkError("session-detached", "this client is detached", advice="attach to the session again")
        else:
            self._write(self._connection, json.dumps({"token": self._token, "command": command, **values}))

    def _write(self, connection: socket.socket, text: str) -> None:
        try:
            connection.sendall(text.encode("ascii") + b"\n")
        except OSError:
            self._ended()

    def _take(self, event: dict[str, Any]) -> None:
        if event["event"] == "status":
            self._status = SenderStatus.from_json(event["status"])
        elif event["event"] == "outcome":
            self.outcome = Outcome.from_json(event["outcome"])
            self._status = self.outcome.status
        elif event["event"] == "refused" and "command" not in event:
            raise LinkError("session-refused", f"the session refused {event['text']}", advice="attach to it again")
        elif event["event"] == "refused":
            take_refusal(event)

    def _ended(self) -> None:
        """The connection is over: take the outcome, which was written before; raises LinkError when it was not."""
        self.close()
        content = read_private(self._outcome_file())
        if content is None:
            self.session_file.unlink(missing_ok=True)
            raise LinkError(
                "session-lost",
                f"the session {self.session_file.stem} is not there, or was killed",
                advice="if it was cutting, the position is unknown: look at the machine, then see " + self._log(),
            )
        self.outcome = self.outcome or Outcome.from_json(content)
        self._status = self.outcome.status

    def _reap(self) -> None:
        """Let the process that we started go; it ends right after its outcome."""
        self.close()
        if self._process:
            self._process.wait(ANSWER_LIMIT_S)

    def _outcome_file(self) -> Path:
        return self.session_file.with_suffix(OUTCOME)

    def _log(self) -> str:
        return str(self.session_file.with_suffix(LOG))
