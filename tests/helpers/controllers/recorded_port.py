# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a recorded parallel port says of its axes, decoded by step and direction on pins 2 to 5."""

from __future__ import annotations

import csv
from pathlib import Path

STEPS = {0: 0x01, 1: 0x04}  # bits of the data register: pins 2 and 4
DIRECTIONS = {0: 0x02, 1: 0x08}  # pins 3 and 5; high is backwards


def pulses_of(recording: Path) -> list[tuple[float, int, int, tuple[int, int]]]:
    """Return (time in s, step bits, back bits, place in steps) of each pulse: of each rise of step lines."""
    pulses, before, place = [], 0, [0, 0]
    with recording.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            data, step, back = int(row["data"]), 0, 0
            for axis, line in STEPS.items():
                if data & line and not before & line:
                    step |= 1 << axis
                    back |= (1 << axis) if data & DIRECTIONS[axis] else 0
                    place[axis] += -1 if data & DIRECTIONS[axis] else 1
            if step:
                pulses.append((float(row["t_s"]), step, back, (place[0], place[1])))
            before = data
    return pulses
