# SPDX-License-Identifier: LGPL-2.1-or-later
"""The profile that turning operations are to leave, and how far a part as cut is from it.

outside            inside                gouge       material of `keep` that is missing
  to cut             stays               left over   material beyond the stock to leave that a tool could reach
---------chain     ---------chain
  stays              to cut              only the chains' own stretch of z is judged
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.turning.half_section import HalfSection, solid
from CNCStepper.simulation.turning.insert_reach import out_of_reach
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_part import thickness

GOUGE_MM = 0.005  # how deep a cut may be in the wanted part
LEFT_MM = 0.01  # how thick material may be left beyond the stock to leave
FAR_MM = 1e4


@dataclass(frozen=True)
class WantedProfile:
    """What operations on one profile are to cut: a region of the half plane, within a stretch of z, mm.

    points: the profile itself, (z, r), float64[n, 2]. leave_mm: the stock to leave of the last operation, normal to it.
    left_mm: how much thicker the steps of its passes may be, where no operation finishes it. tools: the numbers of
    those that cut it; without any, no material is missed that is left. wall_r_mm: the radius to which the wall behind
    the last point goes, on which the stock to leave stays too.
    """

    to_cut: BaseGeometry
    span_mm: tuple[float, float]
    points: np.ndarray
    leave_mm: float = 0.0
    left_mm: float = 0.0
    tools: tuple[int, ...] = ()
    name: str = ""
    wall_r_mm: float = FAR_MM

    def must_go(self) -> BaseGeometry:
        """Return what is to be cut when the stock to leave stays."""
        if not self.leave_mm:
            return self.to_cut
        surface = shapely.LineString([*self.points, (self.points[-1, 0], self.wall_r_mm)])
        return self.to_cut.difference(surface.buffer(self.leave_mm, quad_segs=64))


def wanted_chain(points: np.ndarray, inside: bool = False, **more: Any) -> WantedProfile:
    """Return a profile by its chain (z, r), arcs as chords: what lies outside it is cut, or inside it in a bore."""
    far = 0.0 if inside else FAR_MM
    closed = np.vstack([points, [(points[-1, 0], far), (points[0, 0], far)]])
    span = float(points[:, 0].min()), float(points[:, 0].max())
    region = solid(shapely.make_valid(shapely.Polygon(closed)))
    return WantedProfile(region, span, points, wall_r_mm=far, **more)


def wanted_ring(z_mm: tuple[float, float], radius_mm: tuple[float, float], **more: Any) -> WantedProfile:
    """Return what an end face, a groove or a parting cut takes: all between two z and two radii."""
    (z_first, z_last), (inner, outer) = z_mm, radius_mm
    points = np.array([(z_last, outer), (z_last, inner), (z_first, inner), (z_first, outer)])
    return WantedProfile(shapely.box(z_first, inner, z_last, outer), z_mm, points, **more)


@dataclass(frozen=True)
class Excess:
    """Where a part differs most from what is wanted: how much, at which place (z, r), in which region."""

    depth_mm: float
    place_mm: tuple[float, float]
    region: BaseGeometry


def gouge(part: HalfSection, stock: HalfSection, wanted: Sequence[WantedProfile]) -> Excess | None:
    """Return the deepest cut into the wanted part, None for none."""
    keep = _judged(_keep(stock, wanted), wanted)
    missing = solid(keep.difference(part.region))
    found = [_deepest(piece, keep) for piece in shapely.get_parts(missing)]
    return max(found, key=lambda one: one.depth_mm, default=None)


def left_over(
    part: HalfSection,
    stock: HalfSection,
    wanted: Sequence[WantedProfile],
    tools: dict[int, ToolSection],
) -> list[tuple[WantedProfile, Excess]]:
    """Return for each profile that has tools the thickest material which they could have cut, where it is too thick."""
    found = []
    for profile in wanted:
        sections = [tools[number] for number in profile.tools if number in tools]
        must_go = _judged(profile.must_go(), [profile]).intersection(part.region)
        if not sections or must_go.is_empty:
            continue
        keep = _keep(stock, [other for other in wanted if other is not profile]).difference(profile.must_go())
        for section in sections:
            must_go = must_go.difference(out_of_reach(stock.region, keep, section).buffer(LEFT_MM / 2))
        limit_mm = LEFT_MM + profile.left_mm
        if not must_go.buffer(-limit_mm / 2).is_empty:
            left = solid(must_go)
            found.append((profile, Excess(*thickness(left), left)))
    return found


def _keep(stock: HalfSection, wanted: Sequence[WantedProfile]) -> BaseGeometry:
    return stock.region.difference(shapely.union_all([profile.to_cut for profile in wanted]))


def _judged(region: BaseGeometry, wanted: Sequence[WantedProfile]) -> BaseGeometry:
    """Return the part of a region that lies within the chains' stretches of z."""
    stretches = [shapely.box(low, 0.0, high, FAR_MM) for low, high in (profile.span_mm for profile in wanted)]
    return solid(region.intersection(shapely.union_all(stretches)))


def _deepest(missing: BaseGeometry, keep: BaseGeometry) -> Excess:
    """Return how deep a missing piece reaches: its farthest corner from the wanted surface, or its thickness."""
    corners = shapely.get_coordinates(missing)
    depths = shapely.distance(keep.boundary, shapely.points(corners))
    deepest = int(np.argmax(depths))
    thick_mm, middle = thickness(missing)
    if thick_mm > depths[deepest]:
        return Excess(thick_mm, middle, missing)
    z, r = corners[deepest].tolist()
    return Excess(float(depths[deepest]), (z, r), missing)
