# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long calculations ask now and then whether they are still wanted, so that whoever began one can end it.

with interruptible(look):      look raises what ends the calculation
    cycle.cut(setup, table)    ──► TableBuilder, the writer, offsets ... ──► checkpoint() ──► look()
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

_look: Callable[[], None] | None = None


def checkpoint() -> None:
    """Let whoever began this calculation end it here; costs a fraction of a microsecond."""
    if _look is not None:
        _look()


@contextmanager
def interruptible(look: Callable[[], None]) -> Iterator[None]:
    """Call `look` at every checkpoint within; what it raises ends the calculation.

    Only one thread of a process may calculate so at a time.
    """
    global _look
    before, _look = _look, look
    try:
        yield
    finally:
        _look = before
