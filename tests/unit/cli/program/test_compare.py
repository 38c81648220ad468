# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper compare`: figures, sentences, picture, JSON and exit status; mills and lathes with their parts."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from helpers.cli.command_line import called

PLATE = "G21 G90\nM3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X40 F300\nY20\nX0\nY0\nG0 Z5\nM2\n"
SHAFT = "G21 G18 G7 G90 G94\nT1 M6\nS1000 M3\nG0 X60 Z5\nX50\nG1 Z-40 F200\nX58 Z-38\nG0 X60 Z5\nM2\n"
ORANGE_SHADE = (230, 165, 112)  # 55 % of the first one's colour over the bar's
COLOURS = {"first": (213, 94, 0), "second": (0, 114, 178)}


def written(folder: Path, **texts: str) -> list[Path]:
    files = [folder / f"{name}.nc" for name in texts]
    for file, text in zip(files, texts.values(), strict=True):
        file.write_text(text)
    return files


def near(picture: np.ndarray, colour: tuple[int, int, int]) -> int:
    return int((np.abs(picture.astype(int) - colour).max(axis=2) < 40).sum())


def test_a_plate_is_compared_drawn_and_reported(tmp_path: Path) -> None:
    one, other = written(tmp_path, one=PLATE, other=PLATE.replace("Y20\nX0", "Y20\nX10\nX0 Y15"))
    picture, report = tmp_path / "both.png", tmp_path / "both.json"
    cut = ("--stock", "50,40,8", "--origin", "top-left-front", "--tool", "flat:3")
    ended = called("compare", one, other, *cut, "-o", picture, "--json", report)
    assert ended.returncode == 1, ended.stdout + ended.stderr
    assert "first difference of the path: line 7 of one.nc, line 8 of other.nc" in ended.stdout
    assert "the simulated parts differ by up to 1.000 mm" in ended.stdout
    content = json.loads(report.read_text("utf-8"))
    assert content["first_difference"]["path"] == [7, 8]
    assert content["part"]["only_first_mm3"] > 0
    pixels = np.asarray(Image.open(picture).convert("RGB"))
    assert all(near(pixels, colour) > 100 for colour in COLOURS.values())
    same = called("compare", one, one, "-o", picture.with_suffix(".svg"))
    assert same.returncode == 0 and same.stdout.rstrip().splitlines()[-2] == "the motion is the same"


@pytest.mark.parametrize("diameter", ["50", "50.4"])
def test_a_shaft_is_compared_in_its_half_section(tmp_path: Path, diameter: str) -> None:
    one, other = written(tmp_path, one=SHAFT, other=SHAFT.replace("X50", f"X{diameter}"))
    bar = ("--bar", "55x170", "--face", "1", "--turning-tool", "1=CNMG120408", "--dialect", "linuxcnc")
    picture, report = tmp_path / "shaft.png", tmp_path / "shaft.json"
    ended = called("compare", one, other, *bar, "--tolerance", "0.005", "-o", picture, "--json", report)
    words = {
        "50": "the turned parts are the same within 0.005 mm",
        "50.4": "ø50.000 and ø50.400, 0.400 mm in diameter, from Z-4",
    }
    assert words[diameter] in ended.stdout, ended.stdout + ended.stderr
    assert ended.returncode == (diameter != "50")
    rings = json.loads(report.read_text("utf-8"))["part"]["rings"]
    assert bool(rings) == (diameter != "50")
    assert not rings or rings[0]["diameters_mm"] == pytest.approx([50, 50.4], abs=1e-6)
    pixels = np.asarray(Image.open(picture).convert("RGB"))
    assert (near(pixels, ORANGE_SHADE) > 1000) == (diameter != "50")  # the first one cuts deeper, and shows it enlarged


def test_programs_that_do_not_go_together_are_refused(tmp_path: Path) -> None:
    one, other = written(tmp_path, one=SHAFT, other=PLATE)
    ended = called("compare", one, other, "--dialect", "linuxcnc")
    assert ended.returncode == 1 and "[compare-kinds]" in ended.stderr, ended.stderr
    assert "other.nc is a mill's program and one.nc a lathe's" in ended.stderr
    ended = called("compare", one, one, "--part", "1")
    assert ended.returncode == 2 and "--part goes with the --job of a lathe" in ended.stderr
    ended = called("compare", one, one, "--part", "1", "--bar", "55x170")
    assert ended.returncode == 2 and "--part goes with --job" in ended.stderr
