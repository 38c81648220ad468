# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes of a simulation in FreeCAD's 3D view: the stock's outline, the cut part, the path, the tool, a marker.

view's scene graph
  root (not pickable) ── place (the job's work zero) ── stock ── part ── rapids ── feeds ── fallen
                                                    └── tool: switch, translation, shapes ── marker
  part: switch ── the finished part
              └── the part at a moment: one node a tile, so that few are exchanged when time goes on
  fallen: a switch for each piece that is cut free of a sheet
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.simulation.meshes.bodies_of_revolution import revolved
from CNCStepper.simulation.views.depth_colours import deepest_shown_mm
from CNCStepper.workbench.services.view_colours import FEED_RGB, MARKER_RGB, RAPID_RGB, STOCK_RGB
from CNCStepper.workbench.simulation import coin_nodes as nodes

if TYPE_CHECKING:
    from CNCStepper.job.proof_folder import Part
    from CNCStepper.simulation.meshes.fallen_faces import FallenFaces
    from CNCStepper.workbench.proving.proof_process import ProofResult
    from CNCStepper.workbench.simulation.timeline_client import Tiles

FACES_AT_ONCE = 2500  # so many are handed to the 3D view at once, which takes a few ms
POINTS_AT_ONCE = 10_000  # of lines, likewise
PIECES_AT_ONCE = 50  # that are cut free, likewise
CUTTER_RGB = (0.78, 0.80, 0.83)
SHANK_RGB = (0.42, 0.45, 0.50)
FALLEN_RGB = (0.62, 0.70, 0.78)
MARKER_SHARE = 0.12  # of the stock's longest side: the height of the marker
FINISHED, AT_MOMENT = 0, 1  # children of the part's switch
CORNERS = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0))])
OUTLINE = np.concatenate([CORNERS, *(CORNERS[[k, k + 5]] for k in range(1, 4))])
OUTLINE_COUNTS = np.array([10, 2, 2, 2])


class Scene:
    """The nodes of one simulation in one 3D view.

    `load_part` and, when the proof is there, `load_result` bring them in bit by bit: run them on from a timer until
    they end. `remove` takes all away. work_origin_mm: where the work zero lies in the document.
    """

    def __init__(self, view: Any, part: Part, work_origin_mm: tuple[float, float, float]):
        from pivy import coin

        self._cut = part
        self._graph = view.getSceneGraph()
        self._root = coin.SoSeparator()
        self._root.setName("CNCStepper_Simulation")
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        place = coin.SoTranslation()
        place.translation = work_origin_mm
        self._root.addChild(unpickable)
        self._root.addChild(place)
        self._tools: dict[int, tuple[np.ndarray, np.ndarray]] = {}
        self._tool_number: int | None = None
        self._tiles: dict[int, Any] = {}
        self._fallen: FallenFaces | None = None
        self._fallen_shown = 0
        self._fallen_pieces = nodes.separator(nodes.plain(FALLEN_RGB), nodes.concave())
        self._part = coin.SoSwitch()
        self._part.whichChild = FINISHED
        for _ in (FINISHED, AT_MOMENT):
            self._part.addChild(_solid_faces())
        self._path = coin.SoSwitch()
        self._path.whichChild = coin.SO_SWITCH_ALL
        self._graph.addChild(self._root)

    @property
    def height_range_mm(self) -> tuple[float, float]:
        """The heights at the two ends of the colour scale."""
        part = self._cut
        low, high = float(part.low_mm[2]), float(part.high_mm[2])
        return deepest_shown_mm(float(part.heights_mm.min()), low, high), high

    def load_part(self) -> Iterator[None]:
        """Add stock and finished part, made a few ms at a time; the view is drawn once it is whole."""
        self._root.addChild(self._stock())
        yield
        for piece in _pieces(self._cut.corners, self._cut.rgba):
            self._part.getChild(FINISHED).addChild(piece)
            yield
        self._root.addChild(self._part)

    def load_result(self, result: ProofResult) -> Iterator[None]:
        """Add path, fallen pieces, tools and marker, a few ms at a time."""
        self._root.addChild(self._path)
        for lines, rgb in ((result.rapids, RAPID_RGB), (result.feeds, FEED_RGB)):
            group = nodes.separator(nodes.plain(rgb))
            self._path.addChild(group)
            for piece in lines.pieces(POINTS_AT_ONCE):
                group.addChild(nodes.separator(nodes.lines(piece.points, piece.counts)))
                yield
        yield from self._add_fallen(result.fallen)
        self._add_tools(result.tools)
        self._add_marker()

    def remove(self) -> None:
        """Take everything out of the 3D view."""
        if self._graph.findChild(self._root) >= 0:
            self._graph.removeChild(self._root)

    def change_tiles(self, tiles: Tiles) -> Iterator[None]:
        """Exchange tiles of the part at a moment: made a few ms at a time, and then all at once."""
        made = {}
        for number, faces in tiles.items():
            made[number] = nodes.separator()
            for piece in _pieces(*faces):
                made[number].addChild(piece)
                yield
        group = self._part.getChild(AT_MOMENT)
        for number, tile in made.items():
            if number in self._tiles:
                group.replaceChild(self._tiles[number], tile)
            else:
                group.addChild(tile)
        self._tiles.update(made)

    def show_tiles(self) -> None:
        """Show the part at a moment."""
        self._part.whichChild = AT_MOMENT

    def show_finished(self) -> None:
        """Show the finished part."""
        self._part.whichChild = FINISHED

    def show_path(self, shown: bool) -> None:
        """Show the lines of rapids and feeds, or not."""
        from pivy import coin

        self._path.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE

    def show_fallen(self, time_s: float) -> None:
        """Show the pieces that are free at a moment."""
        if self._fallen is None:
            return
        shown = self._fallen.fallen_at(time_s)
        for number in range(*sorted((shown, self._fallen_shown))):
            switch = self._fallen_pieces.getChild(self._fallen_pieces.getNumChildren() - len(self._fallen) + number)
            switch.whichChild = 0 if number < shown else -1
        self._fallen_shown = shown

    def show_tool(self, number: int, tip_mm: np.ndarray) -> None:
        """Put the tool with that number there; a place that is not known shows no tool."""
        known = bool(np.isfinite(tip_mm).all()) and number in self._tools
        if known:
            self._tool_place.translation.setValue(*map(float, tip_mm))
            if number != self._tool_number:
                self._tool_number = number
                self._tool_shapes.whichChild = list(self._tools).index(number)
        if bool(self._tool.whichChild.getValue() == 0) != known:
            self._tool.whichChild = 0 if known else -1

    def mark(self, place_mm: np.ndarray | None) -> None:
        """Put the marker's tip there; None takes it away."""
        if place_mm is None or not np.isfinite(place_mm).all():
            self._marker.whichChild = -1
            return
        self._marker_place.translation.setValue(*map(float, place_mm))
        self._marker.whichChild = 0

    def _stock(self) -> Any:
        part = self._cut
        points = (part.low_mm + OUTLINE * (part.high_mm - part.low_mm)).astype(np.float32)
        return nodes.separator(nodes.plain(STOCK_RGB), nodes.lines(points, OUTLINE_COUNTS))

    def _add_fallen(self, fallen: FallenFaces) -> Iterator[None]:
        """Add a switch for each piece, a few ms at a time; none is shown yet."""
        from pivy import coin

        self._root.addChild(self._fallen_pieces)
        for number, (points, counts) in enumerate(fallen):
            switch = coin.SoSwitch()
            switch.whichChild = -1
            switch.addChild(nodes.polygons(points, counts))
            self._fallen_pieces.addChild(switch)
            if number % PIECES_AT_ONCE == 0:
                yield
        self._fallen = fallen

    def _add_tools(self, tools: dict[int, tuple[np.ndarray, np.ndarray]]) -> None:
        from pivy import coin

        self._tools = tools
        self._tool = coin.SoSwitch()
        self._tool.whichChild = -1
        self._tool_place = coin.SoTranslation()
        self._tool_shapes = coin.SoSwitch()
        for cutter, shank in tools.values():
            self._tool_shapes.addChild(_tool_shape(cutter, shank))
        self._tool.addChild(nodes.separator(self._tool_place, self._tool_shapes))
        self._root.addChild(self._tool)

    def _add_marker(self) -> None:
        from pivy import coin

        part = self._cut
        height_mm = MARKER_SHARE * float((part.high_mm - part.low_mm).max())
        self._marker = coin.SoSwitch()
        self._marker.whichChild = -1
        self._marker_place = coin.SoTranslation()
        pin = revolved(np.array([(0.0, 0.0), (0.22 * height_mm, height_mm), (0.0, height_mm)]))
        settings = (nodes.solid(), nodes.in_front(), nodes.material(MARKER_RGB))
        self._marker.addChild(nodes.separator(self._marker_place, *settings, nodes.quads(pin)))
        self._root.addChild(self._marker)


def _solid_faces() -> Any:
    """Return a group for faces of a part, pushed back a little so that lines on them are seen."""
    from pivy import coin

    return nodes.separator(nodes.unlit(), nodes.solid(), coin.SoPolygonOffset())


def _pieces(corners: np.ndarray, rgba: np.ndarray) -> Iterator[Any]:
    """Yield nodes of so many faces as are handed to the 3D view at once."""
    for first in range(0, len(corners), FACES_AT_ONCE):
        piece = slice(first, first + FACES_AT_ONCE)
        yield nodes.coloured_quads(corners[piece], rgba[piece])


def _tool_shape(cutter: np.ndarray, shank: np.ndarray) -> Any:
    return nodes.separator(
        nodes.solid(),
        nodes.separator(nodes.material(CUTTER_RGB, 0.4), nodes.quads(revolved(cutter))),
        nodes.separator(nodes.material(SHANK_RGB, 0.3), nodes.quads(revolved(shank))),
    )
