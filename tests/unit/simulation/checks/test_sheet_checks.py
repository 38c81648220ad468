# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pierces, kerfs and free pieces of a sheet: each program that must be refused has a near twin that must pass."""

from dataclasses import replace

import pytest
import shapely

from CNCStepper.machine.processes import PROCESSES
from CNCStepper.simulation.exact import sheet_cuts
from CNCStepper.simulation.stock import Stock
from helpers.simulation.torch_programs import DATA, LASER, Cut, Plate, hole, square, square_part, text_of

HOLE, OUTLINE = hole(75, 75, 6), square(60, 60, 30)
PART = square_part(60, 60, 30, [(75, 75, 6)])
PLATE = Plate(parts=[PART])


def test_hole_then_outline_is_clean() -> None:
    assert [str(one) for one in PLATE.findings(text_of((HOLE, OUTLINE)))] == []


def test_a_hole_behind_its_outline_is_refused() -> None:
    text = text_of((OUTLINE, HOLE))
    assert PLATE.codes(text) == {"piece-free"}
    (found,) = [one for one in PLATE.findings(text) if one.code == "piece-free"]
    assert "line 14" in found.text and "outline" in found.advice  # of the last side
    assert text.splitlines()[13] == "G1 X75.0000 Y59.2500"
    assert shapely.Point(75, 75).distance(shapely.Point(found.place_mm)) < 6
    assert Plate().codes(text) == {"piece-free"}  # without knowing the parts


def test_an_outline_that_does_not_close_holds_the_piece() -> None:
    tab = [*OUTLINE.blocks[:-2], "G1 X80 Y59.25"]
    assert Plate().codes(text_of((replace(OUTLINE, blocks=tab), HOLE))) == set()
    nearly = [*OUTLINE.blocks[:-2], "G1 X76.4 Y59.25"]  # within the kerf of the begin
    assert Plate().codes(text_of((replace(OUTLINE, blocks=nearly), HOLE))) == {"piece-free"}


@pytest.mark.parametrize(
    ("pierce", "code"),
    [((75.0, 57.0), None), ((75.0, 60.5), "pierce-on-part"), ((75.0, 59.5), "pierce-on-part"), ((74.0, 75.0), None)],
)
def test_a_pierce_on_the_part_is_refused(pierce, code) -> None:
    cut = replace(OUTLINE, pierce_mm=pierce) if pierce[1] < 70 else replace(HOLE, pierce_mm=pierce)
    text = text_of((HOLE, cut) if pierce[1] < 70 else (cut, OUTLINE))
    assert (PLATE.codes(text) & {"pierce-on-part"}) == ({code} if code else set())
    assert PLATE.codes(text) <= {"pierce-on-part", "cut-in-part"}


def test_a_pierce_nearer_than_the_charts_lead_in_is_a_warning() -> None:
    near = replace(OUTLINE, pierce_mm=(75.0, 58.5))
    assert PLATE.codes(text_of((HOLE, near)), "warning") == {"pierce-near-part"}
    assert PLATE.codes(text_of((HOLE, near))) == set()


@pytest.mark.parametrize(("gap_mm", "refused"), [(0.5, True), (0.9, False), (-0.75, True)])
def test_a_pierce_on_or_near_an_edge_that_is_cut_is_refused(gap_mm: float, refused: bool) -> None:
    right_edge = 60 + 30 + 1.5
    across = Cut((right_edge + gap_mm, 80.0), [f"G1 X{right_edge + gap_mm + 20:.3f} Y80"])
    assert Plate().codes(text_of((OUTLINE, across))) == ({"pierce-on-edge"} if refused else set())


def test_passes_of_a_laser_begin_where_the_ones_before_did() -> None:
    twice = text_of((OUTLINE, OUTLINE))
    assert Plate(process=PROCESSES["laser"], machine=LASER, data=None).codes(twice) == set()
    assert Plate(data=None).codes(twice) == {"pierce-on-edge"}


def test_a_lead_through_the_part_is_refused() -> None:
    turned = replace(OUTLINE, pierce_mm=(75.0, 64.0))
    found = [one for one in PLATE.findings(text_of((HOLE, turned))) if one.code == "cut-in-part"]
    assert [one.text for one in found] == ["a lead or a cut goes through a part"]
    long_out = [*OUTLINE.blocks[:-1], "G1 X75 Y62"]
    assert "cut-in-part" in PLATE.codes(text_of((HOLE, replace(OUTLINE, blocks=long_out))))


def test_a_kerf_beyond_the_drawing_is_refused() -> None:
    inside = square(60.1, 60, 30)
    found = [one for one in PLATE.findings(text_of((HOLE, inside))) if one.code == "cut-in-part"]
    assert [one.text for one in found] == ["the kerf goes beyond the drawing into a part"]
    assert found[0].value == pytest.approx(0.1, abs=1e-3)
    assert PLATE.codes(text_of((HOLE, square(60.01, 60, 30)))) == set()


def test_less_than_a_kerf_between_two_cuts_is_a_warning() -> None:
    thin = square_part(60, 60, 30, [(67, 75, 6)])  # 1 mm beside its edge
    text = text_of((hole(67, 75, 6), OUTLINE))
    (found,) = Plate(parts=[thin]).findings(text)
    assert (found.severity, found.code, found.limit) == ("warning", "thin-part", 1.5)
    assert found.value == pytest.approx(1.0, abs=0.03)
    wide = square_part(60, 60, 30, [(68, 75, 6)])
    assert Plate(parts=[wide]).findings(text_of((hole(68, 75, 6), OUTLINE))) == []


def strip(x: float) -> Cut:
    return Cut((x, -5.0), [f"G1 X{x} Y155"])


def test_a_strip_cut_off_the_sheet_may_be_cut_again_with_a_warning() -> None:
    text = text_of((strip(40.0), hole(20, 40, 6)))
    assert (Plate().codes(text), Plate().codes(text, "warning")) == (set(), {"piece-free", "head-over-piece"})
    assert Plate().findings(text_of((hole(20, 40, 6), strip(40.0)))) == []


def test_a_part_at_the_sheets_edge_is_a_part() -> None:
    corner = Cut((44.0, -5.0), ["G1 X44 Y40.75", "G1 X-5 Y40.75"])
    part = square_part(0, 0, 43.25, [(20, 20, 6)]).intersection(shapely.box(0, 0, 43.25, 40))
    plate = Plate(parts=[part])
    assert plate.codes(text_of((corner, hole(20, 20, 6)))) == {"piece-free"}
    assert plate.codes(text_of((hole(20, 20, 6), corner))) == set()


def test_common_line_cuts_free_both_parts_at_once() -> None:
    around = square(60, 60, 30)
    across = Cut((75.0, 55.0), ["G1 X75 Y95"])
    assert "piece-free" in Plate(data=None).codes(text_of((around, across)))
    inner = Cut((75.0, 65.0), ["G1 X75 Y59.25", "G1 X75 Y90.75"])
    assert "piece-free" not in Plate(data=None).codes(text_of((inner, around)))


def test_the_head_goes_over_free_pieces_only_when_it_is_lifted() -> None:
    far = square(150, 60, 8)
    low = replace(OUTLINE, travel_mm=1.8)
    high = replace(OUTLINE, travel_mm=20)
    over = Cut((75.0, 110.0), ["G1 X80 Y110"])  # beyond the part, seen from its lead-out
    assert Plate().codes(text_of((far, low, over))) == {"head-over-piece"}
    text = text_of((replace(OUTLINE, travel_mm=10), over))
    (found,) = Plate().findings(text)
    assert (found.severity, found.code, found.value, found.limit) == ("warning", "head-over-piece", 10.0, 15.0)
    assert Plate().findings(text_of((high, over))) == []
    assert Plate().findings(text_of((OUTLINE, far))) == []  # goes beside it
    water = Plate(process=PROCESSES["hot-wire"], data=None)
    assert "head-over-piece" not in water.codes(text, "warning")


def test_a_head_that_is_never_lifted_is_not_refused_for_it() -> None:
    lines = "G21 G90\nG0 X{0} Y{1}\nM3 S900\nG1 X{0} Y{2} F3000\n"
    box = "G1 X90\nG1 Y90\nG1 X60\nG1 Y60\nG1 X75\nM5\nG0 X75 Y110\nM3\nG1 X80\nM5\nM2\n"
    laser = Plate(process=PROCESSES["laser"], machine=LASER, data=None)
    found = laser.findings(lines.format(75, 55, 60) + box)
    assert {(one.severity, one.code) for one in found if one.code != "position-unknown"} == {
        ("info", "head-over-piece")
    }


def test_a_wide_piece_lies_on_three_slats_and_stays() -> None:
    sheet = Stock((380, 380, 3), "top-left-front")
    back = Cut((175.0, 300.0), ["G1 X180 Y300"])
    assert Plate(stock=sheet).codes(text_of((square(100, 100, 140), back)), "warning") == {"head-over-piece"}
    assert Plate(stock=sheet).findings(text_of((square(100, 100, 152), back))) == []


def test_a_wire_through_a_part_is_refused() -> None:
    wire = Plate(process=PROCESSES["hot-wire"], data=None, parts=[shapely.box(20, 20, 60, 60)])
    around = "G1 X19.25 F300\nG1 Y60.75\nG1 X60.75\nG1 Y19.25\nG1 X19.25\nG1 Y40\n"
    path = f"G21 G90\nG0 X-10 Y40\nM3 S500\n{around}G1 X-10\nM5\nM2\n"
    assert wire.findings(path) == []
    through = path.replace("G1 Y19.25\nG1 X19.25", "G1 X19.25 Y19.25")
    (found,) = wire.findings(through)
    assert (found.code, found.text) == ("cut-in-part", "the wire goes through a part")


def test_a_wire_cuts_nothing_out_of_a_piece_that_it_has_freed() -> None:
    wire = Plate(process=PROCESSES["hot-wire"], data=None)
    around = "G21 G90\nG0 X-10 Y40\nM3 S500\nG1 X19.25 F300\nG1 Y60.75\nG1 X60.75\nG1 Y19.25\nG1 X19.25\nG1 Y40\n"
    back = "G1 X-10\nM5\nM2\n"
    assert wire.findings(around + back) == []
    assert wire.codes(around + "G1 X40\nG1 X19.25\n" + back) == {"piece-free"}


def test_marking_at_little_power_cuts_nothing_free() -> None:
    data = DATA.model_copy(update={"process": "laser", "power": 1000.0, "pierce_delay_s": 0.0, "lead_in_mm": 0.0})
    laser = Plate(process=PROCESSES["laser"], machine=LASER, data=data)
    mark = replace(OUTLINE, on="M3 S200", delay="")
    assert laser.codes(text_of((mark, replace(HOLE, delay="")))) == set()
    assert laser.codes(text_of((replace(mark, on="M3 S900"), replace(HOLE, delay="")))) == {"piece-free"}


def test_too_long_a_program_is_told_instead_of_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sheet_cuts, "MOST_SEGMENTS", 10)
    assert PLATE.codes(text_of((OUTLINE, HOLE)), "warning") == {"pieces-unknown"}


def test_milling_knows_none_of_these() -> None:
    mill = Plate(process=PROCESSES["milling"], parts=[PART])
    assert not mill.codes(text_of((OUTLINE, replace(HOLE, delay="G4 P9")))) & {
        "piece-free", "power-standing", "pierce-delay", "cut-in-part",
    }  # fmt: skip
