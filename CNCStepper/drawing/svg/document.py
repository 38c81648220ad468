# SPDX-License-Identifier: LGPL-2.1-or-later
"""The XML of an SVG file as elements, parsed by expat within bounds; nothing that the file names is fetched.

    bytes ──► unpacked (.svgz) ──► expat: no external entities, no parameter entities ──► Element tree

Entities may stand for short plain text only, as Illustrator's do for namespaces: such can neither nest nor grow.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.parsers import expat

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input
from CNCStepper.safe_text import printable

MOST_BYTES = 100_000_000
MOST_ELEMENTS = 250_000
MOST_DEPTH = 128
MOST_ENTITIES = 128
MOST_ENTITY_CHARACTERS = 256
MOST_GROWTH = 4_000_000  # characters that entities may add to a file
CHUNK_BYTES = 1 << 16
GZIP = b"\x1f\x8b"
SVG, XLINK = "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"
INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
ADOBE = "http://ns.adobe.com/"
PREFIXES = {SVG: "", "": "", XLINK: "xlink:", INKSCAPE: "inkscape:", "http://www.w3.org/XML/1998/namespace": "xml:"}
TEXT = "#text"


class Element:
    """An element: its local name ("" for one of another namespace), attributes, children, and text of a #text."""

    __slots__ = ("attributes", "children", "name", "text")

    def __init__(self, name: str, attributes: dict[str, str]):
        self.name, self.attributes = name, attributes
        self.children: list[Element] = []
        self.text = ""

    def get(self, key: str, otherwise: str = "") -> str:
        """Return an attribute."""
        return self.attributes.get(key, otherwise)

    def all(self) -> Iterator[Element]:
        """Yield the element and all below it, in the order of the file."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(element.children))


class Document:
    """The root element, the comments before it (a generator's mark) and whether Adobe's namespaces are used."""

    def __init__(self, root: Element, comments: str, adobe: bool):
        self.root, self.comments, self.adobe = root, comments, adobe


def read_document(path: Path) -> Document:
    """Return the document in an SVG file, packed or not; raises JobError for one that is none or out of bounds."""
    place = Place(str(path))
    content = read_input(path, MOST_BYTES)
    if content.startswith(GZIP):
        content = _unpacked(content, place)
    builder = _Builder(place, len(content))
    try:
        for at in range(0, max(len(content), 1), CHUNK_BYTES):
            checkpoint()
            builder.parser.Parse(content[at : at + CHUNK_BYTES], at + CHUNK_BYTES >= len(content))
    except (expat.ExpatError, LookupError, ValueError) as error:
        if isinstance(error, JobError):
            raise
        raise _no_svg(place, printable(str(error), 255), getattr(error, "lineno", None)) from error
    return builder.document()


def _unpacked(content: bytes, place: Place) -> bytes:
    """Return the content of a gzip file of bounded size."""
    machine = zlib.decompressobj(zlib.MAX_WBITS | 16)
    try:
        found = machine.decompress(content, MOST_BYTES + 1)
    except zlib.error as error:
        raise _no_svg(place, str(error)) from error
    if len(found) > MOST_BYTES:
        raise _large("bytes when it is unpacked", MOST_BYTES, place)
    return found


class _Builder:
    """Takes what expat finds; raises JobError where a bound is passed."""

    def __init__(self, place: Place, size: int):
        self._place = place
        self._left = size + MOST_GROWTH
        self._count = self._entities = 0
        self._stack: list[Element] = []
        self._root: Element | None = None
        self._comments: list[str] = []
        self._adobe = False
        self._names: dict[str, str] = {}
        self.parser = expat.ParserCreate(namespace_separator="\n")
        self.parser.buffer_text = True
        self.parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._characters
        self.parser.CommentHandler = self._comment
        self.parser.EntityDeclHandler = self._entity
        self.parser.StartNamespaceDeclHandler = self._namespace

    def document(self) -> Document:
        """Return what was built."""
        if self._root is None or self._root.name != "svg":
            raise _no_svg(self._place, "its first element is no <svg>")
        return Document(self._root, " ".join(self._comments), self._adobe)

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if self._count > MOST_ELEMENTS:
            raise _large("elements", MOST_ELEMENTS, self._place)
        if len(self._stack) >= MOST_DEPTH:
            raise _large("elements within each other", MOST_DEPTH, self._place)
        names, own = self._names, {}
        for key, value in attributes.items():
            self._left -= len(value)
            own[names[key] if key in names else self._local(key)] = value
        self._require_growth()
        element = Element(self._local(name), own)
        if self._stack:
            self._stack[-1].children.append(element)
        elif self._root is None:
            self._root = element
        self._stack.append(element)

    def _end(self, name: str) -> None:
        self._stack.pop()

    def _characters(self, text: str) -> None:
        self._left -= len(text)
        self._require_growth()
        if self._stack and (self._stack[-1].name in ("text", "tspan", "textPath", "a", "style", "title")):
            child = Element(TEXT, {})
            child.text = text
            self._stack[-1].children.append(child)

    def _comment(self, text: str) -> None:
        if not self._root and len(self._comments) < 8:
            self._comments.append(text[:200])

    def _namespace(self, prefix: str | None, address: str | None) -> None:
        self._adobe = self._adobe or bool(address and address.startswith(ADOBE))

    def _entity(self, *declared: Any) -> None:
        _, parameter, value, _, system, public, _ = declared
        self._entities += 1
        short = value is not None and len(value) <= MOST_ENTITY_CHARACTERS and not set("&<%") & set(value)
        if parameter or system or public or not short or self._entities > MOST_ENTITIES:
            raise JobError(
                "svg-entity",
                "the drawing declares XML entities that are longer than a short text",
                advice="save it again from the drawing program as plain SVG",
                place=self._place,
            )

    def _require_growth(self) -> None:
        if self._left < 0:
            raise _large("characters with its entities in their places", MOST_GROWTH, self._place)

    def _local(self, name: str) -> str:
        """Return a name without its namespace where that is SVG's, else with a prefix that we give; "" for unknown."""
        if name not in self._names and len(self._names) < MOST_ENTITIES * 8:
            address, _, local = name.rpartition("\n")
            prefix = PREFIXES.get(address)
            self._names[name] = "" if prefix is None else prefix + local
        return self._names.get(name, "")


def _large(of_what: str, most: int, place: Place) -> JobError:
    return JobError(
        "svg-large",
        Text("the drawing has too many {of_what}", of_what=of_what),
        limit=f"{most}",
        advice="split it into several drawings",
        place=place,
    )


def _no_svg(place: Place, why: str, line: int | None = None) -> JobError:
    return JobError(
        "svg-file",
        Text("not an SVG file: {why}", why=why),
        advice="save it again from the drawing program as plain SVG",
        place=place if line is None else Place(place.file, line),
    )
