# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form that every cycle shares: what it is given besides its parameters and what it answers.

A cycle is a frozen pydantic model of parameters with one method,

    cut(setup, table) -> Answer

which appends its moves to a `TableBuilder` in WORK coordinates (z = 0 is the top of the stock) and
leaves the tool at clearance height. It raises `CycleError` before it has added any row.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.cut_charts import CutData
from CNCStepper.machine.processes import MILLING, Process
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.toolpath import TableBuilder


@dataclass(frozen=True)
class Setup:
    """What the job gives every cycle; heights are above the stock's top, feeds are the tool's.

    stock, thickness_mm: the outline of the raw material seen from above and its thickness, where they are known. keep:
    closed outlines of the parts that the job's other operations leave standing, which leads must not cut into. parts:
    of those, for each contour that runs outside, the outlines of the part, which no cut beside it may enter. Curves are
    in work coordinates. process, cut_data: how it is cut, with the row of the cut chart where the process has one.
    has_z: without a Z axis all rows stay at height 0. power_s: the S with which a beam or wire is on.
    """

    tool: Tool
    clearance_mm: float
    retract_mm: float
    stock: Curve | None = None
    keep: tuple[Curve, ...] = ()
    thickness_mm: float | None = None
    parts: tuple[tuple[Curve, ...], ...] = ()
    process: Process = MILLING
    cut_data: CutData | None = None
    has_z: bool = True
    power_s: float = 1.0


@dataclass(frozen=True)
class Removal:
    """What a cycle wants removed: the plane region from `top_mm` down to `bottom_mm`, exactly.

    region: shapely polygon(s) whose boundary lies within 0.0005 mm of the true shape. An engraving
    wants its line at its depth: there `region` is the line itself (no area) and the tool makes the width.
    tolerance_mm: how far from it the cycle promises to stay; a check refuses what leaves it. reachable: the part
    of the region that the tool can reach, where that is not all; only there material left is refused.
    """

    region: BaseGeometry
    top_mm: float
    bottom_mm: float
    tolerance_mm: float = 0.01
    reachable: BaseGeometry | None = None


@dataclass(frozen=True)
class RestCorner:
    """A place that the tool cannot reach: how thick the material is that stays there, where, and its area."""

    thick_mm: float
    place_mm: tuple[float, float]
    area_mm2: float


@dataclass(frozen=True)
class Answer:
    """What a cycle reports: the wanted removals, its figures (recalculated ae, ap, passes) by name, and warnings.

    corners: all places that the tool cannot reach, the worst first. parts: what a beam or wire cuts out, tabs or not,
    in the order in which that is done: shapely polygons with their holes, exact within 0.0005 mm.
    """

    removals: list[Removal]
    figures: dict[str, float] = field(default_factory=dict)
    warnings: list[str] = field(default_factory=list)
    corners: list[RestCorner] = field(default_factory=list)
    parts: list[BaseGeometry] = field(default_factory=list)


class Cycle(Protocol):
    """The interface of a cycle for a job."""

    cycle: str
    tool: int

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the moves to `table` and return what they are to remove."""
        ...
