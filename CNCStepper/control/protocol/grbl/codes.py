# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meaning of error and alarm codes; each firmware has its table: `codes_grbl`, `codes_grblhal` ..."""

from __future__ import annotations

from dataclasses import dataclass

CORRECT_LINE = "correct that line of the program"
HOME_AGAIN = "find the cause, then home the machine: its position is lost"


@dataclass(frozen=True)
class Code:
    """What a number means and what to do; `position_kept` is of interest for alarms only."""

    meaning: str
    advice: str
    position_kept: bool = True


def lost(meaning: str, advice: str = HOME_AGAIN) -> Code:
    """Return the code of an alarm after which the machine's position cannot be trusted."""
    return Code(meaning, advice, position_kept=False)
