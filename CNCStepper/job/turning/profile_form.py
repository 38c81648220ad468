# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The half profile of a turned part as a job file names it, and the chain of lines and arcs that follows from it.

    [[profile]]                                   x as the job's x_is says, z < 0 towards the chuck
    name = "shaft"
    points = [
        [0, 0],
        { to = [30, 0], chamfer_mm = 1 },         the corner at this point: a chamfer, or fillet_mm = radius
        [30, -40],
        { to = [40, -45], arc = "cw", radius_mm = 5 },    how it is reached: an arc, seen with z to the right, r up;
        [40, -80],                                        or centre = [x, z] in place of radius_mm
    ]
    dxf = { file = "shaft.dxf", layer = "PROFILE" }       in place of points: its X is z, its Y the radius

A profile runs from the end face towards the chuck and never back: z never rises along it. The curve has z as its first
and the radius as its second coordinate.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag, model_validator
from shapely import LineString

from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.shapes import Drawn, DxfForm, ShapeKey, read_shapes
from CNCStepper.job.turning.profile_crossing import crossing_error, way_back_mm
from CNCStepper.quantities import MOST_ITEMS, Coordinate, Width, WidthOr0
from CNCStepper.tolerances import SAME_MM

Pair = tuple[Coordinate, Coordinate]
Xis = Literal["diameter", "radius"]
CHORDS_MM = 1e-4  # how far the lines that stand for arcs in checks of a profile may leave them


class Corner(BaseModel):
    """A point of a profile that says more than its place."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    to: Pair
    arc: Literal["cw", "ccw"] | None = None
    radius_mm: Width | None = None
    centre: Pair | None = None
    chamfer_mm: WidthOr0 = 0.0
    fillet_mm: WidthOr0 = 0.0

    @model_validator(mode="after")
    def _is_one_way(self) -> Corner:
        if (self.arc is None) != (self.radius_mm is None and self.centre is None):
            raise ValueError('an arc needs arc = "cw" or "ccw", and radius_mm or centre')
        if self.radius_mm is not None and self.centre is not None:
            raise ValueError("an arc needs radius_mm or centre, not both")
        if self.chamfer_mm and self.fillet_mm:
            raise ValueError("a corner has a chamfer_mm or a fillet_mm, not both")
        return self


def _kind(row: Any) -> str:
    return "corner" if isinstance(row, Corner | dict) else "point"


Row = Annotated[Annotated[Pair, Tag("point")] | Annotated[Corner, Tag("corner")], Discriminator(_kind)]


class ProfileForm(BaseModel):
    """A `[[profile]]` table of a job file."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: str = Field(min_length=1)
    points: tuple[Row, ...] | None = Field(default=None, min_length=2, max_length=MOST_ITEMS["corners"])
    dxf: DxfForm | None = None

    @model_validator(mode="after")
    def _is_drawn_once(self) -> ProfileForm:
        if (self.points is None) == (self.dxf is None):
            raise ValueError("a profile needs points or dxf, one of them")
        return self

    def curve(self, x_is: Xis, folder: Path) -> Curve:
        """Return the chain in (z, r), checked; raises JobError with the number that would do."""
        with placed(Place(Text("profile '{name}'", name=self.name))):
            chain = self._drawn(folder) if self.dxf else _of_points(self.points or (), x_is)
            check_profile(chain)
            return chain

    def _drawn(self, folder: Path) -> Curve:
        table = {"name": self.name, "dxf": self.dxf and self.dxf.model_dump(exclude_none=True)}
        place = Place(Text("profile '{name}'", name=self.name))
        shapes = read_shapes([table], folder, place.file, Drawn())
        curves = shapes.named(self.name, ShapeKey("dxf", "curve", closed=False), place)
        if len(curves) != 1:
            what = "the layer of a profile must hold one chain"
            raise JobError("profile-chains", what, value=f"{len(curves)}", limit="1", advice="draw it joined up")
        return curves[0] if curves[0].xy[0, 0] >= curves[0].xy[-1, 0] else curves[0].reversed()


def check_profile(chain: Curve) -> None:
    """Raise JobError for a profile that crosses the axis or itself, or that runs back towards the end face."""
    points = chain.points(CHORDS_MM)
    low = int(np.argmin(points[:, 1]))
    if points[low, 1] < -SAME_MM:
        what = "the profile goes over the centre"
        value = Text("radius {radius:.4g} mm at z {z:.4g} mm", radius=points[low, 1], z=points[low, 0])
        raise JobError("profile-axis", what, value=value, limit="radius 0 mm", advice="end it at the axis")
    if not LineString(points).is_simple:
        raise crossing_error(chain, points, _can_be_turned)
    back = way_back_mm(points)
    worst = int(np.argmax(back))
    if back[worst] > SAME_MM:
        what = "the profile has an undercut: it runs back towards the end face"
        value = Text("from z {z:.4g} mm by {back:.4g} mm", z=points[worst, 0], back=back[worst])
        limit = f"z {points[worst, 0]:.4g} mm"
        raise JobError("profile-undercut", what, value=value, limit=limit, advice="let z never rise along it")


def _can_be_turned(chain: Curve) -> bool:
    points = chain.points(CHORDS_MM)
    is_on_its_side = points[:, 1].min() >= -SAME_MM and way_back_mm(points).max() <= SAME_MM
    return bool(is_on_its_side and LineString(points).is_simple)


def _of_points(rows: tuple[Row, ...], x_is: Xis) -> Curve:
    """Return the chain through the rows, its corners cut or rounded."""
    corners = [row if isinstance(row, Corner) else Corner(to=row) for row in rows]
    scale = 0.5 if x_is == "diameter" else 1.0
    places = np.array([(corner.to[1], corner.to[0] * scale) for corner in corners])
    bulges = [0.0]
    for number in range(1, len(corners)):
        bulges.append(_bulge(corners[number], places[number - 1], places[number], scale))
    if corners[0].arc or any(corner.chamfer_mm or corner.fillet_mm for corner in (corners[0], corners[-1])):
        raise JobError(
            "profile-end", "a profile's ends have no corner to cut and its begin no arc", advice="take it out"
        )
    points: list[np.ndarray] = [places[0]]
    turns: list[float] = []
    for number in range(1, len(corners)):
        corner = corners[number]
        size_mm = corner.chamfer_mm or corner.fillet_mm
        if not size_mm:
            points.append(places[number])
            turns.append(bulges[number])
            continue
        if bulges[number] or bulges[number + 1]:
            raise JobError("profile-corner", "chamfers and fillets lie between two lines", advice="draw them as points")
        first, last, bulge = _cut_corner(corner, points[-1], places[number], places[number + 1])
        points += [first, last]
        turns += [0.0, bulge]
    lengths = np.hypot(*np.diff(np.array(points), axis=0).T)
    keep = np.concatenate([[True], lengths > SAME_MM])
    if keep.sum() < 2:
        what = "the points of the profile lie at one place"
        raise JobError(
            "profile-short", what, value=f"{lengths.sum():g} mm long", limit="above 0 mm", advice="redraw it"
        )
    return Curve(np.array(points)[keep], np.array(turns)[lengths > SAME_MM])


def _cut_corner(corner: Corner, before: np.ndarray, at: np.ndarray, after: np.ndarray) -> tuple:
    """Return begin, end and bulge of what takes the place of a corner; raises JobError where its legs are too short."""
    legs = (before - at, after - at)
    lengths = [float(np.hypot(*leg)) for leg in legs]
    units = [leg / max(length, SAME_MM) for leg, length in zip(legs, lengths, strict=True)]
    turn = math.atan2(units[0][0] * units[1][1] - units[0][1] * units[1][0], float(units[0] @ units[1]))
    leg_mm, bulge = corner.chamfer_mm, 0.0
    if corner.fillet_mm:
        leg_mm = corner.fillet_mm / max(abs(math.tan(turn / 2)), SAME_MM)
        bulge = -math.copysign(math.tan((math.pi - abs(turn)) / 4), turn)
    if leg_mm > min(lengths) + SAME_MM:
        most_mm = corner.chamfer_mm * min(lengths) / leg_mm or corner.fillet_mm * min(lengths) / leg_mm
        what, value = "the corner is too large for its lines", f"{corner.chamfer_mm or corner.fillet_mm:g} mm"
        raise JobError("profile-corner", what, value=value, limit=f"{most_mm:.4g} mm", advice="make it smaller")
    return at + units[0] * leg_mm, at + units[1] * leg_mm, bulge


def _bulge(corner: Corner, begin: np.ndarray, end: np.ndarray, scale: float) -> float:
    """Return the bulge of the way to a corner."""
    if corner.arc is None:
        return 0.0
    chord_mm, sign = float(np.hypot(*(end - begin))), 1.0 if corner.arc == "ccw" else -1.0
    if corner.radius_mm is not None:
        if chord_mm > 2 * corner.radius_mm + SAME_MM:
            what, value = "the arc's radius is too small for its ends", f"{corner.radius_mm:g} mm"
            limit = Text("at least {least:.4g} mm", least=chord_mm / 2)
            raise JobError("profile-arc", what, value=value, limit=limit, advice="correct it")
        return sign * math.tan(math.asin(min(chord_mm / 2 / corner.radius_mm, 1.0)) / 2)
    assert corner.centre is not None
    centre = np.array([corner.centre[1], corner.centre[0] * scale])
    radii = [float(np.hypot(*(point - centre))) for point in (begin, end)]
    if abs(radii[0] - radii[1]) > 0.005:
        what = "the arc's centre is not as far from both its ends"
        value = Text("{first:.4g} and {second:.4g} mm", first=radii[0], second=radii[1])
        raise JobError("profile-arc", what, value=value, limit="0.005 mm apart", advice="correct centre or to")
    angles = [math.atan2(*(point - centre)[::-1]) for point in (begin, end)]
    sweep = (sign * (angles[1] - angles[0])) % (2 * math.pi)
    return sign * math.tan(sweep / 4)
