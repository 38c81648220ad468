# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands to a sender or a connection service, queued from the loopback for the thread of the link."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from queue import SimpleQueue
from typing import Any

from CNCStepper.control.transport.link import Link
from CNCStepper.errors import Text

STOPS = ("stop", "end")
_NUMBER = (int, float)
_STAND = (int, type(None))  # the number of the stand that is answered to; None: whichever there is
_WAY = {"x_mm": _NUMBER, "y_mm": _NUMBER, "z_mm": _NUMBER, "feed_mm_min": _NUMBER}

_BY_LINE = (bool, type(None))  # None: as the job says
_JOB = {"file": str, "zero_confirmed": bool, "allow_differences": bool, "by_line": _BY_LINE}
JOB_COMMANDS = (
    "hold",
    "resume",
    "stop",
    "by_line",
    "jog",
    "jog_on",
    "jog_cancel",
    "set_zero",
    "tell_place",
    "retrace",
    "override",
)
VALUES: dict[str, dict[str, Any]] = {  # of each command: its values and their types
    "hold": {},
    "resume": {"stand": _STAND},
    "stop": {},
    "by_line": {"on": bool},
    "tell_place": {"file": str},
    "retrace": {"file": str},
    "run": _JOB,
    "send": _JOB,  # the same from a command line
    "disconnect": {},
    "jog": _WAY,
    "jog_on": _WAY | {"press": str},
    "jog_cancel": {},
    "set_zero": {"axes": str},
    "home": {},
    "unlock": {},
    "line": {"text": str},
    "override": {"kind": str, "step": str},
    "end": {},
}


@dataclass(frozen=True)
class Command:
    """A request; asked_s: when it arrived, by the clock of its `Inbox`."""

    name: str
    values: Mapping[str, Any] = field(default_factory=dict)
    asked_s: float = 0.0


def read_command(request: Mapping[str, Any], known: tuple[str, ...]) -> Command:
    """Return the command of a client's request; raises ValueError with words when it is none of `known`."""
    name = str(request.get("command", ""))
    if name not in known:
        raise ValueError(Text("there is no command '{name}'", name=name[:40]))
    return Command(name, {key: _value(request.get(key), kind, key) for key, kind in VALUES[name].items()})


def _value(value: Any, kind: Any, key: str) -> Any:
    kinds = kind if isinstance(kind, tuple) else (kind,)
    if not isinstance(value, kinds) or (isinstance(value, bool) and bool not in kinds) or not _is_number(value):
        raise ValueError(Text("'{key}' cannot be {value!r}", key=key, value=str(value)[:40]))
    return value


def _is_number(value: Any) -> bool:
    """Return False for a number that is none, or too large to compute with; True for all that is no number."""
    try:
        return not (isinstance(value, _NUMBER) and math.isnan(value))
    except OverflowError:
        return False


class Inbox:
    """Takes commands from any thread or signal handler and wakes up the thread that waits on `link`."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.link: Link | None = None
        self._clock = clock
        self.wants_stop = False  # whether one of those that wait ends all work
        self._commands: SimpleQueue[Command] = SimpleQueue()

    def put(self, command: Command) -> None:
        """Leave a command; it is taken within the link's next turn."""
        if command.name in STOPS:  # before it can be taken
            self.wants_stop = True
        self._commands.put(replace(command, asked_s=self._clock()))
        if self.link:
            self.link.wake()

    def take(self) -> Iterator[Command]:
        """Yield the commands that wait, oldest first."""
        while not self._commands.empty():
            command = self._commands.get()
            if command.name in STOPS:
                self.wants_stop = False
            yield command
