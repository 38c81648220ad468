# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words for the choices of enumerations, which documents and job files keep in English."""

from __future__ import annotations

from CNCStepper.workbench.words import later, tr

WORDS = {
    "climb": later("climb"),
    "conventional": later("conventional"),
    "tolerance": later("arcs within the tolerance"),
    "dda": later("published points (DDA)"),
    "helix": later("helix"),
    "ramp": later("ramp"),
    "plunge": later("straight down"),
    "flat": later("flat end mill"),
    "ball": later("ball end mill"),
    "bullnose": later("bull nose"),
    "v": later("V-bit"),
    "drill": later("drill"),
    "engraver": later("engraver"),
    "jet": later("jet (water, plasma, laser)"),
    "wire": later("wire"),
    "mm": later("millimetres (G21)"),
    "inch": later("inches (G20)"),
    "none": later("none"),
    "mist": later("mist (M7)"),
    "flood": later("flood (M8)"),
    "box": later("box"),
    "sheet": later("sheet"),
    "cylinder": later("cylinder"),
    "top-centre": later("centre of the top"),
    "top-left-front": later("front left corner of the top"),
    "": later("the machine's own"),
}


def words_of(choice: str) -> str:
    """Return a choice as a person reads it; what has no words of its own, like G54, stands for itself."""
    return tr(WORDS[choice]) if choice in WORDS else choice
