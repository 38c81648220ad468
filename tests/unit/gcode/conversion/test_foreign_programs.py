# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs of other controllers, as CAM makes them, and what makes them programs of a machine's own controller."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.conversion.foreign_programs import conversion_of, converted
from CNCStepper.gcode.wire.read_back import refused_lines

FOREIGN = Path(__file__).parents[3] / "data" / "foreign"
GOOD = sorted(path.name for path in FOREIGN.glob("*.nc") if not path.name.startswith("rotary-moves"))


def text_of(name: str) -> str:
    return (FOREIGN / name).read_text("ascii")


@pytest.mark.parametrize("name", GOOD)
def test_a_cam_program_is_refused_and_its_conversion_is_not(name: str) -> None:
    text = text_of(name)
    assert list(refused_lines(text, None, "grbl", name))
    found = conversion_of(text, "grbl", file=name, tool_length="touch_off")
    assert found is not None and found.tool_change == "pause"
    assert not list(refused_lines(found.made.text, None, "grbl", name))
    assert found.made.text.count("M0\n") == text.count("M6") - (1 if "M6" in text else 0)


def test_an_axis_that_never_turns_is_left_out_with_a_note() -> None:
    found = conversion_of(text_of("rotary-at-rest.nc"), "grbl")
    assert found is not None and "A0" not in found.made.text
    notes = [note for note in found.made.notes if note.what.startswith("left out: A")]
    assert [(note.line, note.times) for note in notes] == [(7, 2)]


def test_real_moves_of_a_rotary_axis_stay_refused_with_the_reason() -> None:
    with pytest.raises(ProgramError, match="more than the axes X, Y and Z") as caught:
        conversion_of(text_of("rotary-moves.nc"), "grbl", file="rotary-moves.nc")
    assert caught.value.place and caught.value.place.line == 9
    with pytest.raises(ProgramError) as caught:
        converted(text_of("rotary-moves.nc"), "grbl", file="rotary-moves.nc")
    assert caught.value.code == "not-convertible" and "X, Y and Z" in caught.value.what


def test_lengths_that_nobody_has_said_are_left_out_only_where_the_operator_zeroes_each_tool() -> None:
    text = text_of("tool-lengths.nc")
    with pytest.raises(ProgramError, match="tool table") as caught:
        conversion_of(text, "grbl", tool_length="table")
    assert caught.value.code == "tool-length"
    found = conversion_of(text, "grbl", tool_length="touch_off")
    assert found is not None and found.tool_length == "touch_off" and "G43" not in found.made.text
    assert "set the Z zero" in found.made.text and any("lengths of tools" in note.what for note in found.made.notes)
    compensated = text.replace("G1 X30", "G41 D1 G1 X30")
    with pytest.raises(ProgramError) as caught:  # a diameter that nobody has said is not taken for 0
        conversion_of(compensated, "grbl", tool_length="touch_off")
    assert caught.value.code in ("tool-diameter", "tool-length")


def test_what_needs_no_conversion_stays_as_it_is() -> None:
    text = "G21 G90\nG0 Z5\nM2\n"
    assert conversion_of(text, "grbl") is None
    assert converted(text, "grbl").text == text and converted(text, "grbl").changes == 0


def test_the_machines_rule_decides_how_tools_are_changed() -> None:
    text = text_of("tool-changes.nc")
    with pytest.raises(ProgramError, match="more than one tool"):
        conversion_of(text, "grbl", tool_change="split")
    found = conversion_of(text_of("rotary-at-rest.nc"), "grblhal", tool_change="m6")
    assert found is not None and found.made.text.count("M6") == 2 and "M0" not in found.made.text


def test_an_error_that_no_dialect_has_is_told_as_the_first_one_says_it() -> None:
    with pytest.raises(ProgramError) as caught:
        conversion_of("G1 X\n", "grbl", file="p.nc")
    assert caught.value.place and caught.value.place.line == 1
