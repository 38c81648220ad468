# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of many values of FreeCAD's 3D view (Coin, by pivy) from arrays."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
import numpy.typing as npt


def fill_points(field: Any, points: npt.ArrayLike) -> None:
    """Let an SoMFVec3f hold points, [n, 3] or none."""
    _fill(field, np.asarray(points, np.float32).reshape(-1, 3))


def fill_whole_numbers(field: Any, values: npt.ArrayLike) -> None:
    """Let an SoMFInt32 hold whole numbers, [n]."""
    _fill(field, np.asarray(values, np.int32))


def fill_colours(field: Any, rgba: npt.ArrayLike) -> None:
    """Let an SoMFUInt32 hold packed colours, uint32[n]."""
    _fill(field, np.asarray(rgba, np.uint32))


def _fill(field: Any, values: np.ndarray) -> None:
    """Copy the values into the field's own memory, which has their form.

    pivy's setValues keeps a copy of whole numbers and colours for good, and takes a microsecond a point.
    """
    field.setNum(len(values))
    if not len(values):
        return
    values = np.ascontiguousarray(values)
    place = field.startEditing()
    ctypes.memmove(int(getattr(place, "this", place)), values.ctypes.data, values.nbytes)
    field.finishEditing()
