# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a drawing in the order of the file, their curves fitted many paths at a time.

shape ──► add_paths: waits ──► MOST_WAITING segments ──► PathColumns.bundle: one call for all ──► ChainGatherer
text ───► add_curves: behind those that wait ──────────────────────────────────────────────────► ChainGatherer
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.chain_columns import ChainColumns, ChainGatherer
from CNCStepper.drawing.drawing import Attributes
from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.bezier_path import PathGatherer, PathPen
from CNCStepper.geometry.fitting.path_columns import SampleBudget

MOST_WAITING = 4_096  # segments


class _Waiting(NamedTuple):
    """An element: how many paths it has, its attributes, and what is called where a path has no curve."""

    paths: int
    attributes: Attributes
    refused: Callable[[GeometryError], None]


class FittedPieces:
    """Gathers the paths of elements and fits them; all paths of an element become pieces, or none."""

    def __init__(self, tolerance_mm: float):
        self._tolerance_mm, self._budget = tolerance_mm, SampleBudget()
        self._pieces = ChainGatherer()
        self._paths = PathGatherer()
        self._waiting: list[_Waiting] = []

    @property
    def budget(self) -> SampleBudget:
        """The samples that are left for all curves of the drawing."""
        return self._budget

    def add_curves(self, curves: Sequence[Curve], attributes: Attributes) -> None:
        """Add the curves of an element; raises GeometryError as `add_paths`."""
        self._fit()
        for curve in curves:
            self._pieces.add(curve, attributes)

    def add_paths(
        self, pens: Sequence[PathPen], attributes: Attributes, refused: Callable[[GeometryError], None]
    ) -> None:
        """Add the paths of an element; `refused` is called later where one of them has no curve.

        Raises GeometryError where the curves of the drawing are too many for the tolerance.
        """
        count = 0
        for pen in pens:
            if len(pen):
                self._paths.add(pen)
                count += 1
        if count:
            self._waiting.append(_Waiting(count, attributes, refused))
            if len(self._paths) >= MOST_WAITING:
                self._fit()

    def all(self) -> ChainColumns:
        """Return the pieces of all elements; raises GeometryError as `add_paths`."""
        self._fit()
        return self._pieces.columns()

    def _fit(self) -> None:
        if not self._waiting:
            return
        checkpoint()
        waiting, self._waiting = self._waiting, []
        paths, self._paths = self._paths.columns(), PathGatherer()
        bundle, errors = paths.bundle(self._tolerance_mm, self._budget)
        attributes = [own.attributes for own in waiting for _ in range(own.paths)]
        if errors:
            kept = self._kept(waiting, errors)
            sound = [number for number in range(len(kept)) if number not in errors]
            bundle, attributes = bundle.where(kept[sound]), [attributes[number] for number in np.flatnonzero(kept)]
        self._pieces.add_bundle(bundle, attributes)

    @staticmethod
    def _kept(waiting: Sequence[_Waiting], errors: dict[int, GeometryError]) -> np.ndarray:
        """Return which paths are of elements all of whose paths have a curve, bool[k]; refuse the other elements."""
        kept: list[bool] = []
        for own in waiting:
            numbers = range(len(kept), len(kept) + own.paths)
            error = next((errors[number] for number in numbers if number in errors), None)
            kept += [error is None] * own.paths
            if error is not None:
                own.refused(error)
        return np.array(kept, bool)
