# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a program cuts free of a sheet: which pieces, when, and what cuts into them later."""

import math
import time
from dataclasses import replace

import numpy as np
import pytest
import shapely

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.check_context import CheckContext, Cutting
from CNCStepper.simulation.exact.free_pieces import Freed, freed_pieces, sheet_verdict
from CNCStepper.simulation.exact.sheet_cuts import SheetCuts
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from helpers.simulation.torch_programs import KERF_MM, SHEET, START, TABLE, Cut, beam, hole, square, text_of

PLASMA = PROCESSES["plasma"]


def freed(text: str, stock: Stock | None = SHEET, process=PLASMA) -> Freed:
    subject = CheckContext.of(interpret(text, START), TABLE, "p.nc")
    found = sheet_verdict(subject, Cutting(process), beam(process), stock).freed
    assert found is not None
    return found


def test_hole_and_part_come_free_at_the_lines_that_close_them() -> None:
    text = text_of((hole(75, 75, 6), square(60, 60, 30)))
    slug, part = freed(text).free
    lines = text.splitlines()
    assert lines[slug.line - 1].startswith("G3") and lines[part.line - 1] == "G1 X75.0000 Y59.2500"
    assert part.shape.area == pytest.approx(900 - math.pi * 36, abs=0.6)
    whole = math.pi * (6 - KERF_MM) ** 2
    lead_in = KERF_MM * 4.5 + math.pi * (KERF_MM / 2) ** 2 / 2  # a slot with a round end
    assert slug.shape.area == pytest.approx(whole - lead_in, abs=0.3)
    assert part.centre_mm == pytest.approx((75, 75), abs=0.01)
    assert not part.at_edge and not part.later and not slug.later


@pytest.mark.parametrize("stock", [SHEET, None])
def test_a_cut_into_a_free_piece_is_listed_with_its_row_and_place(stock: Stock | None) -> None:
    found = freed(text_of((square(60, 60, 30), hole(75, 75, 6))), stock).free
    assert len(found) == 1  # the hole's slug falls with the square or later: it is no piece of the sheet any more
    (later,) = found[0].later
    assert shapely.Point(later.place_mm).distance(shapely.Point(75, 75)) <= 6
    assert later.row > found[0].row


def test_a_dividing_line_sets_both_halves_free_and_each_is_one() -> None:
    inner, around = Cut((75.0, 65.0), ["G1 X75 Y59.25", "G1 X75 Y90.75"]), square(60, 60, 30)
    halves = freed(text_of((inner, around))).free
    assert len(halves) == 2 and halves[0].row < halves[1].row  # the round cut passes one half first
    assert [half.shape.area for half in halves] == pytest.approx([14.25 * 30] * 2, abs=0.5)
    together = freed(text_of((around, inner))).free
    assert len(together) == 1 and len(together[0].later) == 1


def test_two_strokes_that_meet_close_a_piece_at_the_later_one() -> None:
    low, high = Cut((60.0, 60.0), ["G1 X90", "G1 Y90"]), Cut((60.0, 61.0), ["G1 Y90", "G1 X90"])
    (piece,) = freed(text_of((low, high))).free
    assert piece.cut == 1 and piece.shape.area == pytest.approx(28.5**2, abs=1.0)
    apart = Cut((60.0, 61.0), ["G1 Y92", "G1 X90"])
    assert freed(text_of((low, apart))).free == []


def test_the_rest_of_a_halved_sheet_is_its_larger_half() -> None:
    (strip,) = freed(text_of((Cut((40.0, -5.0), ["G1 X40 Y155"]),))).free
    assert strip.at_edge and strip.centre_mm[0] < 40
    (strip,) = freed(text_of((Cut((160.0, -5.0), ["G1 X160 Y155"]),))).free
    assert strip.centre_mm[0] > 160


@pytest.mark.parametrize("power", [{"power": 800.0}, {"power_percent": 80.0}])
def test_a_closed_mark_frees_nothing_however_the_chart_says_its_power(power: dict[str, float]) -> None:
    laser = PROCESSES["laser"]
    ring = "G0 X50 Y50\nM3 S{0:g}\nG1 X80 F900\nG1 Y80\nG1 X50\nG1 Y50\nM5\n"
    text = f"G21 G90\n{ring.format(40)}{ring.replace('X50', 'X55').replace('Y50', 'Y55').format(800)}M2\n"
    row = CutData(process="laser", material="plywood", thickness_mm=3.0, feed_mm_min=900.0, kerf_mm=0.2, **power)
    subject = CheckContext.of(interpret(text, START), load_machine("laser-table"), "p.nc")
    found = sheet_verdict(subject, Cutting(laser, row), beam(laser), SHEET).freed
    assert found is not None
    (piece,) = found.free
    assert piece.shape.area == pytest.approx((25.0 - KERF_MM) ** 2, abs=0.5)


def test_a_wires_one_cut_frees_its_pieces_one_after_the_other() -> None:
    one = "G1 X{0} Y40\nG1 Y60\nG1 X{1}\nG1 Y20\nG1 X{0}\nG1 Y40\n"
    text = f"G21 G90\nG0 X-10 Y40\nM3 S500\nF300\n{one.format(20, 40)}G1 Y10\nG1 X60\n"
    text += f"{one.format(60, 90)}M5\nM2\n"
    first, second = freed(text, process=PROCESSES["hot-wire"]).free
    assert first.cut == second.cut == 0 and first.row < second.row
    assert [piece.centre_mm[0] for piece in (first, second)] == pytest.approx([30, 75], abs=1.0)


def test_the_last_cusp_of_a_wires_ring_is_no_cut_into_the_free_piece() -> None:
    for before_mm in np.arange(
        10.0, 16.0, 0.5
    ).tolist():  # so that a piece of the path ends anywhere before the ring's end
        text = f"G21 G90\nG0 X60 Y-{before_mm}\nM3 S500\nF300\nG1 Y40\nG3 X60 Y80 I0 J20\nG3 X60 Y40 I0 J-20\n"
        (piece,) = freed(text + "G1 Y-10\nM5\nM2\n", process=PROCESSES["hot-wire"]).free
        assert piece.later == [] and piece.centre_mm == pytest.approx((60.0, 60.0), abs=0.1)
        found = freed(text + "G1 X60 Y60\nG1 X70\nM5\nM2\n", process=PROCESSES["hot-wire"]).free
        assert any(piece.later for piece in found), "a cut into the piece itself is one"


def test_a_program_in_parts_is_the_same_as_a_whole_one() -> None:
    whole = interpret(text_of((square(60, 60, 30), hole(75, 75, 6), square(120, 60, 20))), START)
    one, other = (SheetCuts(Cutting(PLASMA), beam(), SHEET) for _ in range(2))
    one.see(CheckContext.of(whole, TABLE, ""), np.arange(len(whole)) * 1.0)
    begin = whole.start
    for first in range(0, len(whole), 7):
        part = _rows(whole, begin, first, first + 7)
        other.see(CheckContext.of(part, TABLE, ""), np.arange(first, first + len(part)) * 1.0)
        begin = _after(begin, part)
    first, second = freed_pieces(one), freed_pieces(other)
    assert first is not None and second is not None and len(first.free) == 2
    for a, b in zip(first.free, second.free, strict=True):
        assert (a.row, a.line, a.end_s, a.cut, a.later) == (b.row, b.line, b.end_s, b.cut, b.later)
        assert a.end_s == a.row and a.shape.equals_exact(b.shape, 1e-9)


def _rows(whole: Toolpath, start: Start, first: int, last: int) -> Toolpath:
    table = whole.table()
    columns = {name: getattr(table, name)[first:last] for name in type(table).__dataclass_fields__ if name != "first"}
    return replace(whole, start=start, chunks=[replace(table, first=0, **columns)], frame=whole.states[0])


def _after(start: Start, part: Toolpath) -> Start:
    return replace(start, position_mm=tuple(part.table().end[-1].tolist()))


@pytest.mark.slow
def test_five_hundred_parts_take_about_a_second_and_twice_as_many_twice_as_long() -> None:
    took_s = {}
    for count in (250, 500):
        cuts = [cut for k in range(count) for cut in _nth(k)]
        stock = Stock((25 * 22.0 + 20, (count // 25) * 22.0 + 20, 3), "top-left-front")
        subject = CheckContext.of(interpret(text_of(cuts), START), TABLE, "p.nc")
        begun_s = time.perf_counter()
        found = sheet_verdict(subject, Cutting(PLASMA), beam(), stock).freed
        took_s[count] = time.perf_counter() - begun_s
        assert found is not None and len(found.free) == 2 * count and len(found.pieces) == 2 * count + 1
        assert not any(piece.later for piece in found.free)
    print("500 parts with a hole each", took_s)
    assert took_s[500] < 5.0  # 0.6 s where nothing else runs
    assert took_s[500] < 5 * took_s[250]


def _nth(k: int) -> tuple[Cut, Cut]:
    x, y = 22.0 * (k % 25) + 14, 22.0 * (k // 25) + 14
    return hole(x + 6, y + 6, 4), square(x, y, 12, 3.0)
