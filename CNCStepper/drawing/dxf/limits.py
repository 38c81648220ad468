# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much a DXF drawing holds, counted before it costs time: in the file, and with its blocks taken apart.

    bytes ──► require_readable   entities as they stand in the file          before ezdxf reads it, 0.1 s for 60 MB
    document ──► require_small   rows of blocks, and blocks within blocks    before any of them is taken apart

ezdxf reads some 20 000 entities a second; a block of ten things in ten rows and columns of itself, ten times over, is
a file of 2 kB and more things than any computer holds.
"""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterable
from typing import Any

from CNCStepper.errors import JobError, Place, Text

MOST_BYTES = 100_000_000
MOST_ENTITIES = 100_000
ENOUGH = 10  # times as many are not counted to the last one
MOST_POINTS = 1_000_000  # of all polylines and splines
SPLINE_WEIGHT = (
    5  # points: what a spline's control point takes beside reading; how long arcs are fitted has its own bound
)
DEEPEST = 32  # blocks within blocks; a block that holds itself goes on for ever
LONGEST = 1_000  # bytes: what the patterns below find is shorter
BINARY = b"AutoCAD Binary DXF\r\n\x1a\x00"
# the vertices of an old polyline are points of it, not entities
_ENTITY = re.compile(rb"\n[ \t]*0[ \t]*(?=\r?\n[ \t]*(?!VERTEX\b|SEQEND\b)\S)")
_POINT = re.compile(rb"\n[ \t]*10[ \t]*\r?\n")
_BINARY_ENTITY = re.compile(rb"\x00\x00[A-Z0-9_]+\x00")
_OLD_BINARY_ENTITY = re.compile(rb"\x00[A-Z0-9_]{3,}\x00")  # until R12 a group's code is one byte


def require_readable(chunks: Iterable[bytes], place: Place) -> None:
    """Raise JobError for a text of more entities or points than are read; what is no DXF file passes."""
    counts: _TextCounts | _BinaryCounts | None = None
    tail = b""
    for chunk in itertools.chain(chunks, [b""]):
        counts = counts or (_BinaryCounts(chunk) if chunk.startswith(BINARY) else _TextCounts())
        content = tail + chunk
        end = max(len(content) - LONGEST, 0) if chunk else len(content)
        counts.add(content, end)
        tail = content[end:]
        if counts.entities > ENOUGH * MOST_ENTITIES:
            break
    assert counts
    _require("entities", counts.entities, MOST_ENTITIES, place)
    _require("points", counts.points, MOST_POINTS, place)


class _TextCounts:
    """The entities and points of a text so far: lines are code and value in turn, an entity is the code 0."""

    def __init__(self) -> None:
        self.entities = self.points = self._lines = 0

    def add(self, content: bytes, end: int) -> None:
        """Count what begins before a place; what comes behind it is seen again in the next content."""
        self.points += _found(_POINT, content, end)
        counted, lines = 0, self._lines
        for match in itertools.takewhile(lambda match: match.start() < end, _ENTITY.finditer(content)):
            lines += content.count(b"\n", counted, match.end())
            counted = match.end()
            self.entities += lines % 2 == 0
        self._lines += content.count(b"\n", 0, end)


class _BinaryCounts:
    """The entities of a binary file so far; its points are not counted."""

    points = 0

    def __init__(self, begin: bytes) -> None:
        self.entities = 0
        self._entity = _BINARY_ENTITY if b"\x00\x00SECTION\x00" in begin[:100] else _OLD_BINARY_ENTITY

    def add(self, content: bytes, end: int) -> None:
        """Count what begins before a place; what comes behind it is seen again in the next content."""
        self.entities += _found(self._entity, content, end)


def _found(pattern: re.Pattern[bytes], content: bytes, end: int) -> int:
    """Return how often a pattern begins before a place, without a list of all the places."""
    return sum(1 for match in pattern.finditer(content) if match.start() < end)


def require_small(document: Any, plain: int, place: Place) -> int:
    """Return how many entities the model space has, `plain` of them beside the document's, blocks taken apart.

    Raises JobError where these, or their points, are more than are read.
    """
    entities, points = _Count(document).of(document.modelspace(), DEEPEST)
    entities += plain
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
