# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offset, scale, rotation, mirror image and units: what the new text means is what the map makes of the old meaning."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.transform_verbs import convert_units, mirror, offset, rotate, scale
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from helpers.gcode.edit_programs import random_program

SEEDS = range(60)
PARKED = {5161: 0.0, 5162: 0.0, 5163: -1.0}  # where G28 goes
STEP = {False: 0.001, True: 0.0254 * 0.1}


def work(path: Toolpath) -> np.ndarray:
    """Return the ends in work coordinates."""
    return path.table().end - path.offsets_mm()


def require_mapped(edited: Edited, linear: np.ndarray, shift: np.ndarray, step_mm: float, turned: bool = False) -> None:
    """Every row ends where the map puts it, to the last digit; kinds, feeds, events and lines are those of before."""
    old, new = interpret(edited.before), interpret(edited.text)
    one, other = old.table(), new.table()
    assert len(old) == len(new)
    assert np.array_equal(one.line, other.line)
    assert np.abs(work(old) @ linear.T + shift - work(new)).max() <= 0.5001 * step_mm
    kinds = np.where(one.kind > 1, 5 - one.kind, one.kind) if turned else one.kind
    planes_turned = one.plane != 2 if turned else False
    assert np.array_equal(np.where(planes_turned, kinds, one.kind), other.kind)
    assert np.array_equal(one.feed, other.feed)
    assert [(event.kind, event.text, event.index) for event in old.events] == [
        (event.kind, event.text, event.index) for event in new.events
    ]
    _require_centres(old, new, linear, shift, step_mm)


def _require_centres(old: Toolpath, new: Toolpath, linear: np.ndarray, shift: np.ndarray, step_mm: float) -> None:
    """Centres of arcs are mapped too, as near as rounding of ends and of radii lets them be."""
    table = old.table()
    arcs = np.flatnonzero(table.kind > 1)
    before = (table.centre - old.offsets_mm())[arcs] @ linear.T + shift
    after = (new.table().centre - new.offsets_mm())[arcs]
    normal = np.array([2, 1, 0])[table.plane[arcs]]
    away = np.abs(before - after)
    away[np.arange(len(arcs)), normal] = 0.0
    begin = (old.begins() - old.offsets_mm())[arcs]
    half = np.linalg.norm(begin - (table.end - old.offsets_mm())[arcs], axis=1) / 2
    radius = np.linalg.norm((begin - (table.centre - old.offsets_mm())[arcs])[:, :], axis=1)
    sharp = np.abs(radius - half) > 0.05 * radius  # R on a half circle: the centre goes with the root of the rounding
    assert (away.max(axis=1) <= np.where(sharp, 12 * step_mm, 0.3)).all()


@pytest.mark.parametrize("seed", SEEDS)
def test_offset(seed: int) -> None:
    text = random_program(seed)
    require_mapped(offset(text, 12.5, -3.25, 0.125), np.eye(3), np.array([12.5, -3.25, 0.125]), 0.001)


@pytest.mark.parametrize("seed", SEEDS)
def test_offset_and_back(seed: int) -> None:
    text = random_program(seed)
    back = offset(offset(text, 12.5, -3.25, 7).text, -12.5, 3.25, -7)
    one, other = interpret(text), interpret(back.text)
    assert np.allclose(one.table().end, other.table().end, atol=1e-9)
    assert np.allclose(one.table().centre, other.table().centre, atol=1e-9)
    assert one.states == other.states


@pytest.mark.parametrize("seed", SEEDS)
def test_scale(seed: int) -> None:
    text = random_program(seed)
    require_mapped(scale(text, 1.37), 1.37 * np.eye(3), np.zeros(3), 0.001)
    back = interpret(scale(scale(text, 4).text, 0.25).text)
    assert np.allclose(interpret(text).table().end, back.table().end, atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_scale_about_a_point_and_unevenly_in_z(seed: int) -> None:
    text = random_program(seed, flat_arcs=True)
    edited = scale(text, 2.0, 2.0, 0.5, about_mm=(10.0, 20.0, 0.0))
    require_mapped(edited, np.diag([2.0, 2.0, 0.5]), np.array([-10.0, -20.0, 0.0]), 0.001)


@pytest.mark.parametrize("seed", SEEDS)
def test_rotate(seed: int) -> None:
    text = random_program(seed, flat_arcs=True)
    c, s = np.cos(np.radians(33.0)), np.sin(np.radians(33.0))
    linear = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    about = np.array([5.0, 7.0, 0.0])
    require_mapped(rotate(text, 33.0, (5.0, 7.0)), linear, about - linear @ about, 0.001)


@pytest.mark.parametrize("seed", SEEDS)
def test_four_quarters_are_a_whole_turn(seed: int) -> None:
    text = random_program(seed, flat_arcs=True)
    turned = text
    for _ in range(4):
        turned = rotate(turned, 90.0).text
    one, other = interpret(text).table(), interpret(turned).table()
    assert np.allclose(one.end, other.end, atol=1e-9)
    assert np.allclose(one.centre, other.centre, atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_mirror(seed: int) -> None:
    text = random_program(seed)
    edited = mirror(text, "X", 4.0)
    require_mapped(edited, np.diag([-1.0, 1.0, 1.0]), np.array([8.0, 0.0, 0.0]), 0.001, turned=True)
    one, other = interpret(text), interpret(mirror(edited.text, "x", 4.0).text)
    assert np.array_equal(one.table().kind, other.table().kind)
    assert np.allclose(one.table().end, other.table().end, atol=1e-9)
    assert np.allclose(one.table().centre, other.table().centre, atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_units(seed: int) -> None:
    text = random_program(seed, decimals=4, inch=True)
    edited = convert_units(text, "mm")
    old, new = interpret(text), interpret(edited.text)
    assert np.abs(old.table().end - new.table().end).max() <= 0.5001 * 0.001
    assert np.allclose(old.table().feed, new.table().feed, rtol=1e-3)
    assert all(state.units == "mm" for state in new.states[1:])
    back = interpret(convert_units(edited.text, "inch").text)
    assert np.abs(old.table().end - back.table().end).max() <= 0.0005 + 0.00254 / 2


def test_what_need_not_change_stays_to_the_letter() -> None:
    text = "%\r\nG21 G90 G17\r\n\r\ng1 x 1 0.50 y5 f100 (X1 stays)\r\nG1 Y 6. ;Y6\r\nM2\r\n%"
    edited = offset(text, 1.0)
    assert edited.text == text.replace("x 1 0.50", "x 11.50")
    assert edited.changes == 1
    assert edited.diff("a.nc") == (
        "--- a.nc\n+++ a.nc (edited)\n@@ -3,3 +3,3 @@\n \n-g1 x 1 0.50 y5 f100 (X1 stays)\n"
        "+g1 x 11.50 y5 f100 (X1 stays)\n G1 Y 6. ;Y6\n"
    )


def test_a_turned_line_names_both_coordinates() -> None:
    text = "G21 G90\nG0 X10 Y0\nG1 X20 F100\nY5\n"
    assert rotate(text, 90).text == "G21 G90\nG0 X0 Y10\nG1 X0 Y20 F100\nX-5 Y20\n"


def test_the_machine_s_places_stay() -> None:
    text = "G21 G90\nG53 G0 Z-5\nG0 X1 Y2\nG91 G28 Z0\nG90 X3\n"
    start = Start(work_offsets_mm={"G54": (100.0, 50.0, -60.0)}, zero_known=True, parameters=PARKED)
    assert offset(text, 10.0, 0.0, 4.0, start=start).text == "G21 G90\nG53 G0 Z-5\nG0 X11 Y2\nG91 G28 Z0\nG90 X13\n"


def test_a_missing_unit_word_is_written() -> None:
    text = "(top)\nG0 X25.4\nG1 Y12.7 F254\nM2\n"
    edited = convert_units(text, "inch")
    assert edited.text == "(top)\nG20\nG0 X1\nG1 Y0.5 F10\nM2\n"
    assert edited.origins == (1, 2, 2, 3, 4)


def test_a_zero_set_in_the_work_goes_along() -> None:
    text = "G21 G90\nG0 X10 Y10 Z5\nG92 X0 Y0\nG1 X5 F100\n"
    start = Start.at_zero()
    edited = offset(text, 2.0, 3.0, start=start)
    assert edited.text == "G21 G90\nG0 X12 Y13 Z5\nG92 X2 Y3\nG1 X7 F100\n"
    assert interpret(edited.text, start).table().end[-1].tolist() == [17.0, 13.0, 5.0]


REFUSED = [
    (lambda: scale("G21 G90\nG0 X0 Y0\nG2 X10 Y0 I5 F100\n", 2.0, 1.0), "edit-arc", 3),
    (lambda: rotate("G21 G90\nG0 X0 Y0 Z0\nG18\nG2 X10 Z0 I5 F100\n", 45.0), "edit-arc", 4),
    (lambda: rotate("G21 G90\nG0 X10\n", 45.0), "edit-place", 2),
    (lambda: offset("G21 G91\nG1 X10 F100\n", 5.0, start=Start.at_zero()), "edit-relative", 2),
    (lambda: offset("G21 G90\nG0 X10 Y0 Z0\nG1 @5 ^30 F1\nM2\n", 1.0, dialect="linuxcnc"), "edit-code", 3),
    (lambda: offset("G21 G90\nG0 X10\nM2\n/X11\n", 5.0), "edit-skipped", 4),
    (lambda: scale("G21 G90\nG0 X10 Y0 Z5\nG92 X0\nX5\n", 2.0, start=Start.at_zero()), "edit-zero", 3),
]


@pytest.mark.parametrize(("edit", "code", "line"), REFUSED, ids=[code for _, code, _ in REFUSED])
def test_refused_with_its_place(edit, code: str, line: int) -> None:
    with pytest.raises(ProgramError) as refused:
        edit()
    assert refused.value.code == code
    assert refused.value.place.line == line


@pytest.mark.parametrize("call", [lambda: scale("G0 X1\n", -1.0), lambda: mirror("G0 X1\n", "Z")])
def test_maps_that_are_none(call) -> None:
    with pytest.raises(ProgramError):
        call()


def test_canned_cycles_keep_their_heights_and_pecks() -> None:
    text = "G21 G90 G0 X0 Y0 Z10\nG98 G83 X10 Y5 Z-8 R2 Q3 F100\nX20\nG80\nM2\n"
    moved = offset(text, 1.0, 2.0, 0.5, dialect="linuxcnc")
    assert moved.text == "G21 G90 G0 X1 Y2 Z10.5\nG98 G83 X11 Y7 Z-7.5 R2.5 Q3 F100\nX21\nG80\nM2\n"
    larger = scale(text, 2.0, dialect="linuxcnc")
    assert larger.text == "G21 G90 G0 X0 Y0 Z20\nG98 G83 X20 Y10 Z-16 R4 Q6 F100\nX40\nG80\nM2\n"


def test_feeds_of_inverse_time_stay_when_the_way_grows():
    text = "G21 G90 G94 F100\nG0 X0 Y0 Z0\nG93 G1 X10 F6\nY[1 + 4] F#1\nG94 F200\nX0\nM2\n".replace("F#1", "F[3 * 4]")
    for factor in (2.0, 0.4):
        edited = scale(text, factor, dialect="linuxcnc")
        old, new = interpret(text, dialect="linuxcnc"), interpret(edited.text, dialect="linuxcnc")
        assert new.table().feed[1:] == pytest.approx(old.table().feed[1:], rel=1e-5)
    for moved in (offset(text, 5, dialect="linuxcnc"), rotate(text, 30, dialect="linuxcnc")):
        assert "X" in moved.text and "F6\n" in moved.text
    with pytest.raises(ProgramError) as refused:
        scale(text, 2.0, 2.0, 1.0, dialect="linuxcnc")
    assert refused.value.code == "edit-feed" and refused.value.place.line == 3
