# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as they are written: how many decimals a program has, and a new number in the manner of the old one."""

from __future__ import annotations

import math

from CNCStepper.gcode.dialects import Dialect

DECIMALS = {"mm": 3, "inch": 4}
MOST_DECIMALS = 9
FEED_DIGITS = 4  # significant ones


def decimals_of(written: str) -> int:
    """Return the number of digits after the point."""
    return len("".join(written.split()).partition(".")[2])


def dialect_decimals(dialect: Dialect, units: str) -> int:
    """Return the digits after the point that programs of this dialect have."""
    return (dialect.writing.decimals if dialect.writing else DECIMALS)[units]


def feed_decimals(feed: float, least: int) -> int:
    """Return the digits after the point that make a feed right to a thousandth: at least `least`, where it is 0 with
    these too."""
    if feed < 0.5 / 10**least:
        return least
    return max(least, FEED_DIGITS - 1 - math.floor(math.log10(feed)))


def number_text(value: float, decimals: int, least: int = 0, like: str = "") -> str:
    """Return `value` rounded to `decimals` digits, without zeros at its end beyond `least` of them; never -0.

    like: the number that it takes the place of: its bare point ("5.") or missing zero (".5") is kept.
    """
    text = f"{value:.{decimals}f}"
    if "." in text:
        whole, rest = text.split(".")
        rest = rest.rstrip("0").ljust(min(least, decimals), "0")
        text = f"{whole}.{rest}" if rest else whole + "." * like.rstrip().endswith(".")
    elif like.rstrip().endswith("."):
        text += "."
    if not text.strip("-0."):
        text = text.lstrip("-")
    if like.lstrip("+- \t").startswith(".") and text.lstrip("-").startswith("0.") and text.strip("-0."):
        text = text.replace("0.", ".", 1)
    return text
