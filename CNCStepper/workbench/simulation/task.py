# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task of a simulation: it proves the job's program, shows panel and scene, and leaves nothing behind.

The part is shown as soon as it is cut, the rest when all is proven; without a proof the part goes away again.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from itertools import chain
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.workbench.document.undo_steps import undo_step
from CNCStepper.workbench.panels.view_task_panel import ViewTask
from CNCStepper.workbench.proving import latest_proof
from CNCStepper.workbench.proving.proof_process import ProofResult, ProofRun
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.number_format import clock_text
from CNCStepper.workbench.services.object_observers import ProgramObserver
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.simulation.panel import SimulationPanel
from CNCStepper.workbench.simulation.player import Player
from CNCStepper.workbench.simulation.stock_update import Material
from CNCStepper.workbench.simulation.view_menu import FRAME
from CNCStepper.workbench.simulation.view_session import Stage, view_of

if TYPE_CHECKING:
    from CNCStepper.errors import CNCStepperError
    from CNCStepper.job.proof_folder import Part
    from CNCStepper.simulation.finding import Finding
    from CNCStepper.workbench.services.remedy_bar import Remedy
    from CNCStepper.workbench.simulation.scene import Scene

LOADS_S = 0.02  # of nodes at a time, and up to one bit more


class SimulationTask(ViewTask):
    """The object for FreeCAD's task panel; `form` is its widget. An edit of the program is shown at once."""

    def __init__(self, job: Any, restart: Callable[[Any, int], object], panel: SimulationPanel | None = None):
        self.form: Any = panel or SimulationPanel(job.Label)
        self.form.again.connect(messages.guarded(self.begin))
        self.form.path_shown.connect(messages.guarded(self._show_path))
        self.form.view_chosen.connect(messages.guarded(self._look))
        self.form.keep.connect(messages.guarded(self._want_mesh))
        self.form.restart.connect(messages.guarded(self._restart))
        self.form.destroyed.connect(self._leave)  # however FreeCAD closes the panel
        self._job, self._open_restart = job, restart
        self._document_name = job.Document.Name
        self._watch = ProgramObserver(job, self._changed, self._deleted, self._document_closing)
        self._run: ProofRun | None = None
        self._result: Any = None
        self._player: Player | None = None
        self._scene: Any = None
        self._material: Any = None
        self._stage: Stage | None = None
        self._has_left = False
        self._loading: Iterator[None] = iter(())
        self._loader = QtCore.QTimer()
        self._loader.setInterval(0)
        self._loader.timeout.connect(messages.guarded(self._load_on))

    # ---- the life of a simulation ----

    def begin(self) -> None:
        """Prove the program as it now stands in the document."""
        self._leave_result()
        self.form.clear()
        self._run = ProofRun(self._job, begins=latest_proof.start_here())
        self._run.progress.connect(self._show_stage)
        self._run.part.connect(messages.guarded(self._show_part))
        self._run.finished.connect(messages.guarded(self._show))
        self._run.failed.connect(messages.guarded(self._refuse))
        self.form.say(tr("Looking for a Python…"), busy=True)
        self._run.start()

    def end(self) -> None:
        """Leave nothing behind: no process, no timer, no node, nothing hidden."""
        self._leave()
        self.form.clear()

    def _leave(self, *_: Any) -> None:
        """Do so without the panel, which may be gone; Qt keeps this object with the timer that calls it."""
        if self._has_left:
            return
        self._has_left = True
        self._watch.end()
        self._leave_result()
        self._loader.deleteLater()

    def _leave_result(self) -> None:
        self._loader.stop()
        self._loading = iter(())
        if self._run is not None:
            self._run.cancel()
            self._run.deleteLater()
            self._run = None
        if self._material is not None:
            self._material.end()
            self._material.deleteLater()
            self._material = None
        if self._player is not None:
            self._player.pause()
            self._player.deleteLater()
            self._player = None
        if self._scene is not None:
            self._scene.remove()
            self._scene = None
        if self._stage is not None:
            self._stage.restore()
            self._stage = None
        self._result = None

    def _show_stage(self, text: str) -> None:
        self.form.say(text, busy=True)

    def _refuse(self, error: CNCStepperError) -> None:
        """Say why there is nothing to show, take away what was shown of it, and offer to try again."""
        self._leave_result()
        self.form.say(words_of(error), again=True)

    def _show_part(self, part: Part, work_origin_mm: tuple[float, float, float]) -> None:
        """Show stock and part; a document without a 3D view shows nothing yet."""
        from CNCStepper.workbench.simulation.scene import Scene

        view = view_of(self._job.Document)
        if view is None:
            return
        self._stage = Stage(self._job, view)
        self._scene = Scene(view, part, work_origin_mm)
        self._loading = self._part_bit_by_bit(self._scene, self._stage)
        self._loader.start()

    def _part_bit_by_bit(self, scene: Scene, stage: Stage) -> Iterator[None]:
        """Bring in the part, a few ms at a time, and look at it: run it on from a timer until it ends."""
        yield
        yield from scene.load_part()
        stage.look()

    def _show(self, result: Any) -> None:
        """Show all that is proven; the part is mostly there already."""
        if self._scene is None:
            self._show_part(result.part, result.work_origin_mm)
        if self._scene is None:
            self._refuse(no_view())
            return
        self._result = result
        self._player = Player(result.moves)
        self._loading = chain(self._loading, self._rest_bit_by_bit(result, self._player, self._scene))
        self._loader.start()

    def _rest_bit_by_bit(self, result: ProofResult, player: Player, scene: Scene) -> Iterator[None]:
        """Bring in path, tools and panel likewise, and stand at the end."""
        remedies = self._remedies(result)
        yield
        yield from self.form.load_result(result, player, scene.height_range_mm, remedies)
        self.form.program.chosen.connect(messages.guarded(self._go_to_line))
        self.form.findings.chosen.connect(messages.guarded(self._go_to_finding))
        yield
        yield from scene.load_result(result)
        self._material = Material(player, scene, result)
        self._material.moments.failed.connect(messages.guarded(self._show_material))
        self._material.moments.mesh.connect(messages.guarded(self._keep_mesh))
        player.moved.connect(messages.guarded(self._follow))
        player.stand_at_end()

    def _remedies(self, result: ProofResult) -> list[Remedy | None]:
        """Return what mends each finding; a program that has changed since is left to the next proof."""
        from CNCStepper.workbench.simulation.finding_remedies import of_proof

        return of_proof(self._job, result, self._prove_soon)

    def _prove_soon(self) -> None:
        """Prove anew, when the button that asks for it has been left."""
        QtCore.QTimer.singleShot(0, messages.guarded(lambda: None if self._has_left else self.begin()))

    def _load_on(self) -> None:
        """Bring more in: some ms at a time, for the window is drawn after each, which may take longer."""
        until_s = time.monotonic() + LOADS_S
        while next(self._loading, self) is None:
            if time.monotonic() > until_s:
                return
        self._loader.stop()

    def _follow(self) -> None:
        """Put the tool, what has fallen and the marked line where the player stands."""
        player, scene, result = self._player, self._scene, self._result
        if player is None or scene is None or result is None or not len(result.moves):
            return
        scene.show_fallen(player.time_s)
        scene.show_tool(int(result.moves.tool[player.row]), player.tip_mm())
        self.form.program.follow(player.line)

    def _show_material(self, error: CNCStepperError) -> None:
        """Say why the material does not follow; the tool does."""
        self.form.set_keeping(False)
        self.form.say(words_of(error))

    def _want_mesh(self) -> None:
        if self._material is not None and self._player is not None:
            self.form.set_keeping(True)
            self._material.moments.want_mesh(self._player.time_s)

    def _keep_mesh(self, time_s: float, stl: str) -> None:
        """Add the part of a moment to the document; it is seen when the simulation is closed."""
        if self._material is None or self._stage is None:
            return
        self.form.set_keeping(False)
        self._material.moments.go_on()
        self._stage.hide(keep_mesh(self._job, stl, time_s, self._result.work_origin_mm))

    def _restart(self) -> None:
        """Leave the simulation, and choose the restart from the line under way."""
        if self._player is not None:
            program, line = self._job, self._player.line
            self.reject()
            self._open_restart(program, line)

    def _show_path(self, shown: bool) -> None:
        if self._scene is not None:
            self._scene.show_path(shown)

    def _look(self, name: str) -> None:
        """Look as the view's menu says; a frame is dragged by FreeCAD's own command."""
        if name == FRAME:
            import FreeCADGui

            FreeCADGui.runCommand("Std_ViewBoxZoom")
        elif self._stage is not None:
            self._stage.look(name)

    def _go_to_line(self, line: int) -> None:
        """Let the tool stand where a line has taken it."""
        if self._player is not None:
            self._player.pause()
            self._player.go_to_line(line)
            self.form.program.follow(line)

    def _go_to_finding(self, finding: Finding) -> None:
        """Let the tool stand, the program be marked and the marker point where something was found."""
        import numpy as np

        if self._scene is None or self._player is None:
            return
        if finding.place.line:
            self._go_to_line(finding.place.line)
        if finding.place_mm is not None:
            self._scene.mark(np.array(finding.place_mm))
        else:
            self._scene.mark(self._player.tip_mm() if finding.place.line else None)

    # ---- what happens to the job meanwhile ----

    def _changed(self) -> None:
        if self._result is not None:
            self.form.findings.withdraw_remedies()
            self.form.say(tr("The program has changed since: the view shows the earlier one."), again=True)

    def _deleted(self) -> None:
        QtCore.QTimer.singleShot(0, messages.guarded(self.reject))

    def _document_closing(self, name: str) -> None:
        if name == self._document_name:
            self._deleted()


def words_of(error: CNCStepperError) -> str:
    """Return an error's sentence and what to do."""
    return "\n".join(part for part in (messages.sentence(error), translated(error.advice)) if part)


def no_view() -> CNCStepperError:
    """Return the refusal of a document without a 3D view."""
    from CNCStepper.errors import JobError

    return JobError("view-missing", tr("this document has no 3D view"), advice=tr("open one and simulate again"))


def keep_mesh(job: Any, stl: str, time_s: float, origin_mm: tuple[float, float, float]) -> Any:
    """Add a mesh from a file in work coordinates to a job's document, at the job's work zero, in one undo step."""
    import FreeCAD
    import Mesh

    with undo_step(job.Document, tr("Keep the cut part as mesh")):
        obj = job.Document.addObject("Mesh::Feature", "CutPart")
        obj.Label = tr("{0}, cut until {1}").format(job.Label, clock_text(time_s))
        obj.Mesh = Mesh.Mesh(stl)
        obj.Placement = FreeCAD.Placement(FreeCAD.Vector(*origin_mm), FreeCAD.Rotation())
    return obj
