# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions: `[1 + #2 * SIN[30]]`, evaluated as in RS274/NGC.

    value       number | expression | parameter | function | + value | - value
    expression  [ value { operator value } ]     left to right among operators of one strength
    function    NAME expression | ATAN expression / expression | EXISTS [ parameter ]
    parameter   # whole value | # < name >

The text is packed: without blanks, in capitals. Angles are degrees; what is not 0 is true.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Protocol

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.syntax.words import lower_case
from CNCStepper.tolerances import SAME_NUMBER, WHOLE_NUMBER

_NUMBER = re.compile(r"[+-]?[0-9.]+")
_NAME = re.compile(r"[A-Z]+")
_OPERATOR = re.compile(r"\*\*|[-+*/]|AND|XOR|OR|MOD|EQ|NE|GT|GE|LT|LE")
_DEEPEST = 60
_CLOSE = "]"


class Names(Protocol):
    """The values of the parameters that an expression names; each method raises ProgramError for invalid ones."""

    def number(self, number: int) -> float:
        """Return the value of `#number`."""

    def named(self, name: str) -> float:
        """Return the value of `#<name>`."""

    def exists(self, parameter: int | str) -> bool:
        """Whether there is such a parameter."""


class Scanner:
    """Reads values from packed text, from `position` on; `columns` has the column of each character."""

    def __init__(self, packed: str, columns: list[int], names: Names):
        self.packed = packed
        self.position = 0
        self.columns = columns
        self._names = names
        self._depth = 0

    @property
    def ended(self) -> bool:
        """Whether all is read."""
        return self.position >= len(self.packed)

    @property
    def next(self) -> str:
        """The next character, "" at the end."""
        return self.packed[self.position : self.position + 1]

    @property
    def column(self) -> int:
        """The column of the next character in its line."""
        return self.columns[min(self.position, len(self.columns) - 1)] if self.columns else 1

    def take(self, text: str) -> bool:
        """Go over `text` if it comes next; whether it did."""
        found = self.packed.startswith(text, self.position)
        if found:
            self.position += len(text)
        return found

    def error(self, code: str, what: str, advice: str, begin: int | None = None) -> ProgramError:
        """Return the error for the text at `begin`, or here."""
        at = self.position if begin is None else begin
        column = self.columns[min(at, len(self.columns) - 1)] if self.columns else 1
        end = max(self.position, at + 1) if begin is not None else at + 12
        return ProgramError(code, what, advice=advice, value=self.packed[at:end][:40], place=Place(column=column))

    def value(self) -> float:
        """Read a value; raises ProgramError where there is none or where it is not finite."""
        begin = self.position
        self._depth += 1
        if self._depth > _DEEPEST:
            raise self.error("too-deep", "the expression is nested too deep", "compute it in several lines", begin)
        value = self._value()
        self._depth -= 1
        if not math.isfinite(value):
            raise self.error("not-finite", "the value is no finite number", "correct the expression", begin)
        return value

    def whole(self) -> int:
        """Read a value that must be a whole number."""
        begin = self.position
        value = self.value()
        whole = math.floor(value + 0.5)
        if abs(value - whole) > WHOLE_NUMBER:
            raise self.error(
                "not-whole", Text("{value:g} must be a whole number", value=value), "use ROUND[...]", begin
            )
        return whole

    def name(self) -> str:
        """Read `<name>` and return the name in small letters."""
        begin = self.position
        end = self.packed.find(">", begin)
        if not self.take("<") or end < 0:
            raise self.error("parameter", "the name is not closed", "close it with >", begin)
        self.position = end + 1
        return lower_case(self.packed[begin + 1 : end])

    def expression(self) -> float:
        """Read `[...]`: operators that bind as strongly are worked from left to right."""
        begin = self.position
        if not self.take("["):
            raise self.error("bracket", "an expression begins with [", "put it in brackets")
        values, operators = [self.value()], [self._operator(begin)]
        while operators[0] != _CLOSE:
            values.append(self.value())
            operators.append(self._operator(begin))
            while len(operators) > 1 and _STRENGTH[operators[-1]] <= _STRENGTH[operators[-2]]:
                right = values.pop()
                values[-1] = self._work(values[-1], operators.pop(-2), right, begin)
        return values[0]

    def _value(self) -> float:
        character = self.next
        if character == "[":
            return self.expression()
        if character == "#":
            return self._parameter()
        if character in ("+", "-") and not self._is_number(self.position + 1):
            self.position += 1
            return self.value() if character == "+" else -self.value()
        if character.isalpha():
            return self._function()
        return self._number()

    def _is_number(self, position: int) -> bool:
        return self.packed[position : position + 1] in (*".0123456789",)

    def _number(self) -> float:
        match = _NUMBER.match(self.packed, self.position)
        try:
            value = float(match[0]) if match else math.nan
        except ValueError:
            value = math.nan
        if match is None or math.isnan(value):
            what = Text("{match} is no number", match=match[0]) if match else "a value is missing"
            raise self.error("bad-number", what, "write a number, #parameter or [expression]")
        self.position = match.end()
        return value

    def _parameter(self) -> float:
        begin = self.position
        self.position += 1
        try:
            return self._names.named(self.name()) if self.next == "<" else self._names.number(self.whole())
        except ProgramError as error:
            raise self._placed(error, begin) from None

    def _placed(self, error: ProgramError, begin: int) -> ProgramError:
        """Return the error with the column of what begins at `begin`, if it has none yet."""
        if error.place:
            return error
        return self.error(error.code, error.what, error.advice, begin)

    def _operator(self, begin: int) -> str:
        if self.take(_CLOSE):
            return _CLOSE
        if self.ended:
            raise self.error("bracket", "the expression is not closed", "close it with ]", begin)
        match = _OPERATOR.match(self.packed, self.position)
        if match is None:
            advice = "use + - * / ** MOD EQ NE GT GE LT LE AND OR XOR"
            raise self.error("operator", "an operator is missing or unknown", advice)
        self.position = match.end()
        return match[0]

    def _work(self, left: float, operator: str, right: float, begin: int) -> float:
        try:
            return float(_WORK[operator](left, right))
        except ZeroDivisionError:
            raise self.error(
                "divided-by-zero", "the expression divides by 0", "correct the expression", begin
            ) from None
        except (ValueError, OverflowError):
            what = Text("{left:g} {operator} {right:g} is no finite number", left=left, operator=operator, right=right)
            raise self.error("not-finite", what, "correct the expression", begin) from None

    def _function(self) -> float:
        begin = self.position
        match = _NAME.match(self.packed, begin)
        name = match[0] if match else self.next
        if name not in ("ATAN", "EXISTS", *_FUNCTIONS):
            raise self.error(
                "function",
                Text("there is no function {name}", name=name),
                Text("use {functions} or ATAN", functions=", ".join(_FUNCTIONS)),
                begin,
            )
        self.position = begin + len(name)
        if name == "EXISTS":
            return self._exists()
        argument = self.expression()
        if name == "ATAN":
            if not self.take("/"):
                raise self.error("function", "ATAN needs a second value", "write ATAN[y]/[x]", begin)
            return math.degrees(math.atan2(argument, self.expression()))
        try:
            return float(_FUNCTIONS[name](argument))
        except (ValueError, OverflowError):
            what = Text("{name} has no value for {argument:g}", name=name, argument=argument)
            raise self.error("domain", what, "correct the expression", begin) from None

    def _exists(self) -> float:
        begin = self.position
        if not self.take("[#"):
            raise self.error("function", "EXISTS asks for a parameter", "write EXISTS[#<name>]", begin)
        parameter = self.name() if self.next == "<" else self.whole()
        if not self.take("]"):
            raise self.error("bracket", "the expression is not closed", "close it with ]", begin)
        return float(self._names.exists(parameter))


def _power(left: float, right: float) -> float:
    if left == 0 and right < 0:
        raise OverflowError
    value = left**right
    if isinstance(value, complex):
        raise ValueError
    return value


def _modulo(left: float, right: float) -> float:
    """Return the remainder, never negative."""
    rest = math.fmod(left, right)
    return rest + abs(right) if rest < 0 else rest


def _rounded(value: float) -> float:
    return math.trunc(value + math.copysign(0.5, value))


_WORK: dict[str, Callable[[float, float], float]] = {
    "**": _power,
    "*": lambda left, right: left * right,
    "/": lambda left, right: left / right,
    "MOD": _modulo,
    "+": lambda left, right: left + right,
    "-": lambda left, right: left - right,
    "EQ": lambda left, right: abs(left - right) < SAME_NUMBER,
    "NE": lambda left, right: abs(left - right) >= SAME_NUMBER,
    "GT": lambda left, right: left > right,
    "GE": lambda left, right: left >= right,
    "LT": lambda left, right: left < right,
    "LE": lambda left, right: left <= right,
    "AND": lambda left, right: left != 0 and right != 0,
    "OR": lambda left, right: left != 0 or right != 0,
    "XOR": lambda left, right: (left != 0) != (right != 0),
}
_STRENGTH = {
    _CLOSE: 0,
    **dict.fromkeys(("AND", "OR", "XOR"), 1),
    **dict.fromkeys(("EQ", "NE", "GT", "GE", "LT", "LE"), 2),
    **dict.fromkeys(("+", "-"), 3),
    **dict.fromkeys(("*", "/", "MOD"), 4),
    "**": 5,
}
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "ABS": abs,
    "ACOS": lambda value: math.degrees(math.acos(value)),
    "ASIN": lambda value: math.degrees(math.asin(value)),
    "COS": lambda value: math.cos(math.radians(value)),
    "EXP": math.exp,
    "FIX": math.floor,
    "FUP": math.ceil,
    "LN": math.log,
    "ROUND": _rounded,
    "SIN": lambda value: math.sin(math.radians(value)),
    "SQRT": math.sqrt,
    "TAN": lambda value: math.tan(math.radians(value)),
}
