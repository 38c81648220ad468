# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point lists as people write them, in both decimal signs, and what is refused with file and line."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.drawing.point_list import read_points
from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve

ROOT = Path(__file__).parents[3]
DIGITS = "1" * 200_000 + "!,1"  # read in one go


def read(folder: Path, content: str | bytes, closed: bool = False) -> Curve:
    path = folder / "peça nº 1.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8"))
    return read_points(path, closed)


@pytest.mark.parametrize(
    "content",
    [
        "1.5,2\n3,-4e0\n",
        "x_mm,y_mm\n1.5,2\n3,-4\n",
        "# drawn by hand\n\nX,Y\n 1.5 , 2 \n3,-4 # the end\n\n",
        "1,5;2\n3;-4\n",
        "x [mm];y [mm]\n1,5;2,0\n3,0;-4,0\n",
        "1,5\t2\n3\t-4\n",
        '"x","y"\r\n1.5,2\r\n3,-4\r\n',
        "\ufeffx,y\n1.5,2\n+3.,-4\n",
        "1.5,2\n1.5,2\n3,-4\n3,-4\n",
    ],
)
def test_points_are_read(tmp_path: Path, content: str) -> None:
    assert read(tmp_path, content).xy.tolist() == [[1.5, 2], [3, -4]]


def test_a_closed_line_comes_back_once(tmp_path: Path) -> None:
    assert read(tmp_path, "0,0\n1,0\n1,1\n", closed=True).xy.tolist() == [[0, 0], [1, 0], [1, 1], [0, 0]]
    assert len(read(tmp_path, "0,0\n1,0\n1,1\n0,0\n", closed=True)) == 3


def test_the_map_of_brazil() -> None:
    brazil = read_points(ROOT / "examples" / "brazil-outline.csv", closed=True)
    assert brazil.closed and len(brazil) == 202


@pytest.mark.parametrize(
    "line",
    [
        "nan,1",
        "1,inf",
        "abc",
        "1",
        "1,2,3",
        "12,5,7,25",
        "1.234,5;2",
        "1_0,2",
        "1,",
        ";",
        "1 2",
        "x",
        "1,y",
        "٣,1",
        "1" * 200_000 + "!,1",
    ],
)
def test_a_line_that_is_no_point_is_named(tmp_path: Path, line: str) -> None:
    with pytest.raises(JobError, match=r"peça nº 1\.csv:3: not a point: .*write x,y in mm"):
        read(tmp_path, f"x,y\n0,0\n{line}\n1,1\n")


def test_a_point_far_away_is_named(tmp_path: Path) -> None:
    with pytest.raises(JobError, match=r"\.csv:2: a point is too far.*1e99,1.*1e\+06 mm"):
        read(tmp_path, "0,0\n1e99,1\n")


@pytest.mark.parametrize("content", ["", "# nothing\n", "x,y\n", "1,2\n", "1,2\n1,2\n1.0,2.0\n"])
@pytest.mark.parametrize("closed", [False, True])
def test_fewer_than_two_points_are_refused(tmp_path: Path, content: str, closed: bool) -> None:
    with pytest.raises(JobError, match=r"\.csv: a line needs at least two different points"):
        read(tmp_path, content, closed)


@pytest.mark.parametrize(
    "content", ["x,y\n1,2\n3,4".encode("utf-16"), "# peça\n1,2\n".encode("latin-1"), b"\x89PNG\r\n"]
)
def test_what_is_no_text_is_refused(tmp_path: Path, content: bytes) -> None:
    with pytest.raises(JobError, match=r"not a text file.*UTF-8"):
        read(tmp_path, content)


@pytest.mark.parametrize("name", ["absent.csv", "", "x" * 5000, "a\0b"])
def test_a_file_that_cannot_be_read_is_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(JobError, match=r"correct the path|a folder"):
        read_points(tmp_path / name)
