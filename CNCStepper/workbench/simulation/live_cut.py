# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut under way in FreeCAD's 3D view: tool and path from the controller's reports, the part as it is cut by then.

status ──► TipFollower ──► planned time ──► Player ──► Material: a process of its own gives the part
   └─────► ReportedPath ──► lines behind the tool
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import Any

import numpy as np
from PySide import QtCore

from CNCStepper.simulation.tip_follower import ReportedPath, TipFollower
from CNCStepper.workbench.proving.proof_process import ProofResult
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.object_observers import ProgramObserver
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.services.view_colours import REPORTED_RGB
from CNCStepper.workbench.simulation import coin_nodes as nodes
from CNCStepper.workbench.simulation.player import Player
from CNCStepper.workbench.simulation.scene import Scene
from CNCStepper.workbench.simulation.stock_update import Material
from CNCStepper.workbench.simulation.view_session import Stage, view_of


class LiveScene(Scene):
    """The nodes of a cut under way: stock, part, tool, and the reported path in place of the program's."""

    def load_tools(self, tools: dict[int, tuple[np.ndarray, np.ndarray]]) -> Iterator[None]:
        """Add the tools and an empty path."""
        self._reported = nodes.separator(nodes.plain(REPORTED_RGB))
        self._root.addChild(self._reported)
        self._add_tools(tools)
        yield

    def show_reported(self, points_mm: np.ndarray) -> None:
        """Show the path of the reports, float32[n, 3]."""
        drawn = nodes.lines(points_mm, np.array([len(points_mm)], np.int32))
        if self._reported.getNumChildren() > 1:
            self._reported.replaceChild(1, drawn)
        else:
            self._reported.addChild(drawn)


class LiveCut(QtCore.QObject):
    """One cut that is shown, until `end`; a document that is closed or whose program is deleted ends it.

    program: the document object that is cut. result: its proof. view: the 3D view.
    """

    def __init__(self, program: Any, result: ProofResult, view: Any, parent: Any = None):
        super().__init__(parent)
        self.result, self.is_shown = result, True
        self._follower, self._path = TipFollower(result.moves), ReportedPath()
        self._player = Player(result.moves, self)
        self._stage = Stage(program, view)
        self._scene = LiveScene(view, result.part, result.work_origin_mm)
        self._scene.show_tiles()  # the finished part is shown at the end alone
        self._material: Material | None = None
        self._document_name = program.Document.Name
        self._watch = ProgramObserver(program, lambda: None, self._ended_elsewhere, self._document_closing)
        self._bits = chain(self._scene.load_part(), self._scene.load_tools(result.tools), self._load_material())
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
        tip_mm = np.array(status.wpos_mm[:3], float)
        self._player.seek(self._follower.follow(status.file_line, status.file_line_sent, tip_mm))
        self._scene.show_tool(int(self.result.moves.tool[self._follower.row]), tip_mm)
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

    def _load_material(self) -> Iterator[None]:
        """Start the process that gives the part at any moment."""
        self._material = Material(self._player, self._scene, self.result, self)
        self._material.moments.failed.connect(messages.guarded(messages.error))
        yield

    def _load_on(self) -> None:
        if next(self._bits, self) is not None:
            self._loader.stop()

    def _ended_elsewhere(self) -> None:
        QtCore.QTimer.singleShot(0, messages.guarded(self.end))

    def _document_closing(self, name: str) -> None:
        if name == self._document_name:
            self._ended_elsewhere()


def live_cut(program: Any, result: Any, parent: Any) -> LiveCut | None:
    """Return the cut of a program shown in a 3D view of its document; None without such a view, or with a note."""
    try:
        view = view_of(program.Document)
    except ReferenceError:  # as FreeCAD says that it was deleted, or its document closed, while it is cut
        return None
    if view is None:
        return None
    if not isinstance(result, ProofResult):
        messages.note(tr("The cut of a lathe is not shown while it runs: Check and simulate shows it at any moment."))
        return None
    return LiveCut(program, result, view, parent)
