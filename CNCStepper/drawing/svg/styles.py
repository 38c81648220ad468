# SPDX-License-Identifier: LGPL-2.1-or-later
"""The style of SVG elements: attributes, classes of <style>, the attribute style, and what is inherited.

    weakest                                                                        strongest
    inherited ──► attribute fill="…" ──► rules: * · tag · .class · #id ──► style="fill:…" ──► those marked !important

What selects an element is in selectors.py. Selectors that it does not know select nothing and are told; those of a
pointer (":hover") never select anything in a drawing.
"""

from __future__ import annotations

import operator
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, NamedTuple

from CNCStepper.drawing.svg.colours import colour_code
from CNCStepper.drawing.svg.document import TEXT, Element
from CNCStepper.drawing.svg.matrices import length
from CNCStepper.drawing.svg.selectors import Matcher, Selector, parsed_selector, selectors
from CNCStepper.errors import JobError

INHERITED = {
    "stroke", "fill", "color", "visibility", "fill-rule", "stroke-dasharray", "font-family", "font-size", "font-style",
    "font-weight", "font", "text-anchor", "letter-spacing", "stroke-opacity", "fill-opacity", "stroke-width", "marker",
    "marker-start", "marker-mid", "marker-end", "writing-mode",
}  # fmt: skip
PAINTS = ("fill", "stroke", "color")
SAME_AS_COLOUR = ("currentcolor", "context-stroke", "context-fill")
NO_COLOURS = ("none", "inherit", *SAME_AS_COLOUR)
MARKERS = ("marker", "marker-start", "marker-mid", "marker-end")
OWN = {"display", "clip-path", "mask", "opacity", "baseline-shift", "transform", "transform-origin"}
GEOMETRY = {"x", "y", "cx", "cy", "r", "rx", "ry", "width", "height", "d"}  # SVG 2: in styles they are stronger
NOT_INHERITED = OWN | GEOMETRY
KNOWN = INHERITED | NOT_INHERITED
PLACES = {"transform", "transform-origin"} | GEOMETRY  # of attributes the element's own: hardly two look alike
AT_RULE = re.compile(r"@([\w-]+)([^;{]*)([;{]?)")
BRACE = re.compile("[{}]")
CSS_LENGTH = re.compile(r"[+-]?0+|[+-]?[\d.]+(?:e[+-]?\d+)?(?:[a-z]+|%)", re.ASCII | re.IGNORECASE)  # it has a unit
CSS_PATH = re.compile(r"""path\(\s*(?:(?:nonzero|evenodd)\s*,\s*)?(?P<mark>["'])(?P<data>[^"']*)(?P=mark)\s*\)""")
MEDIA = ("screen", "all")
MOST_RULES = 5_000
MOST_SHEET = 1_000_000  # characters of all <style> elements
MOST_SELECTOR = 2_000  # characters
MOST_TRIALS = 5_000_000  # of rules on elements
NEVER = re.compile(r":(?:hover|active|focus(?:-\w+)?|visited|target)\b|::")  # of a pointer, and parts of no element
MOST_UNKNOWN = 100
SIZE = 16.0  # of CSS: medium
LARGEST_SIZE = 1e6
SIZES = {
    "xx-small": 9.0,
    "x-small": 10.0,
    "small": 13.0,
    "medium": SIZE,
    "large": 18.0,
    "x-large": 24.0,
    "xx-large": 32.0,
}
RELATIVE_SIZES = {"smaller": 1.0 / 1.2, "larger": 1.2}
BOLD = ("bold", "bolder", "600", "700", "800", "900")
SLANTED = ("italic", "oblique")
MOST_FONT = 300  # characters of a `font`
FONT = re.compile(
    r"(?P<words>[\w\s-]*?)\s*(?P<size>[\d.]+(?:[a-z]+|%))(?:\s*/\s*[\w.%]+)?\s+(?P<family>\S.*)", re.ASCII
)
MOST_KEPT = 4_096  # styles that are kept to be given again


class Declaration(NamedTuple):
    """A property, its value, and whether it is marked !important."""

    name: str
    value: str
    important: bool = False


class Style(dict[str, str]):
    """The properties of an element, and what follows from them; `styled` gives one for all elements that look alike."""

    @cached_property
    def stroke(self) -> str | None:
        """The stroke's colour, as `colour_of` returns it."""
        return colour_of(self.get("stroke", "none"), self)

    @cached_property
    def fill(self) -> str | None:
        """The fill's colour, as `colour_of` returns it."""
        return colour_of(self.get("fill", "black"), self)

    @cached_property
    def geometry(self) -> dict[str, str]:
        """What styles, and no attributes, say of place, size and path: `d` as an attribute has it, else lengths."""
        return {name: self[name] for name in GEOMETRY & self.keys()}

    @cached_property
    def displayed(self) -> bool:
        """Whether the element and those in it are drawn."""
        return self.get("display") != "none"

    @cached_property
    def visible(self) -> bool:
        """Whether the element itself is seen where it is drawn."""
        return self.get("visibility") not in ("hidden", "collapse")

    @cached_property
    def dashed(self) -> bool:
        """Whether its stroke is broken."""
        return self.get("stroke-dasharray", "none") != "none"

    @cached_property
    def clips(self) -> int:
        """How many clip paths and masks it has."""
        return sum(self.get(key, "none") != "none" for key in ("clip-path", "mask"))

    @cached_property
    def off_line(self) -> bool:
        """Whether a text is written downwards, or raised or lowered."""
        downwards = self.get("writing-mode", "").startswith(("tb", "vertical"))
        return downwards or self.get("baseline-shift", "baseline") not in ("baseline", "0")

    @cached_property
    def marked(self) -> bool:
        """Whether its lines have markers."""
        return any(self.get(key, "none") != "none" for key in MARKERS)


@dataclass(frozen=True)
class _Rule:
    order: tuple[int, int, int, int]  # ids, classes, tags, place in the sheet
    selector: Selector
    style: tuple[Declaration, ...]


class StyleSheet:
    """The rules of all <style> elements of a drawing."""

    def __init__(self, text: str):
        self._rules: dict[str, list[_Rule]] = defaultdict(list)
        self._kept: dict[tuple[str, str, str], tuple[Declaration, ...]] = {}
        self._nested, self._trials = False, 0
        self._matcher = Matcher(self._tried)
        self.unknown: list[str] = []  # selectors that select nothing here
        self.made: dict[tuple[Any, ...], tuple[Style, Style]] = {}  # see `styled`; the first keeps its id from others
        plain = self._without_at_rules(_without_comments(text[:MOST_SHEET]))
        for number, rule in enumerate(plain.split("}")[:MOST_RULES]):
            listed, _, body = rule.rpartition("{")
            style = tuple(declarations(body))
            for selector in selectors(listed[-MOST_SELECTOR:].rpartition("{")[2]) if style else ():
                self._add(selector, style, number)

    def of(self, element: Element, ancestors: list[Element]) -> tuple[Declaration, ...]:
        """Return the declarations of the rules that select an element, the weakest first."""
        if not self._rules:
            return ()
        key = element.name, element.get("id"), element.get("class")
        if self._nested or key not in self._kept:
            self._kept[key] = self._selecting(element, ancestors)
        return self._kept[key]

    def _without_at_rules(self, text: str) -> str:
        """Return the rules, with those for a screen in their places; nothing is imported, and what is left out told."""
        parts, at = [], 0
        while match := AT_RULE.search(text, at):
            parts.append(text[at : match.start()])
            at = _closing(text, match.end()) if match[3] == "{" else match.end()
            words = match[2].replace(",", " ").split()
            if match[1] == "media" and match[3] == "{" and (not words or set(words) & set(MEDIA)):
                parts.append(text[match.end() : at - 1])
            elif len(self.unknown) < MOST_UNKNOWN:
                self.unknown.append(f"@{match[1]}{match[2]}".strip())
        return "".join(parts) + text[at:]

    def _selecting(self, element: Element, ancestors: list[Element]) -> tuple[Declaration, ...]:
        keys = {"*", element.name, "#" + element.get("id"), *("." + name for name in element.get("class").split())}
        near = [rule for key in keys & self._rules.keys() for rule in self._rules[key]]
        self._tried(len(near))
        chosen = [rule for rule in near if self._matcher.selects(rule.selector, element, ancestors)]
        chosen.sort(key=lambda rule: rule.order)
        return tuple(declaration for rule in chosen for declaration in rule.style)

    def _tried(self, count: int = 1) -> None:
        """Count trials of rules on elements; raises JobError where they are too many."""
        self._trials += count
        if self._trials > MOST_TRIALS:
            what, advice = "the drawing has too many rules of style", "save it with styles as attributes"
            raise JobError("svg-large", what, limit=f"{MOST_TRIALS}", advice=advice)

    def _add(self, selector: str, style: tuple[Declaration, ...], number: int) -> None:
        if not selector.strip() or NEVER.search(selector):
            return
        parsed = parsed_selector(selector)
        if parsed is None:
            if len(self.unknown) < MOST_UNKNOWN:
                self.unknown.append(selector.strip())
            return
        self._nested = self._nested or not parsed.is_simple
        last = parsed.compounds[-1]
        key = "#" + min(last.ids) if last.ids else "." + min(last.classes) if last.classes else last.tag or "*"
        self._rules[key].append(_Rule((*parsed.strength, number), parsed, style))


def _without_comments(text: str) -> str:
    first, *rest = text.split("/*")
    return first + "".join(part.partition("*/")[2] for part in rest)


def _closing(text: str, at: int) -> int:
    """Return where the block ends that was begun before a place."""
    depth = 1
    for brace in BRACE.finditer(text, at):
        depth += 1 if brace[0] == "{" else -1
        if not depth:
            return brace.end()
    return len(text)


def declarations(text: str) -> Iterable[Declaration]:
    """Return the known properties of a style attribute or a rule's body."""
    if not text:
        return ()
    return _declarations(text) if len(text) < 4096 else tuple(_parsed(text))


@lru_cache(4096)
def _declarations(text: str) -> tuple[Declaration, ...]:
    return tuple(_parsed(text))


def _parsed(text: str) -> Iterator[Declaration]:
    for declaration in text.split(";"):
        name, _, value = declaration.partition(":")
        name = name.strip().casefold()
        before, mark, after = value.rpartition("!")
        important = bool(mark) and after.strip().casefold() == "important"
        value = (before if important else value).strip()
        if name in KNOWN and _counts(name, value):
            yield Declaration(name, _path_data(value) if name == "d" else value, important)


def _counts(name: str, value: str) -> bool:
    """Return whether a property has a value that counts: a browser leaves out paints and lengths that are none."""
    if name in PAINTS:
        return _is_paint(value)
    if name == "d":
        return value == "none" or CSS_PATH.fullmatch(value) is not None
    return name not in GEOMETRY or CSS_LENGTH.fullmatch(value) is not None


def _path_data(value: str) -> str:
    """Return the data in CSS's path("…"), "" for none."""
    found = CSS_PATH.fullmatch(value)
    return found["data"] if found else ""


def styled(element: Element, inherited: Style, sheet: StyleSheet, ancestors: list[Element]) -> Style:
    """Return the style of an element; the inherited one is not changed."""
    if element.name == TEXT:
        return inherited
    attributes = tuple([item for item in element.attributes.items() if item[0] in KNOWN and item[0] not in PLACES])
    rules, text = sheet.of(element, ancestors), element.get("style")
    if not (attributes or rules or text or NOT_INHERITED & inherited.keys()):
        return inherited
    key = id(inherited), attributes, rules, text
    if key not in sheet.made:
        if len(sheet.made) >= MOST_KEPT:
            sheet.made.clear()
        own = {name: value for name, value in attributes if name not in PAINTS or _is_paint(value)}
        declared = sorted((*rules, *declarations(text)), key=operator.attrgetter("important"))
        own |= {declaration.name: declaration.value for declaration in declared}
        sheet.made[key] = inherited, _cascaded(inherited, own)
    return sheet.made[key][1]


def _cascaded(inherited: Style, own: dict[str, str]) -> Style:
    """Return the style of an element by that around it and what it declares itself, the strongest of each property."""
    if not own and not NOT_INHERITED & inherited.keys():
        return inherited
    result = Style((name, value) for name, value in inherited.items() if name not in NOT_INHERITED)
    result.update((name, value) for name, value in own.items() if value != "inherit")
    if "font-size" in own or "font" in own:
        _settle_font(result, own, font_size(inherited))
    return result


def font_size(style: Style) -> float:
    """Return the size of a style's font in user units; `styled` has settled sizes relative to that around it."""
    size = length(style.get("font-size", ""), SIZE, SIZE, em=SIZE)
    return size if 0.0 < size < LARGEST_SIZE else SIZE


def _settle_font(style: Style, own: dict[str, str], around: float) -> None:
    """Take the shorthand `font` apart, and make a size relative to that `around` an absolute one."""
    shorthand = FONT.fullmatch(own.get("font", "")[:MOST_FONT])
    if shorthand:
        words = shorthand["words"].split()
        style["font-style"] = next((word for word in words if word in SLANTED), "normal")
        style["font-weight"] = next((word for word in words if word in BOLD), "normal")
        style["font-size"], style["font-family"] = shorthand["size"], shorthand["family"]
    text = style.get("font-size", "").strip()
    if text in RELATIVE_SIZES:
        size = around * RELATIVE_SIZES[text]
    else:
        size = SIZES.get(text, length(text, around, around, em=around))
    style["font-size"] = repr(size)


def colour_of(value: str, style: Style) -> str | None:
    """Return a paint as "#rrggbb", "" where it paints without one colour (a pattern), None where it does not paint."""
    text = value.strip()
    if text.casefold() in ("none", ""):
        return None
    if text.casefold() in SAME_AS_COLOUR:
        text = style.get("color", "black")
    if text.startswith("url("):
        after = text.partition(")")[2].strip()
        return colour_of(after, style) or "" if after else ""
    return colour_code(text) or None


def _is_paint(value: str) -> bool:
    """Return whether a value of fill, stroke or color is one; another one does not count, as in a browser."""
    text = value.strip().casefold()
    return text.startswith("url(") or text in NO_COLOURS or colour_code(text) is not None
