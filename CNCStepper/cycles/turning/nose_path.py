# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The path of the nose's centre along a profile: its exact parallel, and whether the insert reaches all of it.

       \  insert /                 The material lies below the profile, the tool comes from the right and goes to
        \       /  front edge      the left. At the profile's end a wall up to beside the stock is implied, so that
    back `-..-'                    nothing is cut behind it.
 ___________.
|  profile    \____                an edge touches no other place of a profile if no stretch of it is steeper than
| <- wall                          the edge: walls that rise to the left, floors that fall to it.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import shapely

from CNCStepper.cycles.turning import insert_choice
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region
from CNCStepper.tolerances import SAME_EDGE_DEG, SAME_MM

OFFSET_TOLERANCE_MM = 1e-4
LEAST_RUN = 0.05  # to the left, of a length along the end of a profile that is no wall itself
BODY_MM = 50.0  # how far the region below a profile goes on
CHORDS_MM = 1e-3  # of a profile whose stock is measured
LEAST_NOSE_DEG = 1.0  # of an insert that could be
SAMPLES = 400  # places at which it is


def framed(curve: Curve, side: float) -> Curve:
    """Return a profile in the frame with the material below: mirrored at the axis for a bore (side -1)."""
    return curve if side > 0 else Curve(curve.xy * (1.0, -1.0), -curve.bulge)


def centre_path(profile: Curve, distance_mm: float, top_mm: float, raw_mm: float = math.inf) -> Curve:
    """Return the path of the centre at a distance from a framed profile, ending on its wall at r = top_mm.

    raw_mm: height of the raw surface, at which that wall ends; a low one lets the nose come nearer.
    """
    profile = _over_low_wall(profile, distance_mm, raw_mm)
    (z_first, r_first), z_last = profile.xy[0], profile.xy[-1, 0]
    high = max(top_mm, float(profile.points(0.01)[:, 1].max()) + 1.0)
    low = float(min(profile.points(0.01)[:, 1].min(), 0.0)) - BODY_MM
    wall = [(z_last, high), (z_last - BODY_MM, high), (z_last - BODY_MM, low), (z_first, low), (z_first, r_first)]
    xy = np.vstack([profile.xy, wall])
    bulge = np.concatenate([profile.bulge, np.zeros(len(wall))])
    loop = Region.of([Curve(xy, bulge).without_short()]).offset(distance_mm, OFFSET_TOLERANCE_MM).loops[0]
    places_mm = loop.nearest(np.array([_first_centre(profile, loop, distance_mm), (z_last + distance_mm, high)]))[1]
    return loop.part(float(places_mm[0]), float(places_mm[1]))


def _over_low_wall(profile: Curve, distance_mm: float, raw_mm: float) -> Curve:
    r"""Return the profile with its last piece lengthened as far as the nose goes before it meets the wall's upper edge.

    The centre runs parallel to the end until the edge is a distance away; a wall so high that the nose meets its side
    before, or an end that does not lead to the left, stays as it is.
    """
    (z, r), (along_z, along_r) = profile.xy[-1].tolist(), profile.end_directions[-1].tolist()
    high_mm, away_r = raw_mm - r, -along_z  # of the wall; height of the normal
    if along_z > -LEAST_RUN or along_r < 0 or not -SAME_MM <= high_mm < distance_mm:
        return profile
    to_edge_mm = high_mm * along_r - math.sqrt(max(2 * distance_mm * high_mm * away_r - (high_mm * along_z) ** 2, 0.0))
    if distance_mm * away_r + to_edge_mm * along_r < high_mm - SAME_MM:
        return profile
    more_mm = distance_mm * (1.0 - along_r) - to_edge_mm * along_z
    if more_mm <= SAME_MM:
        return profile
    end = (z - more_mm, r - more_mm * along_r / along_z)
    return Curve(np.vstack([profile.xy, [end]]), np.append(profile.bulge, 0.0))


def thickest_mm(profile: Curve, top_mm: float, face_mm: float) -> float:
    """Return the greatest distance from a framed profile and its wall of what lies above it in the stock.

    It is greatest at the raw surface r = top_mm or at the raw end z = face_mm, as a profile never runs back.
    """
    points = profile.points(CHORDS_MM)
    (z_first, r_first), z_last = points[0], float(points[-1, 0])
    high, low = max(top_mm, float(points[:, 1].max())) + BODY_MM, float(points[:, 1].min()) - BODY_MM
    wall = [(z_last, high), (z_last - BODY_MM, high), (z_last - BODY_MM, low), (z_first, low)]
    end = max(face_mm, z_first)
    surface = [(z, top_mm) for z in np.linspace(z_last, end, SAMPLES)]
    raw_end = [(end, r) for r in np.linspace(min(r_first, top_mm), top_mm, SAMPLES)]
    return float(shapely.distance(shapely.Polygon([*points, *wall]), shapely.points([*surface, *raw_end])).max())


def _first_centre(profile: Curve, loop: Curve, distance_mm: float) -> tuple[float, float]:
    """Return where the path begins: over the profile's begin, or before it where it falls or the nose is in the way.

    To a begin that falls the nose would come from the front through its corner, so that it rolls over it.
    """
    (z, r), direction = profile.xy[0].tolist(), profile.at_length(0.0)[1]
    first = z + distance_mm * float(direction[1]), r - distance_mm * float(direction[0])
    away_mm = float(loop.distances_mm(np.array([first]))[0])
    return first if direction[1] >= 0 and away_mm < 10 * OFFSET_TOLERANCE_MM else (z + distance_mm, r)


def require_reach(profile: Curve, setup: TurningSetup, side: float) -> None:
    """Raise CycleError for a framed profile that the insert cannot reach, with the angle or nose that would do."""
    if setup.tool.is_round:
        _require_nose(profile, setup)
        return
    front, back = (angle * side for angle in setup.tool.edges_deg)
    rising, falling = _steepest(profile)
    if rising < front - SAME_EDGE_DEG:
        what = "the front edge of the insert does not reach the profile"
        value = Text("front edge at {front:.4g} deg", front=front)
        needs = "at most {rising:.4g} deg: an entering angle of {entering:.4g} deg or more"
        limit = Text(needs, rising=rising, entering=180 - rising)
        advice = insert_choice.advice(profile, setup, side, rising, falling)
        raise CycleError("insert-front", what, value=value, limit=limit, advice=advice)
    if falling > back + SAME_EDGE_DEG:
        what = "the back edge of the insert does not reach the profile"
        value = Text("back edge at {back:.4g} deg", back=back)
        has_nose = front - falling >= LEAST_NOSE_DEG
        needs = "at least {falling:.4g} deg: a nose angle of {nose:.4g} deg or less"
        limit = Text(needs if has_nose else "at least {falling:.4g} deg", falling=falling, nose=front - falling)
        advice = insert_choice.advice(profile, setup, side, rising, falling)
        raise CycleError("insert-back", what, value=value, limit=limit, advice=advice)
    _require_nose(profile, setup)


def _steepest(profile: Curve) -> tuple[float, float]:
    """Return the least angle of what rises along the profile, and the greatest of what falls, from +z, in degrees."""
    rising, falling = 180.0, 0.0
    ends = zip(profile.begin_directions, profile.end_directions, profile.lengths_mm, strict=True)
    for begin, end, length_mm in ends:
        if length_mm <= SAME_MM:
            continue
        for way in (complex(*begin), complex(*end)):
            angle = math.degrees(math.atan2(way.imag, way.real)) % 360.0  # 90 up, 180 left, 270 down
            if angle <= 180.0 + SAME_EDGE_DEG:
                rising = min(rising, angle)
            else:
                falling = max(falling, angle - 180.0)
    return rising, falling


def _require_nose(profile: Curve, setup: TurningSetup) -> None:
    """Raise CycleError for an arc of the profile that is hollow and narrower than the nose."""
    radii = [abs(radius) for radius, bulge in zip(profile.radii_mm, profile.bulge, strict=True) if bulge < 0]
    if radii and min(radii) < setup.tool.nose_mm - SAME_MM:
        what = "the nose is too large for a hollow of the profile"
        value = Text("nose radius {nose:g} mm", nose=setup.tool.nose_mm)
        raise CycleError("nose-radius", what, value=value, limit=f"{min(radii):.4g} mm", advice="use a smaller nose")


def sharp_hollows(profile: Curve) -> int:
    """Return how many inner corners a framed profile has, in which the nose leaves a fillet."""
    ends, begins = profile.end_directions[:-1], profile.begin_directions[1:]
    turns = ends[:, 0] * begins[:, 1] - ends[:, 1] * begins[:, 0]
    return int(np.count_nonzero(turns < -math.sin(math.radians(1.0))))


def crossings_mm(path: Curve, level_mm: float) -> list[tuple[float, bool]]:
    """Return where a path crosses the height r = level_mm: the length along it, and whether it goes up there."""
    found = {
        round(float(path.before_mm[number]) + length_mm, 9)
        for number in range(len(path))
        for length_mm in _on_segment(path, number, level_mm)
    }
    lengths = sorted(found)
    bounds = [0.0, *lengths, path.length_mm]
    middles = [(first + last) / 2 for first, last in pairwise(bounds)]
    above = path.at_length(np.array(middles))[0][:, 1] > level_mm
    changes = zip(lengths, above[:-1].tolist(), above[1:].tolist(), strict=True)
    return [(length, after) for length, before, after in changes if before != after]


def _on_segment(path: Curve, number: int, level_mm: float) -> list[float]:
    """Return the lengths along one segment at which it has the height."""
    (z0, r0), (_, r1) = path.xy[number], path.xy[number + 1]
    if path.bulge[number] == 0.0:
        if abs(r1 - r0) <= SAME_MM or not min(r0, r1) <= level_mm <= max(r0, r1):
            return []
        return [float((level_mm - r0) / (r1 - r0) * path.lengths_mm[number])]
    centre_z, centre_r = path.centres[number]
    radius = abs(float(path.radii_mm[number]))
    height = level_mm - centre_r
    if abs(height) >= radius:
        return []
    sense = math.copysign(1.0, path.bulge[number])
    sweep = abs(float(path.sweeps_rad[number]))
    begin = math.atan2(r0 - centre_r, z0 - centre_z)
    turns = []
    for angle in (math.asin(height / radius), math.pi - math.asin(height / radius)):
        turn = (sense * (angle - begin)) % (2 * math.pi)
        if turn <= sweep + 1e-12:
            turns.append(turn * radius)
    return turns
