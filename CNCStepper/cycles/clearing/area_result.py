# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a cycle that clears an area answers, found when it is asked for.

What stays in corners is a matter of polygons with thousands of chords: it takes longer than the cut itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Protocol

from CNCStepper.cycles.clearing.reachable_regions import ReachableRegions
from CNCStepper.cycles.clearing.region_stages import Part
from CNCStepper.cycles.contours.neighbour_parts import open_edge_warnings
from CNCStepper.cycles.cycle import Answer, Removal, RestCorner, Setup
from CNCStepper.errors import Text, joined

TOLD = 12  # corners in a warning's text, of those that the tool does not reach into


class Keys(Protocol):
    """The parameter names of the answering cycle."""

    @property
    def entry(self) -> str: ...

    @property
    def depth_mm(self) -> float: ...

    @property
    def tolerance_mm(self) -> float: ...


class AreaAnswer(Answer):
    """The answer of a cycle with these keys, in these rooms, that has cut these parts down to these floors."""

    _keys: Keys
    _rooms: ReachableRegions
    _parts: Sequence[Part]
    _floors_mm: Sequence[float]
    _setup: Setup

    def __init__(
        self, keys: Keys, rooms: ReachableRegions, parts: Sequence[Part], floors_mm: Sequence[float], setup: Setup
    ):
        self.__dict__.update(_keys=keys, _rooms=rooms, _parts=parts, _floors_mm=floors_mm, _setup=setup)
        self.__dict__["parts"] = []  # an area cuts nothing free

    @cached_property
    def removals(self) -> list[Removal]:
        """What is to be removed."""
        return [Removal(self._rooms.wanted, 0.0, -self._keys.depth_mm, self._keys.tolerance_mm, self._rooms.reachable)]

    @cached_property
    def corners(self) -> list[RestCorner]:
        """What the tool cannot reach, the worst first."""
        return self._rooms.corners

    @cached_property
    def figures(self) -> dict[str, float]:
        """What came of the keys, by name."""
        runs = [stage.run for part in self._parts for stage in part.stages]
        passes = sum(one.name != "link" for run in runs for one in run.passes)
        apart_mm = max((run.apart_mm for run in runs), default=0.0)
        floors_mm, corners = self._floors_mm, self.corners
        figures = {"ap_mm": -floors_mm[0], "levels": len(floors_mm), "ae_mm": apart_mm, "passes": passes}
        figures |= {"rooms": len(self._parts), "rest_corners": len(corners)}
        figures |= {"rest_area_mm2": sum(corner.area_mm2 for corner in corners)}
        return figures | {"rest_corner_mm": max((corner.thick_mm for corner in corners), default=0.0)}

    @cached_property
    def warnings(self) -> list[str]:
        """Warnings of material left in corners, and of entries that differ from the requested one."""
        edges = open_edge_warnings(self._rooms.reachable, self._setup.parts, self._keys.tolerance_mm)
        return [*_corner_warnings(self.corners), *self._entry_warnings(), *edges]

    def _entry_warnings(self) -> list[str]:
        kinds = [stage.entry.kind for part in self._parts for stage in part.stages if stage.cut is None]
        others = [kind for kind in kinds if kind != self._keys.entry]
        if not others:
            return []
        asked = Text(
            "there is no room for a {entry} at {others} of {kinds} places",
            entry=self._keys.entry,
            others=len(others),
            kinds=len(kinds),
        )
        return [Text("{asked}; a {other} is used", asked=asked, other=others[0])]


def _corner_warnings(corners: Sequence[RestCorner]) -> list[str]:
    if not corners:
        return []
    told = [_corner_words(corner) for corner in corners[:TOLD]]
    if len(corners) > TOLD:
        told.append(Text("and {corners} smaller ones", corners=len(corners) - TOLD))
    return [
        Text(
            "the tool does not reach into {corners} corners or narrow places; material left there: {told}",
            corners=len(corners),
            told=joined("; ", told),
        )
    ]


def _corner_words(corner: RestCorner) -> str:
    (x, y) = corner.place_mm
    return Text(
        "{thick_mm:.3f} mm ({area_mm2:.3f} mm²) at X{x:.2f} Y{y:.2f}",
        thick_mm=corner.thick_mm,
        area_mm2=corner.area_mm2,
        x=x,
        y=y,
    )
