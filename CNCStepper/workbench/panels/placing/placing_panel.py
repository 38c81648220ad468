# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels of a nest and of an arrangement share: the table, the mouse in the 3D view, and its buttons.

table, values ──► work beside the window ──► ManualNest ──► PlaceMode: dragged, turned ──► counts, overlap at once
                                                 └── OK ──► written and judged as a whole
"""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.errors import JobError
from CNCStepper.job.nesting import nest_data
from CNCStepper.nesting.manual_nesting import ManualNest
from CNCStepper.workbench.panels.background_panel import BackgroundPanel, button_row
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, NAME, WorkNote, note_label
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.placing.place_mode import PlaceMode
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr


class PlacingPanel(BackgroundPanel):
    """nest: what is placed, None until the process has told the outlines. unwritten: whether the files differ."""

    BETWEEN_MM = 50.0  # between two sheets in the view

    def __init__(self, obj: Any, editor: Editor, note: WorkNote, is_new: bool):
        super().__init__(obj, editor, note, is_new)
        self.nest: ManualNest | None = None
        self.mode: PlaceMode | None = None
        self.unwritten = False
        self.why = note_label(f"{NAME}_why_not", ERROR_COLOUR, editor)
        self.chosen_label = QtGui.QLabel(editor)
        self.chosen_label.setObjectName(f"{NAME}_chosen")
        self.chosen_label.setWordWrap(True)
        self._hidden: list[Any] = []  # what the nodes are seen in place of

    def hand_buttons(self) -> list[Any]:
        """Return the rows of buttons for the chosen part, and the one that fills."""
        first = (
            ("turn_part", tr("Turn"), tr("Turn the chosen part to its next rotation"), self.turn),
            ("lock_part", tr("Lock"), tr("A locked part stays where it is; press again to unlock it"), self.lock),
        )
        second = (
            ("fill", tr("Fill"), tr("Fill the sheet of the chosen one, or the first, with the marked row"), self.fill),
            ("remove_part", tr("Take away"), tr("Take the chosen part from its sheet"), self.remove),
        )
        return [button_row(first, self.editor), button_row(second, self.editor)]

    def fill(self) -> None:
        """Fill a sheet with more of one row of the table."""
        raise NotImplementedError

    def show_nest(self, answer: dict[str, Any]) -> None:
        """Show the parts of an answer on their sheets in the 3D view of the document, ready for the mouse."""
        items, sheets, spacing = nest_data.unpacked_order(answer["order"])
        self.leave_mode()
        self.nest = ManualNest(items, sheets, spacing, nest_data.parts_of(answer["parts"]))
        view = _view_of(self.document)
        if view is not None:
            self._hide_drawings()
            calls = (self.on_changed, self.say_why)
            self.mode = PlaceMode(view, self.obj.Document, self.nest, self.BETWEEN_MM, *calls, answer["faults"])
            self.mode.begin()
        self.show_state()

    def leave_mode(self) -> None:
        """Give the mouse back, and show the drawings again."""
        if self.mode is not None:
            self.mode.leave()
            self.mode = None
        hidden, self._hidden = self._hidden, []
        for name in hidden:
            each = self._document() and self._document().getObject(name)
            if each is not None:
                each.ViewObject.Visibility = True

    def on_changed(self) -> None:
        """Show what a person has done with the mouse."""
        if self.nest is not None and self.rows() != self.rows_written():
            self.unwritten = True
        self.show_state()

    def rows(self) -> list[list[Any]]:
        """Return the parts as plain data."""
        raise NotImplementedError

    def rows_written(self) -> list[list[Any]]:
        """Return the parts as the object has them."""
        raise NotImplementedError

    def show_state(self) -> None:
        """Show counts, and the chosen part."""
        number = self.mode.chosen if self.mode is not None else None
        text = tr("Drag parts in the view; with Shift they turn") if self.nest is not None else ""
        if number is not None and self.nest is not None:
            place = self.nest.parts[number].placement
            name = self.nest.items[place.item].name
            text = tr("{0}: X {1}, Y {2}, {3}°").format(
                name, f"{place.x_mm:.2f}", f"{place.y_mm:.2f}", f"{place.rotation_deg:g}"
            )
            if self.nest.parts[number].locked:
                text += ", " + tr("locked")
        self.chosen_label.setText(text)
        self.show_counts()

    def show_counts(self) -> None:
        """Show how many of each lie on the sheets."""
        raise NotImplementedError

    def say_why(self, sentence: str) -> None:
        """Say why a part may not lie where it is dragged."""
        self.why.setText(sentence)
        self.why.setVisible(bool(sentence))

    def turn(self) -> None:
        """Turn the chosen part to its next rotation."""
        mode, number = self._chosen()
        mode.put(mode.nest.turned_by(number, mode.nest.next_rotation_deg(number)))

    def lock(self) -> None:
        """Lock the chosen part, or unlock it."""
        mode, number = self._chosen()
        mode.nest.lock(number, not mode.nest.parts[number].locked)
        mode.choose(number)

    def remove(self) -> None:
        """Take the chosen part away."""
        self._chosen()[0].remove()

    def _chosen(self) -> tuple[PlaceMode, int]:
        """Return the mouse's mode and the chosen part; raises JobError where none is."""
        if self.mode is None or self.mode.chosen is None:
            raise JobError("nest-chosen", "no part is chosen", advice="press on one in the 3D view")
        return self.mode, self.mode.chosen

    @guarded
    def reject(self) -> bool:
        """Leave the document as it was before."""
        self.leave_mode()
        return bool(super().reject())

    def _close(self) -> None:
        self.leave_mode()
        super()._close()

    def _hide_drawings(self) -> None:
        """Hide the drawings of the sheets while their parts may be moved."""
        for drawing in getattr(self.obj, "Group", ()):
            for each in getattr(drawing, "Group", ()):
                if each.ViewObject is not None and each.ViewObject.Visibility:
                    each.ViewObject.Visibility = False
                    self._hidden.append(each.Name)


def _view_of(document: str) -> Any:
    """Return the active 3D view of a document, None where another view is in front."""
    import FreeCADGui

    view = FreeCADGui.getDocument(document).activeView()
    return view if hasattr(view, "graphicsView") else None
