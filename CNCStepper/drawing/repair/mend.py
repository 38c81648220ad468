# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing mended within limits, and a list of every change.

    chains of a layer and colour ──► without doubles ──► without tiny ones ──► ends joined ──► gaps closed ──► fitted
                                     doubles.py                                                           (on request)

What is beyond the limits stays as it is: an open contour is closed only across a gap that the limits allow.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.repair.doubles import doubles_of
from CNCStepper.drawing.repair.problems import RepairLimits, begin_of, grouped, is_tiny
from CNCStepper.errors import Text
from CNCStepper.geometry.chain_joining import Gap, nearly_meeting, numbered_chains
from CNCStepper.geometry.curve import Curve, joined, straight
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.tolerances import JOINED_ENDS_MM

ChangeKind = Literal["double", "tiny", "joined", "closed", "fitted"]
CHANGES: dict[ChangeKind, str] = {
    "double": "stretches drawn twice were taken out",
    "tiny": "tiny chains were taken out",
    "joined": "ends were moved together",
    "closed": "gaps were closed",
    "fitted": "chains have fewer lines and arcs",
}
LEAST_TURN = 0.05  # of two lines at a corner: the sine of their angle
Numbered = list[tuple[int, Curve]]


@dataclass(frozen=True)
class Change:
    """One thing that was mended: where, and its length or size, mm; for a fit how many segments fewer."""

    kind: ChangeKind
    layer: str
    place_mm: tuple[float, float]
    size: float

    @property
    def text(self) -> str:
        """The change for a person."""
        x, y = self.place_mm
        size = f"{self.size:.0f} segments fewer" if self.kind == "fitted" else f"{self.size:.4g} mm"
        return Text("{kind} on layer '{layer}' at X{x:.3f} Y{y:.3f}, {size}",
                    kind=self.kind, layer=self.layer, x=x, y=y, size=size)  # fmt: skip


def mended(drawing: Drawing, limits: RepairLimits) -> tuple[Drawing, tuple[Change, ...]]:
    """Return the drawing mended within the limits, chains in their order, and every change that was made.

    Raises GeometryError where too many lines lie on each other.
    """
    chains: list[tuple[int, Chain]] = []
    gaps: list[tuple[str, Gap]] = []
    changes: list[Change] = []
    for (layer, _), own in grouped(drawing.chains).items():
        checkpoint()
        mender = _Mender(layer, limits)
        numbered = mender.mend([(number, chain.curve) for number, chain in own])
        attributes = {number: chain.attributes for number, chain in own}
        chains += [(number, Chain(curve, attributes[number])) for number, curve in numbered]
        gaps += [(layer, gap) for gap in mender.gaps]
        changes += mender.changes
    ordered = tuple(chain for _, chain in sorted(chains, key=lambda row: row[0]))
    return replace(drawing, chains=ordered, gaps=tuple(gaps)), tuple(changes)


class _Mender:
    """Mends the chains of one layer and colour; each keeps the number of its first piece."""

    def __init__(self, layer: str, limits: RepairLimits):
        self._layer, self._limits = layer, limits
        self.gaps: tuple[Gap, ...] = ()
        self.changes: list[Change] = []

    def mend(self, curves: Numbered) -> Numbered:
        """Return the curves mended."""
        curves = self._without_doubles(curves)
        curves = list(self._without_tiny(curves))
        curves = self._joined(curves)
        curves = self._closed(curves)
        return list(self._fitted(curves)) if self._limits.fit_mm else curves

    def _note(self, kind: ChangeKind, place_mm: tuple[float, float], size: float) -> None:
        self.changes.append(Change(kind, self._layer, place_mm, size))

    def _without_doubles(self, curves: Numbered) -> Numbered:
        found = doubles_of([curve for _, curve in curves], self._limits.double_mm)
        for place_mm, length_mm in found.places():
            self._note("double", place_mm, length_mm)
        left = found.remaining()
        shortest_mm = 2.0 * self._limits.double_mm  # remains of what both drawings of a line differ by
        return [
            (number, part)
            for index, (number, curve) in enumerate(curves)
            for part in left.get(index, [curve])
            if index not in left or part.length_mm > shortest_mm
        ]

    def _without_tiny(self, curves: Numbered) -> Iterator[tuple[int, Curve]]:
        for number, curve in curves:
            chain = Chain(curve, Attributes())
            if is_tiny(chain, self._limits):
                self._note("tiny", begin_of(chain), curve.length_mm)
            else:
                yield number, curve

    def _joined(self, curves: Numbered) -> Numbered:
        """Return the chains of the open curves whose ends lie within the tolerance of joining."""
        ends = [curve for _, curve in curves if not curve.closed]
        for _, (a, b) in nearly_meeting(ends, self._limits.join_mm):
            if abs(a - b) > JOINED_ENDS_MM:
                self._note("joined", ((a + b).real / 2.0, (a + b).imag / 2.0), abs(a - b))
        return self._chained(curves, self._limits.join_mm)

    def _chained(self, curves: Numbered, same_mm: float) -> Numbered:
        chains, self.gaps = numbered_chains([curve for _, curve in curves], same_mm, self._limits.close_mm)
        return [(curves[index][0], curve) for index, curve in chains.items()]

    def _closed(self, curves: Numbered) -> Numbered:
        """Return the curves with the gaps that the limits allow closed: at the corner of two lines, else by a line."""
        loose = [index for index, (_, curve) in enumerate(curves) if not curve.closed]
        meeting = nearly_meeting([curves[index][1] for index in loose], self._limits.close_mm)
        if not meeting:
            return curves
        changed = {index: curves[index][1] for index in loose}
        bridges: Numbered = []
        for (one, other), (a, b) in meeting:
            self._note("closed", ((a + b).real / 2.0, (a + b).imag / 2.0), abs(a - b))
            first, second = loose[one // 2], loose[other // 2]
            corner = corner_of(changed[first], one % 2, changed[second], other % 2, self._limits.close_mm)
            if corner is None:
                bridges.append((curves[first][0], straight((a.real, a.imag), (b.real, b.imag))))
            else:
                changed[first] = _ended_at(changed[first], one % 2, corner)
                changed[second] = _ended_at(changed[second], other % 2, corner)
        whole = [(number, changed.get(index, curve)) for index, (number, curve) in enumerate(curves)]
        return self._chained([*whole, *bridges], JOINED_ENDS_MM)

    def _fitted(self, curves: Numbered) -> Iterator[tuple[int, Curve]]:
        for number, curve in curves:
            checkpoint()
            fitted = fewer_segments(curve, self._limits.fit_mm)
            if len(fitted) < len(curve):
                self._note("fitted", begin_of(Chain(curve, Attributes())), len(curve) - len(fitted))
                yield number, fitted
            else:
                yield number, curve


def corner_of(one: Curve, one_end: int, other: Curve, other_end: int, most_mm: float) -> complex | None:
    """Return where the lines at two ends cross, at most `most_mm` from both ends; None for arcs and for no such place.

    An end is 0 for the begin of a curve, 1 for its end. A line is shortened to less than its length, never turned.
    """
    (a, along_a, long_a), (b, along_b, long_b) = _end_line(one, one_end), _end_line(other, other_end)
    turn = (along_a.conjugate() * along_b).imag
    if min(long_a, long_b) == 0.0 or abs(turn) < LEAST_TURN:
        return None
    beyond_a = ((b - a).conjugate() * along_b).imag / turn
    beyond_b = ((b - a).conjugate() * along_a).imag / turn
    if max(abs(beyond_a), abs(beyond_b)) > most_mm or beyond_a <= -long_a or beyond_b <= -long_b:
        return None
    return a + beyond_a * along_a


def _end_line(curve: Curve, end: int) -> tuple[complex, complex, float]:
    """Return the end of a curve, the direction out of it, and the length of the line there; 0 where it is an arc."""
    at, inner = (curve.xy[-1], curve.xy[-2]) if end else (curve.xy[0], curve.xy[1])
    out = complex(*(at - inner))
    bulge = curve.bulge[-1] if end else curve.bulge[0]
    return complex(*at), out / (abs(out) or 1.0), abs(out) if bulge == 0.0 else 0.0


def _ended_at(curve: Curve, end: int, place: complex) -> Curve:
    xy = curve.xy.copy()
    xy[-1 if end else 0] = (place.real, place.imag)
    return Curve(xy, curve.bulge.copy())


def fewer_segments(curve: Curve, tolerance_mm: float) -> Curve:
    """Return a curve with each run of lines as few lines and arcs within the tolerance; its own arcs stay exact."""
    bounds = np.flatnonzero(np.diff(curve.bulge != 0.0, prepend=True, append=True)).tolist()
    runs = list(zip(bounds[::2], bounds[1::2], strict=True))
    if not any(last - first > 2 for first, last in runs):
        return curve
    return joined(_fitted_parts(curve, runs, tolerance_mm))


def _fitted_parts(curve: Curve, runs: Iterable[tuple[int, int]], tolerance_mm: float) -> Iterator[Curve]:
    """Yield runs of lines fitted, and what lies between them as it is."""
    done = 0
    for first, last in runs:
        if first > done:
            yield Curve(curve.xy[done : first + 1], curve.bulge[done:first])
        lines = Curve(curve.xy[first : last + 1], curve.bulge[first:last])
        yield refitted(lines, tolerance_mm) if last - first > 2 and lines.length_mm > tolerance_mm else lines
        done = last
    if done < len(curve):
        yield Curve(curve.xy[done:], curve.bulge[done:])
