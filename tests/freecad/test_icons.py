# SPDX-License-Identifier: LGPL-2.1-or-later
"""At 16 pixels, as the tree and lists show them, no two operations and no two shapes of tools look alike."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import numpy as np
from PySide import QtGui, QtSvg

import CNCStepper
from CNCStepper.machine.tools.tool_shapes import SHAPES
from CNCStepper.workbench.features.catalogue import OPERATIONS
from CNCStepper.workbench.features.turning.turning_operation import TURNING_OPERATIONS

ICONS = Path(CNCStepper.__file__).parents[1] / "resources" / "icons"
SIDE_PX = 16
LEAST_MEAN = 10.0  # of 255, over all pixels and colours; the nearest pair has 11.4
LEAST_PIXELS = 24  # of 256, that differ clearly; the nearest pair has 26
CLEARLY = 48  # of 255, in one colour


def drawn(name: str) -> np.ndarray:
    """Return an icon as Qt draws it on white: float[16, 16, 3], 0 to 255."""
    picture = QtGui.QImage(SIDE_PX, SIDE_PX, QtGui.QImage.Format.Format_RGB32)
    picture.fill(QtGui.QColor(255, 255, 255))
    painter = QtGui.QPainter(picture)
    QtSvg.QSvgRenderer(str(ICONS / f"{name}.svg")).render(painter)
    painter.end()
    return np.frombuffer(picture.constBits(), np.uint8).reshape(SIDE_PX, SIDE_PX, 4)[..., :3].astype(float)


def alike(names: list[str]) -> list[str]:
    """Return the pairs that a person takes for each other."""
    pictures = {name: drawn(name) for name in names}
    found = []
    for one, other in combinations(names, 2):
        difference = np.abs(pictures[one] - pictures[other])
        mean, clear = difference.mean(), int((difference.max(axis=2) > CLEARLY).sum())
        if mean < LEAST_MEAN or clear < LEAST_PIXELS:
            found.append(f"{one} and {other}: {mean:.1f} on average, {clear} pixels")
    return found


def test_operations_and_shapes_of_tools_differ() -> None:
    operations = [kind.Type for kind in (*OPERATIONS.values(), *TURNING_OPERATIONS.values())]
    tools = [f"CNCStepper_Tool_{shape}" for shape in SHAPES]
    assert len(operations) > 15
    assert len(tools) > 5
    assert all(drawn(name).std() > CLEARLY for name in operations + tools), "an icon is empty"
    assert not alike(operations + tools)


def test_the_same_icon_is_found_alike() -> None:
    assert alike(["CNCStepper_Tool", "CNCStepper_Tool_flat"])
