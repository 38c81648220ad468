# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two programs are compared by their motion: how it is written makes no difference, where it goes does."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from CNCStepper.job.comparison.compare_programs import (
    ComparedProgram,
    ProgramComparison,
    compare_programs,
    report_of,
    rows,
    sentences,
)
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import tool_from_text
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock

PLATE = """G21 G90
M3 S1000
G0 X0 Y0 Z5
G1 Z-1 F100
G1 X40 F300
G1 Y20
G3 X30 Y30 I-10 J0
G1 X0
G1 Y0
G0 Z5
M5
M2
"""
INCHES = """(the same in inches, counted on, with numbers)
N10 G20 G91
N20 M3 S1000
N30 G90 G0 X0 Y0 Z0.19685
N40 G91 G1 Z-0.23622 F3.937
N50 X0.787402 F11.811
N55 X0.787402
N60 Y0.787402
N70 G3 X-0.393701 Y0.393701 I-0.393701
N80 G1 X-1.181102
N90 Y-1.181102
N95 G0 Z0.23622
M2
"""


def chords(count: int = 60) -> str:
    angles = np.linspace(0, math.pi / 2, count + 1)[1:]
    return "".join(f"G1 X{30 + 10 * math.cos(a):.4f} Y{20 + 10 * math.sin(a):.4f}\n" for a in angles)


def compared(first: str, second: str, **more) -> ProgramComparison:
    return compare_programs(ComparedProgram("a.nc", first), ComparedProgram("b.nc", second), **more)


@pytest.mark.parametrize(
    "other",
    [
        PLATE,
        PLATE.replace("\n", " (again)\n").replace("G1 Y20", "Y20"),
        PLATE.replace("G3 X30 Y30 I-10 J0\n", chords()),
        PLATE.replace("G1 Y0\n", "G1 Y17\nY3\nY0\n"),
        INCHES,
    ],
    ids=["identical", "comments", "chords", "divided", "inches"],
)
def test_how_a_path_is_written_is_no_difference(other: str) -> None:
    found = compared(PLATE, other)
    assert found.paths.same, list(sentences(found))
    assert found.paths.deviation is None
    assert list(sentences(found)) == ["the motion is the same"]
    assert sum(judged.length_mm(cuts, False) for judged in (found.paths.first, found.paths.second)
               for cuts in (True, False)) == 0  # fmt: skip


def test_coarse_chords_are_another_path_where_they_leave_the_arc() -> None:
    found = compared(PLATE, PLATE.replace("G3 X30 Y30 I-10 J0\n", chords(3)))
    sagitta_mm = 10 * (1 - math.cos(math.pi / 12))
    assert found.paths.deviation is not None
    assert found.paths.deviation.distance_mm == pytest.approx(sagitta_mm, abs=0.01)
    assert found.lines(found.paths.parting.path) == (7, 7)


def test_a_shifted_program_differs_by_its_shift() -> None:
    moved = PLATE.replace("X40", "X40.5").replace("X30", "X30.5").replace("X0", "X0.5")
    shifted = compared(PLATE, moved)
    assert shifted.paths.deviation is not None
    assert shifted.paths.deviation.distance_mm == pytest.approx(0.5, abs=0.01)
    assert "the tool paths differ" in list(sentences(shifted))


def test_one_changed_move_is_found_with_its_lines_and_its_lengths() -> None:
    found = compared(PLATE, PLATE.replace("G1 X0\n", "G1 X10\nX0 Y26\n"))
    report = report_of(found)
    assert report["first_difference"] == {"path": (8, 9), "feed": None, "mode": None}
    first, second = report["programs"]
    assert first["cut_only_here_mm"] == pytest.approx(10 + 4, abs=0.2)
    assert second["cut_only_here_mm"] == pytest.approx(math.hypot(10, 4), abs=0.2)
    assert first["cut_common_mm"] == pytest.approx(6 + 40 + 20 + 5 * math.pi + 20 + 26, abs=0.3)
    worst = found.paths.deviation
    assert worst is not None and worst.first and worst.line in (8, 9)
    assert worst.place_mm == pytest.approx((0, 30, -1), abs=0.1)
    assert worst.distance_mm == pytest.approx(10 * 4 / math.hypot(10, 4), abs=0.1)
    json.dumps(report, allow_nan=False)


def test_another_feed_speed_tool_or_order_goes_to_the_same_places() -> None:
    feed = compared(PLATE, PLATE.replace("F300", "F310"))
    assert feed.paths.same_places and not feed.paths.same
    assert feed.lines(feed.paths.parting.feed) == (5, 5) and feed.paths.parting.path is None
    speed = compared(PLATE, PLATE.replace("S1000", "S1200"))
    assert speed.paths.same_places and speed.lines(speed.paths.parting.mode) == (4, 4)
    back = PLATE.replace("G1 X40 F300\nG1 Y20\nG3 X30 Y30 I-10 J0\nG1 X0\nG1 Y0\n",
                         "G1 Y30 F300\nG1 X30\nG2 X40 Y20 I0 J-10\nG1 Y0\nG1 X0\n")  # fmt: skip
    order = compared(PLATE, back)
    assert order.paths.same_places and order.lines(order.paths.parting.path) == (5, 5)
    longer = compared(PLATE, PLATE.replace("G0 Z5\nM5", "G0 Z5\nG0 X9 Y9\nM5"))
    assert longer.lines(longer.paths.parting.path) == (0, 11)
    assert any("the end of a.nc" in each for each in sentences(longer))


def test_a_rapid_is_no_cut() -> None:
    found = compared(PLATE, PLATE.replace("G1 Y20\n", "G0 Y20\n"))
    assert found.lines(found.paths.parting.path) == (6, 6)
    assert found.paths.second.length_mm(False, False) == pytest.approx(20)
    assert found.paths.first.length_mm(True, False) == pytest.approx(20, abs=0.2)


def test_a_lathe_program_is_compared_in_its_plane() -> None:
    text = "G18 G7 G21 G90\nG0 X60 Z5\nX50\nG1 Z-40 F200\nX60\nG0 Z5\nM2\n"
    words = {"same_mm": 0.01}
    first, second = (ComparedProgram(name, each, "linuxcnc") for name, each in
                     (("a.ngc", text), ("b.ngc", text.replace("X50", "X50.4"))))  # fmt: skip
    found = compare_programs(first, second, **words)
    assert found.paths.deviation is not None
    assert found.paths.deviation.distance_mm == pytest.approx(0.2, abs=1e-6)  # the radius
    assert compare_programs(first, first, **words).paths.same


def test_figures_times_and_parts_are_side_by_side() -> None:
    stock, tool = Stock((50.0, 40.0, 8.0), "top-left-front"), tool_from_text("flat:3")
    deeper = PLATE.replace("Z-1", "Z-1.5")
    cut = {"machine": load_machine("table-a"), "part_of": lambda program, path: height_map(path, tool, stock)}
    found = compared(PLATE, deeper, **cut)
    assert found.part is not None
    assert found.part.deepest_mm == pytest.approx(0.5)
    assert found.part.only_first_mm3 == 0
    shown = {name: values for name, *values in rows(found)}
    assert shown["Z"] == ["-1 … 5 mm", "-1.5 … 5 mm"]
    assert shown["tools"] == ["T0", "T0"]
    assert shown["feed"] == ["100 … 300 mm/min"] * 2
    assert shown["removed only here"][0] == "0.000 cm³" != shown["removed only here"][1]
    assert found.times_s is not None and found.times_s[1] > found.times_s[0] > 20
    same = compared(PLATE, PLATE, **cut)
    assert "the simulated parts are the same" in list(sentences(same))


def test_random_paths_are_the_same_as_themselves_and_not_as_others() -> None:
    seed = 20261129
    random = np.random.default_rng(seed)
    places = np.round(random.uniform(-50, 50, (400, 3)), 3)
    text = "G21 G90 F500\nG0 X0 Y0 Z0\n" + "".join(f"G1 X{x} Y{y} Z{z}\n" for x, y, z in places.tolist())
    assert compared(text, text).paths.same, f"seed {seed}"
    row = int(random.integers(50, 350))
    lines = text.splitlines(keepends=True)
    x, y, z = places[row].tolist()
    lines[row + 2] = f"G1 X{x + 0.2:.3f} Y{y} Z{z}\n"
    found = compared(text, "".join(lines))
    assert found.lines(found.paths.parting.path) == (row + 3, row + 3), f"seed {seed}"
    assert found.paths.deviation is not None, f"seed {seed}"
    assert 0.02 < found.paths.deviation.distance_mm <= 0.2 + 1e-9, f"seed {seed}"
