# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random contours on every side, judged by the product through their program text and, apart from it, by shapely.

Independent of the cycle: the part is drawn by shapely from the outlines; the tool may nowhere enter it, and must
have swept all that it can reach within its diameter of the part. On its line it is on it everywhere; beside an open
line it touches it wherever its disc fits.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour import Contour
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.simulation.stock import Stock
from helpers.cycles.product_verdict import Verdict, cut, judged, tool
from helpers.cycles.random_outlines import Outlines, enclosed, random_line, random_outlines
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import DEEP_MM, Wanted, band, flattened, gouge_mm, left_mm, reachable, rows_of, swept

TOLERANCE_MM = 0.01
ERROR_MM = 0.0025  # of the judges, the writer's rounding included
SIDES = ("outside", "inside", "outside", "inside", "on")
CORNER_RAD = np.radians(3.0)  # where the wall turns less, less than the tolerance stays


@dataclass(frozen=True)
class Case:
    outlines: Outlines
    side: str
    leave_mm: float
    operation: Contour

    @property
    def clear_mm(self) -> float:
        return self.outlines.tool_mm / 2.0 + self.leave_mm


def closed_case(seed: int) -> Case:
    """Return a contour with some of all that there is."""
    rng = np.random.default_rng(seed)
    side = SIDES[int(rng.integers(len(SIDES)))]
    outlines = random_outlines(seed, rng, side)
    leave_mm = float(rng.choice([0.0, 0.0, 0.2])) if side != "on" else 0.0
    operation = contour(rng, outlines.curves, side, outlines.tool_mm, leave_mm)
    return Case(outlines, side, leave_mm, operation)


def contour(rng: np.random.Generator, curves, side: str, tool_mm: float, leave_mm: float) -> Contour:
    leads = [
        {"kind": "none"},
        {"kind": "arc", "radius_mm": float(rng.uniform(0.3, 4)), "angle_deg": float(rng.choice([90, 45, 150]))},
        {"kind": "line", "length_mm": float(rng.uniform(0.3, 6)), "angle_deg": float(rng.choice([90, 30]))},
    ]
    values: dict[str, Any] = {
        "depth_mm": 4.0,
        "stepdown_mm": float(rng.choice([4.0, 1.9])),
        "direction": str(rng.choice(["climb", "conventional"])),
        "stock_to_leave_mm": leave_mm,
        "finish_stepover_mm": float(rng.choice([0.0, 0.0, 0.1 * tool_mm])),
        "ramp_deg": float(rng.choice([0.0, 0.0, 5.0])),
        "lead_in": leads[int(rng.integers(3))],
        "lead_out": leads[int(rng.integers(3))],
    }
    if side in ("inside", "outside", "on"):
        values["overcut_mm"] = float(rng.choice([0.0, 0.5, 1.3 * curves[0].lengths_mm[0]]))
    if side in ("inside", "outside"):
        values["dogbones"] = str(rng.choice(["none", "none", "corner", "side"]))
    if side == "on":
        values |= {"finish_stepover_mm": 0.0, "lead_in": leads[0], "lead_out": leads[0]}
    if rng.random() < 0.3:
        values["tabs"] = {"count": 2, "width_mm": float(rng.uniform(0.5, 2.0)), "height_mm": 1.0}
    return Contour(tool=1, curves=curves, side=side, tolerance_mm=TOLERANCE_MM, **values)


def tried(operation: Contour, tool_mm: float) -> Verdict | CycleError:
    try:
        return judged(operation, tool(tool_mm), stock_round(operation, tool_mm))
    except CycleError as error:
        return error


def stock_round(operation: Contour, tool_mm: float) -> Stock:
    """Return stock with room for the cut and its leads."""
    far_mm = max(float(np.abs(curve.box_mm).max()) for curve in operation.curves) + 2.0 * tool_mm + 12.0
    return Stock((2.0 * far_mm, 2.0 * far_mm, operation.depth_mm + 1.0))


def scrap_of(case: Case) -> BaseGeometry:
    """Return what may be cut: beside the part, or within the outlines, without the stock to leave."""
    part = enclosed(case.outlines.curves)
    box = shapely.box(*(np.array(part.bounds) + np.array([-1, -1, 1, 1]) * (3 * case.outlines.tool_mm + 30)))
    scrap = box.difference(part) if case.side == "outside" else part
    return scrap.difference(band(scrap, case.leave_mm)) if case.leave_mm else scrap


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_contour_cuts_all_of_its_scrap_and_nothing_else(seed: int) -> None:
    case = closed_case(seed)
    found = tried(case.operation, case.outlines.tool_mm)
    if isinstance(found, CycleError):
        assert found.advice and found.code in ("tool-wide", "lead-room", "tab-room", "overcut-long"), found
        return
    check(case, found, left=seed % 4 == 0)


def check(case: Case, found: Verdict, left: bool) -> None:
    """Assert what both judges say of a closed contour; of what is left the second one is asked when `left` says so."""
    assert [fault for fault in found.faults if "not-exact" not in fault] == []
    assert max(found.gouge_mm, found.left_mm) <= TOLERANCE_MM + 0.001
    if case.side == "on":
        check_on_line(case.operation, found, case.outlines.tool_mm / 2.0)
        return
    radius_mm, scrap = case.outlines.tool_mm / 2.0, scrap_of(case)
    may_go = scrap if case.operation.dogbones == "none" else scrap.union(relief_room(scrap, radius_mm))
    assert gouge_mm(found.toolpath, radius_mm, [Wanted(may_go, -4.0)]) <= TOLERANCE_MM + ERROR_MM
    if left:
        bottom_mm = -3.0 if case.operation.tabs else -4.0
        cut = swept(found.toolpath, radius_mm, bottom_mm)
        assert left_mm(beside(case, scrap, radius_mm), cut) <= TOLERANCE_MM + ERROR_MM


def check_on_line(operation: Contour, found: Verdict, radius_mm: float) -> None:
    """Assert that the tool is on its lines wherever it is below the top, and that these are cut along."""
    chords = flattened(rows_of(found.toolpath, -DEEP_MM))
    places = np.concatenate([chords.begin, chords.end, (chords.begin + chords.end) / 2.0])
    xy = np.column_stack([places.real, places.imag])
    assert np.min([curve.distances_mm(xy) for curve in operation.curves], axis=0).max() <= TOLERANCE_MM + ERROR_MM
    cut = swept(found.toolpath, radius_mm, -3.0 if operation.tabs else -4.0)
    assert all(cut.covers(shapely.simplify(shapely.LineString(curve.points(1e-4)), 1e-3)) for curve in operation.curves)


def relief_room(scrap: BaseGeometry, radius_mm: float) -> BaseGeometry:
    """Return where dog-bones may reach: two tools from the scrap's sharp corners and from where its rims touch."""
    rings = [
        ring for each in shapely.get_parts(scrap) for ring in shapely.get_rings(shapely.geometry.polygon.orient(each))
    ]
    rims = [place for ring in rings for place in np.round(shapely.get_coordinates(ring)[:-1] @ (1, 1j), 6)]
    found, counts = np.unique(rims, return_counts=True)
    corners = found[counts > 1].tolist()
    for ring in rings:
        places = shapely.get_coordinates(ring)[:-1] @ (1, 1j)
        turns = np.angle((np.roll(places, -1) - places) / (places - np.roll(places, 1)))
        corners += places[turns > CORNER_RAD].tolist()
    return shapely.union_all([shapely.Point(place.real, place.imag).buffer(4.0 * radius_mm) for place in corners])


def beside(case: Case, scrap: BaseGeometry, radius_mm: float) -> BaseGeometry:
    """Return the scrap within the tool's diameter of the wall that the tool can reach."""
    near = band(enclosed(case.outlines.curves), case.leave_mm + 2.0 * radius_mm - TOLERANCE_MM)
    return reachable(scrap, radius_mm).intersection(near)


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_open_contour_keeps_its_distance(seed: int) -> None:
    operation, tool_mm = open_case(seed)
    found = tried(operation, tool_mm)
    rim = touched(operation, tool_mm / 2.0)
    if isinstance(found, CycleError):
        assert found.code in ("lead-room", "tab-room") or (found.code == "tool-wide" and not len(rim)), found
        return
    assert [fault for fault in found.faults if "not-exact" not in fault] == []
    assert max(found.gouge_mm, found.left_mm) <= TOLERANCE_MM + 0.001
    if operation.side == "on":
        check_on_line(operation, found, tool_mm / 2.0)
        return
    cut = swept(found.toolpath, tool_mm / 2.0, -3.0 if operation.tabs else -4.0)
    drawn = shapely.LineString(operation.curves[0].points(1e-4))
    assert abs(shapely.distance(cut, drawn) - operation.stock_to_leave_mm) <= TOLERANCE_MM + ERROR_MM
    assert shapely.distance(cut, shapely.points(rim)).max() <= TOLERANCE_MM + ERROR_MM


def open_case(seed: int) -> tuple[Contour, float]:
    """Return a contour along an open line, and the tool's diameter."""
    rng = np.random.default_rng(10_000 + seed)
    side, tool_mm = str(rng.choice(["left", "right", "on"])), round(float(rng.uniform(0.5, 8.0)), 3)
    line, leave_mm = random_line(rng), float(rng.choice([0.0, 0.3]))
    if side == "on":
        keys: dict[str, Any] = {"depth_mm": 4.0, "stepdown_mm": 1.9, "ramp_deg": seed % 2 * 5.0}
        return Contour(tool=1, curves=(line,), side="on", tolerance_mm=TOLERANCE_MM, **keys), tool_mm
    return contour(rng, (line,), side, tool_mm, leave_mm), tool_mm


def touched(operation: Contour, radius_mm: float) -> np.ndarray:
    """Return where the rim of a tool comes to be that is held against the line wherever it fits, float64[n, 2]."""
    line: Curve = operation.curves[0]
    places, along = line.at_length((np.arange(400) + 0.5) * line.length_mm / 400)
    out = np.column_stack([-along[:, 1], along[:, 0]]) * (1.0 if operation.side == "left" else -1.0)
    far_mm = radius_mm + operation.stock_to_leave_mm
    fits = line.distances_mm(places + far_mm * out) > far_mm - 1e-6
    return (places + operation.stock_to_leave_mm * out)[fits]


@pytest.mark.slow
def test_the_generator_tries_what_is_hard() -> None:
    seeds = range(1, 101)
    cases = [closed_case(seed) for seed in seeds]
    share = [case.outlines.tool_mm / case.outlines.narrowest_mm for case in cases]
    assert min(share) < 0.2 and max(share) > 0.85
    kinds = [case.outlines.layout for case in cases]
    assert min(kinds.count(kind) for kind in ("nested", "deep", "neighbours", "sliver")) >= 10
    assert 30 <= sum(case.side == "inside" for case in cases) <= 60
    on_line = [case.operation for case in cases if case.side == "on"]
    assert sum(operation.overcut_mm > operation.curves[0].lengths_mm[0] for operation in on_line) >= 5
    boned = [case.operation for case in cases if case.operation.dogbones != "none"]
    assert sum(operation.ramp_deg > 0 and operation.overcut_mm > 0 for operation in boned) >= 5


@pytest.mark.slow
def test_few_open_contours_are_refused() -> None:
    refused, seeds = 0, range(1, 31)
    for operation, tool_mm in map(open_case, seeds):
        try:
            cut(operation, tool(tool_mm))
        except CycleError:
            refused += 1
    assert refused <= 0.3 * len(seeds)


@pytest.mark.slow
def test_few_are_refused_and_many_collapse() -> None:
    """At most 30 % refusals; in at least 10 % the tool's path has fewer or more loops than the wall."""
    refused, collapsed, seeds = 0, 0, range(1, 31)
    for case in map(closed_case, seeds):
        try:
            _, answer = cut(case.operation, tool(case.outlines.tool_mm))
        except CycleError as error:
            refused, collapsed = refused + 1, collapsed + (error.code == "tool-wide")
        else:
            part = shapely.get_parts(enclosed(case.outlines.curves))
            collapsed += int(answer.figures["contours"]) != sum(1 + len(each.interiors) for each in part)
    assert refused <= 0.3 * len(seeds) and collapsed >= 0.1 * len(seeds)


@pytest.mark.slow
def test_a_plain_contour_with_a_hole() -> None:
    case = closed_case(1)
    found = tried(case.operation, case.outlines.tool_mm)
    assert isinstance(found, Verdict)
    check(case, found, left=True)
