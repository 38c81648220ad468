# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of how a restart enters the path: how much is cut again, and to what height the tool goes up first."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Restart_"
LONGEST_MM = 1000.0
PROPOSED_HEIGHT_MM = 5.0  # of who gives one: what most programs cross at


class EntryFields(QtCore.QObject):
    """The rows of a form; `changed` is sent when a value of theirs is another one."""

    changed = QtCore.Signal()

    def __init__(self, form: Any, parent: Any):
        super().__init__(parent)
        self._overlap = _lengths("overlap", 0.0)
        self._overlap.setToolTip(tr("Begin so much earlier on the same cut, so that no ridge stays"))
        self._gives_height = QtGui.QCheckBox(tr("Height"))
        self._gives_height.setObjectName(f"{NAME}gives_height")
        self._gives_height.setToolTip(
            tr("Go up to this Z first; where none is given: the program's highest crossing rapid")
        )
        self._height = _lengths("height", -LONGEST_MM)
        self._height.setToolTip(self._gives_height.toolTip())
        self._height.setSpecialValueText(tr("as the program"))
        form.addRow(tr("Overlap"), self._overlap)
        form.addRow(self._gives_height, self._height)
        self._show_height()
        self._overlap.valueChanged.connect(lambda _: self.changed.emit())
        self._gives_height.toggled.connect(lambda _: self._ask_height())
        self._height.valueChanged.connect(lambda _: self.changed.emit())

    @property
    def overlap_mm(self) -> float:
        """How many mm are cut again."""
        return float(self._overlap.value())

    @property
    def height_mm(self) -> float | None:
        """The Z in work coordinates to which the tool goes up first; None is as the program's own rapids go."""
        return float(self._height.value()) if self._gives_height.isChecked() else None

    def _ask_height(self) -> None:
        """Let the height be given, or take it away again."""
        self._show_height()
        self.changed.emit()

    def _show_height(self) -> None:
        given = self._gives_height.isChecked()
        self._height.blockSignals(True)
        self._height.setValue(PROPOSED_HEIGHT_MM if given else self._height.minimum())
        self._height.blockSignals(False)
        self._height.setEnabled(given)


def _lengths(what: str, least_mm: float) -> Any:
    spin = QtGui.QDoubleSpinBox()
    spin.setObjectName(f"{NAME}{what}")
    spin.setRange(least_mm, LONGEST_MM)
    spin.setSingleStep(0.5)
    spin.setSuffix(f" {tr('mm')}")
    spin.setKeyboardTracking(False)
    return spin
