# SPDX-License-Identifier: LGPL-2.1-or-later
"""Transforms of SVG: the `transform` attribute, viewports, and the page in mm with Y up.

A Matrix maps the point z = x + iy to turn z + mirror conj(z) + shift. It keeps circles where turn or mirror is 0.

    user units ──► transforms of elements ──► viewBox ──► width and height of the page, mm ──► Y up, lower left is zero
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from CNCStepper.tolerances import SAME_SCALE

NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
NUMBER_UNIT = re.compile(rf"{NUMBER.pattern}(?:px|deg)?", re.ASCII)
SHARES = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}
TRANSFORM = re.compile(r"[\s,]*(matrix|(?:translate|scale|skew)[XY]|translate|scale|rotate)\s*\(([^)]*)\)", re.ASCII)
LENGTH = re.compile(rf"\s*({NUMBER.pattern})\s*(px|pt|pc|mm|cm|in|em|ex|q|%|)\s*", re.IGNORECASE | re.ASCII)
MM_OF_UNIT = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72.0, "pc": 25.4 / 6.0, "q": 0.25}
CSS_DPI = 96.0
MOST_TRANSFORMS = 64  # of one attribute
MOST_TEXT = 10_000  # characters of an attribute that holds a few numbers


@dataclass(frozen=True)
class Matrix:
    """A transform of the plane; see the module's text."""

    turn: complex = 1.0 + 0j
    mirror: complex = 0j
    shift: complex = 0j

    @classmethod
    def of(cls, a: float, b: float, c: float, d: float, e: float, f: float) -> Matrix:
        """Return SVG's matrix(a b c d e f): x to a x + c y + e, y to b x + d y + f."""
        return cls(complex(a + d, b - c) / 2.0, complex(a - d, b + c) / 2.0, complex(e, f))

    def __matmul__(self, other: Matrix) -> Matrix:
        """Return the transform that applies `other` first."""
        return Matrix(
            self.turn * other.turn + self.mirror * other.mirror.conjugate(),
            self.turn * other.mirror + self.mirror * other.turn.conjugate(),
            self(other.shift),
        )

    def __call__(self, z: complex) -> complex:
        return self.turn * z + self.mirror * z.conjugate() + self.shift

    @cached_property
    def circles(self) -> bool:
        """Whether circles stay circles."""
        small, large = sorted((abs(self.turn), abs(self.mirror)))
        return small <= SAME_SCALE * large

    @cached_property
    def sense(self) -> float:
        """1 where turns keep their sense, -1 for a mirror image."""
        return 1.0 if abs(self.turn) >= abs(self.mirror) else -1.0

    @property
    def scale(self) -> float:
        """The largest factor by which a length grows."""
        return abs(self.turn) + abs(self.mirror)

    def placed(self, points: Iterable[complex]) -> list[complex]:
        """Return where several points come to."""
        turn, mirror, shift = self.turn, self.mirror, self.shift
        return [turn * z + mirror * z.conjugate() + shift for z in points]

    @property
    def array(self) -> np.ndarray:
        """The transform as curves take it, float64[2, 3]."""
        x, y = self.turn + self.mirror, 1j * (self.turn - self.mirror)
        return np.array([(x.real, y.real, self.shift.real), (x.imag, y.imag, self.shift.imag)])


def numbers(text: str) -> list[float]:
    """Return the numbers of an attribute that holds a few; raises ValueError for one too long or out of range."""
    if len(text) > MOST_TEXT:
        raise ValueError("too many numbers")
    found = [float(word) for word in NUMBER.findall(text)]
    if not all(map(math.isfinite, found)):
        raise ValueError("a number is out of range")
    return found


def transform_of(text: str) -> Matrix:
    """Return the product of an attribute's transforms; raises ValueError for one that is damaged."""
    result, at, count = Matrix(), 0, 0
    while text[at:].strip(" ,\t\r\n"):
        match = TRANSFORM.match(text, at) if len(text) <= MOST_TEXT else None
        count += 1
        if not match or count > MOST_TRANSFORMS:
            raise ValueError("its transform is damaged")
        result, at = result @ _single(match[1], _plain_numbers(match[2])), match.end()
    return result


def _plain_numbers(text: str) -> list[float]:
    """Return the numbers of a transform, pixels and degrees as CSS has them; raises ValueError for other units."""
    if NUMBER_UNIT.sub("", text).strip(" ,\t\r\n"):
        raise ValueError("its transform is damaged")
    return numbers(text)


def about(matrix: Matrix, origin: str, viewport: tuple[float, float]) -> Matrix:
    """Return a transform about its transform-origin, "" for the origin of the user's system; percentages of a viewport.

    Raises ValueError for one that is damaged.
    """
    words = origin.split()[:2]
    if words and words[0] in ("top", "bottom"):
        words.reverse()
    shares = (SHARES.get(word, word) for word in [*words, "center"][:2]) if words else ("0", "0")
    x, y = (length(share, whole, math.nan) for share, whole in zip(shares, viewport, strict=True))
    if not (math.isfinite(x) and math.isfinite(y)):
        raise ValueError("its transform-origin is damaged")
    return Matrix(shift=complex(x, y)) @ matrix @ Matrix(shift=complex(-x, -y))


def _single(name: str, values: list[float]) -> Matrix:
    maker, fewest, most = _MAKERS[name]
    if not fewest <= len(values) <= most:
        raise ValueError(f"its {name} has {len(values)} numbers")
    return maker(values)


def _rotated(values: list[float]) -> Matrix:
    turn = cmath.rect(1.0, math.radians(values[0]))
    centre = complex(*values[1:]) if len(values) == 3 else 0j
    return Matrix(turn, 0j, centre - turn * centre)


_MAKERS: dict[str, tuple[Callable[[list[float]], Matrix], int, int]] = {
    "matrix": (lambda v: Matrix.of(*v), 6, 6),
    "translate": (lambda v: Matrix(shift=complex(*v)), 1, 2),
    "scale": (lambda v: Matrix.of(v[0], 0.0, 0.0, v[-1], 0.0, 0.0), 1, 2),
    "rotate": (_rotated, 1, 3),
    "translateX": (lambda v: Matrix(shift=complex(v[0], 0.0)), 1, 1),
    "translateY": (lambda v: Matrix(shift=complex(0.0, v[0])), 1, 1),
    "scaleX": (lambda v: Matrix.of(v[0], 0.0, 0.0, 1.0, 0.0, 0.0), 1, 1),
    "scaleY": (lambda v: Matrix.of(1.0, 0.0, 0.0, v[0], 0.0, 0.0), 1, 1),
    "skewX": (lambda v: Matrix.of(1.0, 0.0, math.tan(math.radians(v[0])), 1.0, 0.0, 0.0), 1, 1),
    "skewY": (lambda v: Matrix.of(1.0, math.tan(math.radians(v[0])), 0.0, 1.0, 0.0, 0.0), 1, 1),
}


def length(text: str, whole: float, otherwise: float, em: float = 16.0, dpi: float = CSS_DPI) -> float:
    """Return a length in user units; a percentage is one of `whole`; `otherwise` for none, or a damaged one."""
    match = LENGTH.fullmatch(text) if text and len(text) < 64 else None
    if not match:
        return otherwise
    number, unit = float(match[1]), match[2].casefold()
    if not math.isfinite(number):
        return otherwise
    if unit == "%":
        return number / 100.0 * whole
    if unit in ("em", "ex"):
        return number * em * (0.5 if unit == "ex" else 1.0)
    return number * MM_OF_UNIT[unit] * dpi / 25.4 if unit in MM_OF_UNIT else number


def length_mm(text: str) -> float | None:
    """Return a length in mm where it has a unit of its own, None for pixels, percentages and none."""
    match = LENGTH.fullmatch(text) if text and len(text) < 64 else None
    unit = match[2].casefold() if match else ""
    return float(match[1]) * MM_OF_UNIT[unit] if match and unit in MM_OF_UNIT else None


def view_box(text: str) -> tuple[float, float, float, float] | None:
    """Return x, y, width and height of a viewBox, None for none or one of no area."""
    try:
        values = numbers(text)
    except ValueError:
        return None
    if len(values) != 4 or not (values[2] > 0.0 and values[3] > 0.0):
        return None
    return values[0], values[1], values[2], values[3]


def fitted(box: tuple[float, float, float, float], width: float, height: float, how: str) -> Matrix:
    """Return the transform from a viewBox to a viewport at the origin, as preserveAspectRatio says."""
    x, y, box_width, box_height = box
    scale_x, scale_y = width / box_width, height / box_height
    words = how.replace("defer", "").split() or ["xMidYMid"]
    if words[0] == "none":
        return Matrix.of(scale_x, 0.0, 0.0, scale_y, -x * scale_x, -y * scale_y)
    scale = (max if "slice" in words else min)(scale_x, scale_y)
    share_x = next((share for word, share in (("xMin", 0.0), ("xMax", 1.0)) if word in words[0]), 0.5)
    share_y = next((share for word, share in (("YMin", 0.0), ("YMax", 1.0)) if word in words[0]), 0.5)
    left, top = share_x * (width - scale * box_width), share_y * (height - scale * box_height)
    return Matrix.of(scale, 0.0, 0.0, scale, left - x * scale, top - y * scale)
