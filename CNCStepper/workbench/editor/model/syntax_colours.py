# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of a program's words, on a light and on a dark ground."""

from __future__ import annotations

LIGHT = {
    "motion": "#0b4fa8",
    "code": "#7a1fa2",
    "axis": "#1a1d21",
    "centre": "#3f6b00",
    "feed": "#b04400",
    "number": "#8a8f98",
    "comment": "#5f7a55",
    "flow": "#b3005e",
    "value": "#006d77",
    "mark": "#8a8f98",
    "wrong": "#d40000",
    "line": "#eaf1fb",
    "margin": "#f3f4f6",
    "digits": "#8a8f98",
}
DARK = {
    "motion": "#7fb4ff",
    "code": "#d7a1f9",
    "axis": "#e6e8eb",
    "centre": "#b5d97a",
    "feed": "#ffb26b",
    "number": "#8b929c",
    "comment": "#8fb58a",
    "flow": "#ff8ac4",
    "value": "#5fd3dc",
    "mark": "#8b929c",
    "wrong": "#ff6b6b",
    "line": "#2b3340",
    "margin": "#24282e",
    "digits": "#7c838d",
}
BOLD = ("motion", "code", "flow")


def colours_on(lightness: int) -> dict[str, str]:
    """Return the colours for a ground of that lightness, from 0 (black) to 255."""
    return DARK if lightness < 128 else LIGHT
