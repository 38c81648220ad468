# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a drawing in the order of the file, their curves fitted many paths at a time.

shape ──► add_paths: waits ──► MOST_WAITING segments ──► PathColumns.curves: one call for all ──► Piece
text ───► add_curves: keeps its place ────────────────────────────────────────────────────────► Piece
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.drawing import Attributes, Piece
from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.bezier_path import PathPen, columns_of
from CNCStepper.geometry.fitting.path_columns import SampleBudget

MOST_WAITING = 16_384  # segments


class _Waiting(NamedTuple):
    """The paths of one element, its attributes, the place of its pieces, and what is called where one has no curve."""

    pens: Sequence[PathPen]
    attributes: Attributes
    place: int
    refused: Callable[[GeometryError], None]


class FittedPieces:
    """Gathers the paths of elements and fits them; all paths of an element become pieces, or none."""

    def __init__(self, tolerance_mm: float):
        self._tolerance_mm, self._budget = tolerance_mm, SampleBudget()
        self._pieces: list[Sequence[Piece]] = []  # of each element
        self._waiting: list[_Waiting] = []
        self._segments = 0

    @property
    def budget(self) -> SampleBudget:
        """The samples that are left for all curves of the drawing."""
        return self._budget

    def add_curves(self, curves: Sequence[Curve], attributes: Attributes) -> None:
        """Add the curves of an element."""
        self._pieces.append([Piece(curve, attributes) for curve in curves])

    def add_paths(
        self, pens: Sequence[PathPen], attributes: Attributes, refused: Callable[[GeometryError], None]
    ) -> None:
        """Add the paths of an element; `refused` is called later where one of them has no curve.

        Raises GeometryError where the curves of the drawing are too many for the tolerance.
        """
        drawn = [pen for pen in pens if len(pen)]
        if not drawn:
            return
        self._waiting.append(_Waiting(drawn, attributes, len(self._pieces), refused))
        self._pieces.append(())
        self._segments += sum(map(len, drawn))
        if self._segments >= MOST_WAITING:
            self._fit()

    def all(self) -> list[Piece]:
        """Return the pieces of all elements; raises GeometryError as `add_paths`."""
        self._fit()
        return [piece for own in self._pieces for piece in own]

    def _fit(self) -> None:
        if not self._waiting:
            return
        checkpoint()
        waiting, self._waiting, self._segments = self._waiting, [], 0
        found = iter(columns_of([pen for own in waiting for pen in own.pens]).curves(self._tolerance_mm, self._budget))
        for own in waiting:
            curves: list[Curve] = []
            error: GeometryError | None = None
            for _ in own.pens:
                curve = next(found)
                if isinstance(curve, GeometryError):
                    error = error or curve
                else:
                    curves.append(curve)
            if error is None:
                self._pieces[own.place] = [Piece(curve, own.attributes) for curve in curves]
            else:
                own.refused(error)
