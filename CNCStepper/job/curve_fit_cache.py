# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ellipses and B-splines of drawings as arcs within a tolerance, from plain data; a window lets the cut process do it.

edge ──► Spline or Ellipse (plain data) ──► fit_of ──► Curve, kept for the next call
                             │
                             └── require, while a window only looks ──► Unfitted: what the process is to be asked
"""

from __future__ import annotations

import hashlib
import itertools
import json
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.fitting.curve_to_arcs import fit_arcs, fit_curve
from CNCStepper.job.deferred_fitting import Unfitted, looks_only

SAMPLED = 0.99  # of the tolerance: the fit measures at samples, between them it may be a little worse
MOST_ROWS = 2_000_000  # arcs and lines that are kept
QUARTERS = 4  # parts of a curve without inner knots, such as a whole ellipse
Flat = tuple[float, float]

_fits: OrderedDict[str, Curve] = OrderedDict()  # by the key of the line and the tolerance, the oldest first
_rows = 0


@dataclass(frozen=True)
class Line:
    """A curved line of a drawing between two of its parameters, as plain data; mm."""

    first: float
    last: float

    @cached_property
    def content(self) -> dict[str, Any]:
        """The line as plain data."""
        return {"kind": type(self).__name__, **{each.name: getattr(self, each.name) for each in fields(self)}}

    @cached_property
    def digest(self) -> str:
        """What names the line."""
        return hashlib.sha256(json.dumps(self.content).encode("ascii")).hexdigest()

    def key(self, tolerance_mm: float) -> str:
        """Return what names the fit of this line with a tolerance."""
        return f"{self.digest} {tolerance_mm!r}"

    def points(self, at: np.ndarray) -> np.ndarray:
        """Return the places at parameters, float64[m, 2]."""
        raise NotImplementedError

    def fit(self, tolerance_mm: float) -> Curve:
        """Return the line in quarters, so that an ellipse comes out symmetrical; raises GeometryError."""
        bounds = np.linspace(self.first, self.last, QUARTERS + 1).tolist()
        return joined(fit_arcs(self.points, *span, tolerance_mm) for span in itertools.pairwise(bounds))


@dataclass(frozen=True)
class Ellipse(Line):
    """centre + cos(t) major + sin(t) minor."""

    centre: Flat
    major: Flat
    minor: Flat

    def points(self, at: np.ndarray) -> np.ndarray:
        """Return the places at angles in radians, float64[m, 2]."""
        return np.array(self.centre) + np.outer(np.cos(at), self.major) + np.outer(np.sin(at), self.minor)


@dataclass(frozen=True)
class Spline(Line):
    """A B-spline. knots: repeated by their multiplicity; period: 0 for one that is not periodic.

    corners: whether its corners and cusps are looked for, which may lie at its knots.
    """

    degree: int
    poles: tuple[Flat, ...]
    weights: tuple[float, ...]
    knots: tuple[float, ...]
    period: float = 0.0
    corners: bool = True

    def points(self, at: np.ndarray) -> np.ndarray:
        """Return the places at parameters, float64[m, 2], by de Boor's recursion."""
        (knots, rows), degree = self._columns, self.degree
        at = self._wrapped(np.asarray(at, float))
        span = np.clip(np.searchsorted(knots, at, side="right") - 1, degree, len(rows) - 1)
        found = rows[span - degree + np.arange(degree + 1)[:, None]]
        for step in range(1, degree + 1):
            at_knot = np.arange(step, degree + 1)[:, None] + span
            low, high = knots[at_knot - degree], knots[at_knot + 1 - step]
            share = ((at - low) / (high - low))[..., None]
            found = (1.0 - share) * found[:-1] + share * found[1:]
        return found[0, :, :2] / found[0, :, 2:]  # type: ignore[no-any-return]

    def fit(self, tolerance_mm: float) -> Curve:
        """Return lines and arcs with a vertex at each corner and cusp; raises GeometryError."""
        if not self.corners:
            return super().fit(tolerance_mm)
        return fit_curve(self.points, self.first, self.last, tolerance_mm, sorted(set(self.knots)))

    @cached_property
    def _columns(self) -> tuple[np.ndarray, np.ndarray]:
        """The knots, and the poles as homogeneous rows."""
        weights = np.array(self.weights)[:, None]
        return np.array(self.knots), np.hstack([np.array(self.poles) * weights, weights])

    def _wrapped(self, at: np.ndarray) -> np.ndarray:
        begin, end = self.knots[self.degree], self.knots[-1 - self.degree]
        outside = (at < begin) | (at > end)
        return np.where(outside, begin + np.mod(at - begin, self.period), at) if self.period else at


KINDS: dict[str, type[Line]] = {"Ellipse": Ellipse, "Spline": Spline}


def fit_of(line: Line, tolerance_mm: float) -> Curve:
    """Return arcs and lines in place of a line, cached or new ones; raises GeometryError."""
    key = line.key(tolerance_mm)
    if key not in _fits:
        _keep(key, line.fit(tolerance_mm * SAMPLED))
    _fits.move_to_end(key)
    return _fits[key]


def require(lines: Sequence[Line], tolerance_mm: float) -> None:
    """Raise Unfitted for lines that are not fitted yet, while a window only collects the work of making objects."""
    missing = [line for line in lines if line.key(tolerance_mm) not in _fits] if looks_only() else []
    if missing:
        raise Unfitted({"fit": [line.content for line in missing], "tolerance_mm": tolerance_mm})


def answer_to(question: dict[str, Any]) -> dict[str, Any]:
    """Return the answer of the cut process: the fits by their keys, as columns; raises GeometryError."""
    tolerance_mm = question["tolerance_mm"]
    lines = [_line(content) for content in question["fit"]]
    curves = [(line.key(tolerance_mm), line.fit(tolerance_mm * SAMPLED)) for line in lines]
    return {"fits": {key: [curve.xy.tolist(), curve.bulge.tolist()] for key, curve in curves}}


def _line(content: dict[str, Any]) -> Line:
    values = dict(content)
    return KINDS[values.pop("kind")](**values)


def take(answer: dict[str, Any]) -> None:
    """Keep the fits of an answer."""
    for key, (xy, bulge) in answer["fits"].items():
        _keep(key, Curve(np.array(xy), np.array(bulge)))


def _keep(key: str, curve: Curve) -> None:
    """Keep a fit; the oldest go where there are too many."""
    global _rows
    _fits[key] = curve
    _rows += len(curve)
    while _rows > MOST_ROWS and len(_fits) > 1:
        _rows -= len(_fits.popitem(last=False)[1])
