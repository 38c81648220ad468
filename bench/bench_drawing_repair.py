# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules and repair of 100 000 lines, with gaps, and of the same drawn twice, beside the line merge of shapely."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from typing import TypeVar

import shapely

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing, Piece
from CNCStepper.drawing.joined_pieces import joined_pieces
from CNCStepper.drawing.repair.mend import mended
from CNCStepper.drawing.repair.problems import RepairLimits, problems_of
from CNCStepper.geometry.curve import straight
from CNCStepper.job.templates.rules import assigned
from CNCStepper.job.templates.template import Rule

SQUARES, ACROSS, PITCH_MM, SIDE_MM = 25_000, 160, 12.0, 9.0
GAPS, GAP_MM = 0.02, 0.03  # share of the lines, and how far each ends beside its corner
Result = TypeVar("Result")


def lines() -> list[Piece]:
    """Return the sides of squares in a grid, some of them off their corner."""
    chance, pieces = random.Random(1), []
    for number in range(SQUARES):
        x, y = number % ACROSS * PITCH_MM, number // ACROSS * PITCH_MM
        corners = [(x, y), (x + SIDE_MM, y), (x + SIDE_MM, y + SIDE_MM), (x, y + SIDE_MM)]
        for begin, end in zip(corners, corners[1:] + corners[:1], strict=True):
            off_mm = GAP_MM if chance.random() < GAPS else 0.0
            pieces.append(Piece(straight(begin, (end[0] + off_mm, end[1])), Attributes("CUT", "#ff0000")))
    return pieces


def timed(what: str, work: Callable[[], Result]) -> Result:
    """Print the processor time of a piece of work, and return its result."""
    begun = time.process_time()
    result = work()
    print(f"drawing repair: {4 * SQUARES} lines, {what}: {time.process_time() - begun:.2f} s of processor")
    return result


def main() -> None:
    """Print the times of every step."""
    pieces = lines()
    chains, gaps = timed("joined", lambda: joined_pieces(pieces, by_colour=True))
    sides = [shapely.LineString(piece.curve.xy) for piece in pieces]
    timed("merged by shapely, which leaves the gaps", lambda: shapely.line_merge(shapely.multilinestrings(sides)))
    drawing = Drawing(chains, gaps)
    timed("problems found", lambda: problems_of(drawing, RepairLimits()))
    whole, _ = timed("mended", lambda: mended(drawing, RepairLimits()))
    anew = tuple(Chain(chain.curve, chain.attributes) for chain in drawing.chains)
    timed("drawn twice, mended", lambda: mended(Drawing(drawing.chains + anew), RepairLimits()))
    rules = (Rule(layer="x*", ignore=True), Rule(closed=True, operation={"cycle": "contour", "tool": 1}))
    found = timed("assigned to rules", lambda: assigned(rules, whole.chains))
    print(f"drawing repair: {len(found.taken[1])} closed contours")


if __name__ == "__main__":
    main()
