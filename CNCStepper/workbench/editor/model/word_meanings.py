# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meaning of the word under the cursor, in one sentence. It knows no Qt."""

from __future__ import annotations

from CNCStepper.gcode.syntax.words import scanned_codes, scanned_words
from CNCStepper.workbench.services.translation import later, tr

CODES = {
    "G0": later("rapid: straight, as fast as the machine can"),
    "G1": later("straight cut, at the feed F"),
    "G2": later("arc, clockwise"),
    "G3": later("arc, counter-clockwise"),
    "G4": later("dwell for P"),
    "G5": later("cubic spline"),
    "G5.1": later("quadratic spline"),
    "G7": later("X words are diameters"),
    "G8": later("X words are radii"),
    "G10": later("sets offsets or tools"),
    "G17": later("arcs lie in the XY plane"),
    "G18": later("arcs lie in the ZX plane"),
    "G19": later("arcs lie in the YZ plane"),
    "G20": later("lengths are inches"),
    "G21": later("lengths are millimetres"),
    "G28": later("goes to the first stored place"),
    "G30": later("goes to the second stored place"),
    "G32": later("moves in step with the spindle"),
    "G33": later("moves in step with the spindle"),
    "G38.2": later("probes until it touches, an alarm where it does not"),
    "G38.3": later("probes until it touches"),
    "G38.4": later("probes away until the contact opens; otherwise an alarm"),
    "G38.5": later("probes away until the contact opens"),
    "G40": later("no cutter compensation"),
    "G41": later("the cutter runs left of the path"),
    "G42": later("the cutter runs right of the path"),
    "G43": later("applies the tool's length"),
    "G43.1": later("applies a given tool length"),
    "G49": later("no tool length"),
    "G53": later("this line is in machine coordinates"),
    "G61": later("follows the path exactly"),
    "G64": later("rounds corners off to keep its speed"),
    "G73": later("drills, breaking chips"),
    "G76": later("cuts a thread in several passes"),
    "G80": later("ends the canned cycle"),
    "G81": later("drills"),
    "G82": later("drills with a dwell at the bottom"),
    "G83": later("drills, lifting the chips out"),
    "G90": later("coordinates are absolute"),
    "G91": later("coordinates are steps from where the tool is"),
    "G90.1": later("arc centres are absolute"),
    "G91.1": later("arc centres are seen from the arc's begin"),
    "G92": later("names the present place"),
    "G92.1": later("cancels G92"),
    "G93": later("F is the inverse of a move's time in minutes"),
    "G94": later("F is the feed per minute"),
    "G95": later("F is the feed per turn of the spindle"),
    "G96": later("S is the speed at the surface"),
    "G97": later("S is turns per minute"),
    "G98": later("canned cycles return to where they began"),
    "G99": later("canned cycles return to R"),
    "M0": later("pauses until cycle start"),
    "M1": later("pauses if optional stop is on"),
    "M2": later("end of the program"),
    "M3": later("spindle on, clockwise"),
    "M4": later("spindle on, counter-clockwise"),
    "M5": later("spindle off"),
    "M6": later("changes the tool"),
    "M7": later("mist on"),
    "M8": later("flood on"),
    "M9": later("coolant off"),
    "M30": later("end of the program"),
    "M98": later("calls a subprogram"),
    "M99": later("returns from a subprogram"),
}
LETTERS = {
    "A": later("angle about X"),
    "B": later("angle about Y"),
    "C": later("angle about Z"),
    "D": later("number of the tool for compensation"),
    "F": later("feed"),
    "H": later("number of the tool length"),
    "I": later("arc centre along X"),
    "J": later("arc centre along Y"),
    "K": later("arc centre along Z"),
    "L": later("how often, or which"),
    "N": later("number of the line"),
    "P": later("time, number or turns, as the code has it"),
    "Q": later("depth of a peck"),
    "R": later("radius, or where a canned cycle begins"),
    "S": later("speed of the spindle"),
    "T": later("number of the tool"),
    "U": later("place along U"),
    "V": later("place along V"),
    "W": later("place along W"),
    "X": later("place along X"),
    "Y": later("place along Y"),
    "Z": later("place along Z"),
}
WORK_SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")


def meaning_of(word: str) -> str:
    """Return "G1: straight cut, at the feed F" for a word in capitals without blanks, "" for what is not known."""
    is_code = [letter + number for letter, number in scanned_words(word) if letter in "GM"] == [word]
    name = next(iter(scanned_codes(word))) if is_code else word
    if name in CODES:
        return f"{name}: {tr(CODES[name])}"
    if name in WORK_SYSTEMS:
        return f"{name}: {tr('work zero {0} of 9').format(WORK_SYSTEMS.index(name) + 1)}"
    if word[:1] in ("(", ";"):
        return tr("a comment")
    if word.startswith("#"):
        return f"{word}: {tr('a parameter')}"
    if word.startswith("O"):
        return f"{word}: {tr('leads the program elsewhere')}"
    return f"{word}: {tr(LETTERS[word[0]])}" if word[:1] in LETTERS else ""
