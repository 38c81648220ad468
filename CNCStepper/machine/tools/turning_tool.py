# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The tool of a lathe: its insert, how its holder sets it, and what it may do.

      r ^      \          /  front edge            orientation, as LinuxCNC's tool table: where the tip lies
        |       \ insert /     front_deg                4  8  3       X+ down there, here r upwards:
        |        \      /                               5  9  7         1 tip at z+ r-   2 at z- r-   6 at r-
        |  back   `-..-'  nose                          1  6  2         4 tip at z+ r+   3 at z- r+   8 at r+
        |         .                                                    5 at z+   7 at z-   9 the nose's centre
        +-----------------> z       chuck to the left, the tool comes from the right and cuts towards it

front_deg and back_deg are the directions of the two edges away from the nose, from +z towards +r, as I and J of
LinuxCNC's tool.tbl. They follow from the holder's entering angle (`lead_deg`) and the insert: front = 180 - lead, back
= front - nose angle, for a right-hand tool outside; boring bars mirror them in r, left-hand ones in z. The control
point is the theoretical tip: the nose's centre and one nose radius along z and r as the orientation says.

`outline` and `holder_outline` are closed chains of vertices (z_mm, r_mm, bulge) about the control point; the bulge is
tan(sweep / 4) of the arc from that vertex to the next one, 0 for a line, as in `geometry/curve.py`.
"""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, model_validator

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.tools.insert_code import RHOMBUSES, Insert, insert_of
from CNCStepper.quantities import Bounds, ChipLoadOr0, SpeedOr0, TipAngle, ToolNumber, WidthOr0

Kind = Literal["turning", "boring", "parting", "drill", "threading"]
Hand = Literal["right", "left"]
OTHER_HAND: dict[Hand, Hand] = {"right": "left", "left": "right"}
KINDS: dict[Kind, Text] = {
    "turning": Text("turning"),
    "boring": Text("boring"),
    "parting": Text("parting"),
    "drill": Text("drill"),
    "threading": Text("threading"),
}  # as they are said in "a {kind} tool"
Vertex = tuple[float, float, float]  # z_mm, r_mm, bulge of what follows
Outline = tuple[Vertex, ...]

CENTRES = {1: (-1, 1), 2: (1, 1), 3: (1, -1), 4: (-1, -1), 5: (-1, 0), 6: (0, 1), 7: (1, 0), 8: (0, -1), 9: (0, 0)}
LEAD_DEG = 95.0  # the entering angle of the usual holders
MIRRORED = {1: 2, 2: 1, 3: 4, 4: 3, 5: 7, 7: 5}  # orientations that a mirror in z exchanges
DRILL_POINT_DEG = 118.0
PLAIN_EDGE_MM = 10.0  # of an insert that is given by its angles alone
SHANK_REACH_MM = 60.0  # how much of a shank or a bar the outline shows where reach_mm is not given
TURNS = {"W": (20.0, 100.0, 20.0, 100.0, 20.0), "T": (120.0,)}

Direction = Annotated[float, Bounds("angle", -360.0, 360.0)]


class TurningTool(BaseModel):
    """A lathe's tool as a job file names it; 0 means "not given".

    insert: an ISO 1832 code; without one nose_radius_mm, front_deg and back_deg describe a turning tool. lead_deg: the
    holder's entering angle between the front edge and the feed. orientation: 1 to 9. width_mm: of a parting blade.
    diameter_mm, point_angle_deg: of a drill. tip_angle_deg: of a threading tool. inside: works in a bore.
    smallest_bore_mm: into which a boring bar fits; bar_mm: its diameter. shank_mm: width of a holder. reach_mm: how far
    it gets: a bar or a drill along z, a blade along r. feed_mm_rev, surface_speed_m_min, spindle_rpm: with which it
    cuts where the job says nothing; max_rpm: the limit of constant surface speed. ap_max_mm, feed_min_mm_rev,
    feed_max_mm_rev: what the insert takes.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    number: ToolNumber
    kind: Kind = "turning"
    insert: str = ""
    hand: Hand = "right"
    inside: bool = False
    lead_deg: TipAngle = LEAD_DEG
    front_deg: Direction | None = None
    back_deg: Direction | None = None
    orientation: Annotated[int, Bounds("number", 1, 9)] | None = None
    nose_radius_mm: WidthOr0 | None = None
    edge_length_mm: WidthOr0 = 0.0
    width_mm: WidthOr0 = 0.0
    diameter_mm: WidthOr0 = 0.0
    point_angle_deg: TipAngle = DRILL_POINT_DEG
    tip_angle_deg: TipAngle | None = None
    smallest_bore_mm: WidthOr0 = 0.0
    bar_mm: WidthOr0 = 0.0
    shank_mm: WidthOr0 = 0.0
    reach_mm: WidthOr0 = 0.0
    feed_mm_rev: ChipLoadOr0 = 0.0
    feed_min_mm_rev: ChipLoadOr0 = 0.0
    feed_max_mm_rev: ChipLoadOr0 = 0.0
    ap_max_mm: WidthOr0 = 0.0
    surface_speed_m_min: Annotated[float, Bounds("surface_speed", zero=True)] = 0.0
    spindle_rpm: SpeedOr0 = 0.0
    max_rpm: SpeedOr0 = 0.0

    @model_validator(mode="after")
    def _keys_fit_together(self) -> TurningTool:
        for key, kind in (("width_mm", "parting"), ("diameter_mm", "drill")):
            if (getattr(self, key) > 0) != (self.kind == kind):
                needs = self.kind == kind
                what = "a {kind} tool needs {key}" if needs else "a {kind} tool has no {key}"
                raise ValueError(Text(what, kind=KINDS[self.kind], key=key))
        if self.insert:
            self._check_insert()
        elif self.kind in ("turning", "boring") and (self.front_deg is None or self.back_deg is None):
            raise ValueError('a turning tool needs insert, for example "CNMG 120408", or front_deg and back_deg')
        if self.kind not in ("parting", "drill") and not self.is_round and not 1.0 <= self.included_deg < 179.0:
            what = "the insert must fill 1 to 179 degrees from back_deg to front_deg: it fills {angle:g}"
            raise ValueError(Text(what, angle=self.included_deg))
        if self.feed_max_mm_rev and self.feed_min_mm_rev > self.feed_max_mm_rev:
            raise ValueError("feed_min_mm_rev must not exceed feed_max_mm_rev")
        if self.smallest_bore_mm and self.bar_mm >= self.smallest_bore_mm:
            raise ValueError("bar_mm must be below smallest_bore_mm")
        return self

    def _check_insert(self) -> None:
        if self.kind in ("parting", "drill"):
            raise ValueError(Text("a {kind} tool has no insert of ISO 1832", kind=KINDS[self.kind]))
        try:
            insert = insert_of(self.insert)
        except JobError as error:
            raise ValueError(error.sentence) from error
        if (insert.shape == "thread") != (self.kind == "threading"):
            raise ValueError(
                Text("'{insert}' is no insert of a {kind} tool", insert=insert.code, kind=KINDS[self.kind])
            )

    @property
    def _insert(self) -> Insert | None:
        return insert_of(self.insert) if self.insert else None

    @property
    def is_inside(self) -> bool:
        """Whether it works in a bore, where its tip points away from the axis."""
        return self.inside or self.kind == "boring" or bool(self._insert and self._insert.inside)

    @property
    def nose_mm(self) -> float:
        """The nose radius."""
        if self.nose_radius_mm is not None:
            return self.nose_radius_mm
        return self._insert.nose_radius_mm if self._insert else 0.0

    @property
    def included_deg(self) -> float:
        """The angle between the two edges at the nose; 0 for a round insert."""
        if self.kind == "threading":
            return self.tip_angle_deg or (self._insert.nose_deg if self._insert else 60.0)
        if self._insert and self._insert.shape == "R":
            return 0.0
        if self.front_deg is not None and self.back_deg is not None:
            return self._turned(self.front_deg - self.back_deg)
        return self._insert.nose_deg if self._insert else 0.0

    def _turned(self, angle_deg: float) -> float:
        """Return an angle from the back edge to the front edge, counted the way in which this hand and side have it."""
        return (angle_deg * (-1.0 if self.is_inside else 1.0) * (-1.0 if self.hand == "left" else 1.0)) % 360.0

    @property
    def is_round(self) -> bool:
        """Whether its insert is a disc."""
        return bool(self._insert and self._insert.shape == "R")

    @property
    def tip(self) -> int:
        """The orientation, 1 to 9."""
        if self.orientation is not None:
            return self.orientation
        if self.kind == "drill":
            return 7
        if self.is_round:
            return 9
        if self.kind == "threading":
            return 8 if self.is_inside else 6
        left = self.hand == "left"
        return (4 if left else 3) if self.is_inside else (1 if left else 2)

    @property
    def edges_deg(self) -> tuple[float, float]:
        """The directions (front, back) of the edges away from the nose, from +z towards +r, within -180 to 180."""
        if self.kind == "threading":
            half, axis = self.included_deg / 2, -90.0 if self.is_inside else 90.0
            return axis + half, axis - half
        front = 180.0 - self.lead_deg
        own = (front, front - self.included_deg)
        mirrored = tuple(self._as_mounted(angle) for angle in own)
        front = mirrored[0] if self.front_deg is None else self.front_deg
        back = mirrored[1] if self.back_deg is None else self.back_deg
        return _half_turns(front), _half_turns(back)

    def _as_mounted(self, angle_deg: float) -> float:
        if self.hand == "left":
            angle_deg = 180.0 - angle_deg
        return -angle_deg if self.is_inside else angle_deg

    @property
    def nose_centre(self) -> tuple[float, float]:
        """The centre (z, r) of the nose from the control point, mm."""
        z, r = CENTRES[self.tip]
        return z * self.nose_mm, r * self.nose_mm

    def mirrored(self) -> TurningTool:
        """Return the tool of the other hand: its mirror image in z."""
        angles = {key: None if angle is None else 180.0 - angle for key, angle in self._given_edges()}
        tip = None if self.orientation is None else MIRRORED.get(self.orientation, self.orientation)
        return self.model_copy(update={"hand": OTHER_HAND[self.hand], "orientation": tip, **angles})

    def _given_edges(self) -> tuple[tuple[str, float | None], ...]:
        return ("front_deg", self.front_deg), ("back_deg", self.back_deg)

    @property
    def words(self) -> str:
        """The words by which a person picks the tool."""
        if self.kind == "drill":
            return Text("drill {diameter:g} mm", diameter=self.diameter_mm)
        if self.kind == "parting":
            return Text("parting blade {width:g} mm", width=self.width_mm)
        name = self._insert.code if self._insert else Text("nose {nose:g} mm", nose=self.nose_mm)
        if self.kind == "turning":
            return Text("turning {name}", name=name)
        return Text("boring {name}", name=name) if self.kind == "boring" else Text("threading {name}", name=name)

    @property
    def kind_words(self) -> str:
        """What kind of tool it is, and that it is a left-hand one."""
        kind = KINDS[self.kind]
        return Text("a left-hand {kind} tool", kind=kind) if self.hand == "left" else Text("a {kind} tool", kind=kind)

    @property
    def pitch_mm(self) -> float:
        """The one pitch of a threading insert; 0 where it cuts several."""
        return self._insert.pitch_mm if self._insert else 0.0

    @property
    def edge_mm(self) -> float:
        """The length of its cutting edges."""
        if self.edge_length_mm:
            return self.edge_length_mm
        return self._insert.edge_mm if self._insert and self._insert.edge_mm else PLAIN_EDGE_MM

    @property
    def diameter_of_insert_mm(self) -> float:
        """The inscribed circle of its insert, or the length of its edge where it has none."""
        return self._insert.circle_mm if self._insert else self.edge_mm

    def outline(self) -> Outline:
        """Return the closed outline of what cuts, about the control point, counter-clockwise."""
        if self.kind == "drill":
            return self._drill()
        if self.kind == "parting":
            return self._blade()
        if self.is_round:
            (z, r), radius = self.nose_centre, self.nose_mm
            return (z + radius, r, 1.0), (z - radius, r, 1.0)
        return self._polygon()

    def holder_outline(self) -> Outline:
        """Return the closed outline of the holder, () where the tool does not give it; counter-clockwise."""
        reach_mm, circle_mm = self.reach_mm or SHANK_REACH_MM, self.diameter_of_insert_mm
        side = -1.0 if self.hand == "left" else 1.0
        if self.kind in ("parting", "drill") or not (self.shank_mm or self.bar_mm):
            return ()
        if self.is_inside:
            if not self.bar_mm:
                return ()
            clear_mm = max(self.smallest_bore_mm - self.bar_mm, 0.0) / 2 or circle_mm / 4
            return _box(side * circle_mm / 3, side * reach_mm, -clear_mm - self.bar_mm, -clear_mm)
        return _box(side * circle_mm / 3, side * (circle_mm / 3 + self.shank_mm), circle_mm * 0.75, reach_mm)

    def _polygon(self) -> Outline:
        """Return the insert: a rounded corner at the nose, its other corners sharp."""
        low, high = sorted(self._swept())
        half, nose_mm = math.radians((high - low) / 2), self.nose_mm
        (cz, cr), middle = self.nose_centre, math.radians((low + high) / 2)
        back_mm = nose_mm / math.sin(half)
        corner = (cz - back_mm * math.cos(middle), cr - back_mm * math.sin(middle))
        cut_mm = nose_mm / math.tan(half)
        others = list(self._walk(corner, low))
        first, last = _along(corner, low, cut_mm), _along(corner, high, cut_mm)
        nose = [(*last, math.tan((math.pi - 2 * half) / 4)), (*first, 0.0)] if nose_mm > 0 else [(*corner, 0.0)]
        return (*nose, *((z, r, 0.0) for z, r in others))

    def _swept(self) -> tuple[float, float]:
        """Return both edges' directions such that the insert lies between them, less than a half turn apart."""
        front, back = self.edges_deg
        if front - back > 180.0:
            front -= 360.0
        elif back - front > 180.0:
            back -= 360.0
        return front, back

    def _walk(self, corner: tuple[float, float], low: float) -> list[tuple[float, float]]:
        """Return the other corners of the insert, counter-clockwise from its sharp corner at the nose."""
        points, direction = [_along(corner, low, self.edge_mm)], low
        for turn in self._turns():
            direction += turn
            points.append(_along(points[-1], direction, self.edge_mm))
        if len(points) == 1:  # given by its angles alone: a triangle with two edges of that length
            points.append(_along(corner, low + self.included_deg, self.edge_mm))
        return points

    def _turns(self) -> tuple[float, ...]:
        """Return by how much the outline turns at each corner behind the nose but the last, in degrees."""
        shape = self._insert.shape if self._insert else ""
        if shape in TURNS:
            return TURNS[shape]
        return (self.included_deg, 180.0 - self.included_deg) if shape in RHOMBUSES else ()

    def _blade(self) -> Outline:
        """Return a blade: as wide as it cuts, both corners rounded by the nose radius, standing away from the work."""
        reach_mm, width_mm = self.reach_mm or SHANK_REACH_MM, self.width_mm
        nose_mm = min(self.nose_mm, width_mm / 2.001)
        left = {1: -width_mm, 6: -width_mm / 2, 8: -width_mm / 2, 4: -width_mm}.get(self.tip, 0.0)
        right, round_corner = left + width_mm, math.tan(math.pi / 8) if nose_mm > 0 else 0.0
        ends = [(left, nose_mm, round_corner), (left + nose_mm, 0.0, 0.0)]
        ends += [(right - nose_mm, 0.0, round_corner), (right, nose_mm, 0.0)]
        outline = [*ends, (right, reach_mm, 0.0), (left, reach_mm, 0.0)]
        if nose_mm == 0.0:
            outline = [vertex for place, vertex in enumerate(outline) if place not in (1, 3)]
        return _mirrored(outline) if self.is_inside else tuple(outline)

    @property
    def point_mm(self) -> float:
        """The length of a drill's point."""
        return self.diameter_mm / 2 / math.tan(math.radians(self.point_angle_deg / 2))

    def _drill(self) -> Outline:
        radius_mm, reach_mm, point_mm = self.diameter_mm / 2, self.reach_mm or SHANK_REACH_MM, self.point_mm
        return (
            (0.0, 0.0, 0.0),
            (point_mm, -radius_mm, 0.0),
            (reach_mm, -radius_mm, 0.0),
            (reach_mm, radius_mm, 0.0),
            (point_mm, radius_mm, 0.0),
        )


def _half_turns(angle_deg: float) -> float:
    return (angle_deg + 180.0) % 360.0 - 180.0


def _along(point: tuple[float, float], direction_deg: float, length_mm: float) -> tuple[float, float]:
    angle = math.radians(direction_deg)
    return point[0] + length_mm * math.cos(angle), point[1] + length_mm * math.sin(angle)


def _box(z_first: float, z_last: float, low: float, high: float) -> Outline:
    left, right = sorted((z_first, z_last))
    return (left, low, 0.0), (right, low, 0.0), (right, high, 0.0), (left, high, 0.0)


def _mirrored(outline: list[Vertex]) -> Outline:
    """Return an outline mirrored at r = 0, again counter-clockwise."""
    turned = [(z, -r) for z, r, _ in reversed(outline)]
    bulges = [bulge for _, _, bulge in reversed(outline)]
    return tuple((z, r, bulge) for (z, r), bulge in zip(turned, [*bulges[1:], bulges[0]], strict=True))
