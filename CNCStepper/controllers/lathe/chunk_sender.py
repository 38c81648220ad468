# SPDX-License-Identifier: LGPL-2.1-or-later
"""Automatic mode: lines of records wait here, and go out in "?"-ended chunks as the lathe works them off.

    lines ──► waiting ──chunk──► sent, not done ──► done
                         │       at most ahead_s and ahead_bytes of them: what is there cannot be taken back
                         `── G01X-10.F1.#G01Z-50.F1.#?

The lathe is reckoned to begin a record when it has its chunk and the records before it are done. A record that lasts
longer than ahead_s goes out shortly before the lathe comes to it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

from CNCStepper.controllers.lathe.outward_line import OutwardLine
from CNCStepper.controllers.lathe.records import Modes, Record
from CNCStepper.controllers.lathe.step_times import Steps
from CNCStepper.machine.lathe_link import LatheLink
from CNCStepper.toolpath import LINE

AUTOMATIC, CHUNK_END = b"Y", "?"
LEAD_S = 0.3  # before the lathe comes to its end, what follows goes out whatever it lasts
MOST_LINES = 15  # planned and not done, as grbl has them


@dataclass(frozen=True)
class _Sent:
    """A record that the lathe has: when it is reckoned to begin and to end, the modes before it."""

    record: Record
    size: int
    begin_s: float
    end_s: float
    before: Modes
    ends_line: bool


class Program:
    """The records of one program; modes: behind the last line that was taken.

    begun: automatic mode is on, for good. over: M02 has been sent. index_s: how long the lathe waits at most for its
    encoder before a run of G01, and before a chunk that opens with one.
    """

    def __init__(self, line: OutwardLine, link: LatheLink, modes: Modes, index_s: float = 0.0):
        self.begun = self.over = self.held = False
        self.modes = modes
        self._line, self._link, self._index_s = line, link, index_s
        self._waiting: deque[tuple[Record, bool]] = deque()  # with whether it ends its line
        self._sent: deque[_Sent] = deque()
        self._sent_modes = modes  # behind the last record that was sent
        self._end_s = 0.0  # when all that was sent is done

    # -- lines ---------------------------------------------------------------------------------------

    @property
    def queued_lines(self) -> int:
        """How many lines are not done, as the lathe is reckoned."""
        return sum(ends for _, ends in self._waiting) + sum(sent.ends_line for sent in self._sent)

    @property
    def has_room(self) -> bool:
        """Whether one more line may wait."""
        return self.queued_lines < MOST_LINES

    def add(self, records: Sequence[Record]) -> None:
        """Let the records of a line wait."""
        self._waiting.extend((record, record is records[-1]) for record in records)
        if records:
            self.modes = records[-1].modes

    @property
    def waits(self) -> bool:
        """Whether records wait that the lathe does not have."""
        return bool(self._waiting)

    @property
    def moving(self) -> bool:
        """Whether the lathe has records that are not done."""
        return bool(self._sent)

    def forget(self) -> None:
        """Discard the records that the lathe does not have; it cuts those that it has."""
        self._waiting.clear()
        self.modes = self._sent_modes
        self.held = False

    # -- time ----------------------------------------------------------------------------------------

    def advance(self, now_s: float) -> None:
        """Note finished records, and send due ones; raises LinkError where the port is lost."""
        while self._sent and self._sent[0].end_s <= now_s:
            self._sent.popleft()
        if not self.held:
            self._send_due(now_s)

    def left_s(self, now_s: float) -> float:
        """Return how long the lathe still works on what it has."""
        return max(0.0, self._end_s - now_s) if self._sent else 0.0

    def place_at(self, now_s: float) -> Steps:
        """Return the steps from the program's zero, reckoned."""
        if not self._sent:
            return self._sent_modes.place
        first = self._sent[0]
        if first.record.move is None or now_s <= first.begin_s:
            return first.before.place
        done = first.record.move.done(self._into(first, now_s))
        return first.before.place[0] + done[0], first.before.place[1] + done[1]

    def speed_mm_s(self, now_s: float, steps_per_mm: tuple[float, float]) -> float:
        """Return the speed along the path."""
        first = self._sent[0] if self._sent else None
        if first is None or first.record.move is None or now_s <= first.begin_s:
            return 0.0
        return first.record.move.speed_mm_s(self._into(first, now_s), steps_per_mm)

    @property
    def end_place(self) -> Steps:
        """The position of the lathe after all records that it has."""
        return self._sent_modes.place

    # -- inside --------------------------------------------------------------------------------------

    def _into(self, sent: _Sent, now_s: float) -> float:
        """Return how far into a record's own time the lathe is."""
        return (now_s - sent.begin_s) / (1.0 + self._link.slower)

    def _send_due(self, now_s: float) -> None:
        if not (due := self._due(now_s)):
            return
        if not self.begun:
            self.begun = True
            self._line.send(AUTOMATIC, now_s)
        texts = [due[0][0].opening, *(record.text for record, _ in due[1:])]
        there_s = self._line.send(f"{''.join(texts)}{CHUNK_END}".encode("ascii"), now_s)
        at_s, chunk_begun = max(there_s, self._end_s), False
        for text, (record, ends_line) in zip(texts, due, strict=True):
            at_s += self._waits_s(record, is_first=not chunk_begun)
            chunk_begun = True
            end_s = at_s + record.lasts_s * (1.0 + self._link.slower)
            self._sent.append(_Sent(record, len(text), at_s, end_s, self._sent_modes, ends_line))
            self._sent_modes, at_s = record.modes, end_s
            self.over = self.over or record.ends_program
            self._waiting.popleft()
        self._end_s = at_s

    def _waits_s(self, record: Record, is_first: bool) -> float:
        """Return how long the lathe waits for its encoder at most; is_first: of a chunk."""
        waits = record.begins_feed or (is_first and record.move is not None and record.modes.motion == LINE)
        return self._index_s if waits else 0.0

    def _due(self, now_s: float) -> list[tuple[Record, bool]]:
        """Return the records of the next chunk."""
        room = self._link.ahead_bytes - sum(sent.size + 1 for sent in self._sent) - len(CHUNK_END)
        ahead_s = self.left_s(now_s)
        due: list[tuple[Record, bool]] = []
        for record, ends_line in self._waiting:
            room -= len(record.text if due else record.opening)
            is_soon = ahead_s <= LEAD_S or ahead_s + record.lasts_s <= self._link.ahead_s
            if room < 0 or not is_soon:
                break
            due.append((record, ends_line))
            ahead_s += record.lasts_s * (1.0 + self._link.slower)
        return due
