# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pending requests to the retract client, shown in the sender's status: a sender knows no geometry.

a button `back`, or resume after a way back ──► wanted ──► a client asks for the place: taken
                                                     `───► the machine stands, nobody has come: refused
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.control.session.command import Command
from CNCStepper.control.session.job_phase import Phase
from CNCStepper.errors import CNCStepperError, MachineRefusal

LAPSE_S = 5.0  # at standstill: later, a motion would surprise


class PendingRequests:
    """The requests of one job; back_mm and rest may be read from any thread.

    back_mm: so far back, None for nowhere. rest: cut from here to the end. refuse(command, error): hears of what nobody
    has taken up.
    """

    def __init__(self, clock: Callable[[], float], refuse: Callable[[Command, CNCStepperError], None]):
        self.back_mm: float | None = None
        self.rest = False
        self._clock = clock
        self._refuse = refuse
        self._since_s: float | None = None  # the machine was at rest, with a request
        self._last = Command("resume")

    def request_retract(self, command: Command) -> None:
        """Want to go back, farther with each time."""
        before_mm = self.back_mm or 0.0
        self.take()
        self.back_mm, self._last = before_mm + command.values["distance_mm"], command

    def request_resume(self, command: Command) -> None:
        """Request to resume from here."""
        self.take()
        self.rest, self._last = True, command

    def take(self) -> None:
        """Clear the requests: a client carries them out."""
        self.back_mm, self.rest, self._since_s = None, False, None

    def turn(self, stands: bool) -> None:
        """Refuse requests that no client has taken within LAPSE_S of the machine's stop."""
        if not stands or (self.back_mm is None and not self.rest):
            self._since_s = None
        elif self._since_s is None:
            self._since_s = self._clock()
        elif self._clock() - self._since_s > LAPSE_S:
            self.take()
            self._refuse(self._last, _nobody())


def _nobody() -> MachineRefusal:
    return MachineRefusal(
        Phase.RETREATED,
        "the lines of a retract are not at the controller",
        advice="go back with `cncstepper back`, and on with `cncstepper back --resume`",
    )
