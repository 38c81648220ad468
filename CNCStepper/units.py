# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only unit conversions of the project; everything inside is mm, mm/min, seconds and degrees."""

MM_PER_INCH = 25.4
UNIT_MM = {"mm": 1.0, "inch": MM_PER_INCH}
LAST_DIGIT = {"mm": 0.001, "inch": 0.0001}  # of a control's numbers without a point, in units of the text
S_PER_MIN = 60.0


def mm_from_inch(length_inch: float) -> float:
    """Return a length in mm."""
    return length_inch * MM_PER_INCH


def inch_from_mm(length_mm: float) -> float:
    """Return a length in inches."""
    return length_mm / MM_PER_INCH


def mm_s_from_mm_min(speed_mm_min: float) -> float:
    """Return a speed in mm/s."""
    return speed_mm_min / S_PER_MIN


def mm_min_from_mm_s(speed_mm_s: float) -> float:
    """Return a speed in mm/min."""
    return speed_mm_s * S_PER_MIN
