# SPDX-License-Identifier: LGPL-2.1-or-later
"""DXF drawings: the curves of each layer in mm, joined to chains, with the gaps left and what could not be read.

    text, by windows ──► plain_entities.py: lines, arcs, circles, light polylines ──► plain_columns.py ──┐
                     └─► ezdxf: header, tables, blocks, all other entities ──► entities.py: curves ──────┴─► chains

ezdxf repairs a damaged file and reads all of it. Each insertion of a block becomes its entities; those on layer 0 get
the layer of the insertion. Only visible entities of the model space are read. Hatches, solids and texts follow the
chains.
"""

from __future__ import annotations

import operator
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.chain_columns import ChainColumns, ChainGatherer, columns_joined
from CNCStepper.drawing.drawing import KERF, Attributes, Chain, Drawing, Share, Skipped
from CNCStepper.drawing.dxf.attributes import (
    OUTSIDE,
    Insertion,
    Layers,
    attribute,
    attributes,
    entity_colour,
    layer_of,
)
from CNCStepper.drawing.dxf.entities import AREAS, BROKEN, Fits, curve_of
from CNCStepper.drawing.dxf.ezdxf_document import collected_log, load_file, load_text, no_dxf
from CNCStepper.drawing.dxf.group_text import NotSplit
from CNCStepper.drawing.dxf.groups import groups_of
from CNCStepper.drawing.dxf.hatches import hatch_curves, without_drawn
from CNCStepper.drawing.dxf.limits import DEEPEST, MOST_BYTES, require_readable, require_small
from CNCStepper.drawing.dxf.plain_columns import plain_pieces
from CNCStepper.drawing.dxf.plain_entities import PlainEntities, split_text
from CNCStepper.drawing.dxf.texts import KINDS as TEXTS
from CNCStepper.drawing.dxf.texts import Texts
from CNCStepper.drawing.joined_pieces import joined_pieces
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.errors import GeometryError, JobError, Place, Text, placed
from CNCStepper.geometry.chain_joining import NEAR_MM
from CNCStepper.geometry.curve import Curve
from CNCStepper.input_file import Unchanged, input_chunks, read_input
from CNCStepper.quantities import Bounds
from CNCStepper.safe_text import printable
from CNCStepper.tolerances import JOINED_ENDS_MM

MOST_WORDS = 255  # characters of a name, and of a message of ezdxf
COUNTED, PARSED, CURVED = 0.1, 0.8, 0.85  # of the time, for a drawing of lines, when each of these is done
TOLD_EVERY = 256  # entities
HATCH = "HATCH"
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
        advice = "give a tolerance above 0"
        raise JobError("tolerance", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm", advice=advice)
    place = Place(str(path))
    require_readable(_chunks(path, lambda done: share(COUNTED * done)), place)
    unchanged = Unchanged(path)
    with collected_log() as log:
        source = _source(path, lambda done: share(COUNTED + (PARSED - COUNTED) * done))
        unchanged.check()
        count = require_small(source.document, len(source.plain), place)
        share(PARSED)
        unit_mm = unit_mm or (_unit_mm(source.document) if source.has_unit else 1.0)
        unit_mm = Bounds("unit").require(unit_mm, "the drawing's unit", place)
        with placed(place):
            reading = _Reading(source, Fits(tolerance_mm / unit_mm), unit_mm)
            pieces, skipped = reading.all(count, share)
    damage = source.damage or (log[0] if log else "")
    if not pieces and not reading.whole:
        raise no_dxf(path, damage) if damage else _empty(path, len(skipped))
    with placed(place):
        chains, gaps = joined_pieces(
            pieces, same_mm, near_mm, by_colour, lambda done: share(CURVED + (1.0 - CURVED) * done)
        )
    kept, doubles = without_drawn([*chains, *reading.whole]) if reading.whole else (chains, 0)
    warnings = [*reading.texts.warnings, *_double_warnings(doubles)]
    told = printable(damage, MOST_WORDS), tuple(warnings), _kerf_mm(source.document)
    return Drawing(kept, gaps, tuple(skipped), unit_mm, *told)


def _kerf_mm(document: Any) -> float | None:
    """Return the kerf that a nested sheet names; None where there is none, or no good one."""
    try:
        return Bounds("width").require(float(document.header.custom_vars.get(KERF, "")), KERF)
    except (ValueError, JobError):
        return None


def _empty(path: Path, skipped: int) -> JobError:
    return JobError(
        "dxf-empty",
        "the drawing holds no curves",
        value=Text("{skipped} other things", skipped=skipped) if skipped else "",
        advice="draw lines, arcs, circles, polylines, ellipses or splines in its model space, on visible layers",
        place=Place(str(path)),
    )


def _double_warnings(doubles: int) -> list[str]:
    if not doubles:
        return []
    return [Text("{doubles} boundaries of hatches are drawn as lines too; they are read once", doubles=doubles)]


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the drawing in a DXF file, as `read_drawing` wants it."""
    same_mm, near_mm = options.same_mm, options.near_mm
    return read_dxf(path, options.tolerance_mm, options.unit_mm, same_mm, near_mm, options.by_colour, share)


@dataclass
class _Source:
    """A file as it is read: the entities read straight, and the document of ezdxf with all else.

    `numbers` has the place in the file of each entity of the document by its handle, in capitals. `has_unit`: the file
    names its unit. `groups` are the names of those round an entity, by its handle, too.
    """

    document: Any
    damage: str
    has_unit: bool
    groups: dict[str, tuple[str, ...]]
    plain: PlainEntities = field(default_factory=PlainEntities)
    numbers: dict[str, int] = field(default_factory=dict)
    encoding: str = "utf-8"


class _Reading:
    """Takes the pieces out of a file, in the order of the file."""

    def __init__(self, source: _Source, fits: Fits, unit_mm: float):
        self._source, self._fits, self._unit_mm = source, fits, unit_mm
        self._layers = Layers(source.document)
        self.whole: list[Chain] = []
        self.texts = Texts(source.document, fits.tolerance)
        self._pieces, self._numbers = ChainGatherer(), array("q")
        self._skipped: list[tuple[int, Skipped]] = []

    def all(self, count: int, share: Share) -> tuple[ChainColumns, list[Skipped]]:
        """Return the curve of each of `count` entities in mm, and the entities that have none."""
        plain, numbers = self._read_plain()
        for done, _ in enumerate(self._read_others(), start=len(numbers)):
            checkpoint()
            if done % TOLD_EVERY == 0:
                share(PARSED + (CURVED - PARSED) * min(done / count, 1.0))
        skipped = [skipped for _, skipped in sorted(self._skipped, key=operator.itemgetter(0))]
        pieces = columns_joined(plain, self._pieces.columns())
        order = np.argsort(np.concatenate([numbers, np.array(self._numbers, int)]), kind="stable")
        del plain
        return pieces.where(order, pieces.bundle.taken(order)), skipped

    def _read_plain(self) -> tuple[ChainColumns, np.ndarray]:
        """Return the pieces of the ordinary entities and their numbers."""
        source = self._source
        plain = source.plain
        source.plain = PlainEntities()  # its columns are those of the pieces
        if not len(plain):
            return ChainGatherer().columns(), np.empty(0, np.int32)
        found = plain_pieces(plain, self._layers, source.groups, source.encoding, self._unit_mm)
        for number, kind, layer, handle, error in found.refused:
            self._skip(number, kind, layer, handle, error)
        for number, piece in found.mended:
            self._pieces.add(piece.curve, piece.attributes)
            self._numbers.append(number)
        return found.columns, found.numbers

    def _read_others(self) -> Iterator[None]:
        for order, entity in enumerate(self._source.document.modelspace()):
            handle = str(entity.dxf.handle or "")
            number = self._source.numbers.get(handle.upper(), order)
            yield from self._read(entity, number, self._around(handle))

    def _around(self, handle: str) -> Insertion:
        """Return what is around an entity of the model space: its groups."""
        groups = self._source.groups.get(handle.upper())
        return Insertion(groups=groups) if groups else OUTSIDE

    def _read(self, entity: Any, number: int, around: Insertion) -> Iterator[None]:
        """Take the pieces of an entity where it is visible; a block is taken apart."""
        layer = self._layers.named(layer_of(entity, around))
        if attribute(entity, "invisible", 0) or self._layers.is_hidden(layer):
            return
        colour = entity_colour(entity, layer, around, self._layers)
        if entity.dxftype() == "INSERT" and len(around.blocks) < DEEPEST:
            if _is_external(entity):
                advice = "bind it into the drawing, and save it again"
                why = GeometryError("dxf-xref", "an external reference, whose file is not opened", advice=advice)
                self._skip(number, "INSERT", layer, str(entity.dxf.get("name", "")), why)
                yield
                return
            blocks = (*around.blocks, str(entity.dxf.get("name", "")))
            inside = Insertion(layer, colour, blocks, around.groups)
            for insert in _inserts(entity):
                for part in _taken_apart(insert):
                    yield from self._read(part, number, inside)
            for attached in entity.attribs:
                yield from self._read(attached, number, inside)
            return
        own = attributes(layer, colour, str(entity.dxf.handle or ""), around)
        try:
            if entity.dxftype() in (HATCH, *AREAS, *TEXTS):
                self._read_whole(entity, own)
            else:
                self._add(number, curve_of(entity, self._fits), own)
        except GeometryError as error:
            self._skip(number, entity.dxftype(), layer, str(entity.dxf.handle or ""), error)
        yield

    def _read_whole(self, entity: Any, own: Attributes) -> None:
        """Take the curves of an area or a text, which are never joined with those of others."""
        if entity.dxftype() in TEXTS:
            curves = self.texts.curves(entity)
            filled = self.texts.is_filled(entity)
        else:
            is_hatch, filled = entity.dxftype() == HATCH, True
            curves = hatch_curves(entity, self._fits) if is_hatch else [curve_of(entity, self._fits)]
        self.whole += [Chain(self._scaled(curve), replace(own, filled=filled)) for curve in curves]

    def _skip(self, number: int, kind: str, layer: str, handle: str, error: GeometryError) -> None:
        kind, layer, handle = (printable(text, MOST_WORDS) for text in (kind, layer, handle))
        self._skipped.append((number, Skipped(kind, layer, handle, error.what)))

    def _add(self, number: int, curve: Curve, own: Attributes) -> None:
        self._pieces.add(self._scaled(curve), own)
        self._numbers.append(number)

    def _scaled(self, curve: Curve) -> Curve:
        return curve if self._unit_mm == 1.0 else curve.scaled(self._unit_mm)


def _chunks(path: Path, share: Share) -> Iterator[bytes]:
    """Yield the bytes of a file in pieces."""
    done_bytes = 0
    for chunk in input_chunks(path, MOST_BYTES):
        checkpoint()
        yield chunk
        done_bytes += len(chunk)
        share(min(done_bytes / path.stat().st_size, 1.0))


def _source(path: Path, share: Share) -> _Source:
    """Return the file with its ordinary entities read straight, or all of it as ezdxf has it."""
    try:
        found = split_text(_chunks(path, share))
    except NotSplit:
        return _whole(path, *load_file(path))
    try:
        document, encoding = load_text(found.rest)
    except Exception:  # of ezdxf's parser
        document, damage = load_file(path)
        if not damage:  # the file is whole, so that its shortened text is a fault of the split
            raise
        return _whole(path, document, damage)
    groups = groups_of(document, found.rest)
    return _Source(document, "", UNIT_NAME in found.rest, groups, found.plain, found.numbers, encoding)


def _whole(path: Path, document: Any, damage: str) -> _Source:
    """Return a file of which ezdxf has read all."""
    return _Source(document, damage, UNIT_NAME in read_input(path, MOST_BYTES), groups_of(document, None))


def _unit_mm(document: Any) -> float:
    """Return the length of the drawing's unit, 1 mm where it names none."""
    from ezdxf import units

    unit = units.InsertUnits(document.units)
    return float(units.conversion_factor(unit, units.InsertUnits.Millimeters)) if unit else 1.0


def _is_external(insert: Any) -> bool:
    """Return whether an insertion stands for another file, which is never opened."""
    block = insert.block()
    return block is not None and bool(block.block.is_xref or block.block.is_xref_overlay)


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
