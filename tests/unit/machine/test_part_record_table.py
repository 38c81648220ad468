# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of measured parts: pasted texts, cells that are no reading, and the CSV file that is read back."""

from __future__ import annotations

import csv
import statistics

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.part_record_table import FIGURES, MEASURED, csv_text, judged, read_csv, rows_of_text

PARTS = [["150,02", "49.98", "50.01", "50.00"], ["149.97", "50.03", "50.02", "49.99"]]


@pytest.mark.parametrize(
    "text",
    [
        "Height\td1\td2\td3\n150,02\t49.98\t50.01\t50.00\n149.97\t50.03\t50.02\t49.99\n",
        "150,02;49.98;50.01;50.00\r\n149.97;50.03;50.02;49.99",
        "150,02 49.98 50.01 50.00\n\n149.97,50.03,50.02,49.99",
    ],
)
def test_what_spreadsheets_and_files_give_is_pasted(text):
    assert rows_of_text(text) == PARTS


def test_commas_between_and_commas_in_numbers():
    assert rows_of_text("49,98\n50,01") == [["49,98"], ["50,01"]]
    assert rows_of_text("150.02, 49.98, 50.01, 50.00") == [["150.02", "49.98", "50.01", "50.00"]]
    assert rows_of_text("150,50,50,50") == [["150", "50", "50", "50"]]
    assert rows_of_text("a\n\n;;\n") == []


def test_cells_that_are_no_reading_are_named_and_their_rows_left_out():
    found = judged([*PARTS, ["15", "x", "", ""], ["150", "50", "", "50"]], 150, 50)
    assert [record is not None for record in found.records] == [True, True, False, False]
    assert set(found.problems) == {(2, 0), (2, 1)} and len(found.whole) == 2
    assert "far from the commanded one" in found.problems[2, 0] and "no number" in found.problems[2, 1]


def test_a_file_holds_the_figures_and_is_read_back(tmp_path):
    path = tmp_path / "parts.csv"
    path.write_text(csv_text(judged(PARTS, 150, 50).whole, 150, 50), "utf-8")
    first, second = csv.DictReader(path.read_text("utf-8").splitlines())
    diameters = [49.98, 50.01, 50.00]
    mean = statistics.mean(diameters)
    expected = [mean, statistics.stdev(diameters), mean / 50, 150.02 / 150]
    assert [float(first[key]) for key in FIGURES] == pytest.approx(expected, abs=6e-5)
    assert second["part"] == "2"
    rows, nominal = read_csv(path)
    assert nominal == (150, 50) and rows == [["150.02", "49.98", "50.01", "50"], PARTS[1]]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "no file of part records"),
        ("part,height_mm\n1,150\n", "no file of part records"),
        (",".join((*MEASURED, "nominal_height_mm,nominal_diameter_mm")) + "\n1,2,3,4,x,50\n", "'x' is no number"),
        (",".join((*MEASURED, "nominal_height_mm,nominal_diameter_mm")) + "\n1,2,3,4,0,50\n", "out of range"),
    ],
)
def test_other_files_are_refused_with_what_is_wrong(tmp_path, text, words):
    path = tmp_path / "parts.csv"
    path.write_text(text, "utf-8")
    with pytest.raises(JobError, match=words):
        read_csv(path)
