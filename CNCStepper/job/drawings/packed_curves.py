# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves as plain data for JSON: columns as base64, between a window and a process."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from typing import Any

import numpy as np

from CNCStepper.geometry.curve import Curve

Packed = dict[str, Any]


def packed_curves(curves: Sequence[Curve]) -> Packed:
    """Return curves as three columns: vertices, bulges, and how many segments each curve has."""
    xy = np.concatenate([curve.xy for curve in curves]) if curves else np.zeros((0, 2))
    bulge = np.concatenate([curve.bulge for curve in curves]) if curves else np.zeros(0)
    return {
        "xy": column_text(xy),
        "bulge": column_text(bulge),
        "segments": column_text(np.array(list(map(len, curves)), np.int64)),
    }


def unpacked_curves(content: Packed) -> list[Curve]:
    """Return the curves of `packed_curves`."""
    xy, bulge = array_of(content["xy"], np.float64).reshape(-1, 2), array_of(content["bulge"], np.float64)
    segments = array_of(content["segments"], np.int64)
    ends = np.cumsum(segments)
    firsts, vertices = (ends - segments).tolist(), (ends - segments + np.arange(len(segments))).tolist()
    rows = zip(firsts, vertices, segments.tolist(), strict=True)
    return [
        Curve.trusted(xy[vertex : vertex + count + 1], bulge[first : first + count]) for first, vertex, count in rows
    ]


def column_text(values: np.ndarray) -> str:
    """Return a column as base64."""
    return base64.b64encode(np.ascontiguousarray(values).tobytes()).decode("ascii")


def array_of(text: str, kind: Any) -> np.ndarray:
    """Return the column of `column_text`."""
    return np.frombuffer(base64.b64decode(text), kind).copy()  # kernels take no columns that cannot be written
