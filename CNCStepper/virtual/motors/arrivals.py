# SPDX-License-Identifier: LGPL-2.1-or-later
"""When the bytes of a client came: a computer hands them over in batches, so that each has a span of time.

    read         |<------- the read before ... this read ------->|      three bytes, any time within
    at                                                 .   .   .         the likely times: evenly, up to the read

A pulse that may have been long enough is never called too short: a limit is violated only if no time within the spans
meets it. Bytes with exact times have spans of no length.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

LONGEST_SPACING_S = 0.001  # between the bytes of a batch: one that came behind a rest is not spread over the rest


class Records(NamedTuple):
    """Records of one or more bytes: bytes uint8[k, width]; earliest_s, latest_s, at_s float64[k], never falling."""

    bytes: np.ndarray
    earliest_s: np.ndarray
    latest_s: np.ndarray
    at_s: np.ndarray

    @property
    def is_empty(self) -> bool:
        """Whether there is no record."""
        return len(self.bytes) == 0


NOTHING = Records(np.empty((0, 0), np.uint8), np.empty(0), np.empty(0), np.empty(0))


class Arrivals:
    """Collects batches of bytes and gives them as records of `width` bytes; a record begun waits for its end."""

    def __init__(self, width: int = 1):
        self._width = width
        self._batches: list[tuple[bytes, float, float]] = []
        self._begun = b""
        self._last_s = 0.0

    @property
    def waiting(self) -> int:
        """How many whole records wait."""
        return (len(self._begun) + sum(len(data) for data, _, _ in self._batches)) // self._width

    def add(self, data: bytes, since_s: float, now_s: float) -> None:
        """Take a batch that came after `since_s` and not after `now_s`."""
        self._batches.append((data, since_s, now_s))

    def clear(self) -> None:
        """Forget all that waits: another client begins with a whole record."""
        self._batches.clear()
        self._begun = b""

    def take(self) -> Records:
        """Return the records that are whole."""
        parts: list[Records] = []
        for data, since_s, now_s in self._batches:
            data = self._begun + data
            count = len(data) // self._width
            self._begun = data[count * self._width :]
            if count:
                parts.append(self._records(data[: count * self._width], since_s, now_s, count))
        self._batches.clear()
        return Records(*(np.concatenate(columns) for columns in zip(*parts, strict=True))) if parts else NOTHING

    def _records(self, data: bytes, since_s: float, now_s: float, count: int) -> Records:
        spacing_s = min((now_s - since_s) / count, LONGEST_SPACING_S)
        at_s = np.maximum(now_s - np.arange(count - 1, -1, -1) * spacing_s, self._last_s)
        self._last_s = float(at_s[-1])
        rows = np.frombuffer(data, np.uint8).reshape(count, self._width)
        return Records(rows, np.full(count, since_s), np.full(count, now_s), at_s)
