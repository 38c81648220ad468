# SPDX-License-Identifier: LGPL-2.1-or-later
"""The status line of a program line: position after it, modal state, and time. It knows no Qt."""

from __future__ import annotations

from typing import Any

from CNCStepper.units import MM_PER_INCH
from CNCStepper.workbench.services.translation import later, tr

UNKNOWN = "?"
DISTANCES = {"absolute": later("absolute"), "incremental": later("incremental")}
SPINDLES = {"off": later("spindle off"), "cw": later("S{0} clockwise"), "ccw": later("S{0} counter-clockwise")}
COOLANTS = {"mist": later("mist"), "flood": later("flood")}
FEEDS = {
    ("mm", "per_minute"): later("F{0} mm/min"),
    ("inch", "per_minute"): later("F{0} in/min"),
    ("mm", "per_turn"): later("F{0} mm/rev"),
    ("inch", "per_turn"): later("F{0} in/rev"),
}


def place_text(answer: dict[str, Any]) -> str:
    """Return "X 1.000  Y 2.000  Z ?  mm" for a line's answer, in the units that it is written in."""
    units = answer["state"]["units"]
    scale, decimals = (1 / MM_PER_INCH, 4) if units == "inch" else (1.0, 3)
    axes = zip("XYZ", answer["work_mm"], strict=True)
    shown = [f"{axis} {UNKNOWN if mm is None else f'{mm * scale + 0.0:.{decimals}f}'}" for axis, mm in axes]
    return "  ".join([*shown, "in" if units == "inch" else "mm"])


def modes_text(answer: dict[str, Any]) -> str:
    """Return what is in force after a line: distance, plane, work zero, feed, spindle, tool, coolant."""
    state = answer["state"]
    spindle = tr(SPINDLES[state["spindle"]]).format(f"{state['spindle_rpm']:g}")
    parts = [tr(DISTANCES[state["distance"]]), state["plane"], state["work_system"], _feed(state), spindle]
    parts.append(tr("tool {0}").format(state["tool"]))
    return " · ".join([*parts, *(tr(COOLANTS[name]) for name in state["coolant"])])


def time_text(answer: dict[str, Any], duration_s: float | None) -> str:
    """Return "1:05 of 9:36", "" where the times are not known."""
    if answer["time_s"] is None or duration_s is None:
        return ""
    return tr("{0} of {1}").format(clock(answer["time_s"]), clock(duration_s))


def clock(seconds: float) -> str:
    """Return a time as 0:05 or 1:02:03."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


def _feed(state: dict[str, Any]) -> str:
    if state["feed_mode"] == "inverse_time":
        return tr("inverse time")
    scale = 1 / MM_PER_INCH if state["units"] == "inch" else 1.0
    return tr(FEEDS[state["units"], state["feed_mode"]]).format(f"{state['feed'] * scale:.5g}")
