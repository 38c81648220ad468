# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window asks about programs on the work surface; its program is that of `cncstepper arrange`, byte for byte."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.errors import JobError
from CNCStepper.job.editing.arrange_question import answer_of
from CNCStepper.job.nesting.nest_data import unpacked_order

SQUARE = "G21 G90 G17\nM3 S1000\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F200\nG1 X20 F600\nG1 Y10\nG1 X0\nG1 Y0\nG0 Z5\nM5\nM2\n"
RING = "G21 G90 G17\nM3 S1000\nG0 Z5\nG0 X8 Y0\nG1 Z-1 F200\nG2 X8 Y0 I-8 J0 F500\nG0 Z5\nM5\nM2\n"


@pytest.fixture
def files(tmp_path: Path) -> list[Path]:
    paths = [tmp_path / "square.nc", tmp_path / "ring.nc"]
    for path, text in zip(paths, (SQUARE, RING), strict=True):
        path.write_text(text, encoding="utf-8")
    return paths


def asked(verb: str, files: list[Path], parts: list[list[Any]], out: Path, **more: Any) -> dict[str, Any]:
    programs = [{"file": str(files[0]), "count": 2}, {"file": str(files[1]), "count": 1}]
    told = {"programs": programs, "size_mm": [200.0, 100.0], "gap_mm": 5.0, "radius_mm": 1.0, "turn": False}
    return {"verb": verb, "parts": parts, **told, "dialect": "grbl", "machine": None, "file": str(out), **more}


def test_copies_by_hand_are_the_program_of_the_command_line(tmp_path: Path, files: list[Path]) -> None:
    rows = [[0, 0, 10.0, 10.0, 0.0, False], [0, 1, 90.5, 40.0, 0.0, True], [0, 0, 60.0, 12.345, 33.0, False]]
    answer = answer_of(asked("write", files, rows, tmp_path / "window.nc"))
    assert answer["written"] and answer["parts"] == rows
    places = ["--at", "10,10", "--at", "60,12.345,33", "--at", "90.5,40"]
    given = ["arrange", *map(str, files), "--count", "2", "--count", "1", *places, "--diameter", "2"]
    done = CliRunner().invoke(group, [*given, "-o", str(tmp_path / "terminal.nc")])
    assert done.exit_code == 0, done.output
    assert (tmp_path / "window.nc").read_bytes() == (tmp_path / "terminal.nc").read_bytes()


def test_copies_are_placed_filled_and_locked_ones_stay(tmp_path: Path, files: list[Path]) -> None:
    locked = [0, 1, 150.0, 60.0, 0.0, True]
    answer = answer_of(asked("search", files, [locked], tmp_path / "no.nc"))
    assert locked in answer["parts"] and sorted(row[1] for row in answer["parts"]) == [0, 0, 1]
    filled = answer_of(asked("fill", files, answer["parts"], tmp_path / "no.nc", item=1))
    assert len(filled["parts"]) > 10 and not (tmp_path / "no.nc").exists()
    items, sheets, spacing = unpacked_order(filled["order"])
    assert len(items) == 2 and sheets[0].outline.bounds == (0, 0, 200, 100) and spacing.gap_mm == 5.0
    answer_of(asked("write", files, filled["parts"], tmp_path / "all.nc"))
    assert (tmp_path / "all.nc").read_text("utf-8").count("(begin operation") == len(filled["parts"])


def test_copies_that_cut_into_each_other_are_refused(tmp_path: Path, files: list[Path]) -> None:
    rows = [[0, 0, 10.0, 10.0, 0.0, False], [0, 0, 15.0, 10.0, 0.0, False]]
    with pytest.raises(JobError, match="cut into each other"):
        answer_of(asked("write", files, rows, tmp_path / "bad.nc"))
    assert not (tmp_path / "bad.nc").exists()
