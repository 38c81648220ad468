# SPDX-License-Identifier: LGPL-2.1-or-later
"""The real-time bytes of grbl 1.1 that change feed, rapid, spindle speed and coolant while it moves.

Each sets a flag that the controller looks at now and then, so that two equal bytes in one moment count once:
a step is one byte.
"""

from __future__ import annotations

from CNCStepper.errors import MachineRefusal

BYTES: dict[str, dict[str, bytes]] = {
    "feed": {"reset": b"\x90", "10": b"\x91", "-10": b"\x92", "1": b"\x93", "-1": b"\x94"},
    "rapid": {"100": b"\x95", "50": b"\x96", "25": b"\x97", "reset": b"\x95"},
    "spindle": {"reset": b"\x99", "10": b"\x9a", "-10": b"\x9b", "1": b"\x9c", "-1": b"\x9d", "stop": b"\x9e"},
    "coolant": {"flood": b"\xa0", "mist": b"\xa1"},  # each switches it on, or off
}


def override_byte(kind: str, step: str) -> bytes:
    """Return the byte for one step of a kind of `BYTES`; raises MachineRefusal naming the steps there are.

    step: percent to add ("10", "-1"), of rapid the percentage itself, "reset", "stop" for the spindle
    of a held machine, or of the coolant what is switched on or off.
    """
    try:
        return BYTES[kind][step]
    except KeyError as error:
        there = ", ".join(f"{name} {' '.join(steps)}" for name, steps in BYTES.items())
        what = f"there is no override {kind} {step}"
        raise MachineRefusal("override", what, advice=f"use one of: {there}") from error
