# SPDX-License-Identifier: LGPL-2.1-or-later
"""The answers to a pause of a job: go on, stop, jog, set the zero, override, end stepping."""

from __future__ import annotations

import re
from typing import Any

import click

from CNCStepper.cli.job.override_words import HELP as OVERRIDES
from CNCStepper.cli.job.override_words import read_override

PendingRequests = list[tuple[str, dict[str, Any]]]  # commands of a session with their values

GO_ON: PendingRequests = [("resume", {})]
STOP: PendingRequests = [("stop", {})]
STOP_WORDS = ("s", "stop", "q", "quit", "n", "no")
JOG_FEED_MM_MIN = 500.0
LONGEST_MM = 1000.0
HELP = (
    "press Enter alone to go on or s to stop; x10 y-5 z0.1 jogs (f100: that fast), zero z touches off; "
    f"overrides: {OVERRIDES}"
)
_WAY = re.compile(r"(?:[xyzf]-?(?:\d+\.?\d*|\.\d+) ?)+")
_WORD = re.compile(r"([xyzf])(-?[\d.]+)")
_ZERO = re.compile(r"zero ([xyz]{1,3})")


def read_answer(text: str) -> PendingRequests:
    """Return what an answer asks for; raises ValueError with words where it is none, and for a question mark."""
    words = " ".join(text.lower().split())
    if not words:
        return GO_ON
    if words in STOP_WORDS:
        return STOP
    if words == "all":
        return [("by_line", {"on": False}), *GO_ON]
    if zero := _ZERO.fullmatch(words):
        return [("set_zero", {"axes": zero[1].upper()})]
    if override := read_override(words):
        return [("override", override)]
    if words == "?":
        raise ValueError(HELP)
    return [("jog", _way(words, text))]


def is_end(wishes: PendingRequests) -> bool:
    """Return whether the job leaves its stand with these."""
    return any(name in ("resume", "stop") for name, _ in wishes)


def _way(words: str, text: str) -> dict[str, float]:
    found = _WORD.findall(words)
    values = {letter: float(number) for letter, number in found}
    if not _WAY.fullmatch(words) or len(values) < len(found) or not set(values) & set("xyz"):
        raise ValueError(f"'{text}' is no answer: {HELP}")
    if any(abs(value) > LONGEST_MM for letter, value in values.items() if letter != "f") or values.get("f", 1) <= 0:
        raise ValueError(f"'{text}' is no jog: at most {LONGEST_MM:g} mm, with a feed above 0")
    way = {f"{axis}_mm": values.get(axis, 0.0) for axis in "xyz"}
    return way | {"feed_mm_min": values.get("f", JOG_FEED_MM_MIN)}


class Answer(click.ParamType):
    """One answer; anything else is asked again, for going on moves the machine."""

    name = "answer"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> PendingRequests:
        """Return the wishes of what was typed."""
        try:
            return value if isinstance(value, list) else read_answer(value)
        except ValueError as error:
            self.fail(str(error), param, ctx)
