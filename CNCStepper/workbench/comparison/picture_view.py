# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture that fits its place, grows under the wheel and is moved by dragging."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.services.messages import polled

STEP, MOST = 1.25, 40.0  # of the wheel; how much larger than its place


class PictureView(QtGui.QGraphicsView):
    """Shows one picture."""

    def __init__(self, name: str, parent: Any):
        super().__init__(parent)
        self.setObjectName(name)
        self.setScene(QtGui.QGraphicsScene(self))
        self.setDragMode(QtGui.QGraphicsView.DragMode.ScrollHandDrag)
        self.setTransformationAnchor(QtGui.QGraphicsView.ViewportAnchor.AnchorUnderMouse)
        self.setRenderHint(QtGui.QPainter.RenderHint.SmoothPixmapTransform)
        self.setMinimumSize(240, 180)
        self._larger = 1.0

    def show_picture(self, picture: Any) -> None:
        """Show a QPixmap in place of the one before."""
        self.scene().clear()
        self.scene().addPixmap(picture)
        self.scene().setSceneRect(QtCore.QRectF(picture.rect()))
        self.fit()

    def fit(self) -> None:
        """Show the whole picture."""
        self._larger = 1.0
        self.fitInView(self.scene().sceneRect(), QtCore.Qt.AspectRatioMode.KeepAspectRatio)

    @polled
    def wheelEvent(self, event: Any) -> None:
        """Grow or shrink about the pointer; Qt calls this."""
        factor = STEP if event.angleDelta().y() > 0 else 1 / STEP
        if self._larger * factor <= 1.0:
            self.fit()
        elif self._larger * factor <= MOST:
            self._larger *= factor
            self.scale(factor, factor)
        event.accept()

    @polled
    def resizeEvent(self, event: Any) -> None:
        """Fit again while the whole is shown; Qt calls this."""
        super().resizeEvent(event)
        if self._larger == 1.0:
            self.fit()
