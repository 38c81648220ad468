# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polylines as two arrays, as a 3D view takes them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Lines:
    """Polylines one after another: points float32[n, 3] in work coordinates, counts int32[k] of points in each."""

    points: np.ndarray
    counts: np.ndarray
