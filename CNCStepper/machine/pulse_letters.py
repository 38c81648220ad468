# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pulse letters of the USB board (source system D): which axes each letter moves by one step.

A +X   B +Y   C +Z   D -X   E -Y   F -Z       G to L two axes, one sense      M to R two axes, both senses
S +X+Y+Z   T -X-Y-Z   U to Z three axes
"""

from __future__ import annotations

AXES = "XYZ"
COMMAND = "$L="  # begins a line of letters to a CNCStepper controller
_TABLE = """
A+X B+Y C+Z D-X E-Y F-Z   G+X+Y H+X+Z I+Y+Z J-X-Y K-X-Z L-Y-Z   M+X-Y N-X+Y O+X-Z P-X+Z Q+Y-Z R-Y+Z
S+X+Y+Z T-X-Y-Z U+X-Y-Z V-X+Y-Z W-X-Y+Z X-X+Y+Z Y+X-Y+Z Z+X+Y-Z
"""
MOVES = {entry[0]: entry[1:] for entry in _TABLE.split()}


def letter_steps(letter: str) -> tuple[int, ...]:
    """Return the steps of X, Y and Z of a letter, none where it only switches; raises KeyError for another."""
    if letter.islower():
        return (0, 0, 0)
    move = MOVES[letter]
    return tuple(int(f"{move[move.index(axis) - 1]}1") if axis in move else 0 for axis in AXES)
