# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper arrange`: places by hand, in a grid and nested; overlaps and travel are refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.errors import CNCStepperError

SQUARE = "G21 G90\nG0 Z5\nM3 S1000\nG0 X0 Y0\nG1 Z-1 F100\nX20 F300\nY10\nX0\nY0\nG0 Z5\nM5\nM2\n"


@pytest.fixture
def square(tmp_path: Path) -> Path:
    path = tmp_path / "square.nc"
    path.write_text(SQUARE, encoding="utf-8")
    return path


def run(*words: object) -> Result:
    return CliRunner().invoke(group, ["arrange", *map(str, words)])


def test_a_grid_is_filled_by_one_program(square: Path, tmp_path: Path) -> None:
    done = run(square, "--grid", "3x2", "--gap", 5, "-o", tmp_path / "sheet.nc")
    assert done.exit_code == 0, done.output
    assert "square.nc at X50.2" in done.output and "6 copies of 1 programs" in done.output
    text = (tmp_path / "sheet.nc").read_text("utf-8")
    assert text.count("(begin operation:") == 6
    again = run(square, "--count", 2, "-o", tmp_path / "sheet.nc")
    assert again.exit_code == 0, "its own program is replaced"


def test_a_program_that_is_read_is_not_written(square: Path) -> None:
    done = run(square, "-o", square)
    assert "--out would write over one of the programs that are read" in str(done.exception)


def test_copies_are_nested_on_a_sheet_or_told(square: Path, tmp_path: Path) -> None:
    done = run(square, "--count", 4, "--sheet", "50,35", "--turn", "--gap", 1, "-o", tmp_path / "sheet.nc")
    assert done.exit_code == 0, done.output
    full = run(square, "--count", 9, "--sheet", "50,35", "--gap", 1, "-o", tmp_path / "full.nc")
    assert isinstance(full.exception, CNCStepperError) and full.exception.code == "arrange-room"


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (("--at", "0,0", "--at", "10,2,45"), "arrange-overlap"),
        (("--count", "2", "--at", "0,0"), ""),
        (("--count", "2", "--grid", "1x1"), "usage"),
        (("--at", "0,0", "--grid", "1x1"), "usage"),
        (("--grid", "1.5x2"), "usage"),
        (("--gap", "-1"), "usage"),
        (("--at", "0;0"), "usage"),
        (("--at", "nan,0"), "usage"),
    ],
)
def test_places_that_cannot_be_are_refused(square: Path, tmp_path: Path, words: tuple[str, ...], code: str) -> None:
    done = run(square, *words, "-o", tmp_path / "sheet.nc")
    if code == "usage":
        assert done.exit_code == 2
    elif code:
        assert isinstance(done.exception, CNCStepperError) and done.exception.code == code
    else:
        assert done.exit_code == 0, "one program takes the places that are given"


def test_a_place_beyond_the_travel_is_refused(square: Path, tmp_path: Path) -> None:
    done = run(square, "--at", "0,0", "--at", "90000,0", "--machine", "table-a", "-o", tmp_path / "sheet.nc")
    assert done.exit_code == 1 and not (tmp_path / "sheet.nc").exists()
