# SPDX-License-Identifier: LGPL-2.1-or-later
"""The turned part where the player stands, and its diameter at a Z: asked of a process of its own, without waiting.

player ──► follow ──► one question at a time, the newest ──► groups of faces ──► scene
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.request_queue import RequestQueue
from CNCStepper.workbench.simulation.player import Player

if TYPE_CHECKING:
    from CNCStepper.workbench.proving.proof_process import TurnedResult
    from CNCStepper.workbench.simulation.turned_scene import TurnedScene

WORKER = "CNCStepper.workers.turned_timeline"
QUARTER_DEG = 90.0


class TurnedMaterial(QtCore.QObject):
    """Shows the part in the scene; `end` ends it. open_deg: how far it is cut open; z_mm: where its diameter is read.

    read: sent with diameter and bore in mm, None without a Z. shown: sent when the scene shows an asked moment. mesh:
    with the time and the path of an STL file. failed: with an error; the next question starts the process again.
    """

    read = QtCore.Signal(object, object)
    shown = QtCore.Signal()
    mesh = QtCore.Signal(float, str)
    failed = QtCore.Signal(object)

    def __init__(self, player: Player, scene: TurnedScene, result: TurnedResult, name: str, parent: Any = None):
        super().__init__(parent)
        self._player, self._scene, self._result = player, scene, result
        self.open_deg = QUARTER_DEG
        self.z_mm: float | None = None
        self._asked = self._wanted = False
        what, advice = "the simulation's process has ended", "move the slider to start it again"
        lost = CNCStepperError("timeline-lost", what, advice=advice)
        self._questions = RequestQueue(WORKER, lost, result.folder.name, name, parent=self)
        self._questions.answered.connect(guarded(self._take))
        self._questions.failed.connect(guarded(self._fail))
        player.moved.connect(guarded(self.follow))

    @property
    def waiting(self) -> bool:
        """Whether the scene still shows another moment."""
        return self._asked

    def follow(self) -> None:
        """Show the part where the player stands, as soon as what was asked before is shown."""
        self._wanted = True
        self._ask()

    def open_by(self, open_deg: float) -> None:
        """Cut the part open by another angle."""
        self.open_deg = open_deg
        self.follow()

    def read_at(self, z_mm: float | None) -> None:
        """Read the diameter at another place along the axis; None: nowhere."""
        self.z_mm = z_mm
        self.follow()

    def want_mesh(self) -> None:
        """Ask for the part where the player stands as a mesh."""
        self._questions.ask({"mesh": self._player.time_s})

    def end(self) -> None:
        """Ask and show nothing any more."""
        self._questions.end()
        self._asked = self._wanted = False

    def _ask(self) -> None:
        if self._wanted and not self._asked:
            self._asked, self._wanted = True, False
            self._questions.ask({"at": self._player.time_s, "open_deg": self.open_deg, "z_mm": self.z_mm})

    def _take(self, answer: dict[str, Any]) -> None:
        from CNCStepper.job.turning.turned_groups_file import read_groups

        folder = Path(self._result.folder.name)
        if "mesh" in answer:
            self.mesh.emit(answer["at"], str(folder / answer["mesh"]))
            return
        self._scene.change(read_groups(folder, answer["groups"]))
        if "operations_s" in answer:
            self._player.operations_s = answer["operations_s"]
            self._scene.show_tool(int(self._result.moves.tool[self._player.row]), self._player.tip_mm())
        self.read.emit(answer["diameter_mm"], answer["bore_mm"])
        self._asked = False
        self.shown.emit()
        self._ask()

    def _fail(self, error: CNCStepperError) -> None:
        self.end()
        self.failed.emit(error)
