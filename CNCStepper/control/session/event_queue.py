# SPDX-License-Identifier: LGPL-2.1-or-later
"""Events that wait for a client to read them: bounded in number and bytes, however little it reads.

Statuses: the latest alone, in the place of the one that it replaces. Texts of the machine ("message", "warning",
"console"): the newest, and how many were left out before them. All else ("phase", "outcome", "accepted" …) is not
displaced by texts: a controller that floods its messages hides neither a phase nor an answer.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Mapping
from typing import Any, NamedTuple

from CNCStepper import text_json
from CNCStepper.errors import Text
from CNCStepper.safe_text import printable

LIMIT_COUNT = 500  # of texts, and of all else
LIMIT_BYTES = 200_000  # the same
TEXTS = ("message", "warning", "console")
TEXT_LIMIT = 2000  # characters of one


class Entry(NamedTuple):
    """One event; number: by which entries of all kinds are in order. line: what `line_of` makes of it."""

    number: int
    kind: str
    line: bytes


def line_of(event: Mapping[str, Any]) -> bytes:
    """Return an event as a client reads it; a long text is cut."""
    if event["event"] in TEXTS and len(event["text"]) > TEXT_LIMIT:
        event = {**event, "text": printable(event["text"], TEXT_LIMIT)}
    return text_json.dumps(event).encode("ascii") + b"\n"


class Backlog:
    """A queue of events; what is added to a full one displaces the oldest of its kind. For one thread.

    left_out: how many were displaced and not reported yet.
    """

    def __init__(self) -> None:
        self.left_out = 0
        self._number = 0
        self._texts = _BoundedQueue()
        self._others = _BoundedQueue()
        self._status: Entry | None = None

    def __bool__(self) -> bool:
        return bool(self._texts.entries or self._others.entries or self._status or self.left_out)

    def add(self, kind: str, line: bytes) -> None:
        """Add an event of that kind, as `line_of` makes it."""
        self._number += 1
        if kind == "status":
            self._status = Entry(self._status.number if self._status else self._number, kind, line)
        else:
            queue = self._texts if kind in TEXTS else self._others
            self.left_out += queue.add(Entry(self._number, kind, line))

    def add_all(self, events: Backlog) -> None:
        """Add the events of another one, which keeps them; how many were left out there does not count."""
        for entry in sorted(filter(None, (*events._texts.entries, *events._others.entries, events._status))):
            self.add(entry.kind, entry.line)

    def take(self, least_bytes: int) -> bytes:
        """Return the oldest lines, removed from here: so many bytes and the rest of a line, or all there are."""
        lines, size = [], 0
        if self.left_out:
            what = Text("{left_out} messages were left out: more came than could be read", left_out=self.left_out)
            lines.append(line_of({"event": "warning", "text": what}))
            self.left_out = 0
        while size < least_bytes and (entry := self._oldest()):
            lines.append(entry.line)
            size += len(entry.line)
        return b"".join(lines)

    def _oldest(self) -> Entry | None:
        """Return the oldest entry, removed from here; None for none."""
        queues = [queue for queue in (self._texts, self._others) if queue.entries]
        queue = min(queues, key=lambda queue: queue.entries[0].number, default=None)
        if self._status and (queue is None or self._status.number < queue.entries[0].number):
            status, self._status = self._status, None
            return status
        return queue.remove() if queue else None


class _BoundedQueue:
    """Entries of one kind and the bytes of their lines."""

    def __init__(self) -> None:
        self.entries: deque[Entry] = deque()
        self._bytes = 0

    def add(self, entry: Entry) -> int:
        """Add an entry; return how many of the oldest had to go for it."""
        self.entries.append(entry)
        self._bytes += len(entry.line)
        gone = 0
        while len(self.entries) > LIMIT_COUNT or (self._bytes > LIMIT_BYTES and len(self.entries) > 1):
            self.remove()
            gone += 1
        return gone

    def remove(self) -> Entry:
        """Remove the oldest entry and return it."""
        entry = self.entries.popleft()
        self._bytes -= len(entry.line)
        return entry


class EventQueue:
    """Events on their way from the thread where they happen to the one that serves clients; never waits for either.

    What comes faster than it is served displaces its elders, as in a `Backlog`.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()  # held for the time of an append
        self._waiting = Backlog()

    def put(self, event: Mapping[str, Any]) -> None:
        """Leave an event, from any thread."""
        line = line_of(event)
        with self._lock:
            self._waiting.add(event["event"], line)

    def take(self) -> Backlog:
        """Return what has been left since the last call."""
        with self._lock:
            taken, self._waiting = self._waiting, Backlog()
        return taken
