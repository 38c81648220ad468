# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template while it is changed: its content as a file holds it, and each rule as texts that a person types; no Qt.

    file, or job and drawing ──► Draft: content ──► RuleTexts of a rule ──typed──► content ──► file, worker

What a rule holds beside the fields of the form is kept, as lines of TOML.
"""

from __future__ import annotations

import copy
import tomllib
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError, Text
from CNCStepper.job.templates.template import THROUGH
from CNCStepper.machine.files.toml_text import key_text, value_text
from CNCStepper.safe_text import printable
from CNCStepper.workbench.panels.number_input import Refused, tidied

Content = dict[str, Any]
PATTERNS = ("layer", "colour", "name", "group")
FLAGS = ("closed", "filled")
YES, NO = "yes", "no"
IGNORE, MARKS = "ignore", "marks"  # what a rule does in place of a cycle
DEPTH = "depth_mm"
SEPARATOR = ";"  # between patterns


@dataclass(frozen=True)
class RuleTexts:
    """A rule as the form shows it.

    does: a cycle, IGNORE or MARKS. closed, filled: YES, NO or "". tool: its number, 0 for none. depth: mm, or THROUGH.
    values: the other keys of the operation, a line of TOML each.
    """

    title: str = ""
    layer: str = ""
    colour: str = ""
    name: str = ""
    group: str = ""
    closed: str = ""
    filled: str = ""
    does: str = IGNORE
    marks_for: str = ""
    tool: int = 0
    depth: str = ""
    values: str = ""


def texts_of(rule: Content) -> RuleTexts:
    """Return the texts of a rule."""
    operation = dict(rule.get("operation") or {})
    does = str(operation.pop("cycle", "")) or (MARKS if rule.get("marks_for") else IGNORE)
    tool, depth = int(operation.pop("tool", 0)), operation.pop(DEPTH, "")
    patterns = {key: _patterns_text(rule.get(key, ())) for key in PATTERNS}
    flags = {key: _flag_text(rule.get(key)) for key in FLAGS}
    return RuleTexts(
        title=str(rule.get("title", "")),
        does=does,
        marks_for=str(rule.get("marks_for", "")),
        tool=tool,
        depth=depth if isinstance(depth, str) else f"{depth:.10g}",
        values="\n".join(f"{key_text(key)} = {value_text(value)}" for key, value in operation.items()),
        **patterns,
        **flags,
    )


def rule_of(texts: RuleTexts, before: Content) -> Content:
    """Return the rule of texts; patterns whose text is as it was stay as they were.

    Raises JobError for lines that are no TOML, and Refused for a depth that is no number.
    """
    old = texts_of(before)
    rule: Content = {"title": texts.title} if texts.title else {}
    for key in PATTERNS:
        same = getattr(texts, key) == getattr(old, key)
        patterns = before.get(key) if same else _patterns(getattr(texts, key))
        rule |= {key: patterns} if patterns else {}
    rule |= {key: getattr(texts, key) == YES for key in FLAGS if getattr(texts, key)}
    if texts.does == IGNORE:
        return rule | {"ignore": True}
    if texts.does == MARKS:
        return rule | {"marks_for": texts.marks_for}
    depth = {DEPTH: _depth(texts.depth)} if texts.depth.strip() else {}
    tool = {"tool": texts.tool} if texts.tool else {}
    return rule | {"operation": {"cycle": texts.does, **tool, **depth, **_values(texts.values)}}


def takes_words(rule: Content) -> str:
    """Return what a rule takes, as short as a list shows it: its patterns."""
    return ", ".join(_patterns_text(rule[key]) for key in PATTERNS if rule.get(key))


def _patterns_text(patterns: str | Iterable[str]) -> str:
    return patterns if isinstance(patterns, str) else f"{SEPARATOR} ".join(patterns)


def _patterns(text: str) -> list[str]:
    return [pattern.strip() for pattern in text.split(SEPARATOR) if pattern.strip()]


def _flag_text(value: bool | None) -> str:
    return "" if value is None else YES if value else NO


def _depth(text: str) -> float | str:
    if text.strip() == THROUGH:
        return THROUGH
    tidy = tidied(text)
    try:
        return float(tidy)
    except ValueError as error:
        raise Refused("'{0}' is no number", printable(text, 20)) from error


def _values(text: str) -> Content:
    """Return the keys of lines; raises JobError for what is no TOML."""
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise JobError(
            "toml",
            Text("the further values cannot be read: {error}", error=printable(str(error), 200)),
            advice="write a line for each: stepdown_mm = 2",
        ) from error


class Draft:
    """The content of one template; `path` is that of its file, from which the files that it names are found."""

    def __init__(self, content: Content, path: Path):
        self.content, self.path = copy.deepcopy(content), path
        self.content["rule"] = [dict(rule) for rule in self.content.get("rule", [])]
        self.content["stock"] = dict(self.content.get("stock", {}))

    @property
    def rules(self) -> list[Content]:
        """The rules, in their order."""
        rules: list[Content] = self.content["rule"]
        return rules

    @property
    def tools(self) -> list[Content]:
        """The tools that the template's own keys give."""
        return [tool for tool in self.content.get("tool", []) if isinstance(tool, dict)]

    def put_tools(self, tools: list[Content]) -> None:
        """Give the template other tools of its own; none takes the key out."""
        self.content["tool"] = tools
        if not tools:
            del self.content["tool"]

    @property
    def sheet_cuts(self) -> list[str]:
        """The titles of the rules whose sheet cut takes marks."""
        return [
            str(rule["title"])
            for rule in self.rules
            if rule.get("title") and (rule.get("operation") or {}).get("cycle") == "sheet_cut"
        ]

    def add(self, after: int) -> int:
        """Add a rule that leaves all out after one, and return its number."""
        self.rules.insert(after + 1, {"ignore": True})
        return after + 1

    def delete(self, number: int) -> None:
        """Delete a rule."""
        del self.rules[number]

    def move(self, number: int, by: int) -> int:
        """Move a rule earlier or later where there is room, and return its number."""
        target = number + by
        if 0 <= number < len(self.rules) and 0 <= target < len(self.rules):
            self.rules.insert(target, self.rules.pop(number))
            return target
        return number

    def put_stock(self, key: str, text: str) -> None:
        """Give the stock a length; "" takes it out. Raises Refused for what is no number."""
        self.content["stock"].pop(key, None)
        if text.strip():
            self.content["stock"][key] = _depth(text)

    def put_material(self, text: str) -> None:
        """Give the job a material; "" takes it out."""
        self.content.pop("material", None)
        if text.strip():
            self.content = {"material": text.strip(), **self.content}


def first_rules(attributes: Iterable[tuple[str, str]]) -> list[Content]:
    """Return a rule for each layer and colour, which leaves its contours out until a person says what it does."""
    rules = []
    for layer, colour in dict.fromkeys(attributes):
        keys = {key: text for key, text in (("layer", layer), ("colour", colour)) if text}
        rules.append({"title": " ".join(keys.values()), **keys, "ignore": True})
    return rules or [{"ignore": True}]
