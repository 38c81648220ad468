# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modes that a program takes for granted: it was proven with those of a fresh controller.

    $G                 G1 G54 G17 G20 G91 G94 M3 ... S9000      what an earlier program, or somebody's hand, has left
    program            G90 / X10 / ... G1 ...                   says G90 before it moves, but not G21: 10 inches,
                                                                and no M3 before it cuts: the spindle still turns

A soft reset brings the fresh modes back, but M2 leaves the units, the tool's length and S as they are. The motion is
not among them: what is sent names it (`gcode/wire/first_motion.py`).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from CNCStepper.errors import MachineRefusal, Text

FRESH = {
    "G17": ("G17", "G18", "G19"),
    "G21": ("G20", "G21"),
    "G90": ("G90", "G91"),
    "G94": ("G93", "G94", "G95"),
}
SWITCHED = {  # what may be on -> what a program says of it, and what is wanted where it says nothing
    "M3": (("M3", "M4", "M5"), "M5"),
    "M4": (("M3", "M4", "M5"), "M5"),
    "M7": (("M7", "M9"), "M9"),
    "M8": (("M8", "M9"), "M9"),
}
TURNS = {"M3", "M4"}
LENGTH_TOLERANCE_MM = 0.002
_CODE = re.compile(r"([GM])0*([0-9]+(?:\.[0-9]+)?)")
_CUT = re.compile(r"G0*(?:[1235]|33|38|7[346]|8[1-9])(?:\.[0-9]+)?(?![0-9])")
_USES_MODES = re.compile(r"[XYZIJKRF][-+.0-9]")


def implied_modes(lines: Iterable[str]) -> tuple[str, ...]:
    """Return the fresh modes that wire lines do not name up to the first one with a length or a feed."""
    missing = dict(FRESH)
    for line in lines:
        said = _codes(line)
        missing = {mode: group for mode, group in missing.items() if not said.intersection(group)}
        if _USES_MODES.search(line):
            return tuple(missing)
    return ()


def codes_before_cut(lines: Iterable[str]) -> set[str]:
    """Return the codes of wire lines up to the first that cuts, its own too."""
    said: set[str] = set()
    for line in lines:
        said |= _codes(line)
        if _CUT.search(line):
            break
    return said


def cuts_at_implied_speed(lines: Iterable[str]) -> bool:
    """Return whether wire lines cut with the spindle switched on before any of them names S."""
    turns = False
    for line in lines:
        if "S" in line:
            return False
        turns = bool(TURNS & _codes(line)) or (turns and "M5" not in _codes(line))
        if turns and _CUT.search(line):
            return True
    return False


def mode_differences(modes: str, offsets_mm: Mapping[str, Sequence[float] | None], lines: Sequence[str]) -> list[str]:
    """Return in words what the controller holds and the program takes for granted to be otherwise.

    modes: the words of `$G`. offsets_mm: by name, as `$#` has them. What is not reported is left out.
    """
    held = modes.split()
    found: list[str] = [
        Text("{word} is in force, wanted {wanted}", word=word, wanted=wanted)
        for wanted in implied_modes(lines)
        for word in held
        if word in FRESH[wanted] and word != wanted
    ]
    found += [
        Text("{word} is in force, wanted {wanted}", word=word, wanted=wanted) for word, wanted in _left_on(held, lines)
    ]
    length = offsets_mm.get("TLO")
    if length and any(abs(value) > LENGTH_TOLERANCE_MM for value in length):
        found.append(Text("a tool length of {length:.3f} mm is in force, wanted none (G49)", length=length[-1]))
    return found


def _left_on(held: Sequence[str], lines: Sequence[str]) -> list[tuple[str, str]]:
    """Return what is on that the program does not speak of before it cuts, and what is wanted instead."""
    on = [word for word in held if word in SWITCHED]
    said = codes_before_cut(lines) if on else set()
    found = [(word, SWITCHED[word][1]) for word in on if not said.intersection(SWITCHED[word][0])]
    speed = next((word for word in held if word.startswith("S") and float(word[1:]) != 0), "")
    return [*found, (speed, "S0")] if speed and cuts_at_implied_speed(lines) else found


def _codes(line: str) -> set[str]:
    return {letter + number for letter, number in _CODE.findall(line)}


def check_modes(found: Sequence[str]) -> None:
    """Refuse a controller on which the program would mean something else; raises MachineRefusal."""
    if found:
        raise MachineRefusal(
            "modes-differ",
            "an earlier program has left modes that this one does not set: " + "; ".join(found),
            advice="send the wanted words by hand or reset the controller, look at the work zero, and send again",
        )
