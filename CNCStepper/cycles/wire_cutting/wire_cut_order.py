# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The order of cuts with a wire: which item is cut last, and that nothing is cut after it has come loose.

+--------------------+        Cuts that meet round a piece set it free, with what is still to be cut from it: a ring
|  .--A--.           |        of parts that lie so close that their kerfs meet, or a part as wide as the sheet.
|  B  x  C           |        What lies in such a piece is cut before.
|  '--D--'           |
+--------------------+

A ring with slits is cut in stretches, from slit to slit. A way through the scrap may run along a part nearer than a
kerf, another ring or the sheet's edge may lie there: the part then falls before its ring is closed. The stretch on
which it hangs is cut last, after all of its holes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.wire_cutting.route_tree import ROOT, WayTree
from CNCStepper.cycles.wire_cutting.wire_items import Item, Part
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve

FLAT_MM = 0.01
FIRM = 1.5  # times the kerf: what so wide a cut would take away holds nothing that is worth it
MOST_CHANGES = 3  # a part


def best_last(tree: WayTree, leaving_mm: Callable[[int], float]) -> int:
    """Return the item that is to be cut last, so that all ways together are short.

    leaving_mm: how long the way out of the sheet is from an item's node.
    """
    return min(
        tree.leaves, key=lambda item: leaving_mm(tree.leaves[item]) - tree.length_mm(tree.to_root(tree.leaves[item]))
    )


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
    raise _comes_loose(items[held[0]])


class Uncut:
    """What is left of the sheet behind the wire, while its way is put together.

    half_mm: half of the kerf.
    """

    def __init__(self, sheet: Polygon, half_mm: float):
        self._rest: BaseGeometry = sheet
        self._half_mm = half_mm
        self._taken: list[Curve] = []

    def take(self, curve: Curve) -> None:
        """Cut along a curve."""
        self._taken.append(curve)

    def last_stretch(self, part: Part, stretches: Sequence[Curve]) -> int:
        """Return which stretch of a part's ring holds it while all others are cut: the last one, else the first such.

        One that holds firmly comes before one that holds by a thin strip. Raises CycleError where none holds.
        """
        self._cut_taken()
        last = len(stretches) - 1
        for width in (FIRM, 1.0):
            for tried in (last, *range(last)):
                others = [each for number, each in enumerate(stretches) if number != tried]
                if self._holds(part, others, width * self._half_mm):
                    return tried
        raise _comes_loose(part)

    def _holds(self, part: Part, cuts: Sequence[Curve], half_mm: float) -> bool:
        """Return whether a part hangs in the largest piece after further cuts."""
        rest = self._rest.difference(_kerfs(cuts, half_mm))
        return bool(_largest(rest).intersects(part.polygon))

    def _cut_taken(self) -> None:
        self._rest = self._rest.difference(_kerfs(self._taken, self._half_mm))
        self._taken = []


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
    largest = _largest(rest)
    shapely.prepare(largest)
    return [item for item in waiting if not largest.intersects(_middle(items[item]))]


def _largest(rest: BaseGeometry) -> BaseGeometry:
    return max(shapely.get_parts(rest), key=shapely.area, default=rest)


def _middle(item: Item) -> BaseGeometry:
    assert isinstance(item, Part)
    return item.polygon.representative_point()


def _kerf(line: LineString, half_mm: float) -> BaseGeometry:
    return line.simplify(FLAT_MM).buffer(half_mm)


def _kerfs(curves: Sequence[Curve], half_mm: float) -> BaseGeometry:
    return shapely.union_all([_kerf(LineString(curve.points(FLAT_MM)), half_mm) for curve in curves])


def _comes_loose(item: Item) -> CycleError:
    x, y = item.chords.coords[0]
    return CycleError(
        "wire-loose",
        Text("the part at X{x:.3f} Y{y:.3f} would come loose before it is cut, in any order", x=x, y=y),
        advice="move the parts farther apart, or cut them in several operations",
    )
