# SPDX-License-Identifier: LGPL-2.1-or-later
"""A person's hand at the virtual board: presses its input pins as a timeline says, or as somebody types.

[[press]]        of a TOML file             P            typed: press the probe's pin for 0.3 s
pin = "P"                                   press P      and keep it pressed
at_s = 2.5       since the board's power-up     release P
for_s = 0.3
"""

from __future__ import annotations

import heapq
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError, Place
from CNCStepper.virtual.grbl.input_pins import PINS
from CNCStepper.virtual.grbl.machine import Grbl

TAP_S = 0.3
LONGEST_S = 1e6
KEYS = {"pin", "at_s", "for_s"}
ADVICE = f"write [[press]] with pin (one of {', '.join(PINS)}), at_s and, if not {TAP_S:g}, for_s"


class PinPresses:
    """What is still to be pressed and let go at one board, by the board's clock.

    tell: hears what a typed line did, or why it did nothing.
    """

    def __init__(self, board: Grbl, tell: Callable[[str], None] = lambda text: None):
        self._board = board
        self._tell = tell
        self._due: list[tuple[float, bool, str]] = []  # when, pressed, which pin

    def plan(self, path: Path) -> None:
        """Take over the presses of a TOML file; raises JobError naming it where one cannot be."""
        for pin, at_s, for_s in _presses(path):
            self._press(pin, at_s, for_s)

    def on_message(self, line: str) -> None:
        """Do what a typed line says, now."""
        *verb, pin = line.upper().split() or [""]
        if pin not in tuple(PINS) or verb not in ([], ["PRESS"], ["RELEASE"]):
            self._tell(f"'{line[:40]}' is no press: type P, press P or release P; pins are {', '.join(PINS)}")
            return
        (self._board.release if verb == ["RELEASE"] else self._board.press)(pin)
        if not verb:
            heapq.heappush(self._due, (self._board.time_s + TAP_S, False, pin))
        self._tell(f"pins that are on: {self._board.pins() or 'none'}")

    def turn(self) -> None:
        """Press and let go what is due."""
        while self._due and self._due[0][0] <= self._board.time_s:
            _, pressed, pin = heapq.heappop(self._due)
            (self._board.press if pressed else self._board.release)(pin)

    def _press(self, pin: str, at_s: float, for_s: float) -> None:
        heapq.heappush(self._due, (at_s, True, pin))
        heapq.heappush(self._due, (at_s + for_s, False, pin))


def _presses(path: Path) -> list[tuple[str, float, float]]:
    """Return pin, begin and length of each press of a file."""
    place = Place(str(path))
    try:
        content = tomllib.loads(path.read_text("utf-8-sig"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise JobError("toml", f"not a TOML file: {error}", place=place) from error
    if set(content) - {"press"} or not isinstance(content.get("press", []), list):
        raise JobError("press", "a timeline holds nothing but presses", advice=ADVICE, place=place)
    return [_read_press(entry, place) for entry in content.get("press", [])]


def _read_press(entry: Any, place: Place) -> tuple[str, float, float]:
    if not isinstance(entry, dict) or set(entry) - KEYS or entry.get("pin") not in tuple(PINS):
        raise JobError("press", "a press of the timeline is none", value=str(entry)[:60], advice=ADVICE, place=place)
    return entry["pin"], _seconds(entry.get("at_s"), place), _seconds(entry.get("for_s", TAP_S), place)


def _seconds(value: Any, place: Place) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 <= value < LONGEST_S:
        raise JobError("press", "a time of a press is none", value=str(value)[:20], advice=ADVICE, place=place)
    return float(value)
