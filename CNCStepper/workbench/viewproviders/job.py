# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a job looks in the tree: with its tools, operations and preview below it, which go when it is deleted."""

from __future__ import annotations

from typing import Any

from CNCStepper.job.deferred_fitting import is_on_trial
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.services.messages import guarded, polled
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.viewproviders.base import Entry, ViewProvider
from CNCStepper.workbench.viewproviders.stock_display import SHAPED_BY, StockAndClamps
from CNCStepper.workbench.viewproviders.turned_stock_display import TURNED_BY, TurnedStock

STOCK = "Stock"  # the one way in which a job is drawn


def _prepare_proof() -> None:
    """Have a process loaded for the first proof; Qt is loaded with that, not with the tree."""
    from CNCStepper.workbench.proving import standby

    standby.prepare()


class ProgramJob(ViewProvider):
    """The view of a job of any machine; `figure` draws its stock and what holds it. DRAWN_FROM: by which properties."""

    DRAWN_FROM: frozenset[str] = frozenset()
    figure: Any = None  # FreeCAD tells of properties before it attaches the view of an opened document

    @polled
    def attach(self, view: Any) -> None:
        """Draw the stock, for a new view and when a document is opened; the job's first proof is prepared."""
        super().attach(view)
        self.figure = self.new_figure()
        view.addDisplayMode(self.figure.node, STOCK)
        self._draw()
        _prepare_proof()

    def new_figure(self) -> Any:
        """Return what draws the stock: it has a `node` and an `update` with the job."""
        raise NotImplementedError

    def getDisplayModes(self, view: Any) -> list[str]:
        """Return the one way to draw a job."""
        return [STOCK]

    def getDefaultDisplayMode(self) -> str:
        """Return the one way to draw a job."""
        return STOCK

    @polled
    def updateData(self, obj: Any, name: str) -> None:
        """Follow the stock too; FreeCAD calls this at every change of a property."""
        super().updateData(obj, name)
        if name in self.DRAWN_FROM and not is_on_trial():
            self._draw()

    def _draw(self) -> None:
        if self.figure is not None and set(self.obj.PropertiesList) >= self.DRAWN_FROM:
            self.figure.update(self.obj)

    @polled
    def claimChildren(self) -> list[Any]:
        """Return what stands below the job in the tree."""
        return [*self.obj.Tools, *self.obj.Operations, *previews(self.obj), *edited_programs(self.obj)]

    @polled
    def onChanged(self, view: Any, name: str) -> None:
        """Show and hide the preview with the job, except while a document is opened."""
        if name == "Visibility" and "Restore" not in view.Object.State:
            for preview in previews(view.Object):
                preview.ViewObject.Visibility = view.Visibility

    def replaceObject(self, old: Any, new: Any) -> bool:
        """Let FreeCAD replace nothing that belongs to the job; it would when something is dropped there with Alt."""
        return False

    def canDelete(self, obj: Any) -> bool:
        """Let what belongs to the job be deleted without a question about the job."""
        return True

    @guarded
    def onDelete(self, view: Any, parts: Any) -> bool:
        """Delete what belongs to this job alone, in the same undo step; drawings and edited programs stay."""
        from CNCStepper.workbench.document import macro_recorder

        may = super().onDelete(view, parts)
        own = [child for child in self.claimChildren() if child not in edited_programs(self.obj)]
        for child in [child for child in own if self.is_its_own(child)]:
            macro_recorder.note_deletion(child.Document, child.Name)
            child.Document.removeObject(child.Name)
        return may

    def is_its_own(self, child: Any) -> bool:
        """Return whether nothing of ours outside this job uses one of its children."""
        family = [self.obj, *self.claimChildren()]
        return all(other in family for other in child.InList if proxy_type(other))

    def entries(self) -> list[Entry]:
        """Return the entries of every object, what takes the program further, and what saves the job's set-up."""
        from CNCStepper.workbench.commands.job_files import SaveJobTemplate
        from CNCStepper.workbench.commands.program import EditProgram, Send, Simulate

        further = [entry_of(each) for each in (Simulate(), Send(), EditProgram())]
        return [*super().entries(), *further, self.saving(), entry_of(SaveJobTemplate())]

    def saving(self) -> Entry:
        """Return the entry that saves the program."""
        from CNCStepper.workbench.proving import prove_program

        return Entry(tr("Save program as…"), "CNCStepper_Preview", self.save_program, prove_program.why_not())

    def save_program(self) -> None:
        """Ask for a file and write the program into it."""
        from CNCStepper.workbench.proving.prove_program import save_as

        save_as(self.obj)


class Job(ProgramJob):
    """The view of a job on a table: the edges of its stock, and its clamps."""

    DRAWN_FROM = frozenset({*SHAPED_BY, "ClampOutlines"})

    def new_figure(self) -> StockAndClamps:
        """Return what draws stock and clamps."""
        return StockAndClamps()


class LatheJob(ProgramJob):
    """The view of a lathe's job: the half section of bar, chuck and tailstock in the XZ plane, and their circles."""

    DRAWN_FROM = TURNED_BY

    def new_figure(self) -> TurnedStock:
        """Return what draws bar, chuck and tailstock."""
        return TurnedStock()


def entry_of(command: Any) -> Entry:
    """Return the entry of a context menu that does what a command does."""
    return Entry(command.text(), command.name, command.run, command.why_not())


def previews(job: Any) -> list[Any]:
    """Return the previews of a job (one, unless a user deleted or copied it)."""
    return [other for other in job.InList if proxy_type(other) == "CNCStepper_Preview"]


def edited_programs(job: Any) -> list[Any]:
    """Return the programs that were edited from a job's own."""
    return [other for other in job.InList if proxy_type(other) == "CNCStepper_Program"]
