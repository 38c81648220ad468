# SPDX-License-Identifier: LGPL-2.1-or-later
"""A contact that bounces, followed until it rests.

looked at   0   0 | 1   0   1   1   1 | 1   1
steady      0   0   0   0   0   0   1   1   1      after debounce_s without a change
edge                                ^ True
"""

from __future__ import annotations


class Debouncer:
    """Follows one contact; the first steady level is only learnt, so that what is pressed at the begin does nothing.

    debounce_s: how long a level must last before it is believed, at two looks at least; 0 believes every look.
    """

    def __init__(self, debounce_s: float):
        self._debounce_s = debounce_s
        self._steady: bool | None = None
        self._seen: bool | None = None
        self._since_s = 0.0

    def look(self, level: bool, now_s: float) -> bool | None:
        """Take what the contact shows now; return its new level where it has just changed, else None."""
        if level != self._seen:
            self._seen, self._since_s = level, now_s
            if self._debounce_s > 0:
                return None
        if level == self._steady or now_s - self._since_s < self._debounce_s:
            return None
        is_first, self._steady = self._steady is None, level
        return None if is_first else level
