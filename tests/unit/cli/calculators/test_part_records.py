# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper part-records`: figures by hand, and readings that cannot be."""

from __future__ import annotations

import statistics

import pytest

from helpers.cli.command_line import called

CYLINDER = ("part-records", "--height", "150", "--diameter", "50")
PARTS = ("150.02,49.98,50.01,50.00", "149.97,50.03,50.02,49.99")


def test_each_part_and_all_together(tmp_path):
    plot = tmp_path / "parts.png"
    said = called(*CYLINDER, *PARTS, "--plot", plot).stdout.splitlines()
    for line, part in zip(said[1:3], PARTS, strict=True):
        height, *diameters = map(float, part.split(","))
        mean = statistics.mean(diameters)
        expected = [height, *diameters, mean, statistics.stdev(diameters), mean / 50, height / 150]
        assert [float(word) for word in line.split()[1:]] == pytest.approx(expected, abs=6e-5)
    means = [statistics.mean(map(float, part.split(",")[1:])) for part in PARTS]
    assert f"mean {statistics.mean(means):.4f} mm, standard deviation {statistics.stdev(means):.4f} mm" in said[4]
    assert "height of 2 parts: mean 149.9950 mm" in said[3] and plot.stat().st_size > 1000


@pytest.mark.parametrize(
    ("part", "words"),
    [
        ("150.02,49.98,50.01", "not a height and three diameters"),
        ("150.02,49.98,50.01,abc", "is not a number"),
        ("150.02,49.98,50.01,5.00", "far from the commanded one"),
        ("15.02,49.98,50.01,50.00", "far from the commanded one"),
    ],
)
def test_readings_that_cannot_be_are_refused(part, words):
    result = called(*CYLINDER, part)
    assert result.returncode and words in result.stderr
