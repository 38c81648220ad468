# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chains in columns: what they hold, and how little memory they take."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from pathlib import Path

import ezdxf
import pytest

from CNCStepper.drawing.chain_columns import columns_of
from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.geometry.curve import circle, from_points

CHAINS = (
    Chain(circle((0, 0), 5), Attributes("A", "#ff0000", "r1", ("outer", "inner"), True)),
    Chain(from_points([(0, 0), (5, 0), (5, 5)]), Attributes("A", "#ff0000", "r2", ("outer", "inner"), True)),
    Chain(from_points([(9, 0), (9, 1)]), Attributes("ç", "", "", (), False)),
)
LINES = 4_000
MOST_BYTES = 140  # a line that is read, with all that it is known by
MOST_PEAK_BYTES = 280  # a line of no chain while it is read and joined, its columns in two layouts among them


def test_chains_come_out_of_columns_as_they_went_in() -> None:
    columns = columns_of(CHAINS)
    assert len(columns) == 3 and tuple(columns) == CHAINS and columns_of(columns) is columns
    assert columns[-1] == CHAINS[2] and columns[1:] == CHAINS[1:] and len(columns.looks) == 2
    with pytest.raises(IndexError):
        columns[3]


def test_no_chains_are_columns_too() -> None:
    assert tuple(columns_of(())) == ()


def svg_of_lines(path: Path) -> None:
    rows = (f'<path id="p{number}" d="M{2 * number} 0v{number % 7 + 1}"/>' for number in range(LINES))
    head = '<svg xmlns="http://www.w3.org/2000/svg" width="9000mm" height="9mm" viewBox="0 0 9000 9"><g stroke="red">'
    path.write_text(head + "".join(rows) + "</g></svg>", "utf-8")


def dxf_of_lines(path: Path, count: int = LINES) -> None:
    document = ezdxf.new("R2010", units=4)
    for number in range(count):
        document.modelspace().add_line((2 * number, 0), (2 * number, number % 7 + 1))
    document.saveas(path)


@pytest.mark.parametrize(("name", "write"), [("lines.svg", svg_of_lines), ("lines.dxf", dxf_of_lines)])
def test_a_line_that_is_read_takes_little_memory(tmp_path: Path, name: str, write: Callable[[Path], None]) -> None:
    path = tmp_path / name
    write(path)
    read_drawing(path, ReadOptions())  # imports, kernels
    tracemalloc.start()
    drawing = read_drawing(path, ReadOptions())
    kept, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert len(drawing.chains) == LINES
    assert kept / LINES < MOST_BYTES


def test_what_reading_a_dxf_takes_grows_by_little_more_than_its_columns(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("CNCStepper.input_file.CHUNK_BYTES", 1 << 16)
    monkeypatch.setattr("CNCStepper.geometry.chain_joining.MEASURED", 1_000)
    peaks = {}
    for count in (LINES, 3 * LINES):
        dxf_of_lines(tmp_path / f"{count}.dxf", count)
        read_drawing(tmp_path / f"{count}.dxf", ReadOptions())  # imports
        tracemalloc.start()
        read_drawing(tmp_path / f"{count}.dxf", ReadOptions())
        peaks[count] = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
    assert (peaks[3 * LINES] - peaks[LINES]) / (2 * LINES) < MOST_PEAK_BYTES
