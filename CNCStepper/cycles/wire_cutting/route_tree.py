# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The ways through the scrap as a tree, and the order in which its leaves are cut.

    root ----+------+----- leaf 2        Each item is a leaf; the nearest one to the ways that are there is connected
             |      |                    next, so that no way crosses another or comes near it again. The wire runs
          leaf 3  leaf 1                 along the ways, and back in the same kerf.

What lies farther along the ways is cut first: the wire then never passes what it has cut free. Where it leaves on
another way than it came, one branch is cut last and from its near end to its far one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from CNCStepper.cycles.moves import Point
from CNCStepper.cycles.wire_cutting.scrap_roadmap import Connection, Reach, Roadmap, Segment
from CNCStepper.cycles.wire_cutting.wire_items import Item
from CNCStepper.tolerances import SAME_MM

ROOT = 0


@dataclass
class WayTree:
    """Nodes of ways: where they lie, and the one before each on the way from the root. leaves: node of each item."""

    places: list[Point]
    before: list[int] = field(default_factory=lambda: [-1])
    leaves: dict[int, int] = field(default_factory=dict)

    def add(self, connection: Connection) -> list[Segment]:
        """Add a connection; return its segments on which others may begin: all but the lead."""
        node = self._node_at(connection.way[0])
        for place in connection.way[1:]:
            self.places.append(place)
            self.before.append(node)
            node = len(self.places) - 1
        self.leaves[connection.item] = node
        ways = connection.way[:-1]
        return list(pairwise(ways)) or [(ways[0], ways[0])]

    def way(self, begin: int, end: int) -> list[int]:
        """Return the nodes from one to another along the ways, both included."""
        back, forth = self.to_root(begin), self.to_root(end)
        common = set(back) & set(forth)
        meet = next(node for node in back if node in common)
        return [*back[: back.index(meet) + 1], *reversed(forth[: forth.index(meet)])]

    def to_root(self, node: int) -> list[int]:
        """Return the nodes from one to the root, both included."""
        found = [node]
        while self.before[found[-1]] >= 0:
            found.append(self.before[found[-1]])
        return found

    def length_mm(self, nodes: Sequence[int]) -> float:
        """Return how long the way along nodes is."""
        steps = np.diff(np.array([self.places[node] for node in nodes]).reshape(-1, 2), axis=0)
        return float(np.hypot(*steps.T).sum())

    def order(self, last: int | None = None) -> list[int]:
        """Return the items in order: those farther along the ways first; `last`, with what leads to it, at the end."""
        own = {node: item for item, node in self.leaves.items()}
        trunk = set(self.to_root(self.leaves[last])) if last is not None else set()
        children: dict[int, list[int]] = {}
        for node, before in enumerate(self.before):
            children.setdefault(before, []).append(node)
        return [own[node] for node in _leaves_of(ROOT, children, trunk, own)]

    def _node_at(self, place: Point) -> int:
        """Return the node at a place of the ways, a new one where it lies between two."""
        for node, other in enumerate(self.places):
            if _apart(place, other) <= SAME_MM:
                return node
        node = min(range(1, len(self.places)), key=lambda each: self._off(each, place), default=ROOT)
        if node == ROOT:
            self.places[ROOT] = place
            return ROOT
        self.places.append(place)
        self.before.append(self.before[node])
        self.before[node] = len(self.places) - 1
        return self.before[node]

    def _off(self, node: int, place: Point) -> float:
        """Return by how much a detour over a place makes the way to a node longer."""
        if node in self.leaves.values():
            return np.inf
        begin, end = self.places[self.before[node]], self.places[node]
        return _apart(begin, place) + _apart(place, end) - _apart(begin, end)


def connected(
    roadmap: Roadmap, items: Sequence[Item], begins: Sequence[Segment], allowed: np.ndarray
) -> tuple[WayTree, list[int]]:
    """Return the tree that begins somewhere on the segments `begins`, and the items that it does not reach.

    allowed: at which corners of the map ways may turn.
    """
    waiting = list(range(len(items)))
    tree = WayTree([begins[0][0]])
    reach = Reach(roadmap, allowed, begins)
    while waiting:
        found = reach.nearest(items, waiting)
        if found is None:
            break
        segments = tree.add(found)
        if len(waiting) == len(items):
            reach = Reach(roadmap, allowed, segments)
        else:
            reach.grow(segments)
        waiting.remove(found.item)
    return tree, waiting


def _leaves_of(node: int, children: dict[int, list[int]], trunk: set[int], own: dict[int, int]) -> Iterator[int]:
    """Yield the leaves beyond a node: branches, then an item at the node itself, then the trunk."""
    stack = [node]
    while stack:
        here = stack.pop()
        if here in own:
            yield here
        after = children.get(here, [])
        stack += sorted(after, key=lambda each: (each in trunk, each in own), reverse=True)


def _apart(one: Point, other: Point) -> float:
    return float(np.hypot(one[0] - other[0], one[1] - other[1]))
