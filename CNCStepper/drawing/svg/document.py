# SPDX-License-Identifier: LGPL-2.1-or-later
"""The XML of an SVG file as elements, parsed by expat within bounds; nothing that the file names is fetched.

    bytes ──► unpacked (.svgz) ──► expat: no external entities, no parameter entities ──► Survey: rules, count
                                                                                     └──► Element tree, or as a stream

Where no element refers to another one, elements of groups are parsed as they are asked for, so that a drawing of any
length takes the memory of its deepest branch.

Entities may stand for short plain text only, as Illustrator's do for namespaces: they cannot nest, and what they can
add to the file is known before it is parsed.
"""

from __future__ import annotations

import re
import zlib
from collections import Counter, deque
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple
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
WITH_TEXT = ("text", "tspan", "textPath", "a", "style", "title")
REFERRING = ("use", "textPath")
ASKS_SIBLINGS = re.compile(r":(?:nth-)?(?:last|only)-|[+~](?!=)", re.IGNORECASE)  # in rules; `1e+5` costs memory alone
ASKS_PLACES = re.compile(rf":(?:first|nth)-|:root|{ASKS_SIBLINGS.pattern}", re.IGNORECASE)
GROUPS = frozenset({"svg", "g", "a", "switch"})


class Siblings:
    """How many elements a parent has, of each name too, as far as they are parsed; `is_top`: the root's own."""

    __slots__ = ("count", "is_top", "kinds", "last")

    def __init__(self, is_top: bool = False):
        self.count, self.is_top = 0, is_top
        self.kinds: Counter[str] = Counter()
        self.last: Element | None = None


class Rank(NamedTuple):
    """Which child of its parent an element is, and which one of its name: 1 for the first."""

    of_all: int
    of_type: int


class Element:
    """An element: its local name ("" for one of another namespace), attributes, children, and text of a #text.

    The children of a group in a stream can be gone through once. Where rules of style ask for them there are its
    `rank`, its `siblings`, and the one `before` it (in a whole tree).
    """

    __slots__ = ("attributes", "before", "children", "name", "rank", "siblings", "text")

    def __init__(self, name: str, attributes: dict[str, str], children: Iterable[Element] = ()):
        self.name, self.attributes = name, attributes
        self.children = children
        self.text = ""
        self.rank: Rank | None = None
        self.siblings: Siblings | None = None
        self.before: Element | None = None

    def stand_among(self, siblings: Siblings, is_tree: bool) -> None:
        """Become the next one of some siblings."""
        siblings.count += 1
        siblings.kinds[self.name] += 1
        self.rank, self.siblings = Rank(siblings.count, siblings.kinds[self.name]), siblings
        if is_tree:
            self.before, siblings.last = siblings.last, self

    def get(self, key: str, otherwise: str = "") -> str:
        """Return an attribute."""
        return self.attributes.get(key, otherwise)

    def all(self) -> Iterator[Element]:
        """Yield the element and all below it, in the order of the file."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(tuple(element.children)))


class Document:
    """The root element, and what is known of the whole file.

    `is_stream`: no element refers to another one, no rule of style asks for what is behind one, and the groups'
    children are parsed as they are gone through.
    `rules`: the text of all <style>. `count`: how many elements there are. `comments`: those before the root (a
    generator's mark). `adobe`: whether Adobe's namespaces are used.
    """

    def __init__(self, root: Element, survey: _Survey):
        self.root, self.is_stream = root, survey.is_stream
        self.rules, self.count = "".join(survey.rules), survey.count
        self.comments, self.adobe = " ".join(survey.comments), survey.adobe


def read_document(path: Path) -> Document:
    """Return the document in an SVG file, packed or not; raises JobError for one that is none or out of bounds."""
    place = Place(str(path))
    content = read_input(path, MOST_BYTES)
    if content.startswith(GZIP):
        content = _unpacked(content, place)
    survey = _Survey(content, place)
    for _ in survey.parsed():
        pass
    if survey.root != "svg":
        raise _no_svg(place, "its first element is no <svg>")
    root = _Elements(content, place, survey.is_stream, survey.asks_places).next()
    assert root is not None
    return Document(root, survey)


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


class _Parser:
    """Gives what expat finds to the methods of a kind of reading; raises JobError where a bound is passed."""

    def __init__(self, content: bytes, place: Place):
        self._content, self._place = content, place
        self._names: dict[str, str] = {}
        self._parser = expat.ParserCreate(namespace_separator="\n")
        self._parser.buffer_text = True
        self._parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._takes_text = False

    def parsed(self) -> Iterator[None]:
        """Yield before each part of the file is parsed; at the end the parser is let go, with what it refers to."""
        for at in range(0, max(len(self._content), 1), CHUNK_BYTES):
            yield
            checkpoint()
            try:
                self._parser.Parse(self._content[at : at + CHUNK_BYTES], at + CHUNK_BYTES >= len(self._content))
            except (expat.ExpatError, LookupError, ValueError) as error:
                if isinstance(error, JobError):
                    raise
                raise _no_svg(self._place, printable(str(error), 255), getattr(error, "lineno", None)) from error
        del self._parser, self._content

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        raise NotImplementedError

    def _end(self, name: str) -> None:
        raise NotImplementedError

    def _characters(self, text: str) -> None:
        raise NotImplementedError

    def _take_text(self, wanted: bool) -> None:
        """Have text given from here on, or not: the blanks between elements are most of it."""
        if wanted != self._takes_text:
            self._takes_text = wanted
            self._parser.CharacterDataHandler = self._characters if wanted else None

    def _element(self, name: str, attributes: dict[str, str]) -> Element:
        names = self._names
        own = {names[key] if key in names else self._local(key): value for key, value in attributes.items()}
        return Element(self._local(name), own)

    def _local(self, name: str) -> str:
        """Return a name without its namespace where that is SVG's, else with a prefix that we give; "" for unknown."""
        if name not in self._names and len(self._names) < MOST_ENTITIES * 8:
            address, _, local = name.rpartition("\n")
            prefix = PREFIXES.get(address)
            self._names[name] = "" if prefix is None else prefix + local
        return self._names.get(name, "")


class _Survey(_Parser):
    """What is to be known of a whole file before it is read, and whether it is in bounds."""

    def __init__(self, content: bytes, place: Place):
        super().__init__(content, place)
        self.root: str | None = None
        self.refers, self.adobe = False, False
        self.count = self._entities = self._longest = 0
        self.rules: list[str] = []
        self.comments: list[str] = []
        self._inside: list[str] = []
        self._parser.CommentHandler = self._comment
        self._parser.EntityDeclHandler = self._entity
        self._parser.StartNamespaceDeclHandler = self._namespace

    @property
    def asks_places(self) -> bool:
        """Whether rules of style may ask which child of its parent an element is."""
        return ASKS_PLACES.search("".join(self.rules)) is not None

    @property
    def is_stream(self) -> bool:
        """Whether elements can be let go once they are read."""
        return not self.refers and not ASKS_SIBLINGS.search("".join(self.rules))

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self.count += 1
        if self.count > MOST_ELEMENTS:
            raise _large("elements", MOST_ELEMENTS, self._place)
        if len(self._inside) >= MOST_DEPTH:
            raise _large("elements within each other", MOST_DEPTH, self._place)
        local = self._local(name)
        self._inside.append(local)
        self._take_text(local == "style")
        self.refers = self.refers or local in REFERRING
        if self.root is None:
            self.root = local

    def _end(self, name: str) -> None:
        self._inside.pop()
        self._take_text(bool(self._inside) and self._inside[-1] == "style")

    def _characters(self, text: str) -> None:
        self.rules.append(text)

    def _comment(self, text: str) -> None:
        if not self.root and len(self.comments) < 8:
            self.comments.append(text[:200])

    def _namespace(self, prefix: str | None, address: str | None) -> None:
        self.adobe = self.adobe or bool(address and address.startswith(ADOBE))

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
        self._longest = max(self._longest, len(value))
        if self._content.count(b"&") * self._longest > MOST_GROWTH:
            raise _large("characters with its entities in their places", MOST_GROWTH, self._place)


class _Elements(_Parser):
    """The elements: all at once, or those of groups as they are asked for."""

    def __init__(self, content: bytes, place: Place, is_stream: bool, asks_places: bool):
        super().__init__(content, place)
        self._levels = [Siblings(is_top=True)] if asks_places else []  # of the elements that are open
        self._streamed: frozenset[str] = GROUPS if is_stream else frozenset()
        self._parts = self.parsed()
        self._open: list[tuple[Element, list[Element]]] = []  # of a whole element, and their children
        self._ready: deque[Element | None] = deque()  # whole elements and begun groups; None ends a group

    def next(self) -> Element | None:
        """Return the next whole element or begun group, None at the end of a group."""
        while not self._ready:
            next(self._parts, None)
        return self._ready.popleft()

    def _inside(self) -> Iterator[Element]:
        """Yield the children of a group; what was not taken of one is passed over."""
        while (element := self.next()) is not None:
            yield element
            if element.name in self._streamed:
                for _ in element.children:
                    pass

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        element = self._element(name, attributes)
        if self._levels:
            element.stand_among(self._levels[-1], not self._streamed)
            self._levels.append(Siblings())
        if not self._open and element.name in self._streamed:
            element.children = self._inside()
            self._ready.append(element)
            return
        children: list[Element] = []
        element.children = children
        if self._open:
            self._open[-1][1].append(element)
        self._open.append((element, children))
        self._take_text(element.name in WITH_TEXT)

    def _end(self, name: str) -> None:
        if self._levels:
            self._levels.pop()
        whole = self._open.pop()[0] if self._open else None
        if not self._open:
            self._ready.append(whole)
        self._take_text(bool(self._open) and self._open[-1][0].name in WITH_TEXT)

    def _characters(self, text: str) -> None:
        child = Element(TEXT, {})
        child.text = text
        self._open[-1][1].append(child)


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
