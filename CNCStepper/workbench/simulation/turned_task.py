# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task of a lathe's simulation: the bar as it stands at any moment, cut open, with chuck, tool and path."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from CNCStepper.workbench.features.program import job_behind
from CNCStepper.workbench.proving.proof_process import TurnedResult
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.simulation.player import Player
from CNCStepper.workbench.simulation.task import SimulationTask, keep_mesh, no_view, words_of
from CNCStepper.workbench.simulation.turned_material import TurnedMaterial
from CNCStepper.workbench.simulation.turned_panel import TurnedPanel
from CNCStepper.workbench.simulation.view_session import Stage, point_in_plane, view_of

if TYPE_CHECKING:
    from CNCStepper.errors import CNCStepperError
    from CNCStepper.simulation.finding import Finding
    from CNCStepper.workbench.simulation.turned_scene import TurnedScene

CLICK = "SoMouseButtonEvent"


class TurnedSimulationTask(SimulationTask):
    """The object for FreeCAD's task panel; `form` is its widget."""

    def __init__(self, job: Any, restart: Callable[[Any, int], object]):
        super().__init__(job, restart, TurnedPanel(job.Label))
        self.form.opened.connect(messages.guarded(self._open_by))
        self.form.z_chosen.connect(messages.guarded(self._read_at))
        self._view: Any = None
        self._clicks: Any = None

    def _leave_result(self) -> None:
        if self._clicks is not None:
            self._view.removeEventCallback(CLICK, self._clicks)
            self._clicks = None
        super()._leave_result()

    def _show(self, result: Any) -> None:
        """Show all that is proven."""
        from CNCStepper.workbench.simulation.turned_scene import TurnedScene

        self._view = view_of(self._job.Document)
        if self._view is None:
            self._refuse(no_view())
            return
        self._result = result
        self._stage = Stage(self._job, self._view)
        self._scene = TurnedScene(self._view, result.work_origin_mm)
        self._player = Player(result.moves)
        self._loading = self._bit_by_bit(result, self._player, self._scene, self._stage)
        self._loader.start()

    def _bit_by_bit(self, result: TurnedResult, player: Player, scene: TurnedScene, stage: Stage) -> Iterator[None]:
        """Bring in path, panel and part, a few ms at a time, and stand at the end."""
        names = {int(tool.Number): f"T{tool.Number}  {tool.Label}" for tool in job_behind(self._job).Tools}
        used = set(result.moves.tool.tolist())
        tools = {number: name for number, name in names.items() if number in used} or names
        yield from self.form.load_turned(result, player, tools)
        self.form.program.chosen.connect(messages.guarded(self._go_to_line))
        self.form.findings.chosen.connect(messages.guarded(self._go_to_finding))
        yield
        scene.add_path(result.rapids, result.feeds)
        yield
        material = self._material = TurnedMaterial(player, scene, result, self._job.Label)
        material.read.connect(messages.guarded(self.form.show_reading))
        material.failed.connect(messages.guarded(self._show_material))
        material.mesh.connect(messages.guarded(self._keep_turned))
        material.shown.connect(messages.guarded(self._look_once))
        player.moved.connect(messages.guarded(self._follow))
        self._clicks = self._view.addEventCallback(CLICK, messages.guarded(self._clicked))
        player.stand_at_end()

    def _look_once(self) -> None:
        """Look at the part from the side when it is there for the first time."""
        self._material.shown.disconnect()
        if self._stage is not None:
            self._stage.look_from_the_side()

    def _follow(self) -> None:
        """Put the tool and the marked line where the player stands."""
        player, scene, result = self._player, self._scene, self._result
        if player is None or scene is None or result is None or not len(result.moves):
            return
        scene.show_tool(int(result.moves.tool[player.row]), player.tip_mm())
        self.form.program.follow(player.line)

    def _open_by(self, open_deg: float) -> None:
        if self._material is not None:
            self._material.open_by(open_deg)

    def _read_at(self, z_mm: float) -> None:
        if self._material is not None and self._scene is not None:
            self._scene.mark(z_mm)
            self._material.read_at(z_mm)

    def _clicked(self, event: dict[str, Any]) -> None:
        """Read the diameter where the part's plane is clicked."""
        if event["State"] != "DOWN" or event["Button"] != "BUTTON1" or self._result is None:
            return
        place = point_in_plane(self._view, event["Position"], self._result.work_origin_mm)
        if place is not None:
            self.form.show_z(place[2])
            self._read_at(place[2])

    def _go_to_finding(self, finding: Finding) -> None:
        """Let the tool stand, the program be marked and the diameter be read where something was found."""
        if finding.place.line:
            self._go_to_line(finding.place.line)
        if finding.place_mm is not None:
            self.form.show_z(finding.place_mm[2])
            self._read_at(finding.place_mm[2])

    def _want_mesh(self) -> None:
        if self._material is not None:
            self.form.set_keeping(True)
            self._material.want_mesh()

    def _keep_turned(self, time_s: float, stl: str) -> None:
        """Add the part of a moment to the document; it is seen when the simulation is closed."""
        self.form.set_keeping(False)
        if self._stage is not None:
            self._stage.hide(keep_mesh(self._job, stl, time_s, self._result.work_origin_mm))

    def _show_material(self, error: CNCStepperError) -> None:
        self.form.set_keeping(False)
        self.form.say(words_of(error))
