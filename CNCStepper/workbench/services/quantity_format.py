# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths, volumes and times as a person reads them, in the units chosen in FreeCAD."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from CNCStepper.workbench.services.translation import tr


def length_text(length_mm: float) -> str:
    """Return a length in the user's units."""
    import FreeCAD

    return str(FreeCAD.Units.Quantity(length_mm, FreeCAD.Units.Length).UserString)


def volume_text(volume_mm3: float) -> str:
    """Return a volume in the user's units."""
    import FreeCAD

    return str(FreeCAD.Units.Quantity(volume_mm3, FreeCAD.Units.Volume).UserString)


def clock_text(time_s: float) -> str:
    """Return a time as on a clock: "1:02:05", "2:05", with tenths below a minute: "0:05.3"."""
    if time_s < 59.95:
        return f"0:{time_s:04.1f}"
    whole = round(time_s)
    hours, minutes, seconds = whole // 3600, whole // 60 % 60, whole % 60
    return f"{hours}:{minutes:02d}:{seconds:02d}" if hours else f"{minutes}:{seconds:02d}"


def steps_text(steps: Sequence[int]) -> str:
    """Return the motors' positions as text, in steps."""
    places = (f"{name} {count}" for name, count in zip("XYZ", steps, strict=False))
    return tr("Motor steps: {0}").format("  ".join(places))


def totals(report: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return name, label and text of what a program comes to."""
    volume_mm3 = report["removed_volume_mm3"]
    return [
        ("time", tr("Time"), clock_text(report["time_s"])),
        ("cut", tr("Cutting"), length_text(report["cut_length_mm"])),
        ("air", tr("Feeding in air"), length_text(report["air_length_mm"])),
        ("rapid", tr("Rapids"), length_text(report["rapid_length_mm"])),
        ("volume", tr("Removed"), volume_text(volume_mm3) if volume_mm3 is not None else "–"),
    ]
