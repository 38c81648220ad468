# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the checks of a lathe program find, each with a program that has it and one that has not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.turning.half_section import bar, below_chain
from CNCStepper.simulation.turning.insert_reach import out_of_reach
from CNCStepper.simulation.turning.obstacles import chuck_region, tailstock_region
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_part import turned_part
from CNCStepper.simulation.turning.turning_checks import TurningSetup, check_turning
from CNCStepper.simulation.turning.wanted_profile import gouge, wanted_chain, wanted_ring
from helpers.cycles.seeds import SEEDS
from helpers.simulation.half_section_judge import inside
from helpers.simulation.lathe_moves import cnmg, lathe_path

STOCK = bar(55, 100, 0)
PASS = [("rapid", 5, 26), ("feed", -40, 26), ("feed", -40, 29), ("rapid", 5, 29)]
FINISH = [("rapid", 5, 25), ("feed", -40, 25), ("feed", -40, 29), ("rapid", 5, 29)]
WANTED = wanted_chain(np.array([(0.0, 25.0), (-40.0, 25.0), (-40.0, 27.5)]), tools=(1,), name="shaft")


def found(moves: list[tuple], tool: ToolSection | None = None, **setup) -> dict[str, Finding]:
    """Return the findings by code, but that of a bar that sticks out far."""
    tools = {1: tool or cnmg()}
    whole = TurningSetup(**{"stock": STOCK, "tools": tools, "file": "p.nc", **setup})
    part = turned_part(moves_of(lathe_path(moves)), whole.stock, tools)
    findings = [finding for finding in check_turning(part, whole) if finding.code != "slender"]
    return {finding.code: finding for finding in reversed(findings)}  # the first of each


def test_a_sound_program_has_no_findings() -> None:
    chuck = {"chuck": chuck_region(100, 120)}
    assert found(PASS + FINISH, cnmg(shank_mm=20), wanted=[WANTED], obstacles=chuck) == {}


def test_a_rapid_through_stock_names_its_line_and_depth() -> None:
    one = found([("rapid", 5, 26), ("rapid", -10, 26), ("rapid", -5, 40)])["rapid-in-stock"]
    assert (one.severity, one.place.line) == ("error", 2)
    assert one.value == pytest.approx(1.5, abs=0.1)
    assert one.place_mm is not None and 26 < one.place_mm[0] < 27.5


def test_a_rapid_along_the_cut_surface_is_none() -> None:
    assert "rapid-in-stock" not in found([*PASS[:2], ("rapid", 5, 26)])


@pytest.mark.parametrize(("deeper_mm", "is_found"), [(0.0, False), (0.004, False), (0.006, True), (0.2, True)])
def test_a_gouge_above_five_thousandths_is_found(deeper_mm: float, is_found: bool) -> None:
    moves = [("rapid", 5, 25), ("feed", -20, 25), ("feed", -20.5, 25 - deeper_mm), ("feed", -21, 25), *FINISH[1:]]
    findings = found(PASS + moves, wanted=[WANTED])
    assert ("gouge" in findings) == is_found
    if is_found:
        assert findings["gouge"].value == pytest.approx(deeper_mm, abs=1e-3)
        assert findings["gouge"].place.line == 7


def test_places_are_given_as_the_program_gives_x() -> None:
    findings = found([*PASS, ("rapid", 5, 24), ("feed", -5, 24)], wanted=[WANTED], x_factor=2.0)
    assert findings["gouge"].place_mm == pytest.approx((48, 0, -5), abs=5.1)
    assert findings["gouge"].place_mm[0] < 51


@pytest.mark.parametrize(
    ("leave", "codes"), [({}, {"left-over"}), ({"leave_mm": 1.0}, set()), ({"left_mm": 1.0}, set())]
)
def test_material_left_beyond_the_stock_to_leave(leave: dict, codes: set) -> None:
    findings = found(PASS, wanted=[replace(WANTED, **leave)])
    assert set(findings) == codes
    if codes:
        assert findings["left-over"].value == pytest.approx(1.0, abs=0.01)


def test_a_corner_smaller_than_the_nose_is_out_of_reach_and_no_finding() -> None:
    area = out_of_reach(STOCK.region, STOCK.region.difference(WANTED.to_cut), cnmg()).area
    assert area == pytest.approx(0.64 * (1 - np.pi / 4), rel=5e-3)
    assert found(PASS + FINISH, wanted=[WANTED]) == {}


def test_an_undercut_is_out_of_reach_below_the_back_edge() -> None:
    keep = below_chain([(0, 20), (-20, 20), (-20, 19), (-80, 19), (-80, 27.5), (-100, 27.5)])
    left = out_of_reach(STOCK.region, keep, cnmg())
    behind_mm = 1 / np.tan(np.radians(5))  # the back edge leads from the corner at (-20, 20) down into it
    for share in (0.2, 0.5, 0.8):
        edge = shapely.Point(-20 - behind_mm * share, 20 - share)
        assert edge.distance(left.boundary) < 1e-3
        assert left.contains(shapely.Point(edge.x, edge.y - 0.05))
        assert not left.contains(shapely.Point(edge.x, edge.y + 0.05))


@pytest.mark.parametrize("seed", SEEDS)
def test_out_of_reach_is_what_no_place_of_the_tool_reaches(seed: int) -> None:
    """A random point that is out of reach is covered by no place of the outline that spares the part."""
    random = np.random.default_rng(seed)
    z = -np.cumsum(random.uniform(3, 8, 5))
    chain = np.column_stack([np.concatenate([[0.0], z]), random.uniform(6, 18, 6)])
    stock, tool = shapely.box(-60, 0, 0, 20), ToolSection.of(TurningTool(number=1, insert="DNMG 110404"))
    keep = below_chain([*chain.tolist(), (chain[-1, 0], 20.0), (-60.0, 20.0)]).intersection(stock)
    left = out_of_reach(stock, keep, tool)
    outline = tool.cutting_parts[0]
    points = random.uniform((-35, 6), (0, 20), (25, 2))
    points = points[~shapely.contains_xy(keep, *points.T)]
    corners = shapely.get_coordinates(keep.segmentize(0.1).boundary)
    corners = corners[corners[:, 1] > 0]
    for point in points:
        if min(shapely.Point(point).distance(one) for one in (left.boundary, keep)) < 0.15:
            continue
        is_reached = any(not inside(corners - place, outline).any() for place in point - _filled(outline, random))
        assert not (is_reached and left.contains(shapely.Point(point)))


def _filled(outline: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Return points in an outline: near its nose, where it matters, and its corners."""
    around = outline[random.integers(0, len(outline), 15)]
    return around + (outline.mean(axis=0) - around) * random.uniform(0.02, 0.4, (15, 1)) ** 2


def test_loads_above_the_tools_are_warnings() -> None:
    deep = [("rapid", 5, 24), ("feed", -20, 24), ("feed", -18, 40)]
    tool = cnmg(ap_max_mm=3.0, feed_max_mm_rev=0.15)
    findings = found(deep, tool)
    assert findings["depth-of-cut"].value == pytest.approx(3.5)
    assert findings["depth-of-cut"].limit == 3.0
    assert findings["chip-load"].value == pytest.approx(0.2)
    assert set(found(PASS, tool)) == {"chip-load"}
    assert found(deep, cnmg(ap_max_mm=3.5, feed_max_mm_rev=0.2)) == {}
    assert "chip-load" not in found([("rapid", 5, 28), ("feed", -20, 28)], tool)  # in air


def test_a_holder_that_meets_a_shoulder() -> None:
    moves = [("rapid", 5, 26), ("feed", -20, 26), ("feed", -21, 10), ("feed", -40, 10)]
    assert "holder" not in found(moves, cnmg())
    assert found(moves, cnmg(shank_mm=20))["holder"].place.line in (3, 4)


def test_chuck_jaws_and_tailstock_are_not_to_be_touched() -> None:
    obstacles = {"chuck": chuck_region(100, 120), "jaws": chuck_region(90, 70, 10)}
    far = [("rapid", 5, 26), ("feed", -89, 26), ("rapid", 5, 40)]
    assert "collision" not in found([*far[:2], ("feed", -89, 40), ("rapid", 5, 40)], obstacles=obstacles)
    one = found([("rapid", 5, 26), ("feed", -92, 26)], obstacles=obstacles)["collision"]
    assert (one.place.line, "jaws" in one.text) == (2, True)
    tail = {"tailstock": tailstock_region(0, 20, 60, 6)}
    assert tail["tailstock"].bounds == (0, 0, 200, 10)
    assert "tailstock" in found([("rapid", 5, 5)], obstacles=tail)["collision"].text
    assert found([("rapid", 0.5, 12)], obstacles=tail) == {}


def test_x_past_the_centre_is_refused_with_the_least_that_would_do() -> None:
    facing = [("rapid", -0.5, 30), ("feed", -0.5, -0.8), ("rapid", 5, -0.8)]
    assert found(facing) == {}
    facing[1] = ("feed", -0.5, -3.0)
    one = found(facing, x_factor=2.0)["past-centre"]
    assert (one.value, one.limit) == (pytest.approx(-6), pytest.approx(-2.6))


def test_a_slender_bar_and_a_parted_piece_are_told() -> None:
    tools = {1: ToolSection.of(TurningTool(number=1, kind="parting", width_mm=3, reach_mm=30))}
    stock = bar(20, 100, 0)
    part = turned_part(moves_of(lathe_path([("rapid", -33, 30), ("feed", -33, 0)])), stock, tools)
    findings = {one.code: one for one in check_turning(part, TurningSetup(stock, tools))}
    assert (findings["slender"].value, findings["slender"].limit) == (5, 4)
    assert findings["parted-off"].severity == "info"
    assert "30.000 mm" in findings["parted-off"].text


def test_a_tool_without_a_shape_is_an_error() -> None:
    part = turned_part(moves_of(lathe_path(PASS, tool=7)), STOCK, {1: cnmg()})
    (one,) = [one for one in check_turning(part, TurningSetup(STOCK, {1: cnmg()})) if one.severity == "error"]
    assert (one.code, one.place.line) == ("tool-unknown", 2)


def test_a_bore_is_judged_from_within() -> None:
    profile = wanted_chain(np.array([(0.0, 12.0), (-20.0, 12.0)]), inside=True, tools=(1,))
    drill = ToolSection.of(TurningTool(number=1, kind="drill", diameter_mm=24, point_angle_deg=179))
    moves = [("rapid", 5, 0), ("feed", -21, 0), ("rapid", 5, 0)]
    assert found(moves, drill, wanted=[profile]) == {}
    wide = ToolSection.of(TurningTool(number=1, kind="drill", diameter_mm=24.1, point_angle_deg=179))
    assert found(moves, wide, wanted=[profile])["gouge"].value == pytest.approx(0.05, abs=1e-3)
    part = turned_part(moves_of(lathe_path(moves)), STOCK, {1: wide})
    assert gouge(part.section, STOCK, [profile, wanted_ring((-20, 0), (12, 12.1))]) is None
