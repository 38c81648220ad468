# SPDX-License-Identifier: LGPL-2.1-or-later
"""Session events while the operator is asked: printed at once, above the answer being typed.

One thread waits for the answer, as it can on every system; another one hears the session meanwhile, and only meanwhile.
"""

from __future__ import annotations

from collections.abc import Callable
from threading import Event, Thread
from types import TracebackType
from typing import Any

from CNCStepper.cli.job.pause_question import reminder
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.pause_id import WAITING
from CNCStepper.errors import CNCStepperError

LOOK_EVERY_S = 0.05


class SessionListener:
    """Used as a context while somebody is asked about a stand; raises in the end what ended the session's link.

    hear: gets every event but the statuses. tell: gets words.
    """

    def __init__(
        self,
        client: SessionClient,
        asked: SenderStatus,
        on_message: Callable[[dict[str, Any]], None],
        tell: Callable[[str], None],
    ):
        self._client, self._on_message, self._tell = client, on_message, tell
        self._told = (asked.stand, True)
        self._over = Event()
        self._error: CNCStepperError | None = None
        self._listener = Thread(target=self._listen, name="meanwhile", daemon=True)

    def __enter__(self) -> None:
        self._listener.start()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._over.set()
        self._listener.join()
        if self._error:
            raise self._error

    def _listen(self) -> None:
        try:
            while not self._over.is_set() and self._client.outcome is None:
                for event in self._client.poll(LOOK_EVERY_S):
                    self._take(event)
        except CNCStepperError as error:
            self._error = error
        if self._error or self._client.outcome:
            self._tell("\nThe job has ended. Press Enter to see how")

    def _take(self, event: dict[str, Any]) -> None:
        if event["event"] != "status":
            self._on_message(event)
            return
        status = SenderStatus.from_json(event["status"])
        stand = (status.stand, status.phase in WAITING)
        if stand != self._told:
            self._told = stand
            self._tell(f"\n{reminder(status, stand[1])}")
