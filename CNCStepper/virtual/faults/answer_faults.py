# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a controller says, under faults: answers that are kept back, messages that flood in between."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.virtual.faults.plan import Fault

LINE_END = b"\r\n"
ANSWER = b"ok" + LINE_END


class FaultyAnswers:
    """Whole lines of the controller; `fired` is told of a fault as it first does something."""

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
