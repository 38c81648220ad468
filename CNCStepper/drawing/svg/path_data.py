# SPDX-License-Identifier: LGPL-2.1-or-later
"""The `d` of an SVG path, and the basic shapes, drawn with pens where the page has them.

Each point is placed by the transform at once. Circular arcs stay arcs under transforms that keep circles; all other
elliptic arcs become Bezier curves of at most 22.5 degrees, which are 7e-8 of the radius off.
Source: SVG 1.1, second edition, chapter 8 and appendix F.6.
"""

from __future__ import annotations

import cmath
import itertools
import math
import re

from CNCStepper.drawing.svg.matrices import NUMBER, Matrix
from CNCStepper.geometry.fitting.bezier_path import PathPen

COMMAND = re.compile(r"([MmZzLlHhVvCcSsQqTtAa])([^MmZzLlHhVvCcSsQqTtAa]*)")
FLAG = re.compile("[01]")
ARC = (NUMBER, NUMBER, NUMBER, FLAG, FLAG, NUMBER, NUMBER)  # radii, rotation, large, positive, end
BETWEEN = re.compile(r"[\s,]*", re.ASCII)
SEPARATORS = " ,\t\r\n\f"
COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
PART_RAD = math.pi / 8.0
ROUND = 1e-9  # radii that differ by less, relatively, are one
LARGEST = 1e15


class PathDamage(ValueError):
    """A place of a path from which on it cannot be read."""


class PlacedPen:
    """Draws subpaths in user units; their points are placed by a matrix."""

    def __init__(self, matrix: Matrix):
        self._matrix, self._circles, self._sense = matrix, matrix.circles, matrix.sense
        self.pens: list[PathPen] = []
        self.closed: list[bool] = []
        self.place = self.start = 0j
        self._open = False

    def move(self, z: complex) -> None:
        """Begin a subpath."""
        self.place = self.start = z
        self._open = False

    def line(self, z: complex) -> None:
        """Draw a line."""
        self._pen().line(self._matrix(z))
        self.place = z

    def lines(self, points: list[complex]) -> None:
        """Draw lines from one point to the next."""
        if points:
            self._pen().lines(self._matrix.placed(points))
            self.place = points[-1]

    def cubic(self, one: complex, other: complex, z: complex) -> None:
        """Draw a Bezier curve of degree 3."""
        self._pen().cubic(*self._matrix.placed((one, other, z)))
        self.place = z

    def quadratic(self, control: complex, z: complex) -> None:
        """Draw a Bezier curve of degree 2."""
        self._pen().quadratic(self._matrix(control), self._matrix(z))
        self.place = z

    def close(self) -> None:
        """Draw a line back to the start of the subpath and end it there."""
        if self._open:
            self.pens[-1].close()
            self.closed[-1] = True
        self.place, self._open = self.start, False

    def arc(self, radii: complex, rotation_deg: float, large: bool, positive: bool, z: complex) -> None:
        """Draw an elliptic arc by its end point; radii that are too small grow (F.6.6)."""
        rx, ry = abs(radii.real), abs(radii.imag)
        if z == self.place:
            return
        if not (rx and ry):
            self.line(z)
            return
        turn = cmath.rect(1.0, math.radians(rotation_deg))
        half = (self.place - z) / 2.0 / turn
        unit = complex(half.real / rx, half.imag / ry)
        grown = max(abs(unit), 1.0)
        rx, ry, unit = rx * grown, ry * grown, unit / grown
        rise = math.sqrt(max(1.0 / abs(unit) ** 2 - 1.0, 0.0)) * (-1.0 if large == positive else 1.0)
        centre = complex(unit.imag, -unit.real) * rise  # on the unit circle's plane, from the chord's middle
        sweep = cmath.phase((-unit - centre) / (unit - centre))
        if positive and sweep < 0.0:
            sweep += math.tau
        elif not positive and sweep > 0.0:
            sweep -= math.tau
        middle = (self.place + z) / 2.0
        frame = Matrix.of(rx, 0.0, 0.0, ry, 0.0, 0.0)
        placed = Matrix(turn, 0j, middle) @ frame @ Matrix(shift=centre)
        self._round(placed, cmath.phase(unit - centre), sweep, z)

    def ellipse(self, centre: complex, rx: float, ry: float) -> None:
        """Draw a whole ellipse from its right end, clockwise as SVG has it (Y down)."""
        self.move(centre + rx)
        self._round(Matrix.of(rx, 0.0, 0.0, ry, centre.real, centre.imag), 0.0, math.tau, centre + rx)
        self.close()

    def _round(self, frame: Matrix, first: float, sweep: float, z: complex) -> None:
        """Draw the part of a unit circle that a frame places, to the point z."""
        placed = self._matrix @ frame
        pen, exact = self._pen(), placed.circles
        parts = max(1, math.ceil(abs(sweep) / (math.pi if exact else PART_RAD) - 1e-9))
        step = sweep / parts
        bulge, reach = placed.sense * math.tan(step / 4.0), 4.0 / 3.0 * math.tan(step / 4.0)
        for part in range(parts):
            begin, end = cmath.rect(1.0, first + part * step), cmath.rect(1.0, first + (part + 1) * step)
            last = self._matrix(z) if part == parts - 1 else placed(end)
            if exact:
                pen.arc(bulge, last)
            else:
                pen.cubic(placed(begin * (1.0 + reach * 1j)), placed(end * (1.0 - reach * 1j)), last)
        self.place = z

    def _pen(self) -> PathPen:
        if not self._open:
            self.pens.append(PathPen(self._matrix(self.place)))
            self.closed.append(False)
            self._open = True
        return self.pens[-1]


def draw_path(pen: PlacedPen, data: str) -> None:
    """Draw the commands of a path; raises PathDamage at the first that is damaged, with those before it drawn."""
    before = "" if data[:1] in ("M", "m") else data[: _begin(data)].strip(SEPARATORS)
    if before and not before.isspace():
        raise PathDamage(f"it begins with {before[:20]!r}")
    first, control = True, None
    for command, arguments in COMMAND.findall(data):
        name = command.upper()
        if first and name != "M":
            raise PathDamage("it does not begin with M")
        first = False
        relative = command != name
        if name == "A":
            _arcs(pen, arguments, relative)
            control = None
        elif name == "Z":
            pen.close()
            control = None
            if arguments.strip(SEPARATORS):
                raise PathDamage(f"numbers behind {command}")
        else:
            control = _run(pen, name, relative, arguments, control)


def _begin(data: str) -> int:
    found = COMMAND.search(data)
    return found.start() if found else len(data)


def _run(pen: PlacedPen, name: str, relative: bool, arguments: str, control: _Control) -> _Control:
    """Draw what one command letter repeats; return the control point that a smooth curve mirrors, and its degree."""
    values, damaged = _values(arguments)
    size = COUNTS[name]
    whole = len(values) - len(values) % size
    damaged = damaged or whole != len(values) or not whole
    if whole and max(max(values), -min(values)) > LARGEST:
        far = next((at for at, value in enumerate(values[:whole]) if abs(value) > LARGEST), whole)
        whole, damaged = far - far % size, True
    if name in "HV":
        _level_lines(pen, values[:whole], name == "H", relative)
        control = None
    else:
        points = list(map(complex, values[:whole:2], values[1:whole:2]))
        control = _drawn(pen, name, points, relative, control)
    if damaged:
        raise PathDamage(f"the numbers of {name} are damaged")
    return control


def _values(arguments: str) -> tuple[list[float], bool]:
    """Return the numbers of a command, and whether anything else stands between them.

    Those with blanks or commas between them are split there, which is quicker.
    """
    if arguments.isascii() and "_" not in arguments:
        try:
            return list(map(float, arguments.replace(",", " ").split())), False
        except ValueError:  # "1-2.5.5"
            pass
    values = list(map(float, NUMBER.findall(arguments)))
    return values, bool(NUMBER.sub("", arguments).strip(SEPARATORS))


_Control = tuple[complex, int] | None


def _level_lines(pen: PlacedPen, values: list[float], along_x: bool, relative: bool) -> None:
    """Draw lines along X or along Y."""
    place = pen.place
    steps = [complex(value, 0.0) if along_x else complex(0.0, value) for value in values]
    fixed = complex(0.0, place.imag) if along_x else complex(place.real, 0.0)
    pen.lines(_run_on(place, steps) if relative else [fixed + step for step in steps])


def _run_on(place: complex, steps: list[complex]) -> list[complex]:
    """Return the points that steps lead to, one after the other."""
    return list(itertools.accumulate(steps, initial=place))[1:]


def _drawn(pen: PlacedPen, name: str, points: list[complex], relative: bool, control: _Control) -> _Control:
    """Draw the segments of a run; return the last control point and the degree, None after lines."""
    if name in "ML":
        ends = _run_on(pen.place, points) if relative else points
        if name == "M" and ends:
            pen.move(ends[0])
            ends = ends[1:]
        pen.lines(ends)
        return None
    size = COUNTS[name] // 2
    for at in range(0, len(points), size):
        base = pen.place if relative else 0j
        row = [base + point for point in points[at : at + size]]
        if name in "CS":
            one = row[0] if name == "C" else _mirrored(pen, control, 3)
            pen.cubic(one, row[-2], row[-1])
            control = row[-2], 3
        else:
            one = row[0] if name == "Q" else _mirrored(pen, control, 2)
            pen.quadratic(one, row[-1])
            control = one, 2
    return control


def _mirrored(pen: PlacedPen, control: _Control, degree: int) -> complex:
    return 2.0 * pen.place - control[0] if control and control[1] == degree else pen.place


def _arcs(pen: PlacedPen, arguments: str, relative: bool) -> None:
    at = _behind_blanks(arguments, 0)
    if at == len(arguments):
        raise PathDamage("an arc without numbers")
    while at < len(arguments):
        (rx, ry, rotation_deg, large, positive, x, y), at = _arc_values(arguments, at)
        if not all(abs(value) <= LARGEST for value in (rx, ry, rotation_deg, x, y)):
            raise PathDamage("a number is out of range")
        end = complex(x, y) + (pen.place if relative else 0j)
        pen.arc(complex(rx, ry), rotation_deg, bool(large), bool(positive), end)


def _arc_values(text: str, at: int) -> tuple[list[float], int]:
    """Return the seven numbers of an arc and where the next one begins; flags need no blanks between them.

    Each number is taken as long as it is, once: a run of digits that is no arc takes no longer than one that is.
    """
    values = []
    for part in ARC:
        match = part.match(text, at)
        if not match:
            raise PathDamage("the numbers of an arc are damaged")
        values.append(float(match[0]))
        at = _behind_blanks(text, match.end())
    return values, at


def _behind_blanks(text: str, at: int) -> int:
    match = BETWEEN.match(text, at)
    return match.end() if match else at


def draw_rectangle(pen: PlacedPen, x: float, y: float, width: float, height: float, rx: float, ry: float) -> None:
    """Draw a rectangle, its corners sharp or round."""
    rx, ry = min(rx, width / 2.0), min(ry, height / 2.0)
    right, low = x + width, y + height
    if not (rx > 0.0 and ry > 0.0):
        draw_points(pen, [complex(x, y), complex(right, y), complex(right, low), complex(x, low)], True)
        return
    radii = complex(rx, ry)
    pen.move(complex(x + rx, y))
    for straight, corner in (
        (complex(right - rx, y), complex(right, y + ry)),
        (complex(right, low - ry), complex(right - rx, low)),
        (complex(x + rx, low), complex(x, low - ry)),
        (complex(x, y + ry), complex(x + rx, y)),
    ):
        pen.line(straight)
        pen.arc(radii, 0.0, False, True, corner)
    pen.close()


def draw_points(pen: PlacedPen, points: list[complex], closed: bool) -> None:
    """Draw a polyline."""
    if points:
        pen.move(points[0])
        pen.lines(points[1:])
        if closed:
            pen.close()
