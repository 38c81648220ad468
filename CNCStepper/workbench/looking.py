# SPDX-License-Identifier: LGPL-2.1-or-later
"""While a window only looks at what it takes to make objects, it calculates nothing that takes long.

What is missing is raised as `Unfitted`, with the question that the cut process is asked for it.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from CNCStepper.errors import GeometryError

_only_looking = False


class Unfitted(GeometryError):
    """Lines are not fitted yet; `question` is what the cut process is asked for them."""

    def __init__(self, question: dict[str, Any]):
        super().__init__("unfitted", "the lines are being fitted", advice="it goes on by itself")
        self.question = question


@contextmanager
def only_looking() -> Iterator[None]:
    """Calculate nothing within that takes long."""
    global _only_looking
    before, _only_looking = _only_looking, True
    try:
        yield
    finally:
        _only_looking = before


def looks_only() -> bool:
    """Return whether what takes long is to be asked of the cut process now."""
    return _only_looking
