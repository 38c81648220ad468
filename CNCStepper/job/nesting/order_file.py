# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orders of parts from files: our own TOML, and the JSON of published strip packing instances.

    kerf_mm = 0.3                                   width of the cut: parts lie kerf + gap apart
    gap_mm = 2.0                                    material that stays between two cuts; 0: sides share one cut
    margin_mm = 5.0                                 material between a cut and the rim of the sheet
    common_lines = true                             with gap_mm = 0: facing edges are cut once (common_lines.py)
    [[sheet]]                                       size_mm, drawing or strip_height_mm
    size_mm = [1000.0, 500.0]                       count, material, thickness_mm, grain_deg
    [[part]]                                        drawing (layer), size_mm, diameter_mm or polygon_mm (holes_mm)
    drawing = "bracket.dxf"                         count, rotations_deg (a list or "any"), grain_deg, priority, fill,
    count = 12                                      material, thickness_mm, locked

    {"strip_height": 40.0, "items": [{"demand": 2, "rotations_deg": [0.0, 180.0], "polygon": [[x, y], ...]}, ...]}

A drawing's outline is its largest closed chain; the closed chains in it are holes, all else goes along as marks.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import shapely
from pydantic import BaseModel, ConfigDict, Field, StrictBool, model_validator
from shapely import Polygon

from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import CNCStepperError, JobError, Place, Text, placed
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.region import Region
from CNCStepper.machine.files.toml_reader import read_json, read_toml
from CNCStepper.machine.profile import validated
from CNCStepper.nesting.nesting_model import MOST_PARTS, MOST_ROTATIONS, Item, Placement, Sheet, Spacing
from CNCStepper.nesting.order_checks import polygon_from, require_count, require_finite
from CNCStepper.nesting.outlines import EXACT_MM, holding_polygon, simplified, within_polygon
from CNCStepper.quantities import MOST_ITEMS, Angle, Bounds, Coordinate, Length, LengthOr0
from CNCStepper.tolerances import SAME_MM

Point = tuple[Coordinate, Coordinate]
Ring = Annotated[tuple[Point, ...], Field(min_length=3, max_length=MOST_ITEMS["points"])]
ChainsOf = Callable[[str], tuple[str, tuple[Chain, ...]]]  # of a drawing's name: its place for errors, its chains
OUTLINE = Attributes(layer="CUT")


@dataclass(frozen=True)
class Order:
    """What is nested. chains: of each item, for the drawings. strip_height_mm: 0 where there are sheets.

    common_lines: whether facing edges of neighbours are cut once.
    """

    items: tuple[Item, ...]
    sheets: tuple[Sheet, ...]
    spacing: Spacing
    chains: tuple[tuple[Chain, ...], ...]
    kerf_mm: float = 0.0
    strip_height_mm: float = 0.0
    common_lines: bool = False


class _Form(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class _Stock(_Form):
    material: str = ""
    thickness_mm: LengthOr0 = 0.0

    @property
    def stock(self) -> str:
        """Material and thickness as one word."""
        return " ".join(filter(None, (self.material, f"{self.thickness_mm:g} mm" if self.thickness_mm else "")))


class LockedForm(_Form):
    """A part that lies where the user has put it."""

    sheet: Annotated[int, Bounds("number")]
    x_mm: Coordinate
    y_mm: Coordinate
    rotation_deg: Angle = 0.0


class SheetForm(_Stock):
    """Sheets of one kind, or a strip of any length."""

    name: str = ""
    size_mm: tuple[Length, Length] | None = None
    drawing: str | None = None
    layer: str | None = None
    strip_height_mm: Length | None = None
    count: Annotated[int, Bounds("count", most=1000)] = 1
    grain_deg: Angle | None = None

    @model_validator(mode="after")
    def _is_one(self) -> SheetForm:
        _require_one(self, ("size_mm", "drawing", "strip_height_mm"), "sheet")
        return self


class PartForm(_Stock):
    """A part and how often it is wanted."""

    name: str = ""
    drawing: str | None = None
    layer: str | None = None
    size_mm: tuple[Length, Length] | None = None
    diameter_mm: Length | None = None
    polygon_mm: Ring | None = None
    holes_mm: tuple[Ring, ...] = Field(default=(), max_length=MOST_ITEMS["shapes"])
    count: Annotated[int, Bounds("count", most=MOST_PARTS)] = 1
    rotations_deg: tuple[Angle, ...] | Literal["any"] = Field(default=(0.0,), min_length=1, max_length=MOST_ROTATIONS)
    grain_deg: Angle | None = None
    priority: Annotated[int, Bounds("number", least=-1000, most=1000)] = 0
    fill: StrictBool = False
    locked: tuple[LockedForm, ...] = Field(default=(), max_length=MOST_PARTS)

    @model_validator(mode="after")
    def _is_one(self) -> PartForm:
        _require_one(self, ("drawing", "size_mm", "diameter_mm", "polygon_mm"), "part")
        return self


class OrderForm(_Form):
    """The whole file."""

    kerf_mm: Annotated[float, Bounds("width", zero=True)] = 0.0
    gap_mm: LengthOr0 = 0.0
    margin_mm: LengthOr0 = 0.0
    common_lines: StrictBool = False
    tolerance_mm: Annotated[float, Bounds("tolerance", most=1.0)] = 0.02
    sheet: tuple[SheetForm, ...] = Field(min_length=1, max_length=1000)
    part: tuple[PartForm, ...] = Field(min_length=1, max_length=MOST_PARTS)


def _require_one(form: BaseModel, ways: Sequence[str], what: str) -> None:
    given = [way for way in ways if getattr(form, way) is not None]
    if len(given) != 1:
        told = ", ".join(given) or "none"
        raise ValueError(
            Text("a {what} needs one of {ways}; it has {told}", what=what, ways=", ".join(ways), told=told)
        )


def read_order(path: Path) -> Order:
    """Return the order in a file; raises JobError that names the part or the key."""
    with placed(Place(str(path))):
        if path.suffix.lower() == ".json":
            return _instance(read_json(path))
        return order_of(validated(OrderForm, read_toml(path), str(path)), partial(_read_chains, path.parent))


def _instance(content: dict[str, Any]) -> Order:
    """Return a published instance as an order of one strip."""
    height_mm = require_finite("strip_height", content.get("strip_height"))
    found = content.get("items")
    if not height_mm > 0.0 or not isinstance(found, list):
        raise JobError("nest-instance", "the file needs a strip_height above 0 and a list of items", advice="add them")
    items = tuple(_instance_item(number, each) for number, each in enumerate(found))
    chains = tuple((Chain(from_points(shapely.get_coordinates(item.exact)[:-1], True), OUTLINE),) for item in items)
    return Order(items, (_strip(items, height_mm, ""),), Spacing(), chains, strip_height_mm=height_mm)


def _instance_item(number: int, content: Any) -> Item:
    name = Text("item {number}", number=number)
    if not isinstance(content, dict):
        raise JobError(
            "nest-instance", Text("{name} is no object", name=name), advice="write it as an object, in braces"
        )
    polygon = polygon_from(name, content.get("polygon", ()))
    angles = content.get("rotations_deg", [0.0])
    if not isinstance(angles, list) or not 1 <= len(angles) <= MOST_ROTATIONS:
        what, advice = (
            Text("the rotations of {name} are no list of 1 to 360", name=name),
            "give 1 to 360 angles in brackets",
        )
        raise JobError("nest-rotations", what, advice=advice)
    rotations_deg = tuple(require_finite(f"a rotation of {name}", angle) for angle in angles)
    return Item(name, polygon, polygon, require_count(name, content.get("demand", 1)), rotations_deg)


def _strip(items: Sequence[Item], height_mm: float, stock: str) -> Sheet:
    """Return a sheet as high as the strip on which all items lie for certain."""
    lengths = [2.0 * shapely.minimum_bounding_radius(item.outline) * (item.count + len(item.locked)) for item in items]
    return Sheet("strip", shapely.box(0.0, 0.0, 2.0 * sum(lengths) + 1.0, height_mm), stock=stock)


def order_of(form: OrderForm, chains_of: ChainsOf) -> Order:
    """Return the order of a form; chains_of: gives the chains of a drawing by its name in the form."""
    if form.common_lines:
        require_no_gap(form.gap_mm)
    drawn = [_drawn(part, number, chains_of, form.tolerance_mm) for number, part in enumerate(form.part)]
    items = tuple(item for item, _ in drawn)
    spacing = Spacing(form.kerf_mm + form.gap_mm, form.kerf_mm + form.margin_mm)
    strips = [sheet for sheet in form.sheet if sheet.strip_height_mm is not None]
    if strips and (len(form.sheet) > 1 or strips[0].count > 1):
        raise JobError("nest-strip", "a strip must be the only sheet of an order", advice="take the others out")
    if strips:
        height_mm = strips[0].strip_height_mm or 0.0
        sheets: tuple[Sheet, ...] = (_strip(items, height_mm, strips[0].stock),)
    else:
        height_mm = 0.0
        sheets = tuple(sheet for number, each in enumerate(form.sheet) for sheet in _sheets(each, number, chains_of))
    chains = tuple(chains for _, chains in drawn)
    return Order(items, sheets, spacing, chains, form.kerf_mm, height_mm, form.common_lines)


def with_common_lines(order: Order) -> Order:
    """Return the order with facing edges that are cut once; raises JobError where it leaves gaps between cuts."""
    require_no_gap(order.spacing.gap_mm - order.kerf_mm)
    return replace(order, common_lines=True)


def require_no_gap(gap_mm: float) -> None:
    """Raise JobError where a gap is wanted between the cuts of parts that share them."""
    if gap_mm > SAME_MM:
        advice = "set gap_mm to 0, or leave common lines out"
        what = "parts that share cuts have no gap between their cuts"
        raise JobError("nest-common-gap", what, value=f"{gap_mm:g} mm", limit="0 mm", advice=advice)


def _sheets(form: SheetForm, number: int, chains_of: ChainsOf) -> list[Sheet]:
    name = form.name or Text("sheet {number}", number=number)
    if form.size_mm:
        outline = shapely.box(0.0, 0.0, *form.size_mm)
    else:
        region, _ = _region(name, chains_of, form.drawing or "", form.layer)
        with named(name):
            outline = within_polygon(region, EXACT_MM)
    return [Sheet(name, outline, form.grain_deg, form.stock)] * form.count


def _drawn(form: PartForm, number: int, chains_of: ChainsOf, tolerance_mm: float) -> tuple[Item, tuple[Chain, ...]]:
    """Return a part and the chains that are drawn for it."""
    name = form.name or (Path(form.drawing).stem if form.drawing else Text("part {number}", number=number))
    if form.polygon_mm:
        polygon = polygon_from(name, form.polygon_mm, form.holes_mm)
        rings = [shapely.get_coordinates(ring) for ring in (polygon.exterior, *polygon.interiors)]
        chains = tuple(Chain(from_points(ring[:-1], True), OUTLINE) for ring in rings)
        outline = exact = polygon
    else:
        region, chains = _shape(form, name, chains_of)
        with named(name):
            exact = holding_polygon(region, EXACT_MM)
            outline = simplified(exact, tolerance_mm)
    return _item(form, number, name, outline, exact), chains


def _item(form: PartForm, number: int, name: str, outline: Polygon, exact: Polygon) -> Item:
    locked = tuple(Placement(each.sheet, number, each.x_mm, each.y_mm, each.rotation_deg) for each in form.locked)
    return Item(
        name=name,
        outline=outline,
        exact=exact,
        count=form.count,
        rotations_deg=None if form.rotations_deg == "any" else tuple(form.rotations_deg),
        grain_deg=form.grain_deg,
        priority=form.priority,
        fill=form.fill,
        locked=locked,
        stock=form.stock,
    )


def _shape(form: PartForm, name: str, chains_of: ChainsOf) -> tuple[Region, tuple[Chain, ...]]:
    if form.drawing is not None:
        return _region(name, chains_of, form.drawing, form.layer)
    if form.diameter_mm is not None:
        curve = circle((form.diameter_mm / 2.0, form.diameter_mm / 2.0), form.diameter_mm / 2.0)
    else:
        wide, high = form.size_mm or (0.0, 0.0)
        curve = from_points([(0.0, 0.0), (wide, 0.0), (wide, high), (0.0, high)], closed=True)
    return Region.of([curve]), (Chain(curve, OUTLINE),)


def _read_chains(folder: Path, file: str) -> tuple[str, tuple[Chain, ...]]:
    return str(folder / file), tuple(read_drawing(folder / file, ReadOptions()).chains)


def _region(name: str, chains_of: ChainsOf, file: str, layer: str | None) -> tuple[Region, tuple[Chain, ...]]:
    """Return the outline with its holes in a drawing, and all its chains."""
    place, chains = chains_of(file)
    if layer is not None:
        chains = tuple(chain for chain in chains if chain.attributes.layer.casefold() == layer.casefold())
    with placed(Place(place)), named(name):
        return outline_region([chain.curve for chain in chains]), chains


def outline_region(curves: Sequence[Curve]) -> Region:
    """Return the largest closed curve with the closed ones directly in it as holes.

    Raises JobError where there is none, and where a curve lies beside it: such a drawing holds several parts.
    """
    closed = sorted((curve for curve in curves if curve.closed), key=lambda curve: -abs(curve.area_mm2))
    if not closed:
        raise JobError("nest-open", "the drawing has no closed outline", advice="close it, or name another layer")
    outer = Region.of(closed[:1])
    inner = [curve for curve in closed[1:] if outer.contains(_place_in(curve)).all()]
    if len(inner) < len(closed) - 1:
        advice = "give each outline a drawing or a layer of its own"
        raise JobError("nest-outlines", "the drawing has outlines beside each other", advice=advice)
    holes = [curve for curve in inner if not any(_holds(other, curve) for other in inner if other is not curve)]
    return Region.of(closed[:1], holes)


def _place_in(curve: Curve) -> np.ndarray:
    return curve.at_length(curve.length_mm * (np.arange(5) + 0.5) / 5.0)[0]


def _holds(outer: Curve, inner: Curve) -> bool:
    return abs(outer.area_mm2) > abs(inner.area_mm2) and bool((outer.winding(_place_in(inner)) != 0).all())


class named:
    """Names the part in an error that leaves this block."""

    def __init__(self, name: str):
        self._name = name

    def __enter__(self) -> None:
        """Begin the block."""

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: object) -> None:
        if isinstance(error, CNCStepperError):
            what = Text("part '{name}': {what}", name=self._name, what=error.what)
            raise JobError(error.code, what, value=error.value, limit=error.limit, advice=error.advice) from error
