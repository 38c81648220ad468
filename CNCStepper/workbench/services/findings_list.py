# SPDX-License-Identifier: LGPL-2.1-or-later
"""The findings of a proof as a list: a row has severity, line, text, value and limit, and perhaps a button below."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.remedy_bar import Remedy, RemedyBar
from CNCStepper.workbench.services.translation import later, tr

if TYPE_CHECKING:
    from CNCStepper.simulation.finding import Finding

SEVERITIES = {"error": later("Error"), "warning": later("Warning"), "info": later("Note")}
ICONS = {"error": "SP_MessageBoxCritical", "warning": "SP_MessageBoxWarning", "info": "SP_MessageBoxInformation"}
FINDING = QtCore.Qt.ItemDataRole.UserRole
LEAST_LINES = 5


class FindingsList(QtGui.QWidget):
    """A list of findings; `chosen` sends the Finding whose row was clicked or reached by key."""

    chosen = QtCore.Signal(object)

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Findings")
        self._rows = QtGui.QListWidget(self)
        self._rows.setObjectName("CNCStepper_Findings_list")
        self._rows.setAccessibleName(tr("Findings"))
        self._rows.setWordWrap(True)
        self._rows.setAlternatingRowColors(True)
        self._rows.setResizeMode(QtGui.QListView.ResizeMode.Adjust)
        self._rows.setTextElideMode(QtCore.Qt.TextElideMode.ElideNone)
        self._rows.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._rows.setVerticalScrollMode(QtGui.QAbstractItemView.ScrollMode.ScrollPerPixel)
        self._rows.setMinimumHeight(LEAST_LINES * self.fontMetrics().lineSpacing())
        self._rows.itemClicked.connect(self._choose)
        self._rows.currentItemChanged.connect(self._choose)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._rows)

    def show(self, findings: Sequence[Finding], remedies: Sequence[Remedy | None] = ()) -> None:
        """Show these findings in place of earlier ones; an empty list shows that there are none.

        remedies: of each finding, or none for all of them.
        """
        self._rows.blockSignals(True)
        self._rows.clear()
        for finding, remedy in zip(findings, remedies or [None] * len(findings), strict=True):
            self._rows.addItem(self._row(finding))
            if remedy is not None:
                self._add_button(remedy)
        if not findings:
            self._rows.addItem(_nothing_found())
        self._rows.blockSignals(False)
        self._fit_buttons()

    def resizeEvent(self, event: Any) -> None:
        """Fit the buttons into the new width; Qt calls this."""
        super().resizeEvent(event)
        self._fit_buttons()

    def withdraw_remedies(self) -> None:
        """Take the buttons away: what they would change is not what was proven any more."""
        for row in map(self._rows.item, range(self._rows.count())):
            if self._rows.itemWidget(row) is not None:
                row.setHidden(True)

    def _add_button(self, remedy: Remedy) -> None:
        row, bar = QtGui.QListWidgetItem(), RemedyBar(self._rows)
        bar.show_remedies([remedy])
        row.setFlags(QtCore.Qt.ItemFlag.ItemIsEnabled)
        self._rows.addItem(row)
        self._rows.setItemWidget(row, bar)

    def _fit_buttons(self) -> None:
        """Make no button wider than the list beside its scroll bar, for the list cannot be scrolled sideways."""
        bar_px = self._rows.verticalScrollBar().sizeHint().width()
        width_px = max(1, self.width() - 2 * self._rows.frameWidth() - bar_px)
        for row in map(self._rows.item, range(self._rows.count())):
            bar = self._rows.itemWidget(row)
            if bar is not None:
                bar.fit_width(width_px)
                row.setSizeHint(QtCore.QSize(width_px, bar.sizeHint().height()))

    def _row(self, finding: Finding) -> Any:
        icon = self.style().standardIcon(getattr(QtGui.QStyle.StandardPixmap, ICONS[finding.severity]))
        row = QtGui.QListWidgetItem(icon, sentence(finding))
        row.setData(FINDING, finding)
        row.setToolTip(tooltip(finding))
        return row

    def _choose(self, row: Any, *_: Any) -> None:
        finding = row.data(FINDING) if row is not None else None
        if finding is not None:
            self.chosen.emit(finding)


def sentence(finding: Finding) -> str:
    """Return the weight and the line of a finding, what was seen, its value and limit, and how many moves it is."""
    weight, line = tr(SEVERITIES[finding.severity]), finding.place.line
    head = tr("{0}, line {1}").format(weight, line) if line else weight
    return f"{head}: {translated(finding.text)}{_numbers(finding)}"


def tooltip(finding: Finding) -> str:
    """Return the whole finding with what to do about it."""
    return "\n".join(filter(None, (sentence(finding), translated(finding.advice))))


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
    row = QtGui.QListWidgetItem(tr("Nothing was found: the program can be sent."))
    row.setFlags(QtCore.Qt.ItemFlag.ItemIsEnabled)
    return row
