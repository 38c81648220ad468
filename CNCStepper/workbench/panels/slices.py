# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a stack of sheets: solid, sheets, *Slice*, and what was made."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper import text_json
from CNCStepper.workbench.document.slice_files import Slicing
from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.features.drawings.made_files import is_stale
from CNCStepper.workbench.features.drawings.slices import MADE, is_solid
from CNCStepper.workbench.panels.background_panel import BackgroundPanel, button_row
from CNCStepper.workbench.panels.fields import NAME, WARNING_COLOUR, ChoiceField, WorkNote, note_label
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr


class SolidField(ChoiceField):
    """One of the bodies and meshes of the document."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return those that no other body is made of, and the one that is chosen."""
        chosen = value_of(self.obj, self.entry)
        found = [each for each in self.obj.Document.Objects if is_solid(each) and not _is_used(each)]
        others = [] if chosen is None or chosen in found else [chosen]
        return [(each, each.Label) for each in (*found, *others)]


def _is_used(solid: Any) -> bool:
    """Return whether another solid is made of this one."""
    return any(is_solid(user) for user in solid.InList)


class SlicesPanel(BackgroundPanel):
    """Edits a stack of sheets; what is made while it is open belongs to its one undo step."""

    def __init__(self, obj: Any, editor: Editor):
        super().__init__(obj, editor, WorkNote(f"{NAME}_slicing", editor), not obj.MadeOf)
        self.summary = QtGui.QLabel(editor)
        self.summary.setObjectName(f"{NAME}_slices_report")
        self.summary.setWordWrap(True)
        self.warnings = note_label(f"{NAME}_slices_warnings", WARNING_COLOUR, editor)
        texts = (("slice", tr("Slice"), tr("Cut the solid into sheets and nest their pieces"), self.slice),)
        for widget in (self.note, self.summary, self.warnings, button_row(texts, editor)):
            editor.form.add_widget(MADE, widget)
        self.refresh_report()

    def slice(self) -> None:
        """Make the sheets of the values that stand here."""
        self.editor.apply()
        if not self.editor.refused:
            slicing = Slicing(self.obj, guarded(self.done), guarded(self.failed), self._share)
            self.begin(slicing, tr("Slicing…"))

    def accept(self) -> bool:
        """Keep all as one undo step; what was never sliced, or changed since, is sliced first."""
        self.editor.apply()
        if self.work is None and not self.editor.refused and is_stale(self.obj):
            self.slice()
        return super().accept()

    def refresh_report(self) -> None:
        """Show what was made."""
        told = text_json.loads(self.obj.Report) if self.obj.Report else None
        self.summary.setText(_summary(told) if told else "")
        self.summary.setVisible(bool(told))
        rows = [translated(each) for each in (*told["unplaced"], *told["notes"])] if told else []
        self.warnings.setText("\n".join(rows))
        self.warnings.setVisible(bool(rows))

    def _share(self, share: float) -> None:
        self.note.say(tr("Nesting the pieces: {0} %").format(f"{100 * share:.0f}"))


def _summary(told: dict[str, Any]) -> str:
    return tr("{0} slices, {1} pieces on {2} sheets of material; volume {3} % of the solid").format(
        told["slices"], told["pieces"], len(told["sheets"]), f"{100 * (1 + told['volume_share']):.1f}"
    )
