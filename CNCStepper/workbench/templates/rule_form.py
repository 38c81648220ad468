# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of one rule: what it takes, and with which operation, tool and depth that is cut."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.cycles.catalogue import cycle_class
from CNCStepper.job.shapes import SHAPE_KEYS
from CNCStepper.job.templates.template import THROUGH
from CNCStepper.machine.libraries.table_draft import text_of
from CNCStepper.workbench.panels.fields import NAME
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.templates.draft import DEPTH, IGNORE, MARKS, NO, PATTERNS, YES, Content, RuleTexts
from CNCStepper.workbench.templates.rule_list import does_words

LINES_SEEN = 4
APART = ("cycle", "tool", DEPTH, "offset_mm", "notes")  # keys of a cycle that the lines do not give


class RuleForm(QtGui.QWidget):
    """The form; `changed` is sent after each edit by a person."""

    changed = QtCore.Signal()

    def __init__(self, parent: Any):
        super().__init__(parent)
        self._form = QtGui.QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.setVerticalSpacing(3)
        self._form.setHorizontalSpacing(4)
        self.lines = {"title": self._line("title", tr("Rule"), tr("Its name, which is the operation's"))}
        tip = tr("As in the file; * is any text, ; divides several")
        for key, label in zip(PATTERNS, (tr("Layer"), tr("Colour"), tr("Name"), tr("Group")), strict=True):
            self.lines[key] = self._line(key, label, tip)
        flags = [("", tr("both")), (YES, tr("yes")), (NO, tr("no"))]
        self.closed = self._choice("closed", tr("Closed"), tr("Whether it takes closed contours"), flags)
        self.filled = self._choice("filled", tr("Filled"), tr("Whether it takes contours that the file fills"), flags)
        cycles = [(does, does_words(does)) for does in (IGNORE, *SHAPE_KEYS, MARKS)]
        self.does = self._choice("does", tr("Operation"), tr("What becomes of the contours"), cycles)
        self.marks_for = self._choice("marks_for", tr("Marks of"), tr("The rule with the sheet cut"), [])
        self.tool = self._choice("tool", tr("Tool"), tr("One of the template's tools"), [])
        self.depth = self._line("depth", tr("Depth"), tr("In mm from the top of the stock"))
        self.through = QtGui.QCheckBox(tr("through the stock"), self)
        self.through.setObjectName(f"{NAME}_rule_through")
        self.through.clicked.connect(guarded(self._touched))
        self._form.addRow(self.through)
        self.values = QtGui.QPlainTextEdit(self)
        self.values.setObjectName(f"{NAME}_rule_values")
        self.values.setAccessibleName(tr("Further values"))
        self.values.setFixedHeight((LINES_SEEN + 1) * self.fontMetrics().lineSpacing())
        self.values.textChanged.connect(guarded(self._touched))
        self.values_label = QtGui.QLabel(tr("Further values"), self)
        for widget in (self.values_label, self.values):
            self._form.addRow(widget)
        self._showing = False

    def show_rule(self, texts: RuleTexts, tools: Sequence[Content], sheet_cuts: Sequence[str]) -> None:
        """Show a rule; a person's edit of one field leaves the others as they are."""
        self._showing = True
        for key, line in self.lines.items():
            _show(line, getattr(texts, key))
        offered = [(tool.get("number", 0), _tool_words(tool)) for tool in tools]
        known = [number for number, _ in offered]
        own = [] if texts.tool in (0, *known) else [(texts.tool, f"T{texts.tool}")]
        _offer(self.tool, [(0, tr("the only one")), *offered, *own], texts.tool)
        titles = dict.fromkeys((*sheet_cuts, texts.marks_for))
        _offer(self.marks_for, [(title, title) for title in titles], texts.marks_for)
        for box, value in ((self.closed, texts.closed), (self.filled, texts.filled), (self.does, texts.does)):
            box.setCurrentIndex(box.findData(value))
        self.through.setChecked(texts.depth == THROUGH)
        _show(self.depth, "" if texts.depth == THROUGH else texts.depth)
        if self.values.toPlainText() != texts.values and not self.values.hasFocus():
            self.values.setPlainText(texts.values)
        self._show_what_counts(texts.does)
        self._showing = False

    def read(self) -> RuleTexts:
        """Return what stands in the fields."""
        return RuleTexts(
            **{key: line.text().strip() for key, line in self.lines.items()},
            closed=_chosen(self.closed),
            filled=_chosen(self.filled),
            does=_chosen(self.does),
            marks_for=_chosen(self.marks_for) or "",
            tool=_chosen(self.tool) or 0,
            depth=THROUGH if self.through.isChecked() else self.depth.text(),
            values=self.values.toPlainText(),
        )

    def _show_what_counts(self, does: str) -> None:
        cuts = does not in (IGNORE, MARKS)
        drawn = {key.says for key in SHAPE_KEYS.get(does, ())} | {key.field for key in SHAPE_KEYS.get(does, ())}
        keys = [key for key in cycle_class(does).model_fields if key not in {*APART, *drawn}] if cuts else []
        self.values.setToolTip(tr("A line for each, as in job files: {0}").format(", ".join(keys)))
        for widget in (self.tool, self.values_label, self.values):
            self._show_row(widget, cuts)
        has_depth = cuts and DEPTH in cycle_class(does).model_fields
        self._show_row(self.depth, has_depth)
        self._show_row(self.through, has_depth)
        self.depth.setEnabled(not self.through.isChecked())
        self._show_row(self.marks_for, does == MARKS)

    def _show_row(self, widget: Any, visible: bool) -> None:
        widget.setVisible(visible)
        if (label := self._form.labelForField(widget)) is not None:
            label.setVisible(visible)

    def _touched(self, *_: Any) -> None:
        if not self._showing:
            self._show_what_counts(_chosen(self.does))
            self.changed.emit()

    def _line(self, key: str, label: str, tip: str) -> Any:
        line = QtGui.QLineEdit(self)
        line.textEdited.connect(guarded(self._touched))
        return self._row(key, label, tip, line)

    def _choice(self, key: str, label: str, tip: str, choices: Sequence[tuple[Any, str]]) -> Any:
        box = QtGui.QComboBox(self)
        box.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        for value, words in choices:
            box.addItem(words, value)
        box.activated.connect(guarded(self._touched))
        return self._row(key, label, tip, box)

    def _row(self, key: str, label: str, tip: str, widget: Any) -> Any:
        widget.setObjectName(f"{NAME}_rule_{key}")
        widget.setAccessibleName(label)
        widget.setToolTip(tip)
        self._form.addRow(label, widget)
        return widget


def _chosen(box: Any) -> Any:
    return box.itemData(box.currentIndex())


def _offer(box: Any, choices: Sequence[tuple[Any, str]], value: Any) -> None:
    box.clear()
    for each, words in choices:
        box.addItem(words, each)
    box.setCurrentIndex(box.findData(value))


def _show(line: Any, text: str) -> None:
    """Show a text in a line, unless a person is just typing there."""
    if not line.hasFocus():
        line.setText(text)


def _tool_words(tool: Content) -> str:
    name = tool.get("name") or words_of(str(tool.get("shape", "")))
    return f"T{tool.get('number', 0)}  {text_of(tool.get('diameter_mm'))} mm  {name}"
