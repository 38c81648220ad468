# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits unsolicited lines: a damaged or hostile controller would keep the sender from its work."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.errors import LinkError, Text

LINES_PER_S = 50.0  # for good; controllers that report by themselves do so 20 times a second
MOST_LINES = 400  # at a time: what FluidNC says when it starts is a quarter of that
MOST_OF_AN_ANSWER = 10_000  # to a `$` command, which may list all settings


class FloodLimit:
    """Counts unsolicited lines; clock: in s."""

    def __init__(self, clock: Callable[[], float]):
        self._clock = clock
        self._lines = 0.0  # less what was due since
        self._counted_s = clock()

    def check(self, lines: int, is_asked: bool, name: str) -> None:
        """Count lines; raises LinkError where they are too many. is_asked: a `$` command is under way."""
        now_s = self._clock()
        self._lines = max(0.0, self._lines - LINES_PER_S * (now_s - self._counted_s)) + lines
        self._counted_s = now_s
        most = MOST_OF_AN_ANSWER if is_asked else MOST_LINES
        if self._lines <= most:
            return
        self._lines = 0.0
        raise LinkError(
            "link-flood",
            Text("{name} says more than anybody asked for", name=name),
            value=Text("more than {most} lines", most=most),
            limit=f"{LINES_PER_S:g} lines/s",
            advice="look at the baud rate, and at what reports the controller sends by itself",
        )
