# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modes that M70 and M73 keep."""

from __future__ import annotations

from typing import NamedTuple

from CNCStepper.state import State


class Modes(NamedTuple):
    """The modes of a moment; `on_return`: they come back when the subroutine ends (M73)."""

    state: State
    feed_number: float
    plane: str  # its code
    side: str  # "G40", "G41" or "G42"
    diameter: bool
    to_initial: bool
    path_calls: tuple[str, ...]
    overrides: frozenset[str]
    has_length: bool
    on_return: bool
