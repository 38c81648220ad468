# SPDX-License-Identifier: LGPL-2.1-or-later
"""The selectors of CSS that occur in drawings: which elements a rule is for.

    g.cut > path:not([id]):nth-child(2n+1)      Selector: compounds, and between them how their elements are related
    └ compound ┘   └─────── compound ──────┘    " " below, ">" right below, "+" right behind, "~" behind

Known are tags, classes, ids, attributes, the places among the children of an element, :root, :not, :is and :where.
Other selectors are None where they are parsed. Method: Selectors Level 4, from the right to the left.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from CNCStepper.drawing.svg.document import Element

BELOW, CHILD, NEXT, BEHIND = " >+~"
ATTRIBUTE = re.compile(
    r"""\[\s*(?:(?P<prefix>[\w-]*)\|)?(?P<name>[\w-]+)\s*"""
    r"""(?:(?P<how>[~|^$*]?=)\s*(?P<wanted>"[^"]*"|'[^']*'|[^\s"'\]]+)\s*)?\]"""
)
TAG = re.compile(r"(?:[\w*-]*\|)?(\*|[\w-]+)")
NAME = re.compile(r"[\w-]+")
PSEUDO = re.compile(r":([\w-]+)(\()?")
COMBINATOR = re.compile(r"\s*([>+~])\s*|\s+")
NTH = re.compile(r"(?:(?P<step>[+-]?\d*)n\s*(?:(?P<sign>[+-])\s*(?P<plus>\d+))?|(?P<only>[+-]?\d+))", re.IGNORECASE)
WORDS = {"odd": (2, 1), "even": (2, 0)}
CHOICES = ("not", "is", "where")
MOST_DIGITS = 9
MOST_INSIDE = 4  # selectors within each other


class Nth(NamedTuple):
    """A place among the children of an element: every `step`-th one from `first` on, 1 for the first."""

    step: int
    first: int
    from_end: bool = False
    of_type: bool = False

    def matches(self, element: Element) -> bool:
        """Return whether an element has the place."""
        rank, siblings = element.rank, element.siblings
        if siblings is None or rank is None:
            return False
        index = rank.of_type if self.of_type else rank.of_all
        if self.from_end:
            index = (siblings.kinds[element.name] if self.of_type else siblings.count) + 1 - index
        beyond = index - self.first
        return beyond == 0 if not self.step else beyond % self.step == 0 and beyond // self.step >= 0


FIRST, LAST = Nth(0, 1), Nth(0, 1, True)
PLACES = {
    "first-child": (FIRST,),
    "last-child": (LAST,),
    "only-child": (FIRST, LAST),
    "first-of-type": (FIRST._replace(of_type=True),),
    "last-of-type": (LAST._replace(of_type=True),),
    "only-of-type": (FIRST._replace(of_type=True), LAST._replace(of_type=True)),
}
NTHS = {
    "nth-child": FIRST,
    "nth-last-child": LAST,
    "nth-of-type": FIRST._replace(of_type=True),
    "nth-last-of-type": LAST._replace(of_type=True),
}


@dataclass(frozen=True)
class Choice:
    """One of some compounds: :is and :where; none of them: :not."""

    compounds: tuple[Compound, ...]
    is_not: bool
    counts: bool  # for the strength of a rule: :where does not

    def matches(self, element: Element) -> bool:
        """Return whether it selects an element."""
        return any(compound.matches(element) for compound in self.compounds) != self.is_not


class Root:
    """The outermost element."""

    def matches(self, element: Element) -> bool:
        """Return whether an element is the outermost one."""
        return element.siblings is not None and element.siblings.is_top


@dataclass(frozen=True)
class Compound:
    """A selector of one element: tag ("" for any), ids, classes, attributes with comparison and value, and the rest."""

    tag: str
    ids: frozenset[str]
    classes: frozenset[str]
    attributes: tuple[tuple[str, str, str], ...] = ()
    others: tuple[Nth | Choice | Root, ...] = ()

    def matches(self, element: Element) -> bool:
        """Return whether it selects an element."""
        if self.tag and self.tag != element.name:
            return False
        if self.ids and self.ids != {element.get("id")}:
            return False
        if self.classes and not self.classes <= set(element.get("class").split()):
            return False
        return all(
            name in element.attributes and _compares(element.get(name), *wanted) for name, *wanted in self.attributes
        ) and all(other.matches(element) for other in self.others)

    @property
    def strength(self) -> tuple[int, int, int]:
        """How many ids, classes and the like, and tags it has."""
        chosen = [
            max(compound.strength for compound in other.compounds)
            for other in self.others
            if isinstance(other, Choice) and other.counts
        ]
        plain = sum(not isinstance(other, Choice) for other in self.others)
        own = len(self.ids), len(self.classes) + len(self.attributes) + plain, bool(self.tag)
        ids, classes, tags = (sum(column) for column in zip(own, *chosen, strict=True))
        return ids, classes, tags

    @property
    def is_simple(self) -> bool:
        """Whether tag, id and classes alone say what it selects."""
        return not self.attributes and not self.others


@dataclass(frozen=True)
class Selector:
    """Compounds, that of the element itself last, and how each but the first is related to the one before it."""

    compounds: tuple[Compound, ...]
    relations: tuple[str, ...]

    @property
    def strength(self) -> tuple[int, int, int]:
        """How many ids, classes and the like, and tags it has."""
        ids, classes, tags = (sum(column) for column in zip(*(own.strength for own in self.compounds), strict=True))
        return ids, classes, tags

    @property
    def is_simple(self) -> bool:
        """Whether tag, id and classes of an element alone say whether it is selected."""
        return len(self.compounds) == 1 and self.compounds[0].is_simple


class Matcher:
    """Finds whether a selector selects an element; `tried` is called for each element that is looked at.

    What is behind an element is remembered for all of its siblings.
    """

    def __init__(self, tried: Callable[[], None]):
        self._tried = tried
        self._behind: dict[tuple[int, int, int], tuple[int, int | None]] = {}

    def selects(self, selector: Selector, element: Element, above: Sequence[Element]) -> bool:
        """Return whether a selector selects an element, with those above it, the outermost first."""
        if not selector.compounds[-1].matches(element):
            return False
        return self._is_led(selector, len(selector.compounds) - 1, element, above, set())

    def _is_led(
        self, selector: Selector, at: int, element: Element, above: Sequence[Element], failed: set[tuple[int, int]]
    ) -> bool:
        """Return whether the compounds before one match elements round that which this one matches."""
        if not at:
            return True
        relation = selector.relations[at - 1]
        if relation == BEHIND:
            return self._is_behind(selector, at, element, above, failed)
        for other, above_it in _related(relation, element, above):
            self._tried()
            key = at - 1, id(other)
            if key not in failed:
                if selector.compounds[at - 1].matches(other) and self._is_led(
                    selector, at - 1, other, above_it, failed
                ):
                    return True
                failed.add(key)
        return False

    def _is_behind(
        self, selector: Selector, at: int, element: Element, above: Sequence[Element], failed: set[tuple[int, int]]
    ) -> bool:
        """Return whether an earlier sibling matches; `_behind` has how far they are known, and the first that does."""
        if element.rank is None:
            return False
        key = id(selector), at, id(element.siblings)
        known, first = self._behind.get(key, (0, None))
        other, last = element.before, element.rank.of_all - 1
        while other is not None and other.rank is not None and other.rank.of_all > known:
            self._tried()
            if selector.compounds[at - 1].matches(other) and self._is_led(selector, at - 1, other, above, failed):
                first = other.rank.of_all if first is None else min(first, other.rank.of_all)
            other = other.before
        self._behind[key] = max(known, last), first
        return first is not None and first <= last


def _related(relation: str, element: Element, above: Sequence[Element]) -> Iterator[tuple[Element, Sequence[Element]]]:
    """Yield the elements to which one is related, with those above each."""
    if relation == NEXT:
        if element.before is not None:
            yield element.before, above
        return
    for count in range(len(above) - 1, -1 if relation == BELOW else max(len(above) - 2, -1), -1):
        yield above[count], above[:count]


def selectors(text: str) -> list[str]:
    """Return the selectors in a list with commas; those in brackets or quotes divide none."""
    found, depth, begin, quote = [], 0, 0, ""
    for at, sign in enumerate(text):
        if quote:
            quote = "" if sign == quote else quote
        elif sign in "\"'":
            quote = sign
        elif sign in "([":
            depth += 1
        elif sign in ")]":
            depth -= 1
        elif sign == "," and not depth:
            found.append(text[begin:at])
            begin = at + 1
    return [*found, text[begin:]]


def parsed_selector(text: str) -> Selector | None:
    """Return a selector; None for one that is not known."""
    text = text.strip()
    compounds: list[Compound] = []
    relations: list[str] = []
    at = 0
    while at < len(text) or not compounds or len(relations) == len(compounds):
        compound, end = _compound(text, at, MOST_INSIDE)
        if compound is None or end == at:
            return None
        compounds.append(compound)
        if end < len(text):
            between = COMBINATOR.match(text, end)
            if between is None:
                return None
            relations.append(between[1] or BELOW)
            end = between.end()
        at = end
    return Selector(tuple(compounds), tuple(relations))


def _compound(text: str, at: int, inside: int) -> tuple[Compound | None, int]:
    """Return the compound that begins at a place and where it ends; None for one that is not known."""
    tag = TAG.match(text, at)
    at = tag.end() if tag else at
    names: dict[str, list[str]] = {"#": [], ".": []}
    attributes: list[tuple[str, str, str]] = []
    others: list[Nth | Choice | Root] = []
    while at < len(text) and text[at] in "#.[:":
        if text[at] in names:
            name = NAME.match(text, at + 1)
            if name is None:
                return None, at
            names[text[at]].append(name[0])
            at = name.end()
        elif attribute := ATTRIBUTE.match(text, at):
            attributes.append(_attribute(attribute))
            at = attribute.end()
        else:
            found, at = _pseudo(text, at, inside)
            if not found:
                return None, at
            others += found
    own = "" if not tag or tag[1] == "*" else tag[1]
    return Compound(own, frozenset(names["#"]), frozenset(names["."]), tuple(attributes), tuple(others)), at


def _attribute(match: re.Match[str]) -> tuple[str, str, str]:
    name = f"{match['prefix']}:{match['name']}" if match["prefix"] else match["name"]
    wanted = match["wanted"] or ""
    return name, match["how"] or "", wanted[1:-1] if wanted[:1] in ("'", '"') else wanted


def _pseudo(text: str, at: int, inside: int) -> tuple[Sequence[Nth | Choice | Root], int]:
    """Return what a pseudo-class that begins at a place wants, nothing for an unknown one, and where it ends."""
    match = PSEUDO.match(text, at)
    if match is None:
        return (), at
    name, end = match[1].casefold(), match.end()
    if not match[2]:
        return (Root(),) if name == "root" else PLACES.get(name, ()), end
    close = _closing(text, end)
    argument = text[end:close].strip()
    if name in NTHS:
        nth = _nth(argument, NTHS[name])
        return (nth,) if nth else (), close + 1
    if name in CHOICES and inside:
        parts = [_compound(part.strip(), 0, inside - 1) for part in selectors(argument)]
        whole = [len(part.strip()) for part in selectors(argument)]
        compounds = [own for (own, stop), size in zip(parts, whole, strict=True) if own and 0 < stop == size]
        if len(compounds) == len(parts):
            return (Choice(tuple(compounds), name == "not", name != "where"),), close + 1
    return (), close + 1


def _closing(text: str, at: int) -> int:
    """Return where the bracket is closed that was opened before a place; the text's end where it is not."""
    depth = 1
    for place in range(at, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if not depth:
            return place
    return len(text)


def _nth(argument: str, kind: Nth) -> Nth | None:
    """Return the places that an argument as 2n+1, odd or 3 names; None for no such argument."""
    if argument.casefold() in WORDS:
        step, first = WORDS[argument.casefold()]
        return kind._replace(step=step, first=first)
    match = NTH.fullmatch(argument)
    if match is None or len(argument) > 2 * MOST_DIGITS:
        return None
    if match["only"]:
        return kind._replace(first=int(match["only"]))
    step = int(match["step"] + "1") if match["step"] in ("", "+", "-") else int(match["step"])
    return kind._replace(step=step, first=int((match["sign"] or "") + (match["plus"] or "0")))


def _compares(value: str, how: str, wanted: str) -> bool:
    """Return whether an attribute's value is what a selector wants of it."""
    tests = {
        "": True,
        "=": value == wanted,
        "~=": wanted in value.split(),
        "|=": value == wanted or value.startswith(wanted + "-"),
        "^=": bool(wanted) and value.startswith(wanted),
        "$=": bool(wanted) and value.endswith(wanted),
        "*=": bool(wanted) and wanted in value,
    }
    return tests[how]
