# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our icons, and those of the tree with a badge when an object has a problem or is switched off."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.workbench import packages

FOLDER = packages.ROOT / "resources" / "icons"
SIZES_PX = (16, 24, 32, 64)
BADGE = 0.56  # of the icon's width


@functools.cache
def icon(name: str, badge: str = "") -> Any:
    """Return the QIcon of a file of ours ("CNCStepper_Job"), with the badge "Problem" or "Inactive" on it.

    FreeCAD reads the file: Qt itself cannot read SVG where its plugin for that is not installed.
    """
    import FreeCADGui
    from PySide import QtGui

    plain = FreeCADGui.getIcon(str(FOLDER / f"{name}.svg"))
    if not badge:
        return plain
    mark = icon(f"CNCStepper_Overlay_{badge}")
    result = QtGui.QIcon()
    for size_px in SIZES_PX:
        result.addPixmap(_composed(plain, mark, size_px, grey=badge == "Inactive"))
    return result


def picture_painter(path: Path) -> Callable[[Any, Any], None]:
    """Return what paints an SVG file into a rectangle of a QPainter at any size.

    Where Python's QtSvg is not installed it is FreeCAD that reads the file, in the size of an icon.
    """
    from PySide import QtCore

    try:
        from PySide import QtSvg
    except ImportError:
        import FreeCADGui

        return FreeCADGui.getIcon(str(path)).paint
    renderer = QtSvg.QSvgRenderer(str(path))
    return lambda painter, place: renderer.render(painter, QtCore.QRectF(place))


def _composed(plain: Any, mark: Any, size_px: int, grey: bool) -> Any:
    from PySide import QtGui

    mode = QtGui.QIcon.Mode.Disabled if grey else QtGui.QIcon.Mode.Normal
    picture = plain.pixmap(size_px, size_px, mode)
    part_px = round(BADGE * picture.width())
    painter = QtGui.QPainter(picture)
    painter.drawPixmap(picture.width() - part_px, 0, mark.pixmap(part_px, part_px))
    painter.end()
    return picture
