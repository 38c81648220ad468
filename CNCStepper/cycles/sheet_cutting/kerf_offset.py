# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paths of the beam's centre: chains offset by half a kerf, and where a kerf does not fit.

Every path has the part on the good side: exact parallels of lines and arcs.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely

from CNCStepper.cycles.sheet_cutting.chains import SHORTEST_MM, Chain, polygon_of
from CNCStepper.cycles.sheet_cutting.chord_pieces import ChordPieces, points_of
from CNCStepper.errors import CycleError, GeometryError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import bundle_of
from CNCStepper.geometry.offset import left_loops
from CNCStepper.tolerances import SAME_CUT_MM, SAME_MM

OFFSET_TOLERANCE_MM = 0.004  # of which an offset uses an eighth at most
ROUGH_MM = 0.02  # of chords with which slots are looked for
GAP_MM = 0.004  # by so much less than a kerf a gap may be: rounding of drawings


def with_paths(chains: Sequence[Chain], kerf_mm: float, part_right: bool) -> list[Chain]:
    """Return the chains with the paths of a beam of that kerf; raises CycleError where it does not fit."""
    rings = points_of([chain.curve for chain in chains], ROUGH_MM / 10.0)
    for chain, ring in zip(chains, rings, strict=True):
        if not chain.is_open:
            _require_simple(chain, ring)
    return [_with_path(chain, kerf_mm, part_right) for chain in chains]


def require_gaps(chains: Sequence[Chain], pieces: ChordPieces, kerf_mm: float) -> None:
    """Raise CycleError where two parts, or a part and the hole around it, are nearer to each other than the kerf.

    pieces: of the closed chains, by their index.
    """
    if not kerf_mm:
        return
    one, other, apart_mm = pieces.pairs(max(kerf_mm - GAP_MM, SAME_CUT_MM))
    scrap = np.array([_scrap_between(chains, *pair) for pair in zip(one.tolist(), other.tolist(), strict=True)], bool)
    if not scrap.any():
        return
    worst = int(np.flatnonzero(scrap)[apart_mm[scrap].argmin()])
    pair = int(one[worst]), int(other[worst])
    lines = [shapely.LineString(pieces.chords[each]) for each in pair]
    (x, y), _ = shapely.get_coordinates(shapely.shortest_line(*lines))
    raise CycleError(
        "gap-narrow",
        Text(
            "between curves {one} and {other} the kerf does not fit, at X{x:.3f} Y{y:.3f}",
            one=chains[pair[0]].number, other=chains[pair[1]].number, x=x, y=y,
        ),
        value=f"{apart_mm[worst]:.3f} mm",
        limit=Text("at least the kerf of {kerf_mm:g} mm", kerf_mm=kerf_mm),
        advice=_apart_or_narrower(float(apart_mm[worst]), kerf_mm),
    )  # fmt: skip


def _apart_or_narrower(apart_mm: float, kerf_mm: float) -> Text:
    """Return how far two parts must be moved, or the kerf that fits between them."""
    if _down(apart_mm) <= 0.0:
        return Text("draw them {kerf_mm:g} mm apart", kerf_mm=kerf_mm)
    return Text(
        "move them {more_mm:.3f} mm farther apart, or cut with a kerf of at most {gap_mm:.3f} mm",
        more_mm=_up(kerf_mm - apart_mm),
        gap_mm=_down(apart_mm),
    )


def narrow_warnings(chains: Sequence[Chain], kerf_mm: float) -> list[str]:
    """Return a warning for each chain with a slot or corner into which the kerf does not get."""
    told: list[str] = []
    closed = [chain for chain in chains if not chain.is_open]
    for chain, points in zip(closed, points_of([chain.curve for chain in closed], ROUGH_MM), strict=True):
        places = np.vstack([points, _middles(chain.curve)])
        away_mm = np.min([path.distances_mm(places) for path in chain.paths], axis=0)
        worst = int(away_mm.argmax())
        if away_mm[worst] > kerf_mm + GAP_MM:
            x, y = places[worst].tolist()
            told.append(
                Text(
                    "{chain}: the kerf does not get into a slot or corner at X{x:.3f} Y{y:.3f}; {left_mm:.2f} mm stay",
                    chain=chain.title, x=x, y=y, left_mm=float(away_mm[worst]) - kerf_mm / 2.0,
                )
            )  # fmt: skip
    return told


def _middles(curve: Curve) -> np.ndarray:
    places: np.ndarray = curve.at_length((curve.before_mm[1:] + curve.before_mm[:-1]) / 2.0)[0]
    return places


def _scrap_between(chains: Sequence[Chain], one: int, other: int) -> bool:
    """Return whether what lies between two closed chains is cut away."""
    first, second = chains[one], chains[other]
    if first.holder == second.holder:
        return first.is_part
    inner, outer = (first, other) if first.depth > second.depth else (second, one)
    return inner.is_part and inner.holder == outer


def _with_path(chain: Chain, kerf_mm: float, part_right: bool) -> Chain:
    paths = _centre_lines(chain, kerf_mm)
    if not part_right and not chain.is_open:
        paths = tuple(path.reversed() for path in paths)
    return Chain(chain.number, chain.curve, chain.depth, chain.holder, paths)


def _centre_lines(chain: Chain, kerf_mm: float) -> tuple[Curve, ...]:
    """Return the path with the part on its right: clockwise round a part, counter-clockwise in a hole."""
    if chain.is_open:
        return (chain.curve,)
    along = chain.curve if chain.is_hole else chain.curve.reversed()
    if not kerf_mm:
        return (along,)
    try:
        found = left_loops(bundle_of([along]), kerf_mm / 2.0, OFFSET_TOLERANCE_MM).curves()
    except GeometryError as error:
        raise CycleError(error.code, error.what, value=error.value, limit=error.limit, advice=error.advice) from error
    paths = tuple(path for path in found if path.length_mm > SHORTEST_MM)
    if not paths:
        raise _too_wide(chain, kerf_mm)
    return paths


def _require_simple(chain: Chain, ring: np.ndarray) -> None:
    x, y = chain.curve.xy[0].tolist()
    if abs(chain.curve.area_mm2) < SHORTEST_MM**2 or not shapely.is_simple(shapely.linearrings(ring)):
        raise CycleError(
            "curve-crossing",
            Text(
                "curve {number}, which begins at X{x:.3f} Y{y:.3f}, crosses itself or encloses nothing",
                number=chain.number, x=x, y=y,
            ),
            advice="draw an outline that encloses one area",
        )  # fmt: skip


def _too_wide(chain: Chain, kerf_mm: float) -> CycleError:
    room = shapely.maximum_inscribed_circle(polygon_of(chain.curve, SAME_MM), tolerance=0.001)
    (x, y), _ = shapely.get_coordinates(room)
    room_mm = _down(2.0 * float(shapely.length(room)) - SHORTEST_MM)
    return CycleError(
        "kerf-wide",
        Text("the kerf is wider than hole {number} at X{x:.3f} Y{y:.3f}", number=chain.number, x=x, y=y),
        value=f"{kerf_mm:g} mm",
        limit=Text("at most {room_mm:.3f} mm", room_mm=room_mm),
        advice=Text(
            "cut with a kerf of at most {room_mm:.3f} mm, draw the hole wider than the kerf, or set spot_below_mm "
            "above {diameter_mm:.3f} to spot it for drilling",
            room_mm=room_mm,
            diameter_mm=_up(chain.diameter_mm),
        ),
    )


def _up(length_mm: float) -> float:
    return math.ceil(1000.0 * length_mm) / 1000.0


def _down(length_mm: float) -> float:
    return math.floor(1000.0 * length_mm) / 1000.0
