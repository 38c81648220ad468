# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a drawing: each problem with its kind, layer, place and length.

open       a chain that does not end where it begins
gap        two ends that nearly meet
double     a stretch that is drawn twice
tiny       a chain so short that it is a slip of the pen
crossing   a chain that crosses or touches itself
overlap    two closed chains of one layer that cross each other
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.repair.crossings import closed_crossings, self_crossings
from CNCStepper.drawing.repair.doubles import doubles_of
from CNCStepper.errors import Text
from CNCStepper.quantities import Bounds

Kind = Literal["open", "gap", "double", "tiny", "crossing", "overlap"]
KINDS: dict[Kind, str] = {
    "open": "open chains",
    "gap": "gaps",
    "double": "stretches drawn twice",
    "tiny": "tiny chains",
    "crossing": "places where a chain crosses itself",
    "overlap": "places where closed chains cross each other",
}
MOST_CROSSINGS = 1000  # places that are reported
Group = tuple[str, str]


Reach = Annotated[float, Bounds("tolerance", zero=True)]


class RepairLimits(BaseModel):
    """How far mending goes, mm.

    Ends within `join_mm` are moved together. Gaps up to `close_mm` are closed: two lines at their corner, others by a
    line. Lines within `double_mm` of each other are one. Chains up to `tiny_mm` long are left out. With `fit_mm` above
    0 polylines become fewer lines and arcs within it.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    join_mm: Annotated[float, Bounds("tolerance")] = 0.05
    close_mm: Annotated[float, Bounds("tolerance")] = 0.5
    double_mm: Annotated[float, Bounds("tolerance")] = 0.005
    tiny_mm: Reach = 0.02
    fit_mm: Reach = 0.0


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong: where, and how long it is (0 for a crossing)."""

    kind: Kind
    layer: str
    place_mm: tuple[float, float]
    length_mm: float = 0.0

    @property
    def text(self) -> str:
        """The problem for a person."""
        x, y = self.place_mm
        length = f", {self.length_mm:.4g} mm" if self.length_mm else ""
        return Text("{kind} on layer '{layer}' at X{x:.3f} Y{y:.3f}{length}",
                    kind=self.kind, layer=self.layer, x=x, y=y, length=length)  # fmt: skip


def grouped(chains: Iterable[Chain]) -> dict[Group, list[tuple[int, Chain]]]:
    """Return the chains by layer and colour, each with its number in the drawing."""
    found: dict[Group, list[tuple[int, Chain]]] = {}
    for number, chain in enumerate(chains):
        told: Attributes = chain.attributes
        found.setdefault((told.layer, told.colour), []).append((number, chain))
    return found


def problems_of(drawing: Drawing, limits: RepairLimits) -> tuple[Problem, ...]:
    """Return what is wrong with a drawing, by kind in the order of KINDS; crossings up to MOST_CROSSINGS."""
    found = [*_open_and_tiny(drawing, limits), *_gaps(drawing, limits), *_doubles(drawing, limits)]
    found += _crossings(drawing)
    order = list(KINDS)
    return tuple(sorted(found, key=lambda problem: order.index(problem.kind)))


def problem_counts(problems: Iterable[Problem]) -> dict[Kind, int]:
    """Return how many problems of each kind there are."""
    counts = Counter(problem.kind for problem in problems)
    return {kind: counts[kind] for kind in KINDS if counts[kind]}


def is_tiny(chain: Chain, limits: RepairLimits) -> bool:
    """Return whether a chain is so short that it is left out."""
    return chain.curve.length_mm <= limits.tiny_mm


def begin_of(chain: Chain) -> tuple[float, float]:
    """Return where a chain begins."""
    x, y = chain.curve.xy[0].tolist()
    return x, y


def _open_and_tiny(drawing: Drawing, limits: RepairLimits) -> Iterator[Problem]:
    for chain in drawing.chains:
        layer, length_mm = chain.attributes.layer, chain.curve.length_mm
        if is_tiny(chain, limits):
            yield Problem("tiny", layer, begin_of(chain), length_mm)
        elif not chain.curve.closed:
            yield Problem("open", layer, begin_of(chain), length_mm)


def _gaps(drawing: Drawing, limits: RepairLimits) -> Iterator[Problem]:
    for layer, gap in drawing.gaps:
        if gap.size_mm <= limits.close_mm:
            yield Problem("gap", layer, gap.place_mm, gap.size_mm)


def _doubles(drawing: Drawing, limits: RepairLimits) -> Iterator[Problem]:
    for (layer, _), own in grouped(drawing.chains).items():
        checkpoint()
        for place_mm, length_mm in doubles_of([chain.curve for _, chain in own], limits.double_mm).places():
            yield Problem("double", layer, place_mm, length_mm)


def _crossings(drawing: Drawing) -> list[Problem]:
    found: list[Problem] = []
    for layer in drawing.layers:
        checkpoint()
        room = MOST_CROSSINGS - len(found)
        found += [Problem("crossing", layer.name, place) for place in self_crossings(layer.curves, room)]
        room = MOST_CROSSINGS - len(found)
        closed = [curve for curve in layer.curves if curve.closed]
        found += [Problem("overlap", layer.name, place) for place in closed_crossings(closed, room)]
    return found
