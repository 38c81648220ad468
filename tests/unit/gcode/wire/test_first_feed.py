# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is sent of a program without F names the feed with which it was read, once, at its first cut."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.wire_file import WireFile
from CNCStepper.state import Start

LANGUAGE = "grbl:feed=1200"
CASES = {
    "G0 X0 Y0\nM3 S5\nG1 X10\nX20\n": "G1X10F1200",
    "G0 X0 Y0\nG2 X10 I5 J0\nG1 X3 F50\n": "G2X10I5J0F1200",
    "G20\nG0 X0 Y0\nG1 X1\n": "G1X1F47.24409449",
    "G0 X0 Y0\nG20 G1 X1\n": "G20G1X1F47.24409449",
    "G0 X0 Y0\nG1\nX7\n": "G1F1200",
    "G0 X0 Y0\nG80\nG1 X7\n": "G1X7F1200",
}


@pytest.mark.parametrize("text", CASES)
def test_the_first_cut_names_the_feed(text: str) -> None:
    wire = prepare(text, LANGUAGE)
    assert CASES[text] in wire.lines
    assert sum("F1200" in line or "F47" in line for line in wire.lines) == 1
    sent, asked = interpret(wire.text, Start(), "grbl").table(), interpret(text, Start(), LANGUAGE).table()
    assert np.allclose(sent.feed, asked.feed, rtol=1e-9)


@pytest.mark.parametrize("text", ["F50\nG0 X0 Y0\nG1 X5\n", "G0 X0 Y0\nG1 X5 F50\n", "G0 X0 Y0\n"])
def test_a_program_that_names_it_is_sent_as_it_is(text: str) -> None:
    assert prepare(text, LANGUAGE).text == prepare(text, "grbl").text


def test_a_language_whose_feed_is_a_setting_needs_no_f() -> None:
    assert "F" not in prepare("G0 X1 Y0\nG90\nX10\n", "thesis-a:feed=600").text


def test_a_long_file_names_it_where_it_first_cuts(tmp_path: Path) -> None:
    rapids = "".join(f"G0 X{n % 50} Y{n % 70}\n" for n in range(150_000))
    path = tmp_path / "long.nc"
    path.write_text(f"{rapids}G1 X3\nX4 Y1\n", encoding="ascii")
    sent: list[str] = []
    wire = WireFile(path, Start(), LANGUAGE, sink=lambda piece: sent.extend(piece.lines))
    feeds = np.concatenate([chunk.feed for chunk in wire.chunks()])
    assert path.stat().st_size > 1_000_000, "it comes in several pieces"
    assert sent[-2:] == ["G1X3F1200", "X4Y1"]
    assert feeds[-2:].tolist() == [1200.0, 1200.0]


def test_a_line_that_has_no_room_for_it_is_refused() -> None:
    long = "G1X0." + "1" * 34 + "Y0." + "1" * 34
    assert len(long) == 76
    prepare(long, "grbl")
    with pytest.raises(ProgramError, match="does not fit"):
        prepare(long, LANGUAGE)
