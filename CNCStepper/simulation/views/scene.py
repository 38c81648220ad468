# SPDX-License-Identifier: LGPL-2.1-or-later
"""The content of a picture: the part at one time, the path so far, the tool, and the work surface."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from shapely.geometry.base import BaseGeometry

from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.cutter_solid import Tools, tool_numbered
from CNCStepper.simulation.exact.free_pieces import FreePiece
from CNCStepper.simulation.meshes.tool_outline import outlines_mm
from CNCStepper.simulation.removal.heightmap import HeightMap
from CNCStepper.simulation.removal.timeline import TimelinePosition
from CNCStepper.simulation.tip_segments import frame_mm
from CNCStepper.simulation.tip_track import TipTrack
from CNCStepper.simulation.views.fallen_pieces import fallen_until
from CNCStepper.simulation.views.path_lines import DrawnPath, Until, drawn_path
from CNCStepper.toolpath import Toolpath


@dataclass(frozen=True)
class Scene:
    """One moment of a program; all lengths in work coordinates.

    until: how far the path is drawn, None before the first move. outlines: of cutter and shank, as
    `tool_outline.outlines_mm`, None where there is no tool to draw. limits_mm: low and high corner of the travel,
    float64[2, 3], None where the work zero is not known. tallest_mm: height of the longest cutter in the program.
    fallen: the pieces of a sheet that have been cut free, polygons in work coordinates.
    """

    toolpath: Toolpath
    part: HeightMap
    until: Until | None
    outlines: tuple[np.ndarray, np.ndarray] | None = None
    limits_mm: np.ndarray | None = None
    tallest_mm: float = 0.0
    fallen: tuple[BaseGeometry, ...] = ()

    def path(self, seen: tuple[int, ...]) -> DrawnPath:
        """Return the path so far, for a view that shows these axes."""
        return drawn_path(self.toolpath, seen, self.until) if self.until else DrawnPath([], [], [], [])

    @cached_property
    def tip_mm(self) -> np.ndarray | None:
        """Where the tip is, float64[3], or None while that is not known."""
        return self.until.tip_mm if self.until and np.isfinite(self.until.tip_mm).all() else None

    @property
    def deepest_mm(self) -> float:
        """The lowest height of the tip in the program, not above the stock's top."""
        return float(self._whole_path_mm[:, 2].min(initial=self.part.stock.top_mm))

    @cached_property
    def _whole_path_mm(self) -> np.ndarray:
        return drawn_path(self.toolpath, (0, 1, 2)).points_mm

    @cached_property
    def box_mm(self) -> np.ndarray:
        """Low and high corner of the stock and of the path of the whole program, float64[2, 3]."""
        stock = self.part.stock
        everything = np.vstack([stock.low_mm, stock.high_mm, self._whole_path_mm])
        return np.array([everything.min(axis=0), everything.max(axis=0)])


def scene_at(
    toolpath: Toolpath,
    ends_s: np.ndarray,
    part: HeightMap,
    tools: Tools,
    moment: TimelinePosition | None = None,
    machine: Machine | None = None,
    pieces: Sequence[FreePiece] = (),
) -> Scene:
    """Return the scene at a time, or at the program's end; `part` is the stock at that time.

    machine: its travel is the work surface, where the work zero is known. pieces: what the program cuts free.
    """
    used = [tool_numbered(tools, state.tool) for state in toolpath.states]
    tallest_mm = max((outlines_mm(tool, part.stock.size_mm[2])[0][-1, 1] for tool in used if tool), default=0.0)
    row, share = (len(toolpath) - 1, 1.0) if moment is None else (moment.row, moment.share)
    limits_mm = limits_of(toolpath, machine) if machine and toolpath.start.zero_known else None
    if row < 0:
        return Scene(toolpath, part, None, None, limits_mm, tallest_mm)
    tip_mm = TipTrack.of(toolpath, ends_s).tip_mm(row, share)
    tool = tool_numbered(tools, toolpath.states[int(toolpath.table().state[row])].tool)
    outlines = outlines_mm(tool, part.stock.size_mm[2]) if tool else None
    until = Until(row, share, tip_mm)
    return Scene(toolpath, part, until, outlines, limits_mm, tallest_mm, fallen_until(pieces, until))


def limits_of(toolpath: Toolpath, machine: Machine) -> np.ndarray:
    """Return low and high corner of a machine's travel in work coordinates, float64[2, 3]; the work zero is known."""
    travel = np.array([[axis.travel_min_mm, axis.travel_max_mm] for axis in machine.axes]).T
    return travel - frame_mm(toolpath)
