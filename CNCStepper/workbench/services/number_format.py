# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as people read them: lengths, speeds and volumes in their units, durations, percentages."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.units import MM_PER_INCH
from CNCStepper.workbench.services.translation import tr

NOTHING = "–"


@dataclass(frozen=True)
class Lengths:
    """A unit of length: its name, that of its speeds, how many mm it has, its decimals, and the jog steps in it."""

    name: str
    speed_name: str
    mm: float
    decimals: int
    steps: tuple[float, ...]

    def text(self, length_mm: float | None, point: str = ".") -> str:
        """Return a length with all its decimals, never as "-0.000"; a dash when it is not known."""
        if length_mm is None:
            return NOTHING
        rounded = round(length_mm / self.mm, self.decimals) + 0.0
        return f"{rounded:.{self.decimals}f}".replace(".", point)

    def speed_text(self, speed_mm_min: float | None, point: str = ".") -> str:
        """Return a speed, in inches with one decimal."""
        if speed_mm_min is None:
            return NOTHING
        return f"{speed_mm_min / self.mm:.{self.decimals - 3}f}".replace(".", point)

    def step_text(self, step: float, point: str = ".") -> str:
        """Return a jog step with no more decimals than it needs."""
        return f"{step:g}".replace(".", point)


MM = Lengths("mm", "mm/min", 1.0, 3, (0.01, 0.1, 1.0, 10.0))
INCH = Lengths("in", "in/min", MM_PER_INCH, 4, (0.001, 0.01, 0.1, 1.0))


def duration(time_s: float | None) -> str:
    """Return a time as 0:05, 12:05 or 1:02:05; a dash when it is not known."""
    if time_s is None:
        return NOTHING
    minutes, seconds = divmod(round(max(time_s, 0.0)), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{seconds:02d}" if hours else f"{minutes}:{seconds:02d}"


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


def planned_text(time_s: float) -> str:
    """Return a planned time as on a clock; a dash for 0, which stands for one that is not known."""
    return clock_text(time_s) if time_s else NOTHING


def steps_text(steps: Sequence[int]) -> str:
    """Return where the motors stand, in steps."""
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
