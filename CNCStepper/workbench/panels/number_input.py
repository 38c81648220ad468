# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as a person types and reads them, without FreeCAD: separators, and the digits shown."""

from __future__ import annotations

import re

from CNCStepper.workbench.services.translation import later

LARGEST = 1e6  # what a field takes at most: in mm a kilometre
MOST_DECIMALS = 6
LOST = 5e-4  # this share of a value may be lost in showing it
TYPED_ALIKE = str.maketrans({"−": "-", "–": "-", "×": "*", "·": "*", "′": "'", "″": '"', "”": '"', "º": "°", "μ": "µ"})
KNOWN = re.compile(r"[0-9A-Za-zµ°'\"_.,+\-*/^() ]*")
NUMBER = re.compile(r"[0-9.,]*[0-9][0-9.,]*")
MIXED = re.compile(r"(?<![0-9./])([0-9]+) +([0-9]+) */ *([0-9]+)")


class Refused(Exception):
    """Why a text is no value: an English sentence for `tr` with places for values, and the values."""

    def __init__(self, sentence: str, *values: str):
        self.sentence = sentence
        self.values = values
        super().__init__(sentence.format(*values))


def tidied(text: str) -> str:
    """Return a typed number or sum with points as decimal separators and nothing that FreeCAD would pass over.

    One point or comma in a number is its decimal separator, whatever the country; several are refused, for one
    cannot know which of them separates thousands. "1 1/2" becomes a sum. Raises Refused.
    """
    text = " ".join(text.translate(TYPED_ALIKE).split())
    if not text:
        raise Refused(later("A value is missing here"))
    if not KNOWN.fullmatch(text):
        strange = KNOWN.sub("", text)[:1]
        raise Refused(later("'{0}' has no meaning in a number"), strange)
    if not re.search("[0-9]", text):
        raise Refused(later("'{0}' is no number"), shortened(text))
    for number in NUMBER.findall(text):
        if number.count(".") + number.count(",") > 1:
            raise Refused(later("'{0}' has several decimal separators; write 1234.5 or 1234,5"), shortened(number))
    return MIXED.sub(r"(\1+\2/\3)", text.replace(",", "."))


def shown(value: float, decimals: int, point: str = ".") -> str:
    """Return a number with so many decimals, or with more where these would show another value."""
    digits = min(decimals, MOST_DECIMALS)
    while digits < MOST_DECIMALS and abs(round(value, digits) - value) > LOST * abs(value):
        digits += 1
    text = f"{value:.{digits}f}"
    return text.lstrip("-").replace(".", point) if float(text) == 0 else text.replace(".", point)


def shortened(text: str) -> str:
    """Return the beginning of a text, for a sentence at a field."""
    return text if len(text) <= 20 else text[:19] + "…"
