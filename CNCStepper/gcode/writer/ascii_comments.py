# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comments that are safe on any wire: plain ASCII without the bytes that controllers act upon."""

from __future__ import annotations

import textwrap
import unicodedata

COMMENT_WIDTH = 76
_LETTERS = str.maketrans(
    {
        "ß": "ss",
        "æ": "ae",
        "Æ": "AE",
        "œ": "oe",
        "Œ": "OE",
        "ø": "o",
        "Ø": "O",
        "đ": "d",
        "Đ": "D",
        "ł": "l",
        "Ł": "L",
        "ı": "i",
        "°": " deg",
        "×": "x",
        "÷": "/",
        "µ": "u",
        "±": "+/-",
        "–": "-",
        "—": "-",
        "‘": "'",
        "’": "'",
        "“": '"',
        "”": '"',
        "…": "...",
        "(": "[",
        ")": "]",
        "!": ".",
        "?": ".",
        "~": "-",
        "$": "S",
        ";": ",",
        "%": " percent",
        "\t": " ",
    }
)


def ascii_text(text: str) -> str:
    """Return `text` in printable ASCII without ! ? ~ $ ; % and parentheses; what has no likeness becomes "_"."""
    plain = unicodedata.normalize("NFKD", unicodedata.normalize("NFC", text).translate(_LETTERS)).translate(_LETTERS)
    letters = (character for character in plain if not unicodedata.combining(character))
    return " ".join("".join(letter if " " <= letter <= "\x7e" else "_" for letter in letters).split())


def comment_lines(text: str) -> list[str]:
    """Return `text` as lines of a comment, without what a dialect encloses them in."""
    return textwrap.wrap(ascii_text(text), COMMENT_WIDTH)
