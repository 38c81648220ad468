# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mending: a damaged drawing becomes the one that was meant, and every change is in the list."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import ezdxf
import numpy as np
import pytest

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing, Piece
from CNCStepper.drawing.joined_pieces import joined_pieces
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.drawing.repair.mend import fewer_segments, mended
from CNCStepper.drawing.repair.problems import RepairLimits, problem_counts, problems_of
from CNCStepper.drawing.writers.write_drawing import drawing_bytes
from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points, straight
from CNCStepper.geometry.shapes.rectangle import rectangle
from helpers.drawing.damaged_drawings import DAMAGES, damaged

LIMITS = RepairLimits(join_mm=0.05, close_mm=0.9, double_mm=0.002, tiny_mm=0.02)
SEEDS = range(60)
TOLERANCE_MM = 0.1  # of a join, and of a line across a gap in a small arc


def drawing_of(*curves: Curve, layer: str = "CUT") -> Drawing:
    chains, gaps = joined_pieces([Piece(curve, Attributes(layer)) for curve in curves])
    return Drawing(chains, gaps)


def away_mm(one: Curve, other: Curve) -> float:
    """Return how far the farther point of each is from the other one."""
    both = ((one, other), (other, one))
    return max(float(a.distances_mm(b.at_length(np.linspace(0.0, b.length_mm, 200))[0]).max())
               for a, b in both)  # fmt: skip


def test_a_damaged_drawing_becomes_the_one_that_was_meant() -> None:
    done: Counter[str] = Counter()
    for seed in SEEDS:
        case = damaged(seed)
        done += case.done
        found, changes = mended(case.drawing, LIMITS)
        closed = [chain.curve for chain in found.chains]
        where = f"seed {seed}: {[change.text for change in changes]}"
        assert len(closed) == len(case.meant) and all(curve.closed for curve in closed), where
        for meant in case.meant:
            nearest = min(closed, key=lambda curve: away_mm(curve, meant))
            assert away_mm(nearest, meant) <= TOLERANCE_MM, where
            assert abs(abs(nearest.area_mm2) - abs(meant.area_mm2)) <= TOLERANCE_MM * meant.length_mm, where
    print(f"seeds {SEEDS}: {dict(done)}")
    assert all(done[damage] >= 15 for damage in DAMAGES), done


def test_a_sound_drawing_is_left_as_it_is() -> None:
    sound = drawing_of(rectangle((0, 0), (40, 30), 5), circle((20, 15), 6), from_points([(50, 0), (60, 5), (70, 0)]))
    found, changes = mended(sound, LIMITS)
    assert changes == ()
    assert [chain.curve.xy.tolist() for chain in found.chains] == [chain.curve.xy.tolist() for chain in sound.chains]


@pytest.mark.parametrize(
    ("first", "later", "length_mm"),
    [
        (straight((0, 0), (100, 0)), straight((30, 0), (60, 0)), 30.0),
        (straight((0, 0), (50, 0)), straight((80, 0), (20, 0)), 30.0),
        (straight((30, 0), (60, 0)), straight((0, 0), (100, 0)), 30.0),
        (circle((0, 0), 10), circle((0, 0), 10).reversed(), 20 * np.pi),
        (circle((0, 0), 10), Curve(np.array([(10, 0), (0, 10)]), np.array([np.tan(np.pi / 8)])), 5 * np.pi),
        (rectangle((0, 0), (10, 10)), straight((10, 2), (10, 8)), 6.0),
    ],
)
def test_what_is_drawn_twice_is_found_and_taken_out(first: Curve, later: Curve, length_mm: float) -> None:
    twice = drawing_of(first, later)
    doubles = [problem for problem in problems_of(twice, LIMITS) if problem.kind == "double"]
    assert sum(problem.length_mm for problem in doubles) == pytest.approx(length_mm, abs=0.01)
    found, _ = mended(twice, LIMITS)
    together = first.length_mm + later.length_mm - length_mm
    assert sum(chain.curve.length_mm for chain in found.chains) == pytest.approx(together, abs=0.01)
    assert not [problem for problem in problems_of(found, LIMITS) if problem.kind == "double"]


@pytest.mark.parametrize(
    "pair",
    [
        (straight((0, 0), (10, 0)), straight((10, 0), (10, 10))),
        (straight((0, 0), (10, 0)), straight((0, 0.02), (10, 0.02))),
        (straight((0, 0), (10, 0)), straight((2, -5), (2, 5))),
        (straight((0, 0), (10, 0)), Curve(np.array([(0, 0), (10, 0)]), np.array([0.2]))),
    ],
)
def test_what_only_touches_is_no_double(pair: tuple[Curve, Curve]) -> None:
    assert "double" not in problem_counts(problems_of(drawing_of(*pair), LIMITS))


def test_lines_of_two_layers_are_no_double() -> None:
    line = straight((0, 0), (10, 0))
    both = Drawing((Chain(line, Attributes("A")), Chain(line, Attributes("B"))))
    assert mended(both, LIMITS)[1] == ()


def test_crossings_are_found_at_their_places_and_not_mended() -> None:
    bow = from_points([(0, 0), (10, 10), (10, 0), (0, 10)], closed=True)
    case = drawing_of(bow, circle((30, 0), 5), circle((36, 0), 5))
    problems = {problem.kind: problem.place_mm for problem in problems_of(case, LIMITS)}
    assert problems["crossing"] == pytest.approx((5, 5), abs=0.01)
    assert problems["overlap"][0] == pytest.approx(33, abs=0.01)
    assert mended(case, LIMITS)[1] == ()


def test_a_gap_beyond_the_limit_stays_open() -> None:
    wide = drawing_of(from_points([(0, 0), (10, 0), (10, 10), (1.0, 0.1)]))
    found, changes = mended(wide, LIMITS)
    assert changes == () and not found.chains[0].curve.closed


def test_a_polyline_of_many_points_becomes_few_arcs_and_its_arcs_stay() -> None:
    angles = np.linspace(0, np.pi, 181)
    round_side = [(10 * np.cos(a), 10 * np.sin(a)) for a in angles]
    curve = from_points([*round_side, (-10, -5), (10, -5)], closed=True)
    fewer = fewer_segments(curve, 0.01)
    assert len(fewer) <= 8 and away_mm(curve, fewer) <= 0.012
    exact = rectangle((0, 0), (40, 30), 5)
    assert fewer_segments(exact, 0.01) is exact


def test_too_many_lines_on_each_other_are_refused_in_no_time() -> None:
    crowd = Drawing(tuple(Chain(circle((0, 0), 10), Attributes("CUT")) for _ in range(6000)))
    with pytest.raises(GeometryError, match="on top of each other"):
        problems_of(crowd, LIMITS)


@pytest.mark.parametrize("suffix", [".dxf", ".svg"])
def test_what_is_mended_is_written_and_read_again(tmp_path: Path, suffix: str) -> None:
    found, _ = mended(damaged(3).drawing, LIMITS)
    coloured = tuple(Chain(chain.curve, Attributes("CUT", "#ff0000")) for chain in found.chains)
    path = tmp_path / f"mended{suffix}"
    path.write_bytes(drawing_bytes(Drawing(coloured), suffix.upper()))
    if suffix == ".dxf":
        assert not ezdxf.readfile(path).audit().has_errors
    again = read_drawing(path, ReadOptions())
    assert len(again.chains) == len(found.chains)
    for one, other in zip(again.chains, found.chains, strict=True):
        assert away_mm(one.curve, other.curve) < 1e-5
        assert (one.attributes.layer, one.attributes.colour) == ("CUT", "#ff0000")
