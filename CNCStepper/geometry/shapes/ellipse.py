# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ellipse and its true parallel curves.

A curve at a constant distance inside an ellipse is no ellipse. Where the distance exceeds the
smallest radius of curvature (minor² / major, at the two ends of the long axis) the parallel curve
crosses itself; what remains for a tool is the part between the crossings on the long axis:

               . - ' ' - .
            <               >          the two corners lie on the long axis
               ' - . . - '

In the ellipse's own frame the long axis is X, so `major_mm` >= `minor_mm`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.fitting.curve_to_arcs import fit_arcs

MOST_KEPT = 256  # quarters of parallel curves that are remembered


@dataclass(frozen=True)
class Ellipse:
    """An ellipse by its centre, half axes and the direction of its long axis."""

    centre: tuple[float, float]
    major_mm: float
    minor_mm: float
    angle_deg: float

    @classmethod
    def of_radii(
        cls, centre: tuple[float, float], radius_x_mm: float, radius_y_mm: float, rotation_deg: float = 0.0
    ) -> Ellipse:
        """Return the ellipse with radii along X and Y, turned counter-clockwise by `rotation_deg`."""
        if not (radius_x_mm > 0 and radius_y_mm > 0):
            what, advice = "both radii must be positive", "give two radii above 0"
            raise GeometryError("ellipse-radius", what, value=f"{radius_x_mm:g}, {radius_y_mm:g}", advice=advice)
        if radius_x_mm >= radius_y_mm:
            return cls(centre, radius_x_mm, radius_y_mm, rotation_deg)
        return cls(centre, radius_y_mm, radius_x_mm, rotation_deg + 90.0)

    def placed(self, curve: Curve) -> Curve:
        """Return a curve of the ellipse's own frame where the ellipse lies."""
        return curve.rotated(self.angle_deg).moved(*self.centre)

    def points(self, chord_error_mm: float) -> np.ndarray:
        """Return the outline as points, float64[m, 2], counter-clockwise, first = last, chords within the error.

        Equal steps in the parameter: the sagitta of each is at most major/8 * step².
        """
        count = 4 * math.ceil(2.0 * math.pi / math.sqrt(8.0 * chord_error_mm / self.major_mm) / 4.0)
        t = np.linspace(0.0, 2.0 * math.pi, count + 1)
        xy = np.column_stack([self.major_mm * np.cos(t), self.minor_mm * np.sin(t)])
        xy[-1] = xy[0]
        return self.placed(Curve(xy, np.zeros(count))).xy

    def tip_mm(self, inside_mm: float) -> float:
        """Return where, on the long axis from the centre, the parallel curve `inside_mm` inside has its end."""
        if inside_mm <= self.minor_mm**2 / self.major_mm:
            return self.major_mm - inside_mm
        focal = self.major_mm**2 - self.minor_mm**2
        return math.sqrt(max(focal * (1.0 - (inside_mm / self.minor_mm) ** 2), 0.0))

    def unreachable_mm(self, tool_radius_mm: float) -> float:
        """Return the thickness that a round tool must leave at each end of the long axis."""
        return self.major_mm - (self.tip_mm(tool_radius_mm) + tool_radius_mm)

    def parallel(self, inside_mm: float, tolerance_mm: float) -> Curve:
        """Return the true parallel curve `inside_mm` inside, as arcs within `tolerance_mm`.

        It is closed, counter-clockwise, starts at the end of the short axis (own +Y), and has a corner on the
        long axis where `inside_mm` exceeds the smallest radius of curvature. Raises GeometryError when
        `inside_mm` is not below the short half axis.
        """
        if not 0.0 <= inside_mm < self.minor_mm:
            raise GeometryError(
                "ellipse-parallel",
                "no parallel curve that far inside",
                value=f"{inside_mm:g} mm",
                limit=f"{self.minor_mm:g} mm",
                advice="give a distance from 0 to below the limit",
            )
        quarter = _quarter(Ellipse((0.0, 0.0), self.major_mm, self.minor_mm, 0.0), inside_mm, tolerance_mm)
        to_tip, to_bottom = quarter.mirrored_x(), _half_turned(quarter.reversed())
        half = joined([to_tip, to_bottom])
        return self.placed(joined([half, _half_turned(half)]))

    def inside(self, t: np.ndarray, inside_mm: float) -> np.ndarray:
        """Return points of the parallel curve, float64[n, 2], at parameters of the ellipse, in its own frame."""
        cosine, sine = np.cos(t), np.sin(t)
        stretch = np.hypot(self.minor_mm * cosine, self.major_mm * sine)
        x = (self.major_mm - inside_mm * self.minor_mm / stretch) * cosine
        return np.column_stack([x, (self.minor_mm - inside_mm * self.major_mm / stretch) * sine])

    def tip_parameter(self, inside_mm: float) -> float:
        """Return the parameter at which the parallel curve meets the long axis; 0 where it has no corner."""
        beyond = (inside_mm * self.major_mm / self.minor_mm) ** 2 - self.minor_mm**2
        within = self.minor_mm**2 - inside_mm**2
        return math.atan2(math.sqrt(max(beyond, 0.0)), math.sqrt(max(within, 0.0)) * self.major_mm / self.minor_mm)


@lru_cache(MOST_KEPT)  # a pocket that becomes deeper keeps its curves
def _quarter(ellipse: Ellipse, inside_mm: float, tolerance_mm: float) -> Curve:
    """Return the parallel curve from the end of the short axis to the long one, both ends exactly on the axes."""
    begin, end = math.pi / 2.0, ellipse.tip_parameter(inside_mm)
    fitted = fit_arcs(lambda t: ellipse.inside(t, inside_mm), begin, end, tolerance_mm)
    return _exact_ends(fitted, ellipse.minor_mm - inside_mm, ellipse.tip_mm(inside_mm))


def _half_turned(curve: Curve) -> Curve:
    return Curve(-curve.xy, curve.bulge)


def _exact_ends(quarter: Curve, short_mm: float, tip_mm: float) -> Curve:
    """Put the ends exactly on the axes, so that the four quarters meet."""
    xy = quarter.xy.copy()
    xy[0], xy[-1] = (0.0, short_mm), (tip_mm, 0.0)
    return Curve(xy, quarter.bulge)
