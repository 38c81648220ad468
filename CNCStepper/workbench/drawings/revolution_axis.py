# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axis of a solid of revolution, and whether it is one: every normal of its faces must meet the axis."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError, Text

ECCENTRIC_MM = 0.001  # how far a face's normal may pass the axis
SAMPLES = 7  # of a face along each parameter
SPLINE_SAMPLES = 25  # of a face that is a spline
NO_AXIS = 1e-9  # moments of inertia whose shares differ by less are one


@dataclass(frozen=True)
class Axis:
    """A line: a point on it in mm and its direction, of length 1."""

    point: np.ndarray
    direction: np.ndarray

    def passed_mm(self, places: np.ndarray, normals: np.ndarray) -> np.ndarray:
        """Return how far each normal, float64[n, 3], passes the axis; of one that is parallel to it 0."""
        return np.abs(np.einsum("ij,ij->i", places - self.point, np.cross(normals, self.direction)))


def axis_of(solid: Any, label: str) -> Axis:
    """Return the axis of a solid of revolution, towards +Z, else +X, else +Y; raises GeometryError with the place.

    The place is where the solid is furthest from being one about the likeliest axis.
    """
    samples = [_samples(face) for face in solid.Faces]
    places, normals = (np.concatenate([sample[side] for sample in samples]) for side in (0, 1))
    tried = [(axis, axis.passed_mm(places, normals)) for axis in _candidates(solid)]
    if not tried:
        raise _no_revolution(label, "it has no face with an axis", tuple(solid.CenterOfMass))
    axis, passed_mm = min(tried, key=lambda one: float(np.sum(one[1] > ECCENTRIC_MM)))
    worst = int(np.argmax(passed_mm))
    if passed_mm[worst] > ECCENTRIC_MM:
        value = Text("a face's normal passes the axis by {passed:.4g} mm", passed=float(passed_mm[worst]))
        raise _no_revolution(label, value, tuple(places[worst].tolist()))
    return axis


def _no_revolution(label: str, why: str, place: tuple[float, ...]) -> GeometryError:
    x, y, z = place
    return GeometryError(
        "solid-revolution",
        Text("'{label}' is no solid of revolution", label=label),
        value=Text("{why}, at X {x:.4g} Y {y:.4g} Z {z:.4g}", why=why, x=x, y=y, z=z),
        limit=f"{ECCENTRIC_MM} mm",
        advice="take out what is not turned (keyways, flats, cross holes), or draw its half profile",
    )


def _samples(face: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return places of a face's surface and its normals there, float64[n, 3] each."""
    import Part

    is_spline = isinstance(face.Surface, Part.BSplineSurface | Part.BezierSurface)
    count = SPLINE_SAMPLES if is_spline else SAMPLES
    u_first, u_last, v_first, v_last = face.ParameterRange
    inside = (np.arange(count) + 0.5) / count
    pairs = itertools.product(u_first + inside * (u_last - u_first), v_first + inside * (v_last - v_first))
    at = [(float(u), float(v)) for u, v in pairs]
    return tuple(np.array([tuple(find(*pair)) for pair in at]) for find in (face.valueAt, face.normalAt))  # type: ignore[return-value]


def _candidates(solid: Any) -> Iterator[Axis]:
    """Yield the axes that a solid may have, those of its largest faces first, then its axis of inertia."""
    for face in sorted(solid.Faces, key=lambda face: -face.Area):
        for point, direction in (("Center", "Axis"), ("Location", "Direction")):  # a plane has neither pair
            if hasattr(face.Surface, point) and hasattr(face.Surface, direction):
                yield _axis(getattr(face.Surface, point), getattr(face.Surface, direction))
    middle, inertia = solid.CenterOfMass, solid.PrincipalProperties
    moments = np.array(inertia["Moments"])
    for number in range(3):
        others = np.delete(moments, number)
        if np.ptp(others) <= NO_AXIS * moments.max():
            yield _axis(middle, inertia[("FirstAxisOfInertia", "SecondAxisOfInertia", "ThirdAxisOfInertia")[number]])


def _axis(point: Any, direction: Any) -> Axis:
    along = np.array(tuple(direction)) / np.linalg.norm(tuple(direction))
    along[np.abs(along) < 1e-12] = 0.0
    first = next(value for value in along[[2, 0, 1]] if value)
    return Axis(np.array(tuple(point)), along if first > 0 else -along)
