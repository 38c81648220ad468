# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of a job's clamps: solids of the document, taken from the selection."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workbench.document.clamps import outline_of
from CNCStepper.workbench.features.base import edit
from CNCStepper.workbench.panels.job_lists import ObjectList
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr


class ClampList(ObjectList):
    """The clamps, numbered as findings name them."""

    def __init__(self, job: Any, parent: Any):
        super().__init__(job, "clamps", parent)
        self.list.setToolTip(tr("Solids that the tool must not touch; findings name them by their number"))
        self.button("add", tr("Add selected"), tr("Take the solids that are selected for clamps"), self.add)
        self.button("remove", tr("Take out"), tr("The marked solid is no clamp any more; it stays"), self.remove)
        self.refresh()

    def objects(self) -> list[Any]:
        """Return the job's clamps."""
        return list(self.job.Clamps)

    def words(self, obj: Any) -> str:
        """Return a clamp's number and label."""
        return f"{self.objects().index(obj) + 1}  {obj.Label}"

    def picture(self, obj: Any) -> Any:
        """Return FreeCAD's own icon of the solid."""
        return obj.ViewObject.Icon

    def add(self) -> None:
        """Take the selected solids; what is none is named, and then nothing is taken."""
        import FreeCADGui

        chosen = [obj for obj in FreeCADGui.Selection.getSelection() if obj not in self.job.Clamps]
        self.say("" if chosen else tr("Select one or more solids first"))
        try:
            for obj in chosen:
                self._check(obj)
        except CNCStepperError as error:
            self.say(translated(error.what))
            return
        if chosen:
            edit(self.job, clamps=[*self.job.Clamps, *chosen])
            self._show(chosen[-1])

    def remove(self) -> None:
        """Take the marked solid out of the list."""
        clamp = self.chosen()
        if clamp is not None:
            self.say("")
            left = [other for other in self.job.Clamps if other is not clamp]
            edit(self.job, clamps=left)
            self._show(left[-1] if left else None)

    def _check(self, obj: Any) -> None:
        """Raise JobError for what cannot be a clamp."""
        from CNCStepper.errors import JobError

        if self.job in [obj, *obj.OutListRecursive]:
            raise JobError("clamp", Text("'{obj}' stands on this job and cannot be its clamp", obj=obj.Label))
        outline_of(obj)

    def _show(self, clamp: Any) -> None:
        self.refresh()
        self.choose(clamp)
        self.changed.emit()
