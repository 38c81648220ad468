# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words by which a person changes feed, rapid, spindle and coolant of a machine that runs: "feed +10", "flood"."""

from __future__ import annotations

import re

TENS_AND_ONES = {"+10": "10", "-10": "-10", "+1": "1", "-1": "-1", "100": "reset"}
STEPS: dict[str, dict[str, str]] = {  # of each kind: what is typed, and the step of the session's command
    "feed": TENS_AND_ONES,
    "rapid": {"100": "100", "50": "50", "25": "25"},
    "spindle": TENS_AND_ONES | {"stop": "stop"},
}
COOLANTS = ("flood", "mist")
HELP = "; ".join([*(f"{kind} {' '.join(steps)}" for kind, steps in STEPS.items()), *COOLANTS])
_WORDS = re.compile(f"({'|'.join(STEPS)}) *([^ ]*)")


def read_override(text: str) -> dict[str, str] | None:
    """Return the values of the command "override" that a text asks for; None where it asks for something else.

    Raises ValueError with words for a step that there is not.
    """
    words = text.lower().strip()
    if words in COOLANTS:
        return {"kind": "coolant", "step": words}
    found = _WORDS.fullmatch(words)
    if found is None:
        return None
    kind, step = found.groups()
    if step not in STEPS[kind]:
        raise ValueError(f"there is no override '{words}'; there are: {HELP}")
    return {"kind": kind, "step": STEPS[kind][step]}
