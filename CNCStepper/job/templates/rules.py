# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which rule of a template takes which chain of a drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from CNCStepper.drawing.chain_list import Count, counts_of
from CNCStepper.drawing.drawing import Chain
from CNCStepper.drawing.selection import Selection
from CNCStepper.job.templates.template import Rule

WILD = set("*?")


@dataclass(frozen=True)
class Assignment:
    """The chains of each rule, in the rules' order, and those that no rule takes."""

    taken: tuple[tuple[Chain, ...], ...]
    untaken: tuple[Chain, ...]

    @property
    def untaken_counts(self) -> tuple[Count, ...]:
        """How many chains no rule takes, by layer and colour."""
        return counts_of(self.untaken)


def assigned(rules: Sequence[Rule], chains: Sequence[Chain]) -> Assignment:
    """Return the chains of each rule: the first rule that takes a chain has it.

    Chains of the same attributes, closed or not, are judged once.
    """
    known: dict[tuple[object, bool], int] = {}
    taken: list[list[Chain]] = [[] for _ in range(len(rules) + 1)]  # the last: those that no rule takes
    for chain in chains:
        key = (chain.attributes, chain.curve.closed)
        if key not in known:
            known[key] = next((number for number, rule in enumerate(rules) if rule.takes(chain)), len(rules))
        taken[known[key]].append(chain)
    *of_rules, untaken = map(tuple, taken)
    return Assignment(tuple(of_rules), untaken)


def exceptions_of(rules: Sequence[Rule], number: int) -> tuple[Selection, ...]:
    """Return the selections of the rules before one that may take what it would take."""
    own = rules[number].selection
    earlier = [rule.selection for rule in rules[:number]]
    return tuple(selection for selection in earlier if not are_disjoint(selection, own))


def are_disjoint(one: Selection, other: Selection) -> bool:
    """Return whether two selections can take no chain both."""
    if {one.closed, other.closed} == {True, False} or {one.filled, other.filled} == {True, False}:
        return True
    pairs = ((one.layer, other.layer), (one.colour, other.colour), (one.name, other.name))
    return any(first and second and not _may_meet(first, second) for first, second in pairs)


def _may_meet(first: Sequence[str], second: Sequence[str]) -> bool:
    if any(WILD & set(pattern) for pattern in (*first, *second)):
        return True
    return bool({pattern.casefold() for pattern in first} & {pattern.casefold() for pattern in second})
