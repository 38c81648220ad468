# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves that an object keeps with all their digits: FreeCAD's arcs give their ends back with rounding errors.

They count only while the object's shape is that of the curves, at their place: a moved or changed one is read as drawn.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from CNCStepper.geometry.curve import Curve

NAME = "ExactCurves"
ROUNDING_MM = 1e-9  # what FreeCAD's arcs lose is less


def keep_curves(obj: Any, curves: Sequence[Curve]) -> None:
    """Keep the curves of an object, whose shape is theirs."""
    from CNCStepper.job.drawings.packed_curves import packed_curves

    if NAME not in obj.PropertiesList:
        obj.addProperty("App::PropertyString", NAME, "Base", "", 1 | 4)  # cannot be typed, is not shown
    setattr(obj, NAME, json.dumps(packed_curves(curves)))


def all_kept(obj: Any) -> Sequence[Curve]:
    """Return the curves that an object keeps, whatever its shape is now; none where it keeps none."""
    from CNCStepper.job.drawings.packed_curves import unpacked_curves

    content = getattr(obj, NAME, "")
    return unpacked_curves(json.loads(content)) if content else ()


def kept_curves(obj: Any, drawn: Sequence[Curve]) -> Sequence[Curve]:
    """Return the curves that an object keeps, or those read from its shape where the two differ.

    drawn: one curve for each chain of the shape, in the order of the shape.
    """
    exact = all_kept(obj)
    return exact if exact and len(exact) == len(drawn) and all(map(_is_same, exact, drawn)) else drawn


def _is_same(one: Curve, other: Curve) -> bool:
    return len(one) == len(other) and bool(
        np.allclose(one.xy, other.xy, rtol=0.0, atol=ROUNDING_MM)
        and np.allclose(one.bulge, other.bulge, rtol=0.0, atol=ROUNDING_MM)
    )
