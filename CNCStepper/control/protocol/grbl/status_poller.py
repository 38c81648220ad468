# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks the controller for its state in time, and notices when an answer is overdue."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.errors import LinkError, Place, Text

ANSWER_MISSING = "answer-missing"
ASK_AGAIN_S = 1.0  # a `?` may have been lost
DAMAGED_S = 2.0  # in which only damaged reports came


class StatusPoller:
    """Polls one driver; `last_line_s` is when a line was last sent or answered, by the driver's clock."""

    def __init__(self, timing: Timing):
        self.last_line_s = float("-inf")
        self._timing = timing
        self._polled_s = float("-inf")

    def poll(self, driver: Grbl, every_s: float) -> float:
        """Ask `?` when the last one is `every_s` old; return the time until the next one, in s."""
        since_s = driver.clock() - self._polled_s
        if since_s >= (every_s if driver.question_age_s() is None else max(every_s, ASK_AGAIN_S)):
            driver.ask_status()
            self._polled_s, since_s = driver.clock(), 0.0
        return max(0.001, every_s - since_s)

    def idle(self, driver: Grbl, since_s: float) -> bool:
        """Return whether the machine was idle after the last line was sent or answered, and after `since_s`."""
        idle = driver.status is not None and driver.status.state == "Idle"
        return idle and driver.status_asked_s > max(self.last_line_s, since_s)

    def check(
        self, driver: Grbl, idle: bool, dwell_s: float = 0.0, place: Callable[[], Place | None] = lambda: None
    ) -> None:
        """Raise LinkError when a `?`, or a line while the machine is idle, has no answer, or only damaged ones.

        dwell_s: what the oldest line may take longer. place: asked for that of the program, for the error.
        """
        limit_s = self._timing.answer_s
        if driver.damaged_s() > DAMAGED_S:
            raise _damaged(place())
        if (driver.question_age_s() or 0.0) > limit_s:
            raise self._silence("the controller does not answer any more", place())
        if idle and driver.unanswered and driver.clock() - self.last_line_s > limit_s + dwell_s:
            text = driver.unanswered[0].text
            raise self._silence(Text("the controller is idle but has not answered '{text}'", text=text), place())

    def _silence(self, what: str, place: Place | None) -> LinkError:
        return LinkError(
            ANSWER_MISSING,
            what,
            limit=f"{self._timing.answer_s:g} s",
            advice="check cable, power and other programs on this port",
            place=place,
        )


def _damaged(place: Place | None) -> LinkError:
    return LinkError(
        "reports-damaged",
        "where the machine is cannot be seen: every report of the controller is damaged",
        limit=f"{DAMAGED_S:g} s",
        advice="check cable, grounding and baud rate, and that this program supports the firmware",
        place=place,
    )
