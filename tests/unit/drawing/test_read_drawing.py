# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any drawing by its suffix."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from CNCStepper.drawing.drawing import Attributes, Piece
from CNCStepper.drawing.joined_pieces import joined_pieces
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import straight

GASKET = Path("examples/drawings/gasket.dxf")


def test_a_suffix_in_capitals_is_known(tmp_path: Path) -> None:
    shutil.copy(GASKET, tmp_path / "PEÇA.DXF")
    drawing = read_drawing(tmp_path / "PEÇA.DXF", ReadOptions())
    assert drawing.layers == read_drawing(GASKET, ReadOptions()).layers


def test_an_unknown_suffix_is_refused_with_those_known(tmp_path: Path) -> None:
    with pytest.raises(JobError, match=r"'\.xyz'") as refusal:
        read_drawing(tmp_path / "part.xyz", ReadOptions())
    assert ".dxf" in str(refusal.value.advice) and refusal.value.code == "drawing-format"


def test_lines_of_another_colour_are_joined_only_where_colours_do_not_count() -> None:
    red, blue = (Attributes("cut", colour) for colour in ("#ff0000", "#0000ff"))
    corner = [
        Piece(straight((0, 0), (9, 0)), red),
        Piece(straight((9, 9), (9, 0)), blue),
        Piece(straight((0, 9), (0, 0)), red),
    ]
    (one,), gaps = joined_pieces(corner)
    assert one.attributes == red and one.curve.length_mm == 27 and gaps == ()
    chains, _ = joined_pieces(corner, by_colour=True)
    assert [(chain.attributes, chain.curve.length_mm) for chain in chains] == [(red, 18), (blue, 9)]
