# SPDX-License-Identifier: LGPL-2.1-or-later
"""One way of the wire under faults: bytes that are lost, come twice, come changed or come late.

Faults of a controller's answers: answers withheld, messages that flood the link.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from random import Random

from CNCStepper.virtual.faults.plan import Fault


class FaultyDirection:
    """The faults of one way; `passed` counts the bytes that came to it.

    fired: told of a fault as it begins. damaged: bytes that did not arrive as they were sent.
    """

    def __init__(self, faults: list[Fault], random: Random, fired: Callable[[Fault], None]):
        self.passed = 0
        self.damaged = 0
        self._faults = faults
        self._random = random
        self._fired = fired
        self._acting: dict[Fault, int] = {}  # how many bytes each has still to hit
        self._held: deque[tuple[float, bytes]] = deque()  # the moment of release, in s
        self._held_until_s = 0.0

    @property
    def holds(self) -> int:
        """How many bytes are delayed now."""
        return sum(len(data) for _, data in self._held)

    def take(self, data: bytes, now_s: float) -> None:
        """Let bytes come to the way."""
        passed = bytearray()
        for byte in data:
            self._begin(now_s)
            passed += self._changed(byte)
            self.passed += 1
        if passed:
            self._held.append((max(now_s, self._held_until_s), bytes(passed)))

    def give(self, now_s: float) -> bytes:
        """Return the bytes that leave the way by now."""
        given = b""
        while self._held and self._held[0][0] <= now_s:
            given += self._held.popleft()[1]
        return given

    def cut(self) -> None:
        """Lose what is on the way."""
        self._held.clear()

    def _begin(self, now_s: float) -> None:
        for fault in [fault for fault in self._faults if is_due(fault, self.passed, now_s)]:
            self._faults.remove(fault)
            self._fired(fault)
            if fault.kind == "delay":
                self._held_until_s = now_s + fault.for_s
            else:
                self._acting[fault] = fault.count

    def _changed(self, byte: int) -> bytes:
        """Return what becomes of one byte."""
        data = bytes([byte])
        for fault in list(self._acting):
            data = self._hit(fault, data)
            self._acting[fault] -= 1
            if not self._acting[fault]:
                del self._acting[fault]
        self.damaged += data != bytes([byte])
        return data

    def _hit(self, fault: Fault, data: bytes) -> bytes:
        if fault.kind == "drop":
            return b""
        if fault.kind == "duplicate":
            return data * 2
        bits = fault.bits or 1 << self._random.randrange(7)
        return bytes(byte ^ bits for byte in data)


def is_due(fault: Fault, passed: int, now_s: float) -> bool:
    """Return whether a fault's moment has come; passed: bytes of its way."""
    return now_s >= fault.at_s if fault.at_s is not None else passed >= (fault.at_byte or 0)


LINE_END = b"\r\n"
ANSWER = b"ok" + LINE_END


class FaultyAnswers:
    """Whole lines of the controller; `fired` is called when a fault first takes effect."""

    def __init__(self, fired: Callable[[Fault], None]):
        self.withheld = 0
        self._fired = fired
        self._withholding: list[Fault] = []
        self._to_withhold = 0
        self._flood = b""
        self._tail = b""

    def begin(self, fault: Fault) -> None:
        """Let a fault of the words begin."""
        if fault.kind == "withhold":
            self._withholding.append(fault)
            self._to_withhold += fault.count
        else:
            self._flood += (fault.text.encode("ascii") + LINE_END) * fault.count
            self._fired(fault)

    def pass_on(self, data: bytes) -> bytes:
        """Return what is heard of what the controller says; a line begun waits for its end."""
        *lines, self._tail = (self._tail + data).split(LINE_END)
        heard = b"".join(line + LINE_END for line in lines if not self._keeps(line + LINE_END))
        if self._flood:
            heard, self._flood = heard + self._flood, b""
        return heard

    def _keeps(self, line: bytes) -> bool:
        if line != ANSWER or not self._to_withhold:
            return False
        while self._withholding:
            self._fired(self._withholding.pop(0))
        self._to_withhold -= 1
        self.withheld += 1
        return True
