# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's feeds as a drawing, and a drawing that is linked to its file."""

from __future__ import annotations

import math
import os
from pathlib import Path

import pytest

from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.errors import JobError, ProgramError
from CNCStepper.job.drawings.linked_file import has_changed, read_linked
from CNCStepper.job.drawings.read_any import read_any_drawing

PROGRAM = """G21 G90 G17
G0 X0 Y0 Z5
G1 Z-1 F100
G1 X10
G3 X20 Y10 I0 J10
G1 Z-2
G1 Y20
G0 Z5
G0 X40 Y0
G1 Z-2
G2 X40 Y0 I5 J0
G0 Z5
G18 G2 X50 Z5 I5 K0
G17 G1 X60
M2
"""


def test_feeds_become_chains_with_exact_arcs(tmp_path: Path) -> None:
    path = tmp_path / "peça.NC"
    path.write_text(PROGRAM)
    drawing = read_any_drawing(path, ReadOptions())
    named = [(chain.attributes.layer, chain.attributes.name) for chain in drawing.chains]
    assert named == [("Z -2", "line 4"), ("Z -2", "line 11"), ("Z 5", "line 14")]
    corner, circle, line = (chain.curve for chain in drawing.chains)
    assert corner.xy.tolist() == [[0, 0], [10, 0], [20, 10], [20, 20]]
    assert corner.length_mm == pytest.approx(20 + 5 * math.pi)
    assert circle.closed and circle.area_mm2 == pytest.approx(-25 * math.pi)
    assert line.length_mm == 10
    assert [(each.handle, each.why) for each in drawing.skipped] == [("line 13", "an arc of another plane than XY")]


def test_inches_work_offsets_and_relative_moves_are_those_of_the_interpreter(tmp_path: Path) -> None:
    path = tmp_path / "a.ngc"
    path.write_text("G20 G90\nG0 X1 Y1\nG91 G1 X1 F10\nG92 X0 Y0\nG90 G1 Y1\nM2\n")
    (chain,) = read_any_drawing(path, ReadOptions()).chains
    assert chain.curve.length_mm == pytest.approx(50.8)


def test_programs_without_a_feed_or_with_an_error_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.tap"
    path.write_text("G0 X1\n")
    with pytest.raises(JobError, match="no feed"):
        read_any_drawing(path, ReadOptions())
    path.write_text("G1 X1 F10\nG1 Xnan\n")
    with pytest.raises(ProgramError, match=r"a\.tap:2"):
        read_any_drawing(path, ReadOptions())


def test_a_linked_file_has_changed_when_its_content_has(tmp_path: Path) -> None:
    path = tmp_path / "a.nc"
    path.write_text(PROGRAM)
    drawing, state = read_linked(path, ReadOptions())
    assert len(drawing.chains) == 3 and not has_changed(path, state)
    os.utime(path, ns=(1, 1))
    assert not has_changed(path, state), "another time, the same content"
    path.write_text(PROGRAM.replace("X10", "X11"))
    assert has_changed(path, state)
    path.unlink()
    with pytest.raises(JobError, match="no such file"):
        has_changed(path, state)
