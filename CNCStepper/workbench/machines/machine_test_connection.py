# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine during a test: lines sent one by one over the connection that the dock has, and what it reports.

The test is a client of its own of the same connection service, so it takes no event away from the dock.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide import QtCore

from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.workbench.dock.connection import error_text
from CNCStepper.workbench.dock.window import link_here
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded, polled
from CNCStepper.workbench.services.translation import later, tr

POLL_MS = 50
NOT_CONNECTED = later("Connect to the machine first, in the controller's panel.")
BUSY = later("The test is under way: wait, or stop it.")
NOT_IDLE = later("The machine must be idle: wait, or home or unlock it first.")
Done = Callable[[str], None]


class Bench(QtCore.QObject):
    """`changed` is sent after every report; `trouble` is the machine's last refusal, or "".

    answered: the lines of this run that were answered with `ok`, each with what the controller said to it.
    """

    changed = QtCore.Signal()

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.trouble = ""
        self.answered: list[tuple[str, list[str]]] = []
        self._client: ConnectionClient | None = None
        self._lines: list[str] = []
        self._words: list[str] = []
        self._done: Done | None = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(polled(self._tick))

    @property
    def status(self) -> SenderStatus | None:
        """The last status, None while nothing is connected."""
        client = self._client
        return client.status if client and client.phase == "connected" else None

    @property
    def is_busy(self) -> bool:
        """Whether lines are under way."""
        return bool(self._lines)

    def why_not(self, locked: bool = False) -> str:
        """Return why no test can begin now, "" when one can; in English, for `tr`.

        locked: a machine that is locked by an alarm will do, since it is only asked, or a setting is written.
        """
        status = self.status
        if status is None:
            return NOT_CONNECTED
        if self._lines:
            return BUSY
        return "" if status.phase == "idle" or (locked and status.phase == "alarm") else NOT_IDLE

    def watch(self, on: bool) -> None:
        """Follow the machine while the test is seen; else let it go."""
        if on:
            self._timer.start()
        else:
            self._timer.stop()
            self._let_go()

    def run(self, lines: Sequence[str], done: Done | None = None, locked: bool = False) -> None:
        """Send lines, each when the machine stands; `done` gets the words of the last answer's question, if any.

        After a refusal nothing more is sent, and `done` is not called. locked: as in `why_not`.
        """
        if self.why_not(locked) or not lines:
            return
        self.trouble, self._lines, self._done, self.answered = "", list(lines), done, []
        self._send()

    def stop(self) -> None:
        """Brake, and send nothing more."""
        self._lines, self._done = [], None
        if self._client:
            self._client.stop()
        self.changed.emit()

    # --- inside ----------------------------------------------------------------------------------

    def _tick(self) -> None:
        link = link_here()
        wanted = link.client.session_file if link and link.client and link.moment.connected else None
        if self._client and (wanted is None or self._client.session_file != wanted):
            self._let_go()
        if self._client is None and wanted is not None:
            self._client = ConnectionClient.attach(wanted)
        events = [event for event in self._client.poll() if not event.get("past")] if self._client else []
        for event in events:
            self._take(event)
        if events:
            self.changed.emit()

    def _take(self, event: dict[str, Any]) -> None:
        if not self._lines:
            return
        if event["event"] == "console":
            self._words.append(event["text"])
        elif event["event"] == "refused":
            self._end(error_text(event["error"]) if event.get("error") else translated(event["text"]))
        elif event["event"] == "answer" and event["text"] != "ok":
            self._end(translated(event["text"]))
        elif event["event"] == "answer":
            self.answered.append((self._lines.pop(0), self._words))
            self._send()

    def _send(self) -> None:
        if self._lines and self._client:
            self._words = []
            self._client.type(self._lines[0])
            return
        done, self._done = self._done, None
        self.changed.emit()
        if done:
            guarded(done)(next((words for words in self._words if words.startswith("[")), ""))

    def _end(self, trouble: str) -> None:
        self._lines, self._done, self.trouble = [], None, trouble

    def _let_go(self) -> None:
        if self._lines:
            self._end(tr("The connection was lost during the test."))
        if self._client:
            self._client.detach()
        self._client = None
        self.changed.emit()
