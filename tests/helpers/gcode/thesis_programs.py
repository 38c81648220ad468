# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sample programs of thesis A (2006), lines as they are printed: figures 11 and 13, and test part 1."""

from __future__ import annotations

_FIGURES = {
    "figure 11, absolute": "G0|X15 Y10|G90|X35|X25 Y17|X15 Y10",
    "figure 11, incremental": "G0|X15 Y10|G91|X20|X-10 Y7|X-10 Y-7",
    "figure 13": "G0 X2 Y11|G2 X11 Y2 I1 J1",
    "figure 13, the other way": "G0 X11 Y2|G3 X2 Y11 I1 J1",
}
_PART_1 = {
    1: "g90|y-80|G2 x-80 y0 i0 j0|G90|x-160 y0|G2 x0 y160 i0 j0|G90|y80|"
    "G2 x80 y0 i0 j0|G90|x160|G2 x0 y-160 i0 j0|g90|y-80",
    2: "g90|y-160|G3 x160 y0 i0 j0|G90|x80|G3 x0 y80 i0 j0|G90|y160|G3 x-160 y0 i0 j0|G90|x-80|G3 x0 y-80 i0 j0",
    3: "g90|y-160|G2 x-160 y0 i0 j0|G90|x-80|G2 x0 y80 i0 j0|G90|y160|G2 x160 y0 i0 j0|G90|x80|G2 x0 y-80 i0 j0",
    4: "g90|y-80|G3 x80 y0 i0 j0|G90|x160|G3 x0 y160 i0 j0|G90|y80|"
    "G3 x-80 y0 i0 j0|G90|x-160|G3 x0 y-160 i0 j0|g90|y-80",
}

PART_1 = {number: text.replace("|", "\n") + "\n" for number, text in _PART_1.items()}
SAMPLES = {name: text.replace("|", "\n") + "\n" for name, text in _FIGURES.items()} | {
    f"program {number}": text for number, text in PART_1.items()
}
