# SPDX-License-Identifier: LGPL-2.1-or-later
"""The value of a word while it is edited: a number, or an expression with what is done to it around it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from CNCStepper.gcode.edit.line_tokens import Token
from CNCStepper.gcode.edit.number_format import decimals_of, number_text

FACTOR_DIGITS = 12


@dataclass(frozen=True)
class Value:
    """number + the sum of factor * expression; expressions are copied as written."""

    number: float
    parts: tuple[tuple[float, str], ...] = ()

    @classmethod
    def of(cls, token: Token, factor: float) -> Value:
        """Return a word's value, times a factor."""
        if token.number is None:
            return cls(0.0, ((factor, token.written),))
        return cls(token.number * factor)

    @classmethod
    def total(cls, terms: Iterable[tuple[float, Value]], shift: float) -> Value:
        """Return the sum of values times factors, and a number."""
        number, parts = float(shift), []
        for factor, value in terms:
            number += float(factor) * value.number
            parts += [(float(factor) * own, text) for own, text in value.parts if factor]
        return cls(number, tuple(parts))

    @property
    def is_number(self) -> bool:
        """Whether no expression is part of it."""
        return not self.parts

    def times(self, factor: float) -> Value:
        """Return it multiplied."""
        return Value.total([(factor, self)], 0.0)

    def plus(self, number: float) -> Value:
        """Return it with a number added."""
        return Value(self.number + number, self.parts)

    def is_same(self, token: Token, factor: float) -> bool:
        """Whether it equals a word with an expression."""
        return self.parts == ((factor, token.written),) and not self.number

    def text(self, decimals: int, like: str = "") -> str:
        """Return it as it is written, in the manner of `like`: a number, or an expression in brackets."""
        if self.is_number:
            least = decimals_of(like) if like and not like.startswith(("[", "#")) else 0
            return number_text(self.number, decimals, least, like if like and like[0] not in "[#" else "")
        if len(self.parts) == 1 and round(self.parts[0][0], FACTOR_DIGITS) == 1.0 and not self.number:
            return self.parts[0][1]
        terms = [_term(factor, text) for factor, text in self.parts]
        if round(self.number, decimals):
            terms.append(
                f"[{number_text(self.number, decimals)}]" if self.number < 0 else number_text(self.number, decimals)
            )
        return f"[{' + '.join(terms)}]"


def _term(factor: float, text: str) -> str:
    rounded = round(factor, FACTOR_DIGITS)
    whole = text if text.startswith(("[", "#")) else f"[{text}]"
    if rounded == 1.0:
        return whole
    number = number_text(rounded, FACTOR_DIGITS)
    return f"{whole} * {f'[{number}]' if rounded < 0 else number}"
