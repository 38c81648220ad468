# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of SVG and CSS as "#rrggbb": names, hexadecimal, rgb(), hsl() and hwb(), with commas or blanks.

Source: CSS Color Module Level 4, chapters 4 to 8. Colours of wider spaces (lab(), color()) are none here.
"""

from __future__ import annotations

import colorsys
import math
import re
from functools import lru_cache

from CNCStepper.drawing.svg.matrices import NUMBER

HEXADECIMAL = re.compile(r"#(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})", re.ASCII)
FUNCTION = re.compile(r"(rgb|hsl|hwb)a?\(([^()]*)\)?", re.ASCII)
VALUE = re.compile(rf"({NUMBER.pattern})(%|deg|rad|turn|grad|)", re.ASCII)
PRINTED = re.compile(r"\s+(?:icc-color|device-cmyk)\(.*")  # beside the colour for a screen
FULL = {"deg": 360.0, "": 360.0, "grad": 400.0, "turn": 1.0, "rad": math.tau}
MOST_COLOUR = 80  # characters
HUES = ("hsl", "hwb")


@lru_cache(4096)
def colour_code(text: str) -> str | None:
    """Return a colour as "#rrggbb", "" for one that is transparent, None for a text that is no colour."""
    word = PRINTED.sub("", text.strip().casefold()[:MOST_COLOUR])
    if word == "transparent":
        return ""
    if HEXADECIMAL.fullmatch(word):
        return _hexadecimal(word[1:])
    function = FUNCTION.fullmatch(word)
    return _of_function(function[1], function[2]) if function else _named(word)


def _hexadecimal(digits: str) -> str:
    if len(digits) < 6:
        digits = "".join(2 * digit for digit in digits)
    return "" if digits[6:] == "00" else f"#{digits[:6]}"


def _named(word: str) -> str | None:
    from PIL import ImageColor

    if word not in ImageColor.colormap:
        return None
    return "#{:02x}{:02x}{:02x}".format(*ImageColor.getrgb(word)[:3])  # the map itself holds numbers once it was asked


def _of_function(name: str, arguments: str) -> str | None:
    """Return the colour of a function's three values, and of a fourth that says how much of it is seen."""
    words = arguments.replace(",", " ").replace("/", " ").split()
    values = [VALUE.fullmatch(word) for word in words]
    if not 3 <= len(values) <= 4 or not all(values):
        return None
    parts = [(float(value[1]), value[2]) for value in values if value]
    if len(parts) == 4 and parts[3][0] <= 0.0:
        return ""
    red, green, blue = _of_hue(name, parts) if name in HUES else (_channel(*part) for part in parts[:3])
    return "#{:02x}{:02x}{:02x}".format(*(_byte(share) for share in (red, green, blue)))


def _of_hue(name: str, parts: list[tuple[float, str]]) -> tuple[float, float, float]:
    """Return red, green and blue, 0 to 1, of a hue and two percentages."""
    (angle, unit), (second, _), (third, _) = parts[:3]
    hue = angle / FULL.get(unit, FULL["deg"]) % 1.0
    second, third = (min(max(value / 100.0, 0.0), 1.0) for value in (second, third))
    if name == "hsl":
        return colorsys.hls_to_rgb(hue, third, second)
    white, black = second, third
    if white + black >= 1.0:
        grey = white / (white + black)
        return grey, grey, grey
    red, green, blue = (share * (1.0 - white - black) + white for share in colorsys.hls_to_rgb(hue, 0.5, 1.0))
    return red, green, blue


def _channel(number: float, unit: str) -> float:
    return number / (100.0 if unit == "%" else 255.0)


def _byte(share: float) -> int:
    return math.floor(min(max(share, 0.0), 1.0) * 255.0 + 0.5)
