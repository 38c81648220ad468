# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a drawing in the order of the file, their curves fitted many paths at a time.

shape ──► add_paths: waits ──► MOST_WAITING segments ──► PathColumns.curves: one call for all ──► Piece
text ───► add_curves: waits with them ────────────────────────────────────────────────────────► Piece
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import NamedTuple

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.chain_columns import ChainColumns, ChainGatherer
from CNCStepper.drawing.drawing import Attributes
from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.bezier_path import PathPen, columns_of
from CNCStepper.geometry.fitting.path_columns import SampleBudget

MOST_WAITING = 4_096  # segments


class _Waiting(NamedTuple):
    """The paths of one element, or its curves, its attributes, and what is called where a path has no curve."""

    pens: Sequence[PathPen]
    curves: Sequence[Curve]
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
        self._waiting.append(_Waiting((), curves, attributes, _not_refused))
        self._count(sum(map(len, curves)))

    def add_paths(
        self, pens: Sequence[PathPen], attributes: Attributes, refused: Callable[[GeometryError], None]
    ) -> None:
        """Add the paths of an element; `refused` is called later where one of them has no curve.

        Raises GeometryError where the curves of the drawing are too many for the tolerance.
        """
        drawn = [pen for pen in pens if len(pen)]
        if not drawn:
            return
        self._waiting.append(_Waiting(drawn, (), attributes, refused))
        self._count(sum(map(len, drawn)))

    def all(self) -> ChainColumns:
        """Return the pieces of all elements; raises GeometryError as `add_paths`."""
        self._fit()
        return self._pieces.columns()

    def _count(self, segments: int) -> None:
        self._segments += segments
        if self._segments >= MOST_WAITING:
            self._fit()

    def _fit(self) -> None:
        if not self._waiting:
            return
        checkpoint()
        waiting, self._waiting, self._segments = self._waiting, [], 0
        pens = [pen for own in waiting for pen in own.pens]
        found = iter(columns_of(pens).curves(self._tolerance_mm, self._budget) if pens else ())
        for own in waiting:
            fitted = [next(found) for _ in own.pens]
            error = next((curve for curve in fitted if isinstance(curve, GeometryError)), None)
            if error is not None:
                own.refused(error)
                continue
            for curve in itertools.chain(own.curves, fitted):
                assert isinstance(curve, Curve)
                self._pieces.add(curve, own.attributes)


def _not_refused(error: GeometryError) -> None:
    raise error
