# SPDX-License-Identifier: LGPL-2.1-or-later
"""The `[[shape]]` tables of a job file: drawn once, named by operations, resolved into curves before a cycle sees them.

    [[shape]]                        [[operation]]                    the cycle's own field
    name = "boss"             --->   islands = ["boss"]        --->   islands = (Curve,)
    circle_mm = { ... }

A saved job holds the curves themselves and needs no shapes any more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, StrictBool, model_validator

from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.drawing.chain_list import counts_of
from CNCStepper.drawing.crossing_areas import without_crossings
from CNCStepper.drawing.drawing import Drawing, Share
from CNCStepper.drawing.nesting_levels import nesting_levels
from CNCStepper.drawing.point_list import read_points
from CNCStepper.drawing.repair.mend import CHANGES, Change, mended
from CNCStepper.errors import GeometryError, JobError, Place, Text, all_of, placed
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.geometry.shapes.ellipse import Ellipse
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.job.drawings.read_any import read_any_drawing
from CNCStepper.job.shape_forms.drawing_form import DrawingForm
from CNCStepper.job.shape_forms.library_form import LibraryForm
from CNCStepper.job.shape_forms.text_form import TextForm
from CNCStepper.machine.profile import validated
from CNCStepper.quantities import MOST_ITEMS, Angle, Bounds, Coordinate, Length, LengthOr0, Unit, WidthOr0, shown

Point = tuple[Coordinate, Coordinate]
ELLIPSE_TOLERANCE_MM = 0.001
MOST_DRAWINGS = 32  # that one job reads: each may take a minute
MOST_DRAWN = 2_000_000  # lines and arcs in the files of one job
MOST_SKIPPED = 5  # entities that are listed
MOST_LISTED = 12  # layers that a refusal names
MOST_GAPS = 1000  # that the notes of one shape name


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)


class CircleForm(_Checked):
    """A circle; lengths in mm, as the suffix of a key says."""

    centre: Point
    radius: Length

    def curve(self) -> Curve:
        """Return it counter-clockwise."""
        return circle(self.centre, self.radius)


class RectangleForm(_Checked):
    """A rectangle along the axes by its diagonal, mm, its corners sharp or round."""

    corner_a: Point
    corner_b: Point
    corner_radius: LengthOr0 = 0.0

    @model_validator(mode="after")
    def _is_one(self) -> RectangleForm:
        try:
            self.curve()
        except GeometryError as error:
            raise ValueError(error.what) from error
        return self

    def curve(self) -> Curve:
        """Return it counter-clockwise from the left end of its lower side."""
        return rectangle(self.corner_a, self.corner_b, self.corner_radius)


class EllipseForm(_Checked):
    """An ellipse, mm; it becomes arcs within ELLIPSE_TOLERANCE_MM."""

    centre: Point
    radius_x: Length
    radius_y: Length
    rotation_deg: Angle = 0.0

    def curve(self) -> Curve:
        """Return it counter-clockwise."""
        ellipse = Ellipse.of_radii(self.centre, self.radius_x, self.radius_y, self.rotation_deg)
        return ellipse.parallel(0.0, ELLIPSE_TOLERANCE_MM)


class DxfForm(_Checked):
    """A layer of a DXF file; unit_mm: the length of its unit, where the file does not say it or is wrong."""

    file: str = Field(min_length=1)
    layer: str
    tolerance_mm: Annotated[float, Bounds("tolerance", most=1.0)] = 0.005
    unit_mm: Unit | None = None


class ShapeForm(_Checked):
    """A shape as a job file names it: a name and one way of drawing it. `closed` and `smooth_mm` belong to `points`.

    smooth_mm: the line through the points becomes arcs and lines within it.
    """

    name: str = Field(min_length=1)
    polygon_mm: tuple[Point, ...] | None = Field(default=None, min_length=3, max_length=MOST_ITEMS["points"])
    circle_mm: CircleForm | None = None
    rectangle_mm: RectangleForm | None = None
    ellipse_mm: EllipseForm | None = None
    points: str | None = None
    closed: StrictBool = False
    smooth_mm: WidthOr0 = 0.0
    dxf: DxfForm | None = None
    drawing: DrawingForm | None = None
    library: LibraryForm | None = None
    text: TextForm | None = None
    curve: CurveField | None = None

    @model_validator(mode="after")
    def _is_drawn_once(self) -> ShapeForm:
        ways = [key for key in WAYS if getattr(self, key) is not None]
        if len(ways) != 1:
            told = Text("it has {ways}", ways=all_of(ways)) if ways else Text("it has none")
            raise ValueError(
                Text("the shape '{name}' needs one of {ways}; {told}", name=self.name, ways=", ".join(WAYS), told=told)
            )
        if self.closed and self.points is None:
            raise ValueError("closed belongs to points")
        if self.smooth_mm and self.points is None:
            raise ValueError("smooth_mm belongs to points")
        return self


WAYS = ("polygon_mm", "circle_mm", "rectangle_mm", "ellipse_mm", "points", "dxf", "drawing", "library", "text", "curve")


@dataclass(frozen=True)
class Shapes:
    """The curves of each shape by name, and notes on their drawings."""

    curves: dict[str, tuple[Curve, ...]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def named(self, name: str, key: ShapeKey, place: Place) -> tuple[Curve, ...]:
        """Return the curves of one shape; raises JobError for an unknown one, or an open one where that cannot be."""
        if name not in self.curves:
            known = ", ".join(f"'{each}'" for each in self.curves)
            raise JobError(
                "shape-unknown",
                Text("{key} names the shape '{name}', which the job does not have", key=key.says, name=name),
                advice=Text("name one of: {known}", known=known) if known else "draw it in a [[shape]] table",
                place=place,
            )
        curves = self.curves[name]
        ends = [tuple(np.round(curve.xy[0], 3).tolist()) for curve in curves if not curve.closed]
        if key.closed and ends:
            raise JobError(
                "shape-open",
                Text("{key} needs a closed shape, but '{name}' does not end where it begins", key=key.says, name=name),
                value=Text(
                    "{ends} of {curves} open, the first from {end}", ends=len(ends), curves=len(curves), end=ends[0]
                ),
                advice="close it",
                place=place,
            )
        return curves


NO_SHAPES = Shapes()


@dataclass(frozen=True)
class ShapeKey:
    """A key of an operation that names shapes, the cycle's field that takes their curves, and whether they must close.

    A dot leads into a table: "pattern.circles".
    """

    says: str
    field: str
    closed: bool = True


_AREA = (ShapeKey("outlines", "outlines"), ShapeKey("region", "outlines"))
_LINES = (ShapeKey("curves", "curves", closed=False), ShapeKey("region", "curves"))
_HOLES = (ShapeKey("pattern.circles", "pattern.circles"),)
SHAPE_KEYS: dict[str, tuple[ShapeKey, ...]] = {
    "pocket": (*_AREA, ShapeKey("islands", "islands")),
    "face": _AREA,
    "contour": _LINES,
    "engrave": _LINES,
    "sheet_cut": (*_LINES, ShapeKey("marks", "marks", closed=False)),
    "drill": _HOLES,
    "bore": _HOLES,
    "thread": _HOLES,
    "wire_cut": _LINES,
}


def read_shapes(
    tables: Sequence[dict[str, Any]], folder: Path, file: str, drawn: Drawn, share: Share = lambda share: None
) -> Shapes:
    """Return the shapes of a job's `[[shape]]` tables; their files are looked for in `folder`.

    `drawn` counts what they hold; `share` is called with the share of a drawing that is done while it is read. Raises
    JobError that names the file and the shape.
    """
    curves: dict[str, tuple[Curve, ...]] = {}
    files = _Files(folder, drawn, share)
    for number, table in enumerate(tables, start=1):
        place = f"{file} shape {number}"
        shape = validated(ShapeForm, table, place)
        if shape.name in curves:
            what = Text("two shapes have the name '{shape}'", shape=shape.name)
            raise JobError("shape-twice", what, advice="rename one of them", place=Place(place))
        with placed(Place(place)), _file_of(place):
            curves[shape.name] = files.curves(shape, curves)
    notes = (*files.notes, *files.level_notes())
    return Shapes(curves, tuple(dict.fromkeys(notes)))


@contextmanager
def _file_of(place: str) -> Iterator[None]:
    """Let an error of a file that cannot be read name the shape that wants it, too."""
    try:
        yield
    except JobError as error:
        if not error.code.startswith("input-"):
            raise
        told = {"value": error.value, "limit": error.limit, "advice": error.advice}
        raise JobError(
            error.code, Text("{place}: {error}", place=error.place, error=error.what), **told, place=Place(place)
        ) from error


class Drawn:
    """Counts the lines and arcs in the files that one job names, of which together there is a bounded number."""

    def __init__(self) -> None:
        self._segments = 0

    def add(self, curves: Iterable[Curve]) -> None:
        """Count these too; raises JobError where they are too many with those before them."""
        self._segments += sum(map(len, curves))
        if self._segments > MOST_DRAWN:
            raise _too_much("too many lines and arcs in its files", self._segments, MOST_DRAWN)


class _Files:
    """The files that the shapes of one job name; each drawing is read once for each way in which it is read."""

    def __init__(self, folder: Path, drawn: Drawn, share: Share):
        self._folder, self._drawn, self._share = folder, drawn, share
        self._drawings: dict[tuple[Any, ...], Drawing] = {}
        self._levels: dict[str, tuple[str, DrawingForm, set[int]]] = {}  # nesting levels taken, by the rest of a form
        self.notes: list[str] = []

    def curves(self, shape: ShapeForm, before: Mapping[str, tuple[Curve, ...]]) -> tuple[Curve, ...]:
        """Return the curves of a shape; `before` are those of the shapes that stand before it."""
        if shape.polygon_mm is not None:
            return (from_points(shape.polygon_mm, closed=True),)
        if shape.points is not None:
            return self._points(self._folder / shape.points, shape.closed, shape.smooth_mm)
        if shape.curve is not None:
            return (shape.curve,)
        if shape.dxf is not None:
            return self._layer(shape.name, shape.dxf)
        if shape.drawing is not None:
            return self._selected(shape.name, shape.drawing)
        if shape.library is not None:
            return shape.library.curves()
        if shape.text is not None:
            return self._text(shape.text, before)
        form = shape.circle_mm or shape.rectangle_mm or shape.ellipse_mm
        assert form is not None  # the model has seen to it
        return (form.curve(),)

    def _text(self, form: TextForm, before: Mapping[str, tuple[Curve, ...]]) -> tuple[Curve, ...]:
        curves = form.curves(self._folder, before)
        self._drawn.add(curves)
        return curves

    def _points(self, path: Path, closed: bool, smooth_mm: float) -> tuple[Curve, ...]:
        drawn = read_points(path, closed)
        curves = (refitted(drawn, smooth_mm) if smooth_mm else drawn,)
        self._drawn.add(curves)
        return curves

    def _layer(self, name: str, form: DxfForm) -> tuple[Curve, ...]:
        """Return the chains of a layer."""
        from CNCStepper.drawing.dxf.reader import read_dxf  # it loads what few jobs need

        key = ("dxf", form.model_copy(update={"layer": ""}))
        path = self._folder / form.file
        drawing = self._drawing(key, lambda: read_dxf(path, form.tolerance_mm, form.unit_mm, share=self._share))
        layer = drawing.layer(form.layer)
        self.notes.extend(_notes(name, form.file, drawing, [layer.name]))
        return layer.curves

    def _selected(self, name: str, form: DrawingForm) -> tuple[Curve, ...]:
        """Return the chains of a drawing that a shape means; raises JobError where there are none."""
        key = ("drawing", form.file, form.options(), form.mend)
        drawing = self._drawing(key, lambda: self._read(form))
        chains = form.selected(drawing.chains)
        if not chains:
            raise _nothing_selected(name, form, drawing)
        if form.nesting is not None:
            whole = form.model_copy(update={"nesting": None})
            self._levels.setdefault(whole.model_dump_json(), (name, whole, set()))[2].add(form.nesting)
        layers = dict.fromkeys(chain.attributes.layer for chain in chains)
        self.notes.extend(_notes(name, form.file, drawing, list(layers)))
        return tuple(form.placed(chain.curve) for chain in chains)

    def level_notes(self) -> Iterator[str]:
        """Yield a note for each drawing whose chains are nested deeper than the shapes take."""
        for name, form, levels in self._levels.values():
            drawing = self._drawings["drawing", form.file, form.options(), form.mend]
            closed = without_crossings([chain for chain in form.selected(drawing.chains) if chain.curve.closed])
            missed = sorted(set(nesting_levels([chain.curve for chain in closed]).tolist()) - levels)
            if missed:
                yield Text(
                    "shape '{name}': no shape takes the chains of its drawing at the nesting level {missed}",
                    name=name,
                    missed=", ".join(map(str, missed)),
                )

    def _read(self, form: DrawingForm) -> Drawing:
        drawing = read_any_drawing(self._folder / form.file, form.options(), self._share)
        if form.mend is None:
            return drawing
        drawing, changes = mended(drawing, form.mend)
        self.notes.extend(_mended_notes(form.file, changes))
        return drawing

    def _drawing(self, key: tuple[Any, ...], read: Callable[[], Drawing]) -> Drawing:
        """Return the drawing of that key, read now where it was not read before."""
        if key not in self._drawings:
            if len(self._drawings) == MOST_DRAWINGS:
                raise _too_much("too many drawings, or one read in too many ways", MOST_DRAWINGS + 1, MOST_DRAWINGS)
            drawing = self._drawings[key] = read()
            self._drawn.add(chain.curve for chain in drawing.chains)
        return self._drawings[key]


def _nothing_selected(name: str, form: DrawingForm, drawing: Drawing) -> JobError:
    counts = counts_of(drawing.chains)
    known = ", ".join(f"'{count.layer}' {count.colour}".strip() for count in counts[:MOST_LISTED])
    return JobError(
        "drawing-selection",
        Text("the drawing {file} has no chains for the shape '{name}': {words}", file=form.file, name=name,
             words=form.words),
        advice=Text("it has chains on {known}", known=known),
    )  # fmt: skip


def _mended_notes(file: str, changes: Sequence[Change]) -> Iterator[str]:
    """Yield what was mended in a drawing, a sentence for each kind of change."""
    for kind, words in CHANGES.items():
        own = [change for change in changes if change.kind == kind]
        if own:
            yield Text("the drawing {file}: {words}: {count}", file=file, words=words, count=len(own))


def _too_much(of_what: str, count: int, most: int) -> JobError:
    advice = "make several jobs of this one"
    return JobError(
        "shapes-large", Text("the job has {of_what}", of_what=of_what), value=f"{count}", limit=f"{most}", advice=advice
    )


def _notes(name: str, file: str, drawing: Drawing, layers: Sequence[str]) -> Iterator[str]:
    """Yield what of some layers is not as drawn: damage, gaps, and what no tool could follow."""
    if drawing.damage:
        yield Text(
            "the drawing {form_file} is damaged, a part of it may be missing: {damage}",
            form_file=file,
            damage=drawing.damage,
        )
    yield from drawing.warnings
    for gap in [gap for layer, gap in drawing.gaps if layer in layers][:MOST_GAPS]:
        x, y = gap.place_mm
        yield Text(
            "shape '{name}': two ends lie {size_mm:.3g} mm apart at X{x:.3f} Y{y:.3f}",
            name=name,
            size_mm=gap.size_mm,
            x=x,
            y=y,
        )
    folded = {layer.casefold() for layer in layers}
    skipped = [each for each in drawing.skipped if each.layer.casefold() in folded]
    for entity in skipped[:MOST_SKIPPED]:
        yield Text(
            "shape '{name}' goes without the {entity_kind} {handle} of its drawing: {why}",
            name=name,
            entity_kind=entity.kind,
            handle=entity.handle,
            why=entity.why,
        )
    if len(skipped) > MOST_SKIPPED:
        yield Text(
            "shape '{name}' goes without {skipped} more things of its drawing",
            name=name,
            skipped=len(skipped) - MOST_SKIPPED,
        )


def with_curves(content: dict[str, Any], shapes: Shapes, file: str) -> dict[str, Any]:
    """Return an operation's table with the curves of the shapes that it names, in the fields of its cycle.

    What is a curve already (in a saved job) stays. Raises JobError that names file, key, the name and those known.
    """
    resolved = dict(content)
    for key in SHAPE_KEYS.get(str(content.get("cycle", "")), ()):
        *tables, last = key.says.split(".")
        inside = _inner(resolved, tables)
        if inside is not None and last in inside:
            named = _listed(inside.pop(last), key, Place(file))
            curves = [curve for each in named for curve in _resolved(each, shapes, key, Place(file))]
            own = key.field.rpartition(".")[2]
            inside[own] = (*inside.get(own, ()), *curves) if own != last else tuple(curves)
    return resolved


def _inner(content: dict[str, Any], tables: Iterable[str]) -> dict[str, Any] | None:
    """Return the table that has a key, as a copy that may be changed; None where there is none."""
    for name in tables:
        if not isinstance(content.get(name), dict):
            return None
        content[name] = content = dict(content[name])
    return content


def _listed(value: Any, key: ShapeKey, place: Place) -> Sequence[Any]:
    if isinstance(value, str):
        return [value]
    if isinstance(value, list | tuple):
        _require_once(value, key, place)
        return value
    what = Text("{key} must be the name of a shape, or a list of names", key=key.says)
    raise JobError(
        "shape-name", what, value=shown(value), advice=Text('write {key} = "name"', key=key.says), place=place
    )


def _require_once(names: Sequence[Any], key: ShapeKey, place: Place) -> None:
    """Raise JobError for a shape that one list names twice: it would be cut twice, or kept twice."""
    seen: set[str] = set()
    for name in names:
        if isinstance(name, str) and name in seen:
            what, advice = Text("{key} names the shape '{name}' twice", key=key.says, name=name), "name it once"
            raise JobError("shape-twice", what, advice=advice, place=place)
        if isinstance(name, str):
            seen.add(name)


def _resolved(each: Any, shapes: Shapes, key: ShapeKey, place: Place) -> tuple[Any, ...]:
    return shapes.named(each, key, place) if isinstance(each, str) else (each,)
