# SPDX-License-Identifier: LGPL-2.1-or-later
"""The id of each pause of a machine: it rejects stale resume commands.

held 1 ──resume 1──► running ──M0──► paused 2 ──resume 1──► refused: the client has not read of pause 2
"""

from __future__ import annotations

from CNCStepper.control.session.command import Command
from CNCStepper.control.session.job_phase import WAITING
from CNCStepper.errors import MachineRefusal


class PauseCounter:
    """Counts the pauses of one connection; `number` is the last id, read from any thread.

    What is shown with a number must be read after it: then a number is never newer than the words beside it.
    """

    def __init__(self) -> None:
        self.number = 0
        self._phase = ""

    def enter(self, phase: str) -> None:
        """Note the present phase; a pause that begins with it gets the next id."""
        begins = phase in WAITING and phase != self._phase
        self._phase = phase
        if begins:
            self.number += 1

    def check(self, command: Command) -> None:
        """Raise MachineRefusal for a command with a stale pause id; a command without an id fits any pause."""
        number = command.values.get("stand")
        if number is None or (number == self.number and self._phase in WAITING):
            return
        what = "this answer belongs to an earlier pause"
        raise MachineRefusal("stand-over", what, advice="check the state of the machine now, then answer again")
