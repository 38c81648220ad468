# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes of a lathe's simulation in FreeCAD's 3D view: the part cut open, chuck and tailstock, path, tool, marker.

view's scene graph
  root (not pickable) ── place ── drawn: a node a group (`turned_groups_file`) ── path: switch, rapids, feeds
                              └── tool: switch, translation, shapes ── plane: a line across the part at a Z
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.workbench.services.view_colours import FEED_RGB, MARKER_RGB, RAPID_RGB, Rgb
from CNCStepper.workbench.simulation import coin_nodes as nodes
from CNCStepper.workbench.simulation.scene import POINTS_AT_ONCE

if TYPE_CHECKING:
    from CNCStepper.job.turning.turned_groups_file import Groups
    from CNCStepper.simulation.views.path_lines import Lines

RAW_RGB = (0.72, 0.66, 0.54)
SECTION_RGB = (0.93, 0.84, 0.62)
CHUCK_RGB = (0.45, 0.48, 0.53)
JAWS_RGB = (0.34, 0.37, 0.42)
TAILSTOCK_RGB = (0.55, 0.58, 0.62)
HOLDER_RGB = (0.38, 0.41, 0.46)
TOOL_RGB = (
    (0.00, 0.45, 0.70),
    (0.90, 0.62, 0.00),
    (0.00, 0.62, 0.45),
    (0.80, 0.47, 0.65),
    (0.34, 0.71, 0.91),
    (0.84, 0.37, 0.00),
    (0.60, 0.55, 0.10),
)
FIXED = {"raw": RAW_RGB, "section": SECTION_RGB, "chuck": CHUCK_RGB, "jaws": JAWS_RGB, "tailstock": TAILSTOCK_RGB}
FIXTURES, TOOLS = ("chuck", "jaws", "tailstock"), ("tool", "holder")
ABOVE_MM = 0.03  # lines over the section, so that they are seen


def tool_rgb(tool: int) -> Rgb:
    """Return the colour of a tool, and of the surface that it has cut."""
    return TOOL_RGB[(tool - 1) % len(TOOL_RGB)]


def group_rgb(name: str) -> Rgb:
    """Return the colour of a drawn group."""
    kind, _, tool = name.partition("-")
    if kind == "holder":
        return HOLDER_RGB
    return tool_rgb(int(tool)) if tool else FIXED[name]


class TurnedScene:
    """The nodes of one simulation in one 3D view. `remove` takes all away.

    work_origin_mm: where the part's zero lies in the document.
    """

    def __init__(self, view: Any, work_origin_mm: tuple[float, float, float]):
        from pivy import coin

        self._graph = view.getSceneGraph()
        self._root = coin.SoSeparator()
        self._root.setName("CNCStepper_Simulation")
        unpickable, place = coin.SoPickStyle(), coin.SoTranslation()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        place.translation = work_origin_mm
        self._drawn: dict[str, Any] = {}
        self._reach_mm = 1.0
        self._bodies, self._path = coin.SoSeparator(), coin.SoSwitch()
        self._path.whichChild = coin.SO_SWITCH_ALL
        self._tool, self._tool_place, self._tool_shapes = coin.SoSwitch(), coin.SoTranslation(), coin.SoSwitch()
        self._tool.whichChild = -1
        self._tool.addChild(nodes.separator(self._tool_place, self._tool_shapes))
        self._tools: list[int] = []
        self._plane = coin.SoSwitch()
        self._plane.whichChild = -1
        for child in (unpickable, place, self._bodies, self._path, self._tool, self._plane):
            self._root.addChild(child)
        self._graph.addChild(self._root)

    def change(self, groups: Groups) -> None:
        """Draw groups: those of the part take the place of all that were drawn of it, others that of their own name."""
        for name in [name for name in self._drawn if name in groups or name not in FIXTURES]:
            self._bodies.removeChild(self._drawn.pop(name))
        for name, strips in groups.items():
            if name.partition("-")[0] not in TOOLS and len(strips[0]):
                self._drawn[name] = nodes.separator(*_look(name), nodes.strips(*strips))
                self._bodies.addChild(self._drawn[name])
        tools = {name: strips for name, strips in groups.items() if name.partition("-")[0] in TOOLS}
        if tools:
            self._add_tools(tools)
            self._reach_mm = max(float(np.abs(strips[0][:, :2]).max(initial=1.0)) for name, strips in groups.items()
                                 if name in ("raw", "section") or name.startswith("cut"))  # fmt: skip

    def _add_tools(self, groups: Groups) -> None:
        """Add the tools by number; none is shown yet."""
        numbers = sorted({int(name.partition("-")[2]) for name in groups})
        self._tool_shapes.removeAllChildren()
        for number in numbers:
            shapes = {f"{kind}-{number}" for kind in ("tool", "holder")} & set(groups)
            bodies = [nodes.separator(*_look(name), nodes.strips(*groups[name])) for name in sorted(shapes)]
            self._tool_shapes.addChild(nodes.separator(*bodies))
        self._tools = numbers

    def add_path(self, rapids: Lines, feeds: Lines) -> None:
        """Add the lines of the path."""
        above = np.array([0.0, ABOVE_MM, 0.0], np.float32)
        for lines, rgb in ((rapids, RAPID_RGB), (feeds, FEED_RGB)):
            group = nodes.separator(nodes.plain(rgb))
            for piece in lines.pieces(POINTS_AT_ONCE):
                group.addChild(nodes.separator(nodes.lines(piece.points + above, piece.counts)))
            self._path.addChild(group)

    def remove(self) -> None:
        """Take everything out of the 3D view."""
        if self._graph.findChild(self._root) >= 0:
            self._graph.removeChild(self._root)

    def show_path(self, shown: bool) -> None:
        """Show the lines of rapids and feeds, or not."""
        from pivy import coin

        self._path.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE

    def show_tool(self, number: int, tip_mm: np.ndarray) -> None:
        """Put the tool with that number there; a place that is not known shows no tool."""
        known = bool(np.isfinite(tip_mm).all()) and number in self._tools
        if known:
            self._tool_place.translation.setValue(*map(float, tip_mm))
            self._tool_shapes.whichChild = self._tools.index(number)
        self._tool.whichChild = 0 if known else -1

    def mark(self, z_mm: float) -> None:
        """Draw a line across the part at a Z."""
        reach_mm = 1.2 * self._reach_mm
        points = np.array([(-reach_mm, ABOVE_MM, z_mm), (reach_mm, ABOVE_MM, z_mm)], np.float32)
        line = nodes.lines(points, np.array([2], np.int32))
        self._plane.removeAllChildren()
        self._plane.addChild(nodes.separator(nodes.in_front(), nodes.plain(MARKER_RGB), line))
        self._plane.whichChild = 0


def _look(name: str) -> list[Any]:
    """Return the settings of a group: metal that shines a little, section faces that do not."""
    if name == "section":
        return [nodes.plain(group_rgb(name))]
    return [nodes.both_sides(), nodes.material(group_rgb(name), 0.25)]
