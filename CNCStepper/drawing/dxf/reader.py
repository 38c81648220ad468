# SPDX-License-Identifier: LGPL-2.1-or-later
"""DXF drawings: the curves of each layer in mm, joined to chains, with the gaps left and what could not be read.

ezdxf parses the file (and mends a damaged one); entities.py turns each entity into a curve. Blocks are
taken apart where they are inserted; what they hold on layer 0 lies on the layer of the insertion. Only the model space
is read, and of that what is visible.

What ezdxf writes into its log while it reads a drawing: kept here, made printable, and not on the terminal.

How much a DXF drawing holds, counted before it costs time: in the file, and with its blocks taken apart.

    bytes ──► require_readable   entities as they stand in the file          before ezdxf reads it, 0.1 s for 60 MB
    document ──► require_small   rows of blocks, and blocks within blocks    before any of them is taken apart

ezdxf reads some 20 000 entities a second; a block of ten things in ten rows and columns of itself, ten times over, is
a file of 2 kB and more things than any computer holds.
"""

from __future__ import annotations

import logging
import re
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.drawing import Attributes, Drawing, Piece, Share, Skipped, joined_pieces
from CNCStepper.drawing.dxf.entities import BROKEN, Fits, curve_of
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.errors import GeometryError, JobError, Place, Text, placed
from CNCStepper.geometry.chain_joining import NEAR_MM
from CNCStepper.input_file import read_input
from CNCStepper.quantities import Bounds
from CNCStepper.safe_text import printable
from CNCStepper.tolerances import JOINED_ENDS_MM

LOGGER = "ezdxf"
MOST_RECORDS = 20


class _Collector(logging.Handler):
    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.told: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        if len(self.told) < MOST_RECORDS:
            self.told.append(printable(record.getMessage(), 255))


@contextmanager
def collected_log() -> Iterator[list[str]]:
    """Give a list that takes the errors which ezdxf logs inside the block; none of its words reaches another log."""
    logger, collector = logging.getLogger(LOGGER), _Collector()
    propagates, logger.propagate = logger.propagate, False
    logger.addHandler(collector)
    try:
        yield collector.told
    finally:
        logger.removeHandler(collector)
        logger.propagate = propagates


MOST_BYTES = 100_000_000
MOST_ENTITIES = 100_000
MOST_POINTS = 1_000_000  # of all polylines and splines
SPLINE_WEIGHT = (
    5  # points: what a spline's control point takes beside reading; how long arcs are fitted has its own bound
)
DEEPEST = 32  # blocks within blocks; a block that holds itself goes on for ever
BINARY = b"AutoCAD Binary DXF\r\n\x1a\x00"
# the vertices of an old polyline are points of it, not entities
_ENTITY = re.compile(rb"\n[ \t]*0[ \t]*\r?\n[ \t]*(?!VERTEX\b|SEQEND\b)[A-Z0-9_]*[A-Z]")
_POINT = re.compile(rb"\n[ \t]*10[ \t]*\r?\n")
_BINARY_ENTITY = re.compile(rb"\x00\x00[A-Z0-9_]+\x00")
_OLD_BINARY_ENTITY = re.compile(rb"\x00[A-Z0-9_]{3,}\x00")  # until R12 a group's code is one byte


def require_readable(content: bytes, place: Place) -> None:
    """Raise JobError for a file of more entities or points than are read; what is no DXF file passes."""
    if content.startswith(BINARY):
        wide = b"\x00\x00SECTION\x00" in content[:100]
        entities, points = len((_BINARY_ENTITY if wide else _OLD_BINARY_ENTITY).findall(content)), 0
    else:
        entities, points = len(_ENTITY.findall(content)), len(_POINT.findall(content))
    _require("entities", entities, MOST_ENTITIES, place)
    _require("points", points, MOST_POINTS, place)


def require_small(document: Any, place: Place) -> int:
    """Return how many entities the model space has, blocks taken apart.

    Raises JobError where these, or their points, are more than are read.
    """
    entities, points = _Count(document).of(document.modelspace(), DEEPEST)
    _require("entities with its blocks taken apart", entities, MOST_ENTITIES, place)
    splines = Text("those of splines count {spline_weight} times", spline_weight=SPLINE_WEIGHT)
    _require(Text("points with its blocks taken apart ({splines})", splines=splines), points, MOST_POINTS, place)
    return entities


def _require(of_what: str, count: int, most: int, place: Place) -> None:
    if count > most:
        value = f"{count}" if count < 10**12 else "more than a million million"
        what, advice = (
            Text("the drawing has too many {of_what}", of_what=of_what),
            "draw polylines in place of single lines, or split it",
        )
        raise JobError("dxf-large", what, value=value, limit=f"{most}", advice=advice, place=place)


class _Count:
    """Counts entities and points; each block once for each depth at which it is inserted."""

    def __init__(self, document: Any):
        self._document = document
        self._known: dict[tuple[str, int], tuple[int, int]] = {}

    def of(self, entities: Any, depth: int) -> tuple[int, int]:
        """Return entities and points of a model space or block whose own blocks are at most `depth` deep."""
        total, points = 0, 0
        inserted: Counter[str] = Counter()
        for entity in entities:
            if entity.dxftype() == "INSERT" and depth:
                inserted[str(entity.dxf.get("name", ""))] += max(int(entity.mcount), 1)
            else:
                total, points = total + 1, points + _points_of(entity)
        for name, count in inserted.items():
            own, own_points = self._of_block(name, depth - 1)
            total, points = total + count * max(own, 1), points + count * own_points
        return total, points

    def _of_block(self, name: str, depth: int) -> tuple[int, int]:
        key = (name.casefold(), depth)
        if key not in self._known:
            block = self._document.blocks.get(name)
            self._known[key] = self.of(block, depth) if block is not None else (0, 0)
        return self._known[key]


def _points_of(entity: Any) -> int:
    kind = entity.dxftype()
    if kind == "SPLINE":
        return SPLINE_WEIGHT * (len(entity.control_points) + len(entity.fit_points))
    if kind == "LWPOLYLINE":
        return len(entity)
    return len(entity.vertices) if kind == "POLYLINE" else 0


MOST_WORDS = 255  # characters of a name, and of what ezdxf says
PARSED, CURVED = 0.4, 0.95  # of the time, for a drawing of lines, when ezdxf is done, and when all are curves
TOLD_EVERY = 256  # entities
UNIT_NAME = b"$INSUNITS"  # where a file does not hold it, ezdxf may take it for one in metres


def read_dxf(
    path: Path,
    tolerance_mm: float,
    unit_mm: float | None = None,
    same_mm: float = JOINED_ENDS_MM,
    near_mm: float = NEAR_MM,
    by_colour: bool = False,
    share: Share = lambda share: None,
) -> Drawing:
    """Return the curves of a DXF file; ellipses and splines within `tolerance_mm`, all else exact.

    `unit_mm` is the length of its unit where the file does not say it or is wrong; without either it is a mm. Ends
    within `same_mm` are joined (`by_colour`: only lines of one colour), gaps up to `near_mm` reported. `share` is
    called with the share that is done. Raises JobError for no DXF file or no curve in it.
    """
    if not tolerance_mm > 0:
        raise JobError("tolerance", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm")
    place = Place(str(path))
    content = read_input(path, MOST_BYTES)
    require_readable(content, place)
    with collected_log() as log:
        document, damage = _document(path)
        count = require_small(document, place)
        share(PARSED)
        unit_mm = unit_mm or (_unit_mm(document) if UNIT_NAME in content else 1.0)
        unit_mm = Bounds("unit").require(unit_mm, "the drawing's unit", place)
        told = _told(_visible(document, document.modelspace(), None, 0), count, share)
        with placed(place):
            pieces, skipped = _pieces(told, Fits(tolerance_mm / unit_mm), unit_mm)
    damage = damage or (log[0] if log else "")
    if not pieces and damage:
        raise _no_dxf(path, damage)
    if not pieces:
        raise JobError(
            "dxf-empty",
            "the drawing holds no curves",
            value=Text("{skipped} other things", skipped=len(skipped)) if skipped else "",
            advice="draw lines, arcs, circles, polylines, ellipses or splines in its model space, on visible layers",
            place=Place(str(path)),
        )
    with placed(place):
        chains, gaps = joined_pieces(
            pieces, same_mm, near_mm, by_colour, lambda done: share(CURVED + (1.0 - CURVED) * done)
        )
    return Drawing(chains, gaps, tuple(skipped), unit_mm, printable(damage, MOST_WORDS))


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the drawing in a DXF file, as `read_drawing` wants it."""
    same_mm, near_mm = options.same_mm, options.near_mm
    return read_dxf(path, options.tolerance_mm, options.unit_mm, same_mm, near_mm, options.by_colour, share)


def _told(entities: Iterator[tuple[Any, str]], count: int, share: Share) -> Iterator[tuple[Any, str]]:
    """Yield the entities, and call `share` with how far they are now and then."""
    for number, entity in enumerate(entities):
        checkpoint()
        if number % TOLD_EVERY == 0:
            share(PARSED + (CURVED - PARSED) * min(number / count, 1.0))
        yield entity


def _pieces(entities: Iterator[tuple[Any, str]], fits: Fits, unit_mm: float) -> tuple[list[Piece], list[Skipped]]:
    """Return the curve of each entity in mm, and the entities that have none."""
    pieces: list[Piece] = []
    skipped = []
    for entity, layer in entities:
        try:
            curve = curve_of(entity, fits)
            curve = curve if unit_mm == 1.0 else curve.scaled(unit_mm)
        except GeometryError as error:
            kind, handle = printable(entity.dxftype(), MOST_WORDS), printable(str(entity.dxf.handle or ""), MOST_WORDS)
            skipped.append(Skipped(kind, printable(layer, MOST_WORDS), handle, error.what))
        else:
            pieces.append(Piece(curve, Attributes(printable(layer, MOST_WORDS))))
    return pieces, skipped


def _document(path: Path) -> tuple[Any, str]:
    """Return the file as ezdxf has it, and what is damaged where it had to be mended.

    On a damaged file its parser may end with any exception.
    """
    import ezdxf  # it takes 0.4 s
    from ezdxf import recover

    try:
        return ezdxf.readfile(path), ""
    except Exception as damage:
        try:
            return recover.readfile(path)[0], str(damage) or "it ends too early"
        except Exception as error:
            raise _no_dxf(path, str(error)) from error


def _no_dxf(path: Path, why: str) -> JobError:
    advice = "save it as DXF again, as R2000 or newer"
    return JobError(
        "dxf-file", Text("not a DXF file: {why}", why=printable(why, MOST_WORDS)), advice=advice, place=Place(str(path))
    )


def _unit_mm(document: Any) -> float:
    """Return the length of the drawing's unit, 1 mm where it names none."""
    from ezdxf import units

    unit = units.InsertUnits(document.units)
    return float(units.conversion_factor(unit, units.InsertUnits.Millimeters)) if unit else 1.0


def _visible(document: Any, entities: Any, inserted_on: str | None, depth: int) -> Iterator[tuple[Any, str]]:
    """Yield the visible entities, blocks taken apart, with the layer on which each lies."""
    for entity in entities:
        layer = str(_attribute(entity, "layer", "0"))
        layer = inserted_on if inserted_on is not None and layer == "0" else layer
        if _attribute(entity, "invisible", 0) or _is_hidden(document, layer):
            continue
        if entity.dxftype() == "INSERT" and depth < DEEPEST:
            for insert in _inserts(entity):
                yield from _visible(document, _taken_apart(insert), layer, depth + 1)
        else:
            yield entity, layer


def _inserts(entity: Any) -> list[Any]:
    """Return an insertion in rows and columns as single ones; one that ezdxf cannot place stays what it is."""
    try:
        return list(entity.multi_insert()) if entity.mcount > 1 else [entity]
    except BROKEN:
        return [entity]


def _taken_apart(insert: Any) -> list[Any]:
    """Return the entities of a block where it is inserted, or the insertion itself where ezdxf cannot place them."""
    try:
        return list(insert.virtual_entities())
    except BROKEN:
        return [insert]  # at the deepest level it is named among what is left out


def _attribute(entity: Any, name: str, otherwise: Any) -> Any:
    """Return an attribute of an entity; kinds that ezdxf does not know have none."""
    return entity.dxf.get(name, otherwise) if entity.dxf.is_supported(name) else otherwise


def _is_hidden(document: Any, layer: str) -> bool:
    if not document.layers.has_entry(layer):
        return False
    found = document.layers.get(layer)
    return bool(found.is_off() or found.is_frozen())
