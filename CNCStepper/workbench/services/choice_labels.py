# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words for the choices of enumerations, which documents and job files keep in English."""

from __future__ import annotations

from CNCStepper.workbench.services.translation import later, tr

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
    "offset": later("along the walls"),
    "zigzag": later("zigzag"),
    "spiral": later("spiral"),
    "engagement": later("bounded engagement"),
    "oneway": later("lines in one direction"),
    "outside": later("outside"),
    "inside": later("inside"),
    "on": later("on the line"),
    "left": later("left"),
    "right": later("right"),
    "count": later("count"),
    "spacing": later("spacing"),
    "line": later("line"),
    "arc": later("arc"),
    "corner": later("into the corner"),
    "side": later("into one side"),
    "drawing": later("of a drawing"),
    "bolt_circle": later("bolt circle"),
    "grid": later("grid"),
    "points": later("points"),
    "tip": later("the point"),
    "diameter": later("full diameter"),
    "G81": later("G81 straight"),
    "G82": later("G82 with a pause"),
    "G83": later("G83 pecks, all out"),
    "G73": later("G73 pecks, chips"),
    "clearance": later("G98 clearance"),
    "retract": later("G99 retract"),
    "short": later("short rapids"),
    "given": later("as given"),
    "drawn": later("as drawn"),
    "carbide": later("carbide"),
    "hss": later("high-speed steel"),
    "aluminium-6061": later("aluminium 6061"),
    "brass": later("brass"),
    "mild-steel": later("mild steel"),
    "stainless": later("stainless steel"),
    "hardwood": later("hardwood"),
    "softwood": later("softwood"),
    "plywood": later("plywood"),
    "mdf": later("MDF board"),
    "acrylic": later("acrylic, cast"),
    "polycarbonate": later("polycarbonate"),
    "pom": later("POM (acetal)"),
    "hdpe": later("HDPE plastic"),
    "pvc": later("PVC, rigid"),
    "pvc-foam": later("PVC foam board"),
    "xps": later("XPS foam"),
    "fr4": later("FR4 (glass fibre)"),
    "carbon-fibre": later("carbon fibre"),
    "cap": later("the capitals"),
    "em": later("the em (font size)"),
    "center": later("middle"),
    "all": later("all"),
    "outlines": later("outlines"),
    "outline": later("outline"),
    "section": later("at a height"),
    "holes": later("holes"),
    "automatic": later("automatic"),
    "layer": later("by layer"),
    "chain": later("by contour"),
}


TURNING_WORDS = {
    "turning": later("turning outside"),
    "boring": later("boring"),
    "parting": later("parting and grooving"),
    "threading": later("threading"),
    "diameters": later("two diameters"),
    "angle": later("an angle"),
    "bar": later("bar"),
    "tube": later("tube"),
    "radius": later("radius"),
    "absolute": later("absolute (G90)"),
    "incremental": later("incremental (G91)"),
    "insert": later("of the insert"),
    "angles": later("by two angles"),
    "z": later("along Z (as G71)"),
    "x": later("along X (as G72)"),
    "profile": later("along the profile (as G73)"),
    "full": later("out of the hole"),
    "chip": later("to break the chip"),
    "radial": later("radial"),
    "flank": later("along the flank"),
    "alternating": later("alternating flanks"),
}
PROCESS_WORDS = {
    "milling": later("Milling"),
    "plasma": later("Plasma"),
    "oxyfuel": later("Oxyfuel"),
    "laser": later("Laser"),
    "waterjet": later("Water jet"),
    "hot-wire": later("Hot wire"),
    "drag-knife": later("Drag knife"),
    "scribe": later("Scribe"),
}
CHART_WORDS = {
    "aluminium": later("aluminium"),
    "cardboard": later("cardboard"),
    "cardstock": later("cardstock"),
    "copper": later("copper"),
    "eps": later("EPS foam"),
    "epp": later("EPP foam"),
    "felt": later("felt"),
    "foam": later("foam"),
    "foam-board": later("foam board"),
    "glass": later("glass"),
    "granite": later("granite"),
    "heat-transfer-film": later("heat transfer film"),
    "leather": later("leather"),
    "paper": later("paper"),
    "rubber": later("rubber"),
    "sandblast-film": later("sandblast film"),
    "titanium": later("titanium"),
    "vinyl": later("vinyl"),
    "45 degrees": later("45° blade"),
    "60 degrees": later("60° blade"),
    "nichrome 0.4 mm": later("nichrome wire, 0.4 mm"),
}
CUT_WORDS = {
    "usual": later("usual for the process"),
    "own": later("own values"),
    "nearest": later("the nearest edge"),
    "front": later("front"),
    "back": later("rear"),
}
MACHINE_WORDS = {  # the names of profiles that ship
    name: name
    for name in (
        later("Cutting table A"),
        later("Cutting table B"),
        later("Laser table"),
        later("Lathe with LinuxCNC"),
        later("Mini-lathe"),
        later("Plasma table with QtPlasmaC"),
        later("Thesis table"),
        later("Torch table"),
        later("USB board"),
        later("Wire table"),
    )
}
OF_KEY = {
    ("leave", "back"): later("back along the entry"),
    ("leave", "edge"): later("to the nearest edge"),
    ("process", "turning"): later("Turning"),
    ("x_is", "diameter"): later("diameter"),
}
WORDS |= {**TURNING_WORDS, **PROCESS_WORDS, **CHART_WORDS, **CUT_WORDS, **MACHINE_WORDS}


def words_of(choice: str, key: str = "") -> str:
    """Return the label of a choice, of the property with a key; one without a label, like G54, is its own."""
    known = english_words_of(choice, key)
    return tr(known) if known else choice


def english_words_of(choice: str, key: str = "") -> str:
    """Return the English label of a choice, "" for one that is its own label."""
    return OF_KEY.get((key, choice)) or WORDS.get(choice, "")
