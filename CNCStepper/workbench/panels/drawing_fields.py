# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of the drawings that an operation follows: a list to check them in, a box where there is only one."""

from __future__ import annotations

from functools import partial
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.document.selection import Pair, Selected, selected_drawings
from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.panels.fields import NAME, WARNING_COLOUR, ChoiceField, Field, named_button, note_label
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.services.button_row import ButtonRow
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import later, tr

MOST_EDGES = 2000  # more are no drawing that a list should look through
FEWEST_ROWS, MOST_ROWS = 2, 7  # of the list that are seen at once
MOST_SAID = 5  # reasons that are read at once; the others are in the tooltip
SPARE_PX = 4
CHECKED, UNCHECKED = QtCore.Qt.CheckState.Checked, QtCore.Qt.CheckState.Unchecked


def follows(operation: Any, drawing: Any) -> bool:
    """Return whether an operation can follow a drawing: lines that lie flat, of which each kind wants its own."""
    if not _is_drawing(drawing) or operation in drawing.OutListRecursive:
        return False
    try:
        operation.Proxy.look(drawing, ())
    except CNCStepperError:
        return False
    return True


def _is_drawing(obj: Any) -> bool:
    """Return whether an object holds lines or points and no solid; datum planes, axes and origins are none."""
    if not obj.isDerivedFrom("Part::Feature") or obj.isDerivedFrom("Part::Datum"):
        return False
    shape = obj.Shape
    if shape.isNull():
        return bool(obj.isDerivedFrom("Sketcher::SketchObject"))
    return not shape.Solids and bool(shape.Vertexes) and len(shape.Edges) <= MOST_EDGES


def words_of_drawing(pair: Pair) -> str:
    """Return how a drawing is listed: its label, and the faces and edges of it that count."""
    drawing, names = pair
    return f"{drawing.Label}: {', '.join(names)}" if names else str(drawing.Label)


class _Taking(Field):
    """The base of both fields: buttons that use the selection, and the reason when it is refused."""

    BELOW_LABEL = True  # beside it the buttons are too wide for FreeCAD's dock in its dark theme

    def add_buttons(self, buttons: tuple[tuple[str, str, str], ...]) -> None:
        """Add buttons, each by its name, text and tooltip, and the note below them."""
        row = ButtonRow(self.widget)
        for name, text, tip in buttons:
            act = partial(self.take, name == "add")
            row.add(named_button(f"{NAME}_{self.entry.key}_{name}", text, tip, act, row))
        self._column.addWidget(row)
        self.unused = note_label(f"{NAME}_{self.entry.key}_unused", WARNING_COLOUR, self.widget)
        self._column.addWidget(self.unused)
        self.say_unused(self.obj.Proxy.unused)

    def take(self, more: bool = False) -> None:
        """Follow the selected drawings, alone or with those already followed; refusals are shown."""
        own = [self.obj, *self.obj.InListRecursive]
        pairs = [pair for pair in targets.drawings(self.obj.Proxy.PICKS_LINES) if pair[0] not in own]
        if not pairs:
            self.mark(tr("Select a drawing in the tree or in the 3D view first"))
            return
        held = list(value_of(self.obj, self.entry)) if more else []
        found = selected_drawings(type(self.obj.Proxy), [*(pair for pair in held if pair not in pairs), *pairs])
        try:
            found.require()
        except CNCStepperError as error:
            self.mark(translated(error.sentence))
            return
        self.put(found)
        self.say_unused(found.refusals)
        self.touched()

    def put(self, found: Selected) -> None:
        """Show what is to be followed."""
        raise NotImplementedError

    def say_unused(self, refusals: tuple[CNCStepperError, ...]) -> None:
        """Say why what was selected is not used."""
        said = [tr("Not used: {0}").format(translated(error.sentence)) for error in refusals]
        more = [tr("and {0} more").format(len(said) - MOST_SAID)] if len(said) > MOST_SAID else []
        self.unused.setText("\n".join(said[:MOST_SAID] + more))
        self.unused.setToolTip("\n".join(said))
        self.unused.setVisible(bool(said))


class DrawingField(_Taking, ChoiceField):
    """The one drawing that gives an operation its shape, or none: its numbers then count."""

    def make(self) -> list[Any]:
        """Add the box and, below it, the button that takes the selection."""
        (box,) = super().make()
        tip = tr("Follow the drawing that is selected in the tree or in the 3D view")
        self.add_buttons((("take", tr("Take selected"), tip),))
        return [box]

    def choices(self) -> list[tuple[Any, str]]:
        """Return no drawing, and all that the document has for this operation."""
        drawings = [other for other in self.obj.Document.Objects if follows(self.obj, other)]
        return [((), tr(self.obj.Proxy.NO_DRAWING)), *((((drawing, ()),), drawing.Label) for drawing in drawings)]

    def put(self, found: Selected) -> None:
        """Choose the drawing that was found."""
        self._offer(found.used)
        self.editors[0].setCurrentIndex(self.values.index(found.used))

    def write(self) -> None:
        """Show the operation's drawing, whether it can be followed or not."""
        self._offer(value_of(self.obj, self.entry))
        super().write()
        if self.obj.DeletedDrawing:
            self.editors[0].setCurrentIndex(-1)

    def differs(self, value: Any) -> bool:
        """Return whether it changes; to choose none after a deletion is a change, for it lets the numbers count."""
        return bool(self.obj.DeletedDrawing) or super().differs(value)

    def _offer(self, pairs: tuple[Pair, ...]) -> None:
        if pairs not in self.values:
            self.values.append(pairs)
            self.editors[0].addItem("; ".join(map(words_of_drawing, pairs)))


class DrawingsField(_Taking):
    """All drawings that the operation follows, checked, and those that it could follow. NO_DRAWING: none is checked."""

    NO_DRAWING = ""  # the operation's own

    def make(self) -> list[Any]:
        """Add the list, what it means that nothing is checked, and the buttons that take the selection."""
        self.rows: list[Pair] = []
        drawings = self.add(QtGui.QListWidget(self.widget))
        drawings.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        drawings.setTextElideMode(QtCore.Qt.TextElideMode.ElideMiddle)
        drawings.itemChanged.connect(lambda _: self.checked())
        self.none = QtGui.QLabel(tr(self.NO_DRAWING or self.obj.Proxy.NO_DRAWING), self.widget)
        self.none.setObjectName(f"{NAME}_{self.entry.key}_none")
        self._column.addWidget(self.none)
        self.add_buttons(
            (
                (
                    "take",
                    tr("Take selected"),
                    tr("Follow only the selected lines"),
                ),
                ("add", tr("Add selection"), tr("Also follow the selected lines")),
            )
        )
        return [drawings]

    def checked(self) -> None:
        """Note that a person has checked or unchecked a drawing."""
        self.say_unused(())
        self.none.setVisible(not self._chosen())
        self.touched()

    def read(self) -> tuple[Pair, ...]:
        """Return the checked drawings; raises Refused while a deleted one is checked."""
        chosen = self._chosen()
        if any(drawing is None for drawing, _ in chosen):
            raise Refused(later("A deleted drawing is checked: uncheck it to go on without it"))
        return tuple(chosen)

    def differs(self, value: Any) -> bool:
        """Return whether it changes; to go on without a deleted drawing is a change."""
        return bool(self.obj.DeletedDrawing) or super().differs(value)

    def put(self, found: Selected) -> None:
        """Check what was found."""
        self._fill(list(found.used), "")

    def write(self) -> None:
        """Show the operation's drawings, whether they can be followed or not, and what else could be."""
        self._fill(list(value_of(self.obj, self.entry)), self.obj.DeletedDrawing)

    def _fill(self, followed: list[Pair], deleted: str) -> None:
        held = [drawing for drawing, _ in followed]
        others = [other for other in self.obj.Document.Objects if other not in held and follows(self.obj, other)]
        self.rows = [*followed, *((None, ()) for _ in [deleted] if deleted), *((other, ()) for other in others)]
        drawings = self.widget.findChild(QtGui.QListWidget)
        drawings.blockSignals(True)
        drawings.clear()
        for pair in self.rows:
            is_checked = pair in followed or pair[0] is None
            drawings.addItem(self._row(pair, is_checked, deleted))
        drawings.blockSignals(False)
        row_px = max(drawings.sizeHintForRow(0), drawings.fontMetrics().height() + SPARE_PX)
        rows = min(max(drawings.count(), FEWEST_ROWS), MOST_ROWS)
        drawings.setFixedHeight(rows * row_px + 2 * drawings.frameWidth() + SPARE_PX)
        self.none.setVisible(not self._chosen())

    def _row(self, pair: Pair, is_checked: bool, deleted: str) -> Any:
        text = tr("{0} (deleted)").format(deleted) if pair[0] is None else words_of_drawing(pair)
        item = QtGui.QListWidgetItem(text)
        if pair[0] is not None:
            item.setIcon(pair[0].ViewObject.Icon)
        item.setToolTip(text)
        item.setFlags(item.flags() | QtCore.Qt.ItemFlag.ItemIsUserCheckable)
        item.setCheckState(CHECKED if is_checked else UNCHECKED)
        return item

    def _chosen(self) -> list[Pair]:
        drawings = self.widget.findChild(QtGui.QListWidget)
        return [pair for number, pair in enumerate(self.rows) if drawings.item(number).checkState() == CHECKED]


class MarksField(DrawingsField):
    """The drawings that the operation marks; one that was deleted is told in the list of those that it follows."""

    NO_DRAWING = later("nothing is marked")

    def add_buttons(self, buttons: tuple[tuple[str, str, str], ...]) -> None:
        """Add the buttons; why something cannot be followed is told of the other list."""
        super().add_buttons(buttons)
        self.say_unused(())

    def differs(self, value: Any) -> bool:
        """Return whether it changes."""
        return Field.differs(self, value)

    def write(self) -> None:
        """Show the drawings that are marked, and what else could be."""
        self._fill(list(value_of(self.obj, self.entry)), "")
