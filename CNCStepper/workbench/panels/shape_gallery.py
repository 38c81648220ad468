# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library of basic shapes in the task panel: families, pictures, and the one that is inserted."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.panels.fields import NAME
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.standard_buttons import PanelButtons
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.drawing.shape_library.declaration import LibraryShape

ICON_PX = 56
MARGIN_SHARE = 0.08  # of the picture, around the shape
CHORD_SHARE = 0.004  # of the shape: how far the picture's chords leave arcs
FILL, LINE, LINE_PX = "#a9cdf0", "#1b3556", 2.0


class ShapeGallery(PanelButtons):
    """The task with the pictures; `take` is called with the kind that is chosen, when the task is closed."""

    def __init__(self, take: Callable[[str], None]):
        from CNCStepper.drawing.shape_library.shape_families import FAMILIES

        self._take = take
        self.form = QtGui.QWidget()
        self.form.setObjectName(f"{NAME}_Shapes")
        self.form.setWindowTitle(tr("Shapes"))
        self.family = QtGui.QComboBox(self.form)
        self.family.setObjectName(f"{NAME}_family")
        self.family.setAccessibleName(tr("Family"))
        self._titles = list(FAMILIES)
        self.family.addItems([tr(title) for title in self._titles])
        self.list = QtGui.QListWidget(self.form)
        self.list.setObjectName(f"{NAME}_shapes")
        self.list.setAccessibleName(tr("Shapes"))
        self.list.setViewMode(QtGui.QListView.ViewMode.IconMode)
        self.list.setResizeMode(QtGui.QListView.ResizeMode.Adjust)
        self.list.setMovement(QtGui.QListView.Movement.Static)
        self.list.setIconSize(QtCore.QSize(ICON_PX, ICON_PX))
        self.list.setGridSize(QtCore.QSize(ICON_PX + 28, ICON_PX + 3 * self.list.fontMetrics().height()))
        self.list.setWordWrap(True)
        self.list.setMinimumHeight(320)
        self.about = QtGui.QLabel(self.form)
        self.about.setObjectName(f"{NAME}_about")
        self.about.setWordWrap(True)
        self.about.setMinimumHeight(3 * self.about.fontMetrics().height())
        column = QtGui.QVBoxLayout(self.form)
        for widget in (self.family, self.list, self.about):
            column.addWidget(widget)
        self.family.currentIndexChanged.connect(guarded(self.fill))
        self.list.currentRowChanged.connect(guarded(self._tell))
        soon = QtCore.QTimer.singleShot  # closing deletes the list, which must have told its click
        self.list.itemDoubleClicked.connect(guarded(lambda: soon(0, guarded(self.accept))))
        self.fill()

    def fill(self) -> None:
        """Show the shapes of the family that is chosen."""
        from CNCStepper.drawing.shape_library.shape_families import shapes_of

        self._shapes = shapes_of(self._titles[self.family.currentIndex()])
        self.list.clear()
        for shape in self._shapes:
            item = QtGui.QListWidgetItem(QtGui.QIcon(picture_of(shape, ICON_PX)), tr(shape.title))
            item.setToolTip(tr(shape.about))
            self.list.addItem(item)
        self.list.setCurrentRow(0)

    def _tell(self) -> None:
        row = self.list.currentRow()
        self.about.setText(tr(self._shapes[row].about) if row >= 0 else "")

    def accept(self) -> bool:
        """Insert the shape that is marked; FreeCAD calls this for OK."""
        row = self.list.currentRow()
        if row < 0:
            return False
        self._close()
        QtCore.QTimer.singleShot(0, guarded(lambda: self._take(self._shapes[row].kind)))
        return True

    def reject(self) -> bool:
        """Insert nothing; FreeCAD calls this for Cancel and Esc."""
        self._close()
        return True

    def _close(self) -> None:
        import FreeCADGui

        FreeCADGui.Control.closeDialog()


def open_gallery(take: Callable[[str], None]) -> None:
    """Show the library in the task panel."""
    import FreeCADGui

    FreeCADGui.Control.showDialog(ShapeGallery(take))


def picture_of(shape: LibraryShape, size_px: int) -> Any:
    """Return a picture of a shape with its usual dimensions."""
    figure = shape.figure({})
    left, low, right, high = figure.outline.box_mm
    size_mm = max(right - left, high - low)
    scale = size_px * (1.0 - 2.0 * MARGIN_SHARE) / size_mm
    path = QtGui.QPainterPath()
    for curve in figure.curves:
        points = curve.points(CHORD_SHARE * size_mm).tolist()
        corners = [QtCore.QPointF(x * scale, -y * scale) for x, y in points]
        path.addPolygon(QtGui.QPolygonF(corners))
        path.closeSubpath()
    picture = QtGui.QPixmap(size_px, size_px)
    picture.fill(QtCore.Qt.GlobalColor.transparent)
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
    painter.translate(size_px / 2.0 - scale * (left + right) / 2.0, size_px / 2.0 + scale * (low + high) / 2.0)
    painter.setPen(QtGui.QPen(QtGui.QColor(LINE), LINE_PX))
    painter.setBrush(QtGui.QColor(FILL))
    painter.drawPath(path)
    painter.end()
    return picture
