# SPDX-License-Identifier: LGPL-2.1-or-later
"""SVG drawings: the curves of each layer in mm, Y up, zero at the lower left of the sheet, joined to chains.

    file ──► document.py: elements ──► sheet.py: mm ──► Walk: transforms, styles, layers, <use> ──► Piece ──► chains

The layer is the label of the nearest layer of Inkscape around, else the id of the outermost group. What cannot be
read is named with the reason; clip paths, masks, dashes and fonts that are not there are told as warnings.
"""

from __future__ import annotations

import itertools
import math
import operator
import re
from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.chain_columns import ChainColumns
from CNCStepper.drawing.drawing import Attributes, Drawing, Share, Skipped
from CNCStepper.drawing.joined_pieces import joined_pieces
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.drawing.svg.document import REFERRING, Document, Element, read_document
from CNCStepper.drawing.svg.fitted_pieces import FittedPieces
from CNCStepper.drawing.svg.matrices import NUMBER, Matrix, about, fitted, length, transform_of, view_box
from CNCStepper.drawing.svg.path_data import PathDamage, PlacedPen, draw_path, draw_points, draw_rectangle
from CNCStepper.drawing.svg.sheet import is_illustrator, sheet_of
from CNCStepper.drawing.svg.styles import Style, StyleSheet, font_size, styled
from CNCStepper.drawing.svg.text_elements import LetterOutlines, TextSetter
from CNCStepper.drawing.svg.text_letters import Letters
from CNCStepper.errors import CNCStepperError, GeometryError, JobError, Place, Text, placed
from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.fitting.bezier_path import PathPen
from CNCStepper.quantities import Bounds
from CNCStepper.safe_text import printable

MOST_DRAWN = 250_000  # elements with those of <use> in their places
MOST_USES = 16  # within each other
DEEPEST = 200  # elements within each other, with those that are used
MOST_SKIPPED = 1_000
MOST_NAME = 255
MOST_NAMED = 5  # fonts or letters in a warning
READ_SHARE = 0.9
TOLD_EVERY = 512
CONTAINERS = {"g", "a", "svg", "switch", "symbol"}
NOT_DRAWN = {
    "defs", "title", "desc", "metadata", "style", "script", "clipPath", "mask", "pattern", "linearGradient", "marker",
    "radialGradient", "filter", "symbol", "tspan", "view", "cursor", "font", "font-face", "meshgradient", "solidcolor",
    "animate", "animateTransform", "animateMotion", "set", "#text", "",
}  # fmt: skip
PLAIN = re.compile(r"-?\d{1,9}(?:\.\d{1,30})?", re.ASCII)  # a number of user units
LANGUAGE = "en"  # of elements that a file has in several: one drawing is one program wherever it is read
MOST_CHOICES = 1_000  # of a switch, and languages of an element
MARKED = ("path", "line", "polyline", "polygon")
ESCAPED = re.compile(r"_x([0-9A-Fa-f]{2,4})_")  # what Illustrator makes of blanks and signs in names
SVG_WARNINGS = {
    "clip": "{count} clip paths and masks are not applied: the parts that they hide are read too",
    "dash": "{count} dashed strokes are read as whole lines",
    "font": "{count} texts are set in another font or style than the file names: {names}",
    "glyph": "the fonts of {count} texts lack letters, which are left out: {names}",
    "language": "{count} elements are for one language: those in English, or in none, are read",
    "length": "{count} texts with places inside their textLength are not brought to it",
    "marker": "{count} lines have markers, which are not read",
    "set": "{count} texts are written downwards, raised or lowered: they are set on a straight line",
    "path-end": "{count} texts are longer than their path; letters beyond it are left out: {names}",
    "path": "{count} paths are damaged and read up to the damage",
    "selector": "{count} rules of style are not applied, because of their selectors: {names}",
    "transform": "{count} transforms are damaged and not applied",
}


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the drawing in an SVG file, as `read_drawing` wants it."""
    if not options.tolerance_mm > 0:
        what, advice = "the tolerance must be above 0", "give a tolerance above 0"
        raise JobError("tolerance", what, value=f"{options.tolerance_mm:g} mm", advice=advice)
    place = Place(str(path))
    document = read_document(path)
    with placed(place):
        rules = StyleSheet(document.rules)
        style = styled(document.root, Style(), rules, [])
        matrix, viewport, unit_mm, warning = sheet_of(document, style, options.unit_mm)
        Bounds("unit").require(unit_mm, "the drawing's unit", place)
        walk = _Walk(document, rules, options.tolerance_mm, viewport, share)
        chains, gaps = joined_pieces(
            walk.pieces(matrix, style),
            options.same_mm,
            options.near_mm,
            options.by_colour,
            lambda done: share(READ_SHARE + (1.0 - READ_SHARE) * done),
        )
        if not chains:
            raise _empty(walk.skipped, place)
    warnings = (*((warning,) if warning else ()), *walk.warnings())
    return Drawing(chains, gaps, walk.skipped, unit_mm, warnings=warnings)


def _empty(skipped: tuple[Skipped, ...], place: Place) -> JobError:
    return JobError(
        "svg-empty",
        "the drawing holds no curves",
        value=Text("{skipped} other things, the first: {why}", skipped=len(skipped), why=skipped[0].why)
        if skipped
        else "",
        advice="draw visible shapes, paths or texts; convert pictures to paths in the drawing program",
        place=place,
    )


class _Context(NamedTuple):
    """What an element takes from those around it."""

    matrix: Matrix
    style: Style
    layer: str
    name: str
    groups: tuple[str, ...]
    viewport: tuple[float, float]
    uses: tuple[int, ...] = ()
    is_layer: bool = False  # whether `layer` is one of Inkscape's


class _Walk:
    """Goes through the elements of a drawing and gathers their pieces."""

    def __init__(
        self, document: Document, rules: StyleSheet, tolerance_mm: float, viewport: tuple[float, float], share: Share
    ):
        self._root, self._viewport, self._sheet = document.root, viewport, rules
        self._share, self._pieces = share, FittedPieces(tolerance_mm)
        self._letters = LetterOutlines(tolerance_mm, self._pieces.budget)
        self._illustrator = is_illustrator(document)
        self._by_id = {} if document.is_stream else _referred(document.root)
        self._done, self._count = 0, document.count if document.is_stream else self._counted(document.root, {}, 0)
        if self._count > MOST_DRAWN:
            what, advice = "the drawing has too many elements with those that it uses", "split it into several drawings"
            raise JobError("svg-large", what, value=f"{self._count:.6g}", limit=f"{MOST_DRAWN}", advice=advice)
        self._told: Counter[str] = Counter()
        self._names: dict[str, dict[str, None]] = {}
        self._skipped: list[tuple[int, Skipped]] = []
        for selector in self._sheet.unknown:
            self._told["selector"] += 1
            self._names.setdefault("selector", {})[printable(selector, 40)] = None

    def pieces(self, matrix: Matrix, style: Style) -> ChainColumns:
        """Return the pieces of the whole drawing; raises JobError where its curves are too many for the tolerance."""
        context = _Context(matrix, style, "", "", (), self._viewport)
        try:
            self._children(self._root, context, [])
            return self._pieces.all()
        except GeometryError as error:
            raise JobError("svg-large", error.what, limit=error.limit, advice=error.advice) from error

    @property
    def skipped(self) -> tuple[Skipped, ...]:
        """What is in no piece, in the order of the file."""
        return tuple(skipped for _, skipped in sorted(self._skipped, key=operator.itemgetter(0)))

    def warnings(self) -> tuple[str, ...]:
        """Return what was read otherwise than the file says."""
        return tuple(
            Text(SVG_WARNINGS[key], count=count, names=", ".join(list(self._names[key])[:MOST_NAMED]))
            if key in self._names
            else Text(SVG_WARNINGS[key], count=count)
            for key, count in self._told.items()
            if count
        )

    def _children(self, element: Element, context: _Context, above: list[Element]) -> None:
        inside = [*above, element]
        children: Iterable[Element] = element.children
        if element.name == "switch":
            choices = (child for child in itertools.islice(children, MOST_CHOICES) if child.name not in NOT_DRAWN)
            children = itertools.islice((child for child in choices if not _unread(child)), 1)
        for child in children:
            self._element(child, context, inside)

    def _element(self, element: Element, around: _Context, above: list[Element]) -> None:
        if element.name in NOT_DRAWN:
            return
        self._count_drawn()
        if "systemLanguage" in element.attributes:
            self._told["language"] += 1
        if why := _unread(element):
            self._skip(element, around, why)
            return
        style = styled(element, around.style, self._sheet, above)
        if not style.displayed:
            return
        context = self._inside(element, around, style)
        if element.name == "use":
            self._use(element, context, above)
        elif element.name in CONTAINERS:
            if element.name == "svg":
                context = _in_viewport(element, element, style, context)
            self._children(element, context, above)
        elif style.visible:
            self._drawn(element, context, above)

    def _counted(self, element: Element, known: dict[int, int], depth: int) -> int:
        """Return how many elements are drawn with those of each <use> in its place; each is counted once."""
        if depth > DEEPEST:
            return 1
        if id(element) not in known:
            known[id(element)] = 1  # of one that holds itself
            used = self._used(element) if element.name == "use" else None
            inner = [*element.children, used] if used is not None else element.children
            known[id(element)] = 1 + sum(self._counted(child, known, depth + 1) for child in inner)
        return known[id(element)]

    def _used(self, element: Element) -> Element | None:
        address = element.get("href") or element.get("xlink:href")
        return self._by_id.get(address[1:]) if address.startswith("#") else None

    def _count_drawn(self) -> None:
        self._done += 1
        if self._done % TOLD_EVERY == 0:
            checkpoint()
            self._share(READ_SHARE * min(self._done / self._count, 1.0))

    def _inside(self, element: Element, around: _Context, style: Style) -> _Context:
        matrix = around.matrix
        text = style.get("transform") or element.get("transform")
        if text and text != "none":
            origin = style.get("transform-origin") or element.get("transform-origin")
            try:
                own = transform_of(text)
                matrix = matrix @ (about(own, origin, around.viewport) if origin else own)
            except ValueError:
                self._told["transform"] += 1
        if style.clips:
            self._told["clip"] += style.clips
        label = self._label(element)
        _, _, layer, name, groups, viewport, uses, is_layer = around
        name = label or name
        if element.name not in CONTAINERS and element.name != "use":
            return _Context(matrix, style, layer, name, groups, viewport, uses, is_layer)
        if element.get("inkscape:groupmode") == "layer":
            layer, is_layer = label, True
        elif not layer and not is_layer and element.get("id"):
            layer = self._name(element.get("id"))
        groups = (*groups, label) if label else groups
        return _Context(matrix, style, layer, name, groups, viewport, uses, is_layer)

    def _label(self, element: Element) -> str:
        return self._name(element.get("inkscape:label") or element.get("id"))

    def _name(self, text: str) -> str:
        if self._illustrator:
            text = ESCAPED.sub(lambda match: chr(int(match[1], 16)), text)
        return printable(text, MOST_NAME)

    def _use(self, element: Element, context: _Context, above: list[Element]) -> None:
        """Draw what a <use> names where it stands; one that names itself ends here."""
        target = self._used(element)
        if target is None:
            address = element.get("href") or element.get("xlink:href")
            self._skip(
                element, context, Text("it uses '{address}', which is not in the file", address=printable(address, 80))
            )
            return
        if id(target) in context.uses or len(context.uses) >= MOST_USES or len(above) > DEEPEST:
            self._skip(element, context, "it uses itself, or too many others within each other")
            return
        x, y = _lengths(element, context, "x y")
        context = context._replace(
            matrix=context.matrix @ Matrix(shift=complex(x, y)), uses=(*context.uses, id(target))
        )
        if target.name in ("symbol", "svg"):
            own = context._replace(style=styled(target, context.style, self._sheet, above))
            self._children(target, _in_viewport(target, element, context.style, own), above)
        else:
            self._element(target, context, above)

    def _drawn(self, element: Element, context: _Context, above: list[Element]) -> None:
        style = context.style
        stroke, fill = style.stroke, style.fill
        if element.name not in SHAPES and element.name != "text":
            why = "a picture and no line" if element.name == "image" else "nothing that a tool could follow"
            self._skip(element, context, why)
            return
        if stroke is None and fill is None:
            self._skip(element, context, "it has neither a stroke nor a fill")
            return
        if stroke is not None and style.dashed:
            self._told["dash"] += 1
        if element.name in MARKED and style.marked:
            self._told["marker"] += 1
        colour = stroke if stroke is not None else fill
        attributes = Attributes(context.layer, colour or "", context.name, context.groups, fill is not None)
        number = self._done

        def refused(error: GeometryError | JobError | ValueError) -> None:
            why = error.what if isinstance(error, CNCStepperError) else str(error)
            self._skip(element, context, why, number)

        try:
            if element.name == "text":
                self._pieces.add_curves(self._text(element, context, above), attributes)
                return
            pens = self._pens(element, context, close=stroke is None)
        except (GeometryError, JobError, ValueError) as error:
            if isinstance(error, CNCStepperError) and error.code in ("svg-large", "fit-budget"):
                raise
            refused(error)
            return
        self._pieces.add_paths(pens, attributes, refused)

    def _pens(self, element: Element, context: _Context, close: bool) -> list[PathPen]:
        """Return the subpaths of a shape; open ones that are filled alone are closed as the fill is."""
        pen = PlacedPen(context.matrix)
        try:
            SHAPES[element.name](pen, element, context)
        except PathDamage:
            self._told["path"] += 1
        if close:
            for own in pen.pens:
                own.close()
        return pen.pens

    def _text(self, element: Element, context: _Context, above: list[Element]) -> list[Curve]:
        letters = Letters(
            lambda child, style, inside: styled(child, style, self._sheet, [*above, *inside]), context.viewport
        )
        letters.read(element, context.style)
        told: dict[tuple[str, str], None] = {}
        self._told["set"] += any(letter.style.off_line for letter in letters.letters)
        setter = TextSetter(self._letters, self._text_path, lambda key, name: told.update({(key, name): None}))
        curves = setter.outlines(letters, context.matrix)
        self._told.update({key for key, _ in told})
        for key, name in told:
            self._names.setdefault(key, {})[printable(name, 40)] = None
        return curves

    def _text_path(self, address: str) -> Curve | None:
        """Return the path of a textPath in user units."""
        target = self._by_id.get(address[1:]) if address.startswith("#") else None
        if target is None or target.name not in SHAPES:
            return None
        try:
            matrix = transform_of(target.get("transform"))
        except ValueError:
            matrix = Matrix()
        pen = PlacedPen(matrix)
        SHAPES[target.name](pen, target, _Context(matrix, Style(), "", "", (), self._viewport))
        curves = [own.path().curve(0.01, self._pieces.budget) for own in pen.pens if len(own)]
        return joined(curves) if curves else None

    def _skip(self, element: Element, context: _Context, why: str, number: int | None = None) -> None:
        """Note that an element is left out, the one that is read now or an earlier one by its number."""
        if len(self._skipped) < MOST_SKIPPED:
            identity = printable(element.get("id"), MOST_NAME)
            left_out = Skipped(printable(element.name, 40), context.layer, identity, why)
            self._skipped.append((self._done if number is None else number, left_out))


def _referred(root: Element) -> dict[str, Element]:
    """Return the elements that others refer to by their id; of two with one id the first."""
    addresses = {
        element.get("href") or element.get("xlink:href") for element in root.all() if element.name in REFERRING
    }
    found: dict[str, Element] = {}
    for element in root.all() if addresses else ():
        if (name := element.get("id")) and "#" + name in addresses:
            found.setdefault(name, element)
    return found


def _unread(element: Element) -> str:
    """Return why an element is for other readers: for one with extensions, or of another language; "" for no reason."""
    if "requiredExtensions" in element.attributes or element.name == "foreignObject":
        return Text("it is drawn by programs with extensions alone")
    if "systemLanguage" in element.attributes and not _speaks(element.get("systemLanguage")):
        return Text("it is of another language than English")
    return ""


def _speaks(languages: str) -> bool:
    """Return whether a list of languages holds that in which drawings are read."""
    return any(word.strip().casefold().split("-")[0] == LANGUAGE for word in languages.split(",", MOST_CHOICES))


def _in_viewport(element: Element, sized: Element, style: Style, context: _Context) -> _Context:
    """Return the context inside a nested <svg> or a <symbol>, of which `sized` and its style give the size."""
    width, height = (
        length(style.geometry.get(key) or sized.get(key) or element.get(key), whole, whole)
        for key, whole in zip(("width", "height"), context.viewport, strict=True)
    )
    x, y = _lengths(element, context, "x y") if element.name == "svg" else (0.0, 0.0)
    matrix, box = context.matrix @ Matrix(shift=complex(x, y)), view_box(element.get("viewBox"))
    if box and width > 0.0 and height > 0.0:
        matrix = matrix @ fitted(box, width, height, element.get("preserveAspectRatio"))
        width, height = box[2], box[3]
    return context._replace(matrix=matrix, viewport=(width, height))


def _lengths(element: Element, context: _Context, keys: str, otherwise: float = 0.0) -> list[float]:
    """Return lengths of an element in user units: of the width, the height, or for radii of both."""
    own = context.style.geometry
    return [_length(own.get(key) or element.get(key), key, context, otherwise) for key in keys.split()]


def _length(text: str, key: str, context: _Context, otherwise: float) -> float:
    if not text:
        return otherwise
    if PLAIN.fullmatch(text) and math.isfinite(number := float(text)):
        return number
    width, height = context.viewport
    wholes = {"x": width, "w": width, "y": height, "h": height, "r": math.hypot(width, height) / math.sqrt(2.0)}
    em = font_size(context.style) if context.style else 16.0
    return length(text, wholes[key.strip("c12")[0]] if key != "ry" else height, otherwise, em)


def _rectangle(pen: PlacedPen, element: Element, context: _Context) -> None:
    x, y, width, height = _lengths(element, context, "x y width height")
    rx, ry = _lengths(element, context, "rx ry", math.nan)
    rx, ry = (ry if math.isnan(rx) else rx), (rx if math.isnan(ry) else ry)
    if not (width > 0.0 and height > 0.0):
        raise ValueError(Text("its width or height is not above 0"))
    draw_rectangle(pen, x, y, width, height, max(rx, 0.0) if rx == rx else 0.0, max(ry, 0.0) if ry == ry else 0.0)


def _circle(pen: PlacedPen, element: Element, context: _Context) -> None:
    x, y, radius = _lengths(element, context, "cx cy r")
    _ellipse_of(pen, complex(x, y), radius, radius)


def _ellipse(pen: PlacedPen, element: Element, context: _Context) -> None:
    x, y = _lengths(element, context, "cx cy")
    rx, ry = _lengths(element, context, "rx ry", math.nan)
    rx, ry = (ry if math.isnan(rx) else rx), (rx if math.isnan(ry) else ry)
    _ellipse_of(pen, complex(x, y), rx, ry)


def _ellipse_of(pen: PlacedPen, centre: complex, rx: float, ry: float) -> None:
    if not (rx > 0.0 and ry > 0.0):
        raise ValueError(Text("its radius is not above 0"))
    pen.ellipse(centre, rx, ry)


def _line(pen: PlacedPen, element: Element, context: _Context) -> None:
    x1, y1, x2, y2 = _lengths(element, context, "x1 y1 x2 y2")
    draw_points(pen, [complex(x1, y1), complex(x2, y2)], False)


def _polyline(pen: PlacedPen, element: Element, context: _Context) -> None:
    values = [float(word) for word in NUMBER.findall(element.get("points"))]
    draw_points(pen, list(map(complex, values[::2], values[1::2])), element.name == "polygon")


def _path(pen: PlacedPen, element: Element, context: _Context) -> None:
    draw_path(pen, context.style.geometry.get("d", element.get("d")))


SHAPES: dict[str, Callable[[PlacedPen, Element, _Context], None]] = {
    "path": _path,
    "rect": _rectangle,
    "circle": _circle,
    "ellipse": _ellipse,
    "line": _line,
    "polyline": _polyline,
    "polygon": _polyline,
}
