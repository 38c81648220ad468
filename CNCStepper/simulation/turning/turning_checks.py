# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checks of a lathe program on its stock: contact, gouge, material left, loads, chuck, centre and length."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.errors import Place, Text
from CNCStepper.simulation.finding import Finding, Severity, worst_first
from CNCStepper.simulation.turning.half_section import HalfSection
from CNCStepper.simulation.turning.swept_outline import Moves, swept
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_part import CONTACT_MM, Contact, TurnedPart, contacts
from CNCStepper.simulation.turning.wanted_profile import GOUGE_MM, LEFT_MM, WantedProfile, gouge, left_over

PAST_CENTRE_MM = 0.5  # how far beyond its nose radius a tool may cross the axis: facing needs the nose alone
LOAD_SHARE = 1.001  # a limit is exceeded by more than rounding
SLENDER, SLENDER_WITH_TAILSTOCK = 4.0, 10.0  # length by diameter that a bar may stick out
BEFORE_CHUCK = "shorten the travel along Z, or let the bar stick out further"
COLLISIONS = {  # by the name of the obstacle: what is wrong, and what to do
    "chuck": ("the tool runs into the chuck", BEFORE_CHUCK),
    "jaws": ("the tool runs into the jaws", BEFORE_CHUCK),
    "tailstock": ("the tool runs into the tailstock", "retract along X beside the tailstock, or move it away"),
}


@dataclass(frozen=True)
class TurningSetup:
    """What a program is checked against. tools: by number. obstacles: those of COLLISIONS, by name, as regions.

    wanted: the profiles and all else that may be cut; empty where it is not known. x_factor: 2 where the program gives
    X as diameter: findings give places as it does.
    """

    stock: HalfSection
    tools: dict[int, ToolSection]
    obstacles: dict[str, BaseGeometry] = field(default_factory=dict)
    wanted: Sequence[WantedProfile] = ()
    x_factor: float = 1.0
    file: str = ""


def check_turning(part: TurnedPart, setup: TurningSetup) -> list[Finding]:
    """Return all findings of a program whose part was cut by `turned_part`, the worst first."""
    checks = _Checks(part, setup)
    found = [*checks.rapids(), *checks.holders(), *checks.obstacles(), *checks.centre(), *checks.loads()]
    found += [*checks.slender(), *checks.unknown_tools(), *checks.gouges(), *checks.left(), *checks.fallen()]
    return worst_first(found)


class _Checks:
    def __init__(self, part: TurnedPart, setup: TurningSetup):
        self._part, self._setup, self._moves = part, setup, part.moves

    def rapids(self) -> Iterator[Finding]:
        """Yield each rapid through material."""
        for one in self._part.rapids:
            advice = "retract before it, or make it a feed"
            yield self._contact(one, "rapid-in-stock", "a rapid goes through stock", advice)

    def holders(self) -> Iterator[Finding]:
        """Yield the deepest contact of each line whose tool's holder meets the part."""
        for one in _deepest_of_lines(self._part.holders, self._moves):
            advice = "choose a tool that reaches further, or cut this part with another one"
            yield self._contact(one, "holder", "the holder of the tool touches the part", advice)

    def obstacles(self) -> Iterator[Finding]:
        """Yield the first contact of tool or holder with chuck, jaws and tailstock."""
        holders = np.full(len(self._moves), None, object)
        for number, tool in self._setup.tools.items():
            mine = np.flatnonzero(self._moves.tool == number)
            if tool.holder_parts and len(mine):
                holders[mine] = swept(tool.holder_parts, self._moves[mine])
        for name, region in self._setup.obstacles.items():
            found = contacts(region, self._part.areas, 0) + contacts(region, holders, 0)
            for one in sorted(found, key=lambda contact: contact.move)[:1]:
                yield self._contact(one, "collision", *COLLISIONS[name])

    def centre(self) -> Iterator[Finding]:
        """Yield the move that goes farthest over the axis, if it goes farther than its nose needs."""
        limits = {number: -tool.nose_radius_mm - PAST_CENTRE_MM for number, tool in self._setup.tools.items()}
        low = np.minimum(self._moves.begin[:, 1], self._moves.end[:, 1])
        beyond = low - np.array([limits[number] for number in self._moves.tool.tolist()])
        if len(beyond) and beyond.min() < 0:
            move = int(beyond.argmin())
            numbers = self._x(value=low[move], limit=limits[int(self._moves.tool[move])])
            text, advice = "X goes past the centre", "end the move at the axis, at most a nose radius beyond it"
            yield self._finding(move, "error", "past-centre", text, advice=advice, **numbers)

    def loads(self) -> Iterator[Finding]:
        """Yield for each tool its deepest cut and its largest feed per turn in material, where they exceed its own."""
        for number, tool in self._setup.tools.items():
            mine = (self._moves.tool == number) & (self._part.depths_mm > CONTACT_MM)
            text = Text("the cut of the {tool} is deeper than it may be", tool=tool.words)
            advice = "take more passes of a lower depth"
            depth_mm = self._part.depths_mm
            yield from self._above(mine, depth_mm, tool.depth_max_mm, "depth-of-cut", text, advice, "mm")
            text = Text("the {tool} takes too thick a chip", tool=tool.words)
            advice, feed = "lower F, or turn the spindle faster", np.nan_to_num(self._moves.feed_mm_turn)
            yield from self._above(mine, feed, tool.feed_max_mm_turn, "chip-load", text, advice, "mm/rev")

    def slender(self) -> Iterator[Finding]:
        """Yield a warning where the bar sticks out too far for its diameter."""
        low, _, high, radius = self._setup.stock.region.bounds
        limit = SLENDER_WITH_TAILSTOCK if "tailstock" in self._setup.obstacles else SLENDER
        ratio = (high - low) / (2 * radius)
        if ratio > limit * LOAD_SHARE:
            text = "the bar sticks out of the chuck too far for its diameter"
            advice = Text("let it stick out {length:g} mm at most, or support its end", length=limit * 2 * radius)
            numbers: dict[str, Any] = {"value": ratio, "limit": limit, "unit": "times its diameter"}
            yield Finding("warning", "slender", Place(self._setup.file, 1, 1), text, advice, **numbers)

    def unknown_tools(self) -> Iterator[Finding]:
        """Yield each tool of the program whose shape is not known: its moves cut nothing here."""
        for number, line in sorted(self._part.left_out.items()):
            text = Text("tool {number} has no shape: its moves are not simulated", number=number)
            place = Place(self._setup.file, line, 1)
            yield Finding("error", "tool-unknown", place, text, "name its insert, or its angles and nose radius")

    def gouges(self) -> Iterator[Finding]:
        """Yield the deepest cut into the wanted part."""
        if not self._setup.wanted:
            return
        worst = gouge(self._part.section, self._part.stock, self._setup.wanted)
        if worst is not None and worst.depth_mm > GOUGE_MM:
            cut = np.flatnonzero(shapely.distance(self._part.areas, shapely.Point(worst.place_mm)) <= CONTACT_MM)
            numbers: dict[str, Any] = {"value": worst.depth_mm, "limit": GOUGE_MM, "unit": "mm"}
            text, advice = "the tool cuts into the wanted part", "correct the path, or the tool's shape and nose radius"
            move = int(cut[0]) if len(cut) else -1
            yield self._finding(move, "error", "gouge", text, place=worst.place_mm, advice=advice, **numbers)

    def left(self) -> Iterator[Finding]:
        """Yield the thickest material that a profile's tools could have cut and did not."""
        for profile, worst in left_over(self._part.section, self._part.stock, self._setup.wanted, self._setup.tools):
            text = Text("material is left on profile '{name}' where its tools reach", name=profile.name)
            advice = "add the missing pass, or state the stock to leave"
            numbers: dict[str, Any] = {"value": worst.depth_mm, "limit": LEFT_MM + profile.left_mm, "unit": "mm"}
            yield self._finding(-1, "error", "left-over", text, place=worst.place_mm, advice=advice, **numbers)

    def fallen(self) -> Iterator[Finding]:
        """Yield each piece that comes off."""
        for one in self._part.fallen:
            low, _, high, _ = one.section.region.bounds
            text = Text("a piece {length:.3f} mm long comes off the bar here", length=high - low)
            yield self._finding(one.move, "info", "parted-off", text, advice="catch it, and stop the spindle after it")

    def _above(
        self, mine: np.ndarray, values: np.ndarray, limit: float, code: str, text: str, advice: str, unit: str
    ) -> Iterator[Finding]:
        """Yield the worst of these moves whose value is above a limit, 0 for none."""
        over = np.flatnonzero(mine & (values > limit * LOAD_SHARE)) if limit else np.zeros(0, int)
        if len(over):
            move = int(over[values[over].argmax()])
            numbers: dict[str, Any] = {"value": float(values[move]), "limit": limit, "unit": unit, "count": len(over)}
            yield self._finding(move, "warning", code, text, advice=advice, **numbers)

    def _contact(self, one: Contact, code: str, text: str, advice: str) -> Finding:
        numbers: dict[str, Any] = {"value": one.depth_mm, "limit": 0.0, "unit": "mm"}
        return self._finding(one.move, "error", code, text, place=one.place_mm, advice=advice, **numbers)

    def _x(self, **radii_mm: float) -> dict[str, Any]:
        """Return values of X as the program gives them."""
        return {name: float(radius) * self._setup.x_factor for name, radius in radii_mm.items()} | {"unit": "mm"}

    def _finding(
        self, move: int, severity: Severity, code: str, text: str, place: tuple[float, float] | None = None, **more: Any
    ) -> Finding:
        """Return a finding at a move, or at the file where there is none (-1); place: (z, r), else the move's end."""
        if place is None and move >= 0:
            place = tuple(self._moves.end[move].tolist())
        if place is not None:
            more["place_mm"] = (place[1] * self._setup.x_factor, 0.0, place[0])
        line = int(self._moves.line[move]) if move >= 0 else 1
        return Finding(severity, code, Place(self._setup.file, line, 1), text, **more)


def _deepest_of_lines(found: Sequence[Contact], moves: Moves) -> list[Contact]:
    """Return the deepest contact of each line of the program."""
    deepest: dict[int, Contact] = {}
    for one in found:
        line = int(moves.line[one.move])
        if line not in deepest or one.depth_mm > deepest[line].depth_mm:
            deepest[line] = one
    return list(deepest.values())
