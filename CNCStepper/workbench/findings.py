# SPDX-License-Identifier: LGPL-2.1-or-later
"""The findings of a proof as a list: one row each, with its weight, its line, what was seen and what to do."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.words import later, tr

if TYPE_CHECKING:
    from CNCStepper.simulation.finding import Finding

SEVERITIES = {"error": later("Error"), "warning": later("Warning"), "info": later("Note")}
ICONS = {"error": "SP_MessageBoxCritical", "warning": "SP_MessageBoxWarning", "info": "SP_MessageBoxInformation"}
ROW_MARGIN = 8  # pixels
FINDING = QtCore.Qt.ItemDataRole.UserRole


class FindingsList(QtGui.QWidget):
    """A list of findings; `chosen` sends the Finding whose row was clicked or reached by key."""

    chosen = QtCore.Signal(object)

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Findings")
        self._rows = QtGui.QTreeWidget(self)
        self._rows.setObjectName("CNCStepper_Findings_list")
        self._rows.setHeaderLabels([tr("Where"), tr("Finding")])
        self._rows.setRootIsDecorated(False)
        self._rows.setWordWrap(True)
        self._rows.setAllColumnsShowFocus(True)
        self._rows.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._rows.header().setSectionResizeMode(0, QtGui.QHeaderView.ResizeMode.ResizeToContents)
        self._rows.header().setSectionResizeMode(1, QtGui.QHeaderView.ResizeMode.Stretch)
        self._rows.header().sectionResized.connect(self._wrap_again)
        self._rows.itemClicked.connect(self._choose)
        self._rows.currentItemChanged.connect(self._choose)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._rows)

    def show(self, findings: Sequence[Finding]) -> None:
        """Show these findings instead of those before; an empty list says that nothing was found."""
        self._rows.blockSignals(True)
        self._rows.clear()
        self._rows.addTopLevelItems([self._row(finding) for finding in findings] or [_nothing_found()])
        self._rows.blockSignals(False)
        self._wrap_again()

    def _row(self, finding: Finding) -> Any:
        place = tr("line {0}").format(finding.place.line) if finding.place.line else ""
        row = QtGui.QTreeWidgetItem([place, sentence(finding)])
        row.setIcon(0, self.style().standardIcon(getattr(QtGui.QStyle.StandardPixmap, ICONS[finding.severity])))
        row.setData(0, FINDING, finding)
        for column in (0, 1):
            row.setToolTip(column, tooltip(finding))
            row.setTextAlignment(column, QtCore.Qt.AlignmentFlag.AlignTop | QtCore.Qt.AlignmentFlag.AlignLeft)
        return row

    def _choose(self, row: Any, *_: Any) -> None:
        finding = row.data(0, FINDING) if row is not None else None
        if finding is not None:
            self.chosen.emit(finding)

    def _wrap_again(self, *_: Any) -> None:
        """Let the rows be as high as their text is at this width: a tree asks them without one."""
        width = self._rows.columnWidth(1) - ROW_MARGIN
        metrics, flags = self._rows.fontMetrics(), int(QtCore.Qt.TextFlag.TextWordWrap)
        for row in map(self._rows.topLevelItem, range(self._rows.topLevelItemCount())):
            height = metrics.boundingRect(QtCore.QRect(0, 0, width, 0), flags, row.text(1)).height()
            row.setSizeHint(1, QtCore.QSize(width, height + ROW_MARGIN))


def sentence(finding: Finding) -> str:
    """Return the weight of a finding, what was seen, its value and limit, and how many moves it concerns."""
    return f"{tr(SEVERITIES[finding.severity])}: {finding.text}{_numbers(finding)}"


def tooltip(finding: Finding) -> str:
    """Return the whole finding with what to do about it."""
    return "\n".join(part for part in (sentence(finding), finding.advice, f"[{finding.code}]") if part)


def _numbers(finding: Finding) -> str:
    locale = QtCore.QLocale()
    parts = [
        text.format(f"{locale.toString(number, 'g', 6)} {finding.unit}".rstrip())
        for text, number in ((tr("value {0}"), finding.value), (tr("limit {0}"), finding.limit))
        if number is not None
    ]
    if finding.count > 1:
        parts.append(tr("{0} moves").format(finding.count))
    return f" ({', '.join(parts)})" if parts else ""


def _nothing_found() -> Any:
    row = QtGui.QTreeWidgetItem(["", tr("Nothing was found: the program can be sent.")])
    row.setFlags(QtCore.Qt.ItemFlag.ItemIsEnabled)
    return row
