# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves the tool of a session along its cut when the machine's own buttons request it."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.path_retract import STANDS
from CNCStepper.errors import CNCStepperError, LinkError, Text
from CNCStepper.recovery.retract.client import RetractClient

LOOK_EVERY_S = 0.1


class ButtonClient(threading.Thread):
    """A client of its own, until the session ends; tell: gets refusals, on this thread."""

    def __init__(self, session_file: Path, tell: Callable[[str], None]):
        super().__init__(name="leader", daemon=True)
        self._file = session_file
        self._tell = tell

    def run(self) -> None:
        """Look at what is wanted, and do it."""
        try:
            with SessionClient.attach(self._file) as client:
                while client.outcome is None:
                    self._look(client)
                    time.sleep(LOOK_EVERY_S)
        except LinkError as error:
            self._tell(Text("the machine's buttons lead nothing back any more: {error}", error=error))

    def _look(self, client: SessionClient) -> None:
        try:
            lead(client, client.status())
        except LinkError:
            raise
        except CNCStepperError as error:
            if client.outcome is None:
                self._tell(str(error))


def lead(client: SessionClient, status: SenderStatus) -> None:
    """Begin the way that a status wants; raises what the proof or the session refuses."""
    if status.phase not in STANDS or (status.wanted_back_mm is None and not status.wanted_rest):
        return
    back = RetractClient(client)
    held = back.held()
    back.go(held.rest() if status.wanted_back_mm is None else held.along(held.back_by(status.wanted_back_mm)))
