# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presses the input pins of a virtual machine, by a timeline or by typed lines.

[[press]]        of a TOML file             P            typed: press the probe's pin for 0.3 s
pin = "P"                                   press P      and keep it pressed
at_s = 2.5       since the board's power-up     release P
for_s = 0.3                                 13           a status pin of a parallel port
"""

from __future__ import annotations

import heapq
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Protocol

from CNCStepper.errors import JobError, Place, Text

TAP_S = 0.3
LONGEST_S = 1e6
KEYS = {"pin", "at_s", "for_s"}


class Pressable(Protocol):
    """A machine with input pins; `pin_names` are all of them, `pins` those that are on, in words."""

    pin_names: tuple[str, ...]
    time_s: float

    def press(self, pin: str) -> None:
        """Switch a pin on."""

    def release(self, pin: str) -> None:
        """Switch a pin off."""

    def pins(self) -> str:
        """Return the pins that are on."""


class PinPresses:
    """Pending presses and releases of one machine, by the machine's clock.

    tell: hears what a typed line did, or why it did nothing.
    """

    def __init__(self, board: Pressable, tell: Callable[[str], None] = lambda text: None):
        self._board = board
        self._tell = tell
        self._due: list[tuple[float, bool, str]] = []  # when, pressed, which pin

    def plan(self, path: Path) -> None:
        """Take over the presses of a TOML file; raises JobError naming it where one cannot be."""
        for pin, at_s, for_s in _presses(path, self._board.pin_names):
            self._press(pin, at_s, for_s)

    def on_message(self, line: str) -> None:
        """Do what a typed line says, now."""
        *verb, pin = line.upper().split() or [""]
        names = self._board.pin_names
        if pin not in names or verb not in ([], ["PRESS"], ["RELEASE"]):
            what = "'{line}' is no press: type {name}, press {name} or release {name}; pins are {names}"
            self._tell(Text(what, line=line[:40], name=names[0], names=", ".join(names)))
            return
        (self._board.release if verb == ["RELEASE"] else self._board.press)(pin)
        if not verb:
            heapq.heappush(self._due, (self._board.time_s + TAP_S, False, pin))
        self._tell(Text("pins that are on: {pins}", pins=self._board.pins() or "none"))

    def turn(self) -> None:
        """Press and let go what is due."""
        while self._due and self._due[0][0] <= self._board.time_s:
            _, pressed, pin = heapq.heappop(self._due)
            (self._board.press if pressed else self._board.release)(pin)

    def _press(self, pin: str, at_s: float, for_s: float) -> None:
        heapq.heappush(self._due, (at_s, True, pin))
        heapq.heappush(self._due, (at_s + for_s, False, pin))


def _presses(path: Path, names: Sequence[str]) -> list[tuple[str, float, float]]:
    """Return pin, begin and length of each press of a file."""
    place = Place(str(path))
    try:
        content = tomllib.loads(path.read_text("utf-8-sig"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        advice = "correct that, or name a TOML file"
        raise JobError("toml", Text("not a TOML file: {error}", error=error), place=place, advice=advice) from error
    if set(content) - {"press"} or not isinstance(content.get("press", []), list):
        raise JobError("press", "a timeline holds nothing but presses", advice=_advice(names), place=place)
    return [_read_press(entry, names, place) for entry in content.get("press", [])]


def _read_press(entry: Any, names: Sequence[str], place: Place) -> tuple[str, float, float]:
    if not isinstance(entry, dict) or set(entry) - KEYS or str(entry.get("pin")) not in names:
        value, advice = str(entry)[:60], _advice(names)
        raise JobError("press", "a press of the timeline is none", value=value, advice=advice, place=place)
    return str(entry["pin"]), _seconds(entry.get("at_s"), place), _seconds(entry.get("for_s", TAP_S), place)


def _advice(names: Sequence[str]) -> Text:
    what = "write [[press]] with pin (one of {names}), at_s and, if not {tap_s:g}, for_s"
    return Text(what, names=", ".join(names), tap_s=TAP_S)


def _seconds(value: Any, place: Place) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 <= value < LONGEST_S:
        advice = Text("give 0 or more and less than {longest_s:g} s", longest_s=LONGEST_S)
        raise JobError("press", "a time of a press is none", value=str(value)[:20], place=place, advice=advice)
    return float(value)
