# SPDX-License-Identifier: LGPL-2.1-or-later
"""One entity of a DXF drawing as a curve in the drawing's own unit, by its kind.

Lines, arcs, circles and polylines with bulges come over exactly, ellipses and splines as arcs within a
tolerance. An entity drawn seen from below (extrusion -Z, as mirrored ones are) is turned to lie as seen from above.

Fitting takes 3 µs for each place of a curve that is looked at: `Fits` counts them, and fits equal ellipses once.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.dxf.plain_entities import FLAT, LARGEST
from CNCStepper.errors import GeometryError, JobError, Text
from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.fitting.curve_to_arcs import Function, fit_arcs, fit_curve
from CNCStepper.safe_text import printable
from CNCStepper.tolerances import COINCIDENT_MM

ROUND = 1e-9  # an ellipse whose axes differ by less, relatively, is a circle
BROKEN = (ArithmeticError, AttributeError, LookupError, RuntimeError, TypeError, ValueError)
MOST_WORDS = 255
REDRAW = "draw it again, or make a polyline of it"
ON_XY = "draw it on the XY plane or on one parallel to it"
MOST_DEGREE = 25
MOST_SAMPLES = 20_000_000  # places of a curve that are looked at
MOST_SAMPLES_OF_ALL = 40_000_000  # the same, of all curves of a drawing: about a minute
ELLIPSE_DIGITS = 12  # of the axes of two ellipses that are one: what placing a block leaves of them
KNOTS_AT_ONCE = 8  # the fit looks at all of a stretch again and again: long ones would take time with their square


class Fits:
    """What the fits of one drawing share: their tolerance in its unit, the places looked at, the ellipses so far."""

    def __init__(self, tolerance: float):
        self.tolerance = tolerance
        self._looked_at = 0
        self._ellipses: dict[tuple[float, ...], Curve] = {}

    def counted(self, point: Function) -> Function:
        """Return the function of a curve that ends what takes too long.

        It raises GeometryError where this curve alone does, JobError where all of the drawing do.
        """
        most = self._looked_at + MOST_SAMPLES

        def counting(t: np.ndarray) -> np.ndarray:
            checkpoint()
            self._looked_at += len(t)
            if self._looked_at > MOST_SAMPLES_OF_ALL:
                raise _too_long()
            if self._looked_at > most:
                raise GeometryError("dxf-spline", "it is too long for its tolerance", advice="take a larger tolerance")
            return point(t)

        return counting

    def ellipse(self, major: float, minor: float, first: float, sweep: float) -> Curve:
        """Return an ellipse round the origin, its major axis along X, counter-clockwise."""
        lengths = (float(f"{length:.{ELLIPSE_DIGITS}g}") for length in (major, minor))
        key = (*lengths, first, sweep)
        if key not in self._ellipses:
            self._ellipses[key] = _level_ellipse(self, *key)
        return self._ellipses[key]


Reader = Callable[[Any, Fits], Curve]


def _too_long() -> JobError:
    what = "the splines and ellipses of the drawing are too many and too wild for the tolerance"
    return JobError("dxf-large", what, advice="take a larger tolerance_mm, or draw polylines or arcs in their place")


def curve_of(entity: Any, fits: Fits) -> Curve:
    """Return an entity as a curve in its unit; raises GeometryError with the reason when it is none."""
    reader = READERS.get(entity.dxftype())
    if reader is None:
        advice = "draw it as lines, arcs, circles, polylines, ellipses or splines"
        raise GeometryError("dxf-kind", "nothing that a tool could follow", advice=advice)
    _require_numbers(entity)
    try:
        curve = reader(entity, fits)
    except (GeometryError, JobError):
        raise
    except BROKEN as error:  # of ezdxf and numpy, on numbers that make no curve
        why = printable(str(error), MOST_WORDS) or type(error).__name__
        raise GeometryError("dxf-broken", Text("its numbers make no curve: {why}", why=why), advice=REDRAW) from error
    if curve.length_mm <= COINCIDENT_MM:
        raise GeometryError("curve-short", "the curve has no length", advice="draw it larger, or leave it out")
    return curve


def _require_numbers(entity: Any) -> None:
    """Raise GeometryError for an attribute that is no number, or too large a one."""
    for name, value in entity.dxfattribs().items():
        if not _within(value):
            raise GeometryError(
                "dxf-number",
                Text("its {name} is no number in bounds", name=name),
                limit=f"{LARGEST:g}",
                advice=REDRAW,
            )


def _within(value: Any) -> bool:
    """Return whether a value of ezdxf's, a number or a vector, is within the bounds; texts are."""
    numbers = (value,) if isinstance(value, int | float) else getattr(value, "xyz", ())
    return all(abs(number) <= LARGEST for number in numbers)  # false for NaN


def _line(entity: Any, _: Fits) -> Curve:
    begin, end = entity.dxf.start, entity.dxf.end
    _require_level([begin.z, end.z])
    return Curve(np.array([(begin.x, begin.y), (end.x, end.y)]), np.zeros(1))


def _arc(entity: Any, _: Fits) -> Curve:
    first, last = math.radians(entity.dxf.start_angle), math.radians(entity.dxf.end_angle)
    sweep = (last - first) % math.tau or math.tau
    return from_above(entity, round_arc(entity.dxf.center, entity.dxf.radius, first, sweep))


def _circle(entity: Any, _: Fits) -> Curve:
    return from_above(entity, round_arc(entity.dxf.center, entity.dxf.radius, 0.0, math.tau))


def round_arc(centre: Any, radius: float, first_rad: float, sweep_rad: float) -> Curve:
    """Return an arc in parts of at most a half turn, exactly closed when it is a whole one."""
    parts = max(1, math.ceil(abs(sweep_rad) / math.pi - 1e-9))
    angles = first_rad + sweep_rad * np.linspace(0.0, 1.0, parts + 1)
    xy = np.column_stack([centre.x + abs(radius) * np.cos(angles), centre.y + abs(radius) * np.sin(angles)])
    if math.isclose(abs(sweep_rad), math.tau, rel_tol=1e-12):
        xy[-1] = xy[0]
    return Curve(xy, np.full(parts, math.tan(sweep_rad / parts / 4.0)))


def _light_polyline(entity: Any, _: Fits) -> Curve:
    points = np.array(entity.get_points("xyb"), float).reshape(-1, 3)
    require_finite(points)
    return from_above(entity, bulged(points, bool(entity.closed)))


def _polyline(entity: Any, _: Fits) -> Curve:
    if not (entity.is_2d_polyline or entity.is_3d_polyline):
        raise GeometryError("dxf-mesh", "a mesh and no line", advice="draw its outline as a polyline")
    vertices = [vertex for vertex in entity.vertices if not vertex.dxf.flags & vertex.SPLINE_FRAME_CONTROL_POINT]
    rows = [(*vertex.dxf.location, vertex.dxf.get("bulge", 0.0)) for vertex in vertices]
    columns = np.array(rows, float).reshape(-1, 4)
    require_finite(columns)
    _require_level(columns[:, 2])
    curve = bulged(columns[:, [0, 1, 3]], bool(entity.is_closed))
    return from_above(entity, curve) if entity.is_2d_polyline else curve


def require_finite(rows: np.ndarray) -> None:
    """Raise GeometryError for a coordinate or bulge of a polyline that is no number, or too large a one."""
    if not (np.abs(rows) <= LARGEST).all():
        raise GeometryError(
            "dxf-number", "one of its points is no number in bounds", limit=f"{LARGEST:g}", advice=REDRAW
        )


def bulged(points: np.ndarray, closed: bool) -> Curve:
    """Return the polyline through rows of x, y and the bulge to the next one."""
    if closed and len(points) > 1:
        points = np.vstack([points, points[:1]])
    return Curve(points[:, :2], points[:-1, 2]).without_short()


def _ellipse(entity: Any, fits: Fits) -> Curve:
    centre, major, minor = entity.dxf.center, entity.dxf.major_axis, entity.minor_axis
    _require_level([major.z, 0.0, minor.z])
    first, last = entity.dxf.start_param, entity.dxf.end_param
    sweep = (last - first) % math.tau or math.tau
    sense = math.copysign(1.0, major.x * minor.y - major.y * minor.x)
    if abs(abs(entity.dxf.ratio) - 1.0) <= ROUND:
        return round_arc(centre, major.magnitude, math.atan2(major.y, major.x) + sense * first, sense * sweep)
    curve = fits.ellipse(major.magnitude, minor.magnitude, first, sweep)
    along, across = major.normalize(), minor.normalize()
    return curve.transformed(np.array([(along.x, across.x, centre.x), (along.y, across.y, centre.y)]))


def _level_ellipse(fits: Fits, major: float, minor: float, first: float, sweep: float) -> Curve:
    """Return an ellipse along the axes or a part of it, fitted in parts of at most a quarter: so it is symmetrical."""

    @fits.counted
    def point(t: np.ndarray) -> np.ndarray:
        return np.column_stack([major * np.cos(t), minor * np.sin(t)])

    whole = math.isclose(sweep, math.tau, rel_tol=1e-12)
    fitted = math.pi if whole else sweep
    bounds = first + fitted * np.linspace(0.0, 1.0, math.ceil(fitted / (math.pi / 2.0) - 1e-9) + 1)
    curve = joined(fit_arcs(point, *part, fits.tolerance) for part in itertools.pairwise(bounds.tolist()))
    if not whole:
        return curve
    half = curve.xy[:-1]
    return Curve(np.vstack([half, -half, half[:1]]), np.concatenate([curve.bulge, curve.bulge]))


def _spline(entity: Any, fits: Fits) -> Curve:
    _require_spline(entity)
    spline = entity.construction_tool()
    _require_level([point.z for point in spline.control_points])
    knots = np.array(spline.knots(), float)
    first, last = float(knots[spline.degree]), float(knots[spline.count])
    if not (np.isfinite(knots).all() and (np.diff(knots) >= 0).all() and first < last):
        raise GeometryError("dxf-spline", "its knots do not rise", advice=REDRAW)

    @fits.counted
    def point(t: np.ndarray) -> np.ndarray:
        return np.array([(place.x, place.y) for place in spline.points(t.tolist())])

    inner = np.unique(knots[(knots > first) & (knots < last)])
    stops = [first, *inner[KNOTS_AT_ONCE - 1 :: KNOTS_AT_ONCE].tolist(), last]
    parts = itertools.pairwise(stops)
    return joined(fit_curve(point, *part, fits.tolerance, inner.tolist()) for part in parts)


def _require_spline(entity: Any) -> None:
    """Raise GeometryError for a spline whose degree, points, knots and weights do not belong together."""
    degree, points, knots = entity.dxf.get("degree", 3), entity.control_points, entity.knots
    if not 1 <= degree <= MOST_DEGREE:
        limit = f"1 to {MOST_DEGREE}"
        raise GeometryError(
            "dxf-spline", "the degree of the spline is out of bounds", value=f"{degree}", limit=limit, advice=REDRAW
        )
    for name, values in (("points", [*points, *entity.fit_points]), ("knots", knots), ("weights", entity.weights)):
        if not (np.abs(np.array(values, float)) <= LARGEST).all():
            raise GeometryError("dxf-spline", Text("its {name} are no numbers in bounds", name=name), advice=REDRAW)
    if len(knots) and len(points) and len(knots) != len(points) + degree + 1:
        value, limit = f"{len(knots)} knots", f"{len(points) + degree + 1}"
        raise GeometryError(
            "dxf-spline", "its knots and points do not belong together", value=value, limit=limit, advice=REDRAW
        )
    if len(points) and any(weight <= 0 for weight in entity.weights):
        raise GeometryError("dxf-spline", "its weights are not above 0", advice=REDRAW)


def _solid(entity: Any, _: Fits) -> Curve:
    """Return the outline of a SOLID or TRACE, whose third and fourth corners the file has crosswise."""
    rows = np.array([(corner.x, corner.y, 0.0) for corner in entity.vertices()], float).reshape(-1, 3)
    _require_level([corner.z for corner in entity.vertices()])
    return from_above(entity, bulged(rows, closed=True))


def from_above(entity: Any, curve: Curve) -> Curve:
    """Return a curve of the entity's own plane as seen from above; raises GeometryError where that plane leans."""
    ocs = entity.ocs()
    if not ocs.transform:
        return curve
    if abs(abs(ocs.uz.z) - 1.0) > FLAT:
        raise GeometryError("dxf-not-flat", "does not lie flat", advice=ON_XY)
    return curve.transformed(np.array([(ocs.ux.x, ocs.uy.x, 0.0), (ocs.ux.y, ocs.uy.y, 0.0)]))


def _require_level(heights: Any) -> None:
    if len(heights) and max(heights) - min(heights) > FLAT:
        raise GeometryError("dxf-not-flat", "does not lie flat", advice=ON_XY)


AREAS = ("SOLID", "TRACE")  # of the kinds that are filled
READERS: dict[str, Reader] = {
    "LINE": _line,
    "ARC": _arc,
    "CIRCLE": _circle,
    "LWPOLYLINE": _light_polyline,
    "POLYLINE": _polyline,
    "ELLIPSE": _ellipse,
    "SPLINE": _spline,
    "SOLID": _solid,
    "TRACE": _solid,
}
