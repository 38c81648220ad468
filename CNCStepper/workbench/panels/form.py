# SPDX-License-Identifier: LGPL-2.1-or-later
"""A form made from an object's table of properties: one box a group, rarely used ones folded, results below."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.features.base import INTEGER, NUMBERS, Property, value_of
from CNCStepper.workbench.panels.fields import GAP_PX, NAME, Field, field_class
from CNCStepper.workbench.panels.unit_values import text_of
from CNCStepper.workbench.services.remedy_bar import Remedy
from CNCStepper.workbench.services.translation import tr

MOST_BESIDE_LABEL = 1  # of the lines of a field: more of them are too wide there in a narrow dock of a dark theme
LABEL_LETTERS = 14  # longer labels take a second line: Portuguese is longer, and the values need room
MARGINS = (6, 5, 6, 5)


class Box(QtGui.QWidget):
    """A titled group whose body can be folded away."""

    def __init__(self, title: str, name: str, folded: bool, parent: Any):
        super().__init__(parent)
        self.head = QtGui.QToolButton(self)
        self.head.setObjectName(f"{NAME}_group_{name}")
        self.head.setText(title)
        self.head.setToolButtonStyle(QtCore.Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.head.setAutoRaise(True)
        self.head.setStyleSheet("QToolButton { font-weight: bold; border: none; padding: 2px; }")
        self.head.clicked.connect(lambda _: self.fold(self.head.arrowType() == QtCore.Qt.ArrowType.DownArrow))
        self.body = QtGui.QFrame(self)
        self.body.setFrameShape(QtGui.QFrame.Shape.StyledPanel)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(1)
        column.addWidget(self.head)
        column.addWidget(self.body)
        self._fill: Callable[[], Any] | None = None
        self.fold(folded)

    def fill_when_opened(self, fill: Callable[[], Any]) -> None:
        """Call `fill` before the body is seen for the first time: what few people open is made when they do."""
        self._fill = fill

    def fold(self, folded: bool) -> None:
        """Hide or show the body."""
        if self._fill is not None and not folded:
            fill, self._fill = self._fill, None
            fill()
        self.body.setVisible(not folded)
        arrow = QtCore.Qt.ArrowType
        self.head.setArrowType(arrow.RightArrow if folded else arrow.DownArrow)


class Form(QtGui.QWidget):
    """The fields of one object; `changed` is sent after an edit of one of them by the user."""

    changed = QtCore.Signal()

    def __init__(
        self, obj: Any, kinds: dict[str, type[Field]], folded: tuple[str, ...], hidden: tuple[str, ...], parent: Any
    ):
        """kinds: the class of field for single keys. folded: groups. hidden: keys that have no field here."""
        super().__init__(parent)
        self.obj = obj
        self.fields: dict[str, Field] = {}
        self.results: dict[str, Any] = {}
        self.boxes: dict[str, Box] = {}
        self._always: set[str] = set()  # groups that have more than fields
        self._column = QtGui.QVBoxLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        for entry in obj.Proxy.PROPERTIES:
            if entry.key in hidden:
                continue
            if not entry.output:
                self._add_field(entry, kinds.get(entry.key, field_class(entry)), entry.group in folded)
            elif entry.type in (*NUMBERS, INTEGER):
                self._add_result(entry)
        align_labels(list(map(_layout, self.boxes.values())))

    def focus_first(self) -> None:
        """Focus the first editable line and select it, so that typing replaces its text."""
        for field in self.fields.values():
            line = field.editors[0]
            if isinstance(line, QtGui.QLineEdit) and line.isEnabled() and line.isVisible():
                field.focus()
                line.selectAll()
                return

    def field_order(self) -> list[Field]:
        """Return the fields from top to bottom."""
        return list(self.fields.values())

    def refresh(self) -> None:
        """Show the object's values and results."""
        for field in self.fields.values():
            field.refresh()
            if field.asks():
                self._unfold(field)
        self._hide_empty_boxes()
        for key, label in self.results.items():
            entry = next(entry for entry in self.obj.Proxy.PROPERTIES if entry.key == key)
            label.setText(text_of(value_of(self.obj, entry), entry))

    def _hide_empty_boxes(self) -> None:
        """Let a group be seen only while one of its fields counts; what else stands in it is seen with them."""
        for title, box in self.boxes.items():
            counting = [field.counts() for field in self.fields.values() if field.entry.group == title]
            if counting and not (title in self._always or box.isHidden() == (not any(counting))):
                box.setVisible(any(counting))

    def mark(self, key: str, sentence: str, remedies: Sequence[Remedy] = ()) -> None:
        """Say below a field what is wrong, with the remedies as buttons; its group is opened."""
        self.fields[key].mark(sentence, remedies)
        self._unfold(self.fields[key])

    def _unfold(self, field: Field) -> None:
        box = self.boxes[field.entry.group]
        if box.body.isHidden():
            box.fold(False)

    def unmark(self) -> None:
        """Take all marks back."""
        for field in self.fields.values():
            if field.said:
                field.mark("")

    def box(self, title: str, folded: bool = False) -> Box:
        """Return the box of a group, made at the first asking."""
        if title not in self.boxes:
            box = Box(tr(title), title.split()[0].lower(), folded, self)
            layout = QtGui.QFormLayout(box.body)
            layout.setContentsMargins(*MARGINS)
            layout.setVerticalSpacing(0)  # a field brings its own, so that those that are not seen take no room
            layout.setFieldGrowthPolicy(QtGui.QFormLayout.FieldGrowthPolicy.ExpandingFieldsGrow)
            layout.setLabelAlignment(QtCore.Qt.AlignmentFlag.AlignLeft | QtCore.Qt.AlignmentFlag.AlignVCenter)
            self.boxes[title] = box
            self._column.addWidget(box)
        return self.boxes[title]

    def add_widget(self, title: str, widget: Any) -> None:
        """Add a widget as wide as the form to a group."""
        _layout(self.box(title)).addRow(widget)

    def _add_field(self, entry: Property, kind: type[Field], folded: bool) -> None:
        field = kind(self.obj, entry, self)
        field.changed.connect(self.changed)
        self.fields[entry.key] = field
        layout = _layout(self.box(entry.group, folded))
        if field.BELOW_LABEL or len(field.editors) > MOST_BESIDE_LABEL:
            layout.addRow(field.label)
            layout.addRow(field.widget)
        else:
            layout.addRow(field.label, field.widget)

    def add_result(self, group: str, key: str, label: str, tip: str) -> Any:
        """Add a line that shows a text to a group; label, tip: in the user's language."""
        value = QtGui.QLabel(self)
        value.setObjectName(f"{NAME}_{key}")
        value.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        name = QtGui.QLabel(label, self)
        for widget in (name, value):
            widget.setToolTip(tip)
        value.setContentsMargins(0, GAP_PX, 0, GAP_PX)
        self._always.add(group)
        _layout(self.box(group)).addRow(name, value)
        return value

    def _add_result(self, entry: Property) -> None:
        self.results[entry.key] = self.add_result(entry.group, entry.key, tr(entry.label), tr(entry.text))


def align_labels(layouts: list[Any]) -> None:
    """Make the label columns of several form layouts equally wide, so that their fields are aligned."""
    labels = [label for layout in layouts for label in _labels_of(layout)]
    natural = max((label.sizeHint().width() for label in labels), default=0)
    for label in labels:
        widest = label.fontMetrics().averageCharWidth() * LABEL_LETTERS
        label.setWordWrap(natural > widest)
        label.setFixedWidth(min(natural, widest))


def _labels_of(layout: Any) -> list[Any]:
    """Return the labels beside fields.

    Not by the layout's items: these are no QObjects, and PySide2 may take one for what lay at its place in memory.
    """
    fields = [child for child in layout.parentWidget().children() if child.isWidgetType()]
    return [label for field in fields if (label := layout.labelForField(field)) is not None]


def _layout(box: Box) -> Any:
    return box.body.layout()
