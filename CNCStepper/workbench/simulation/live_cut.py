# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut under way in FreeCAD's 3D view: tool and path from the controller's reports, the part as it is cut by then.

status ──► tip ──┬─► TipFollower ──► planned time ──► Player ──► Material or TurnedMaterial: a process gives the part
                 └─► ReportedPath ──► lines behind the tool
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Any

import numpy as np
from PySide import QtCore

from CNCStepper.job.turning.make_turning import points_in_part
from CNCStepper.simulation.tip_follower import ReportedPath, TipFollower
from CNCStepper.workbench.proving.proof_process import ProofResult, ProvenProgram, TurnedResult
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.object_observers import ProgramObserver
from CNCStepper.workbench.services.view_colours import REPORTED_RGB
from CNCStepper.workbench.simulation import coin_nodes as nodes
from CNCStepper.workbench.simulation.player import Player
from CNCStepper.workbench.simulation.scene import Scene
from CNCStepper.workbench.simulation.stock_update import Material
from CNCStepper.workbench.simulation.turned_material import TurnedMaterial
from CNCStepper.workbench.simulation.turned_scene import ABOVE_MM, TurnedScene
from CNCStepper.workbench.simulation.view_session import Stage, view_of


class ReportedNode:
    """The path of the reports as a node of its own, in a scene's root."""

    def __init__(self, root: Any):
        self._group = nodes.separator(nodes.plain(REPORTED_RGB))
        root.addChild(self._group)

    def show(self, points_mm: np.ndarray) -> None:
        """Show a path, float32[n, 3]."""
        drawn = nodes.lines(points_mm, np.array([len(points_mm)], np.int32))
        if self._group.getNumChildren() > 1:
            self._group.replaceChild(1, drawn)
        else:
            self._group.addChild(drawn)


class LiveScene(Scene):
    """The nodes of a cut under way: stock, part, tool, and the reported path in place of the program's."""

    def load_tools(self, tools: dict[int, tuple[np.ndarray, np.ndarray]]) -> Iterator[None]:
        """Add the tools and an empty path."""
        self._reported = ReportedNode(self._root)
        self._add_tools(tools)
        yield

    def show_reported(self, points_mm: np.ndarray) -> None:
        """Show the path of the reports, float32[n, 3]."""
        self._reported.show(points_mm)


class LiveTurnedScene(TurnedScene):
    """The nodes of a lathe's cut under way: the part cut open, chuck, tool, and the reported path."""

    def __init__(self, view: Any, work_origin_mm: tuple[float, float, float]):
        super().__init__(view, work_origin_mm)
        self._reported = ReportedNode(self._root)

    def show_reported(self, points_mm: np.ndarray) -> None:
        """Show the path of the reports, float32[n, 3], over the section."""
        self._reported.show(points_mm + np.array([0.0, ABOVE_MM, 0.0], np.float32))


class LiveCut(QtCore.QObject):
    """One cut that is shown, until `end`; a document that is closed or whose program is deleted ends it.

    program: the document object that is cut. result: its proof. view: the 3D view. `_open_scene`, `_load_scene`,
    `_open_material` and `_tip_mm` are those of a kind of machine.
    """

    def __init__(self, program: Any, result: Any, view: Any, parent: Any = None):
        super().__init__(parent)
        self.result, self.is_shown = result, True
        self._program_label = program.Label
        self._follower, self._path = TipFollower(result.moves), ReportedPath()
        self._reported_mm: np.ndarray | None = None  # the tip, as it was reported last
        self._player = Player(result.moves, self)
        self._stage = Stage(program, view)
        self._scene = self._open_scene(view)
        self._material: Any = None
        self._document_name = program.Document.Name
        self._watch = ProgramObserver(program, lambda: None, self._ended_elsewhere, self._document_closing)
        self._bits = chain(self._load_scene(), self._load_material())
        self._loader = QtCore.QTimer(self)
        self._loader.setInterval(0)
        self._loader.timeout.connect(messages.guarded(self._load_on))
        self._loader.start()

    @property
    def time_s(self) -> float:
        """The planned time up to which the program is cut."""
        return self._follower.time_s

    def follow(self, status: Any) -> None:
        """Show the tool where it was reported, and the part as it is cut by then."""
        if self._material is None or status.wpos_mm is None or len(status.wpos_mm) < 3:
            return
        tip_mm = self._reported_mm = self._tip_mm(status.wpos_mm[:3])
        self._player.seek(self._follower.follow(status.file_line, status.file_line_sent, tip_mm))
        self._show_tool()
        if self._path.add(tip_mm):
            self._scene.show_reported(self._path.points_mm)

    def finish(self) -> None:
        """Show the finished part: all is cut."""
        self._player.seek(self.result.moves.duration_s)

    def end(self) -> None:
        """Take all away, and show what was hidden; the view stays as a person has turned it."""
        if not self.is_shown:
            return
        self.is_shown = False
        self._loader.stop()
        self._watch.end()
        if self._material is not None:
            self._material.end()
        self._scene.remove()
        self._stage.show_again()
        self.deleteLater()

    def _open_scene(self, view: Any) -> Any:
        """Return the scene, in the view."""
        raise NotImplementedError

    def _load_scene(self) -> Iterator[None]:
        """Bring into the scene what stays, a few ms at a time."""
        raise NotImplementedError

    def _open_material(self) -> Any:
        """Start the process that gives the part at any moment, and return its client."""
        raise NotImplementedError

    def _tip_mm(self, work_mm: Sequence[float]) -> np.ndarray:
        """Return the place of a work position among the proof's moves, float64[3]."""
        raise NotImplementedError

    def _load_material(self) -> Iterator[None]:
        self._material = self._open_material()
        yield

    def _show_tool(self) -> None:
        if self._reported_mm is not None:
            self._scene.show_tool(int(self.result.moves.tool[self._follower.row]), self._reported_mm)

    def _load_on(self) -> None:
        if next(self._bits, self) is not None:
            self._loader.stop()

    def _ended_elsewhere(self) -> None:
        QtCore.QTimer.singleShot(0, messages.guarded(self.end))

    def _document_closing(self, name: str) -> None:
        if name == self._document_name:
            self._ended_elsewhere()


class LiveTableCut(LiveCut):
    """The cut of a part that lies on a table; its moves are in work coordinates."""

    result: ProofResult

    def _open_scene(self, view: Any) -> LiveScene:
        scene = LiveScene(view, self.result.part, self.result.work_origin_mm)
        scene.show_tiles()  # the finished part is shown at the end alone
        return scene

    def _load_scene(self) -> Iterator[None]:
        yield from self._scene.load_part()
        yield from self._scene.load_tools(self.result.tools)

    def _open_material(self) -> Material:
        material = Material(self._player, self._scene, self.result, self)
        material.moments.failed.connect(messages.guarded(messages.error))
        return material

    def _tip_mm(self, work_mm: Sequence[float]) -> np.ndarray:
        return np.array(work_mm, float)


class LiveTurnedCut(LiveCut):
    """The cut of a turned part; its moves are on the part, which the proof's placement leads to."""

    result: TurnedResult

    def _open_scene(self, view: Any) -> LiveTurnedScene:
        return LiveTurnedScene(view, self.result.work_origin_mm)

    def _load_scene(self) -> Iterator[None]:
        yield  # part, chuck and tools come with the first moment

    def _open_material(self) -> TurnedMaterial:
        material = TurnedMaterial(self._player, self._scene, self.result, self._program_label, self)
        material.failed.connect(messages.guarded(messages.error))
        material.shown.connect(messages.guarded(self._show_tool))
        material.follow()
        return material

    def _tip_mm(self, work_mm: Sequence[float]) -> np.ndarray:
        return points_in_part(np.array([work_mm], float), self.result.placement)[0]


def live_cut(program: Any, result: ProvenProgram, parent: Any) -> LiveCut | None:
    """Return the cut of a program shown in a 3D view of its document; None without such a view."""
    try:
        view = view_of(program.Document)
    except ReferenceError:  # as FreeCAD says that it was deleted, or its document closed, while it is cut
        return None
    if view is None:
        return None
    kind = LiveTurnedCut if isinstance(result, TurnedResult) else LiveTableCut
    return kind(program, result, view, parent)
