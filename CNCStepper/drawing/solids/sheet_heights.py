# SPDX-License-Identifier: LGPL-2.1-or-later
"""The heights at which a solid is cut into sheets: the same rule for meshes and for the process that reads solids.

    high ---------   the stack is as high as the solid or a little higher, both ends alike;
    ==============   a section at the middle of each sheet
    low  ---------

Standard library only: it runs in CadQuery's own Python and inside FreeCAD too.
"""

from __future__ import annotations

import math

AXES = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}  # columns that become X, Y and the height
MOST_SLICES = 2_000
SLACK_MM = 1e-4  # by which a solid may be higher than its sheets: bounds of curved faces are not exact
BESIDE_MM = 1e-4  # from a level face to the section that stands for it
SLICES = "slices"


def sheet_count(low_mm: float, high_mm: float, thickness_mm: float) -> int:
    """Return how many sheets a solid between two heights needs."""
    return max(1, math.ceil((high_mm - low_mm - SLACK_MM) / thickness_mm))


def sheet_begins(low_mm: float, high_mm: float, thickness_mm: float) -> list[float]:
    """Return where each sheet begins, mm, the lowest first."""
    count = sheet_count(low_mm, high_mm, thickness_mm)
    first_mm = (low_mm + high_mm - count * thickness_mm) / 2.0
    return [first_mm + number * thickness_mm for number in range(count)]


def section_heights(low_mm: float, high_mm: float, thickness_mm: float, levels: list[float]) -> list[float]:
    """Return the height of the section of each sheet, mm: its middle, a little above level faces that lie there."""
    middles = [begin_mm + thickness_mm / 2.0 for begin_mm in sheet_begins(low_mm, high_mm, thickness_mm)]
    return [_beside(min(max(middle, low_mm), high_mm), levels) for middle in middles]


def _beside(height_mm: float, levels: list[float]) -> float:
    while any(abs(level - height_mm) < BESIDE_MM for level in levels):
        height_mm += BESIDE_MM
    return height_mm


def question_of(axis: str, thickness_mm: float) -> str:
    """Return the words by which the process is asked for sections, in place of a height."""
    return f"{SLICES} {axis} {thickness_mm!r}"


def asked_slices(height: str) -> tuple[str, float] | None:
    """Return axis and thickness of such words, None for a height or an outline."""
    words = height.split()
    return (words[1], float(words[2])) if words[0] == SLICES else None
