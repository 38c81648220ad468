# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text from outside (a controller, a drawing, a file's name) made safe to show on a terminal, in a log, in a widget."""

from __future__ import annotations

import unicodedata

# Cc: ESC, BEL, CR … drive a terminal. Cf: bidi marks reorder what is read. Cs: no UTF-8 holds them. Zl, Zp: new lines.
_UNSAFE = {"Cc", "Cf", "Cs", "Zl", "Zp"}


def printable(text: str, most: int = 2000) -> str:
    """Return `text` on one line without control characters: each becomes its escape (\\x1b, \\u202e), a tab a space.

    most: characters kept; of a longer text the rest becomes "…".
    """
    kept = text if len(text) <= most else text[:most] + "…"
    if kept.isascii() and kept.isprintable():
        return kept
    return "".join(map(_printable_character, kept))


def _printable_character(character: str) -> str:
    if character == "\t":
        return " "
    if unicodedata.category(character) in _UNSAFE:
        return (
            character.encode("ascii", "backslashreplace").decode("ascii")
            if ord(character) > 127
            else f"\\x{ord(character):02x}"
        )
    return character
