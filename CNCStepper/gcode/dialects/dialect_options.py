# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings of every dialect for what the machine behind it lacks, as `Machine.language` names them.

grbl:z=none               there is no Z: no word for it is written, and one that is read is refused
grbl:spindle=switch       M3 and M5 without S switch a torch
grbl:spindle=none         nothing is switched: M3, M4 and M5 are refused
thesis-a:spindle=always   the language has no words for it: the wire is on from the program's begin
grbl:outputs=pins         M62 to M65 switch the pins of a machine whose pulses this computer makes
grbl:feed=900             the feed, mm/min, of a program that has no F
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import isfinite

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.definition import Dialect, rs274_codes, same_advice

SPEED_CODES = ("G96", "G97", "M19")
SWITCH_CODES = ("M3", "M4", "M5")
OUTPUT_CODES = ("M62", "M63", "M64", "M65")
HEIGHT_PLANES = ("G18", "G19")
NO_Z = "this machine has no Z axis: take it out"
NO_PLANE = "this machine has no Z axis: arcs are in XY"
NO_S = "this machine has no spindle whose speed is chosen: write M3 alone"
NOT_SWITCHED = "this machine has no output to switch (knife and point have no power): take it out"


def _without(dialect: Dialect, codes: tuple[str, ...], letters: str, advice: str) -> Dialect:
    """Return the dialect without codes and letters that it may have, refused with this advice."""
    refused = {**dialect.refused, **same_advice((*codes, *letters), advice)}
    kept = {name: code for name, code in dialect.codes.items() if name not in codes}
    known = "".join(letter for letter in dialect.letters if letter not in letters)
    return replace(dialect, codes=kept, letters=known, refused=refused)


def _z(dialect: Dialect, value: str) -> Dialect:
    if dialect.plasma:  # it moves Z itself, independently of the profile
        return dialect
    flat = _without(dialect, ("G43.1",), "Z", NO_Z)
    flat = _without(flat, HEIGHT_PLANES, "", NO_PLANE)
    writing = flat.writing and replace(flat.writing, lifts=False, helices=False)
    return replace(flat, writing=writing, has_z=False)


def _spindle(dialect: Dialect, value: str) -> Dialect:
    if dialect.plasma:  # its torch is a switch, and M3 has an S all the same
        return dialect
    if value == "always":
        return replace(dialect, power="always")
    if value == "switch":
        return replace(_without(dialect, SPEED_CODES, "S", NO_S), power="switch")
    bare = _without(dialect, (*SPEED_CODES, *SWITCH_CODES), "S", NOT_SWITCHED)
    if bare.writing is None:
        return bare
    footer = tuple(line for line in bare.writing.footer if line not in SWITCH_CODES)
    return replace(bare, writing=replace(bare.writing, footer=footer))


def _feed(dialect: Dialect, value: str) -> Dialect:
    return replace(dialect, default_feed_mm_min=float(value))


def _outputs(dialect: Dialect, value: str) -> Dialect:
    return replace(dialect, codes={**dialect.codes, **rs274_codes(" ".join(OUTPUT_CODES))})


def as_sent(dialect: Dialect) -> Dialect:
    """Return the dialect as a program is read that a machine is to run: a feed that is only set must reach it.

    A controller that reads the file itself is sent nothing else, and would take the feed of an earlier program.
    """
    return replace(dialect, needs_own_feed=dialect.reads_files and dialect.default_feed_mm_min > 0.0)


_VALUES: dict[str, tuple[tuple[str, ...], Callable[[Dialect, str], Dialect]]] = {
    "z": (("none",), _z),
    "spindle": (("switch", "none", "always"), _spindle),
    "outputs": (("pins",), _outputs),
}


def with_machine_setting(dialect: Dialect, key: str, value: str) -> Dialect | None:
    """Return the dialect with one of these settings; None where it is none of them.

    Raises ProgramError for a feed that is no number above 0.
    """
    if key == "feed":
        return _feed(dialect, _checked_feed(value))
    values, change = _VALUES.get(key, ((), _feed))
    return change(dialect, value) if value in values else None


def _checked_feed(value: str) -> str:
    try:
        feed_mm_min = float(value)
    except ValueError:
        feed_mm_min = 0.0
    if not (isfinite(feed_mm_min) and feed_mm_min > 0):
        what = Text("'{value}' is no feed for programs without F", value=value[:20])
        raise ProgramError("unknown-dialect", what, advice="write feed= and mm/min, for example feed=900")
    return value
