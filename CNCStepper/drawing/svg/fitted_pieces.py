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
from CNCStepper.geometry.fitting.bezier_path import PathPen, columns_of
from CNCStepper.geometry.fitting.path_columns import SampleBudget

MOST_WAITING = 4_096  # segments


class _Waiting(NamedTuple):
    """The paths of one element, its attributes, and what is called where a path has no curve."""

    pens: Sequence[PathPen]
    attributes: Attributes
    refused: Callable[[GeometryError], None]


class FittedPieces:
    """Gathers the paths of elements and fits them; all paths of an element become pieces, or none."""

    def __init__(self, tolerance_mm: float):
        self._tolerance_mm, self._budget = tolerance_mm, SampleBudget()
        self._pieces = ChainGatherer()
        self._waiting: list[_Waiting] = []
        self._segments = 0

    @property
    def budget(self) -> SampleBudget:
        """The samples that are left for all curves of the drawing."""
        return self._budget

    def add_curves(self, curves: Sequence[Curve], attributes: Attributes) -> None:
        """Add the curves of an element."""
        self._fit()
        for curve in curves:
            self._pieces.add(curve, attributes)

    def add_paths(
        self, pens: Sequence[PathPen], attributes: Attributes, refused: Callable[[GeometryError], None]
    ) -> None:
        """Add the paths of an element; `refused` is called later where one of them has no curve.

        Raises GeometryError where the curves of the drawing are too many for the tolerance.
        """
        drawn = [pen for pen in pens if len(pen)]
        if not drawn:
            return
        self._waiting.append(_Waiting(drawn, attributes, refused))
        self._segments += sum(map(len, drawn))
        if self._segments >= MOST_WAITING:
            self._fit()

    def all(self) -> ChainColumns:
        """Return the pieces of all elements; raises GeometryError as `add_paths`."""
        self._fit()
        return self._pieces.columns()

    def _fit(self) -> None:
        if not self._waiting:
            return
        checkpoint()
        waiting, self._waiting, self._segments = self._waiting, [], 0
        pens = [pen for own in waiting for pen in own.pens]
        bundle, errors = columns_of(pens).bundle(self._tolerance_mm, self._budget)
        kept, attributes = np.ones(len(pens), bool), [own.attributes for own in waiting for _ in own.pens]
        if errors:
            self._refuse(waiting, errors, kept)
            sound = [number for number in range(len(pens)) if number not in errors]
            bundle, attributes = bundle.where(kept[sound]), [attributes[number] for number in np.flatnonzero(kept)]
        self._pieces.add_bundle(bundle, attributes)

    @staticmethod
    def _refuse(waiting: Sequence[_Waiting], errors: dict[int, GeometryError], kept: np.ndarray) -> None:
        """Refuse the elements of which a path has no curve; their paths are not `kept`, bool[k]."""
        first = 0
        for own in waiting:
            paths = range(first, first + len(own.pens))
            first = paths.stop
            error = next((errors[number] for number in paths if number in errors), None)
            if error is not None:
                kept[paths.start : paths.stop] = False
                own.refused(error)
