# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rules of a template as a list: what each takes and does, and how many contours; below them those of no rule."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.panels.background_panel import button_row
from CNCStepper.workbench.panels.fields import NAME, WARNING_COLOUR
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.theme_colours import letters
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.templates.draft import IGNORE, MARKS, Content, takes_words, texts_of

ROWS_SEEN = 7


def cycle_words(cycle: str) -> str:
    """Return how a cycle is called, as its command is."""
    import FreeCADGui

    from CNCStepper.workbench.features.catalogue import operation_class

    command = FreeCADGui.Command.get(operation_class(cycle).Type)
    return str(command.getAction()[0].text()).replace("&", "") if command else cycle


def does_words(does: str) -> str:
    """Return what a rule does, for a person."""
    if does == IGNORE:
        return tr("left out")
    return tr("marks of a sheet cut") if does == MARKS else cycle_words(does)


class RuleList(QtGui.QWidget):
    """The list with its buttons; `chosen` is sent with the number of the row that a person marks."""

    chosen = QtCore.Signal(int)

    def __init__(self, act: Callable[[str], None], parent: Any):
        super().__init__(parent)
        self.tree = QtGui.QTreeWidget(self)
        self.tree.setObjectName(f"{NAME}_rules")
        self.tree.setAccessibleName(tr("Rules"))
        self.tree.setToolTip(tr("The first rule that takes a contour has it; operations come in this order"))
        self.tree.setRootIsDecorated(False)
        self.tree.setHeaderLabels([tr("Rule"), tr("Contours"), tr("Operation"), tr("Takes")])
        self.tree.setMinimumHeight((ROWS_SEEN + 2) * self.fontMetrics().lineSpacing())
        self.tree.currentItemChanged.connect(guarded(lambda *_: self._tell()))
        texts = (
            ("rule_add", tr("Add"), tr("Add a rule after the marked one"), lambda: act("add")),
            ("rule_delete", tr("Delete"), tr("Delete the marked rule"), lambda: act("delete")),
        )
        order = (
            ("rule_up", tr("Earlier"), tr("Move the marked rule before the one above"), lambda: act("up")),
            ("rule_down", tr("Later"), tr("Move the marked rule after the one below"), lambda: act("down")),
        )
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        column.addWidget(self.tree)
        for row in (texts, order):
            column.addWidget(button_row(row, self))

    @property
    def row(self) -> int:
        """The number of the marked row, -1 for none."""
        return int(self.tree.indexOfTopLevelItem(self.tree.currentItem()))

    def show_rules(self, rules: Sequence[Content], counts: Sequence[int] | None, untaken: int, row: int) -> None:
        """Show rules with the counts of their contours, None where these are not known; mark a row."""
        self.tree.blockSignals(True)
        self.tree.clear()
        for number, rule in enumerate(rules):
            told = texts_of(rule)
            count = str(counts[number]) if counts is not None else "…"
            takes = takes_words(rule) or tr("all")
            name = told.title or tr("Rule {0}").format(number + 1)
            self.tree.addTopLevelItem(_item(name, count, does_words(told.does), takes))
        if counts is not None:
            last = _item(tr("no rule"), str(untaken), tr("not cut"), "")
            for column in range(4 if untaken else 0):
                last.setForeground(column, QtGui.QColor(letters(WARNING_COLOUR)))
            self.tree.addTopLevelItem(last)
        self.tree.setCurrentItem(self.tree.topLevelItem(row))
        self.tree.blockSignals(False)
        for column in range(4):
            self.tree.resizeColumnToContents(column)

    def _tell(self) -> None:
        self.chosen.emit(self.row)


def _item(*texts: str) -> Any:
    item = QtGui.QTreeWidgetItem(list(texts))
    for column, text in enumerate(texts):
        item.setToolTip(column, text)
    item.setTextAlignment(1, QtCore.Qt.AlignmentFlag.AlignRight)
    return item
