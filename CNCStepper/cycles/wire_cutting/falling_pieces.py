# SPDX-License-Identifier: LGPL-2.1-or-later
r"""An order in which nothing is cut after it has come loose.

+--------------------+        Cuts that meet round a piece set it free, with what is still to be cut from it: a ring
|  .--A--.           |        of parts that lie so close that their kerfs meet, or a part as wide as the sheet.
|  B  x  C           |        What lies in such a piece is cut before.
|  '--D--'           |
+--------------------+
"""

from __future__ import annotations

from collections.abc import Sequence

import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.wire_cutting.way_tree import ROOT, WayTree
from CNCStepper.cycles.wire_cutting.wire_items import Item, Part
from CNCStepper.errors import CycleError, Text

FLAT_MM = 0.01
MOST_CHANGES = 3  # a part


def safe_order(order: Sequence[int], tree: WayTree, items: Sequence[Item], sheet: Polygon, half_mm: float) -> list[int]:
    """Return the order, changed so that no item lies in a piece that came loose before it is cut.

    half_mm: half of the kerf. Raises CycleError where no such order is found.
    """
    found = list(order)
    kerfs = [_kerf(item.chords, half_mm) for item in items]
    for _ in range(MOST_CHANGES * len(found) + 1):
        loose = _first_loose(found, tree, items, kerfs, sheet, half_mm)
        if loose is None:
            return found
        by, held = loose
        for item in held:
            found.remove(item)
        found[found.index(by) : found.index(by)] = held
    x, y = items[held[0]].chords.coords[0]
    raise CycleError(
        "wire-loose",
        Text("what lies at X{x:.3f} Y{y:.3f} would come loose before it is cut, in any order", x=x, y=y),
        advice="move the parts farther apart, or cut them in several operations",
    )


def _first_loose(
    order: Sequence[int],
    tree: WayTree,
    items: Sequence[Item],
    kerfs: Sequence[BaseGeometry],
    sheet: Polygon,
    half_mm: float,
) -> tuple[int, list[int]] | None:
    """Return the first item whose cut sets others free that are not cut yet, and which; None where there is none."""
    rest: BaseGeometry = sheet
    position, run = ROOT, {ROOT}
    for step, item in enumerate(order[:-1]):
        nodes = tree.way(position, tree.leaves[item])
        position = nodes[-1]
        new = [(tree.before[node], node) for node in nodes if node not in run]
        run.update(nodes)
        ways = [_kerf(LineString([tree.places[a], tree.places[b]]), half_mm) for a, b in new]
        rest = rest.difference(shapely.union_all([kerfs[item], *ways]))
        held = _in_smaller_pieces(rest, [each for each in order[step + 1 :] if isinstance(items[each], Part)], items)
        if held:
            return item, held
    return None


def _in_smaller_pieces(rest: BaseGeometry, waiting: Sequence[int], items: Sequence[Item]) -> list[int]:
    """Return which parts do not lie in the largest piece."""
    if not waiting or rest.geom_type == "Polygon":
        return []
    largest = max(shapely.get_parts(rest), key=shapely.area)
    shapely.prepare(largest)
    return [item for item in waiting if not largest.intersects(_middle(items[item]))]


def _middle(item: Item) -> BaseGeometry:
    assert isinstance(item, Part)
    return item.polygon.representative_point()


def _kerf(line: LineString, half_mm: float) -> BaseGeometry:
    return line.simplify(FLAT_MM).buffer(half_mm)
