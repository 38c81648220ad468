# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first picture shows the part from above in its colours, and stands on disk before the part is judged."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from CNCStepper.job.prove import prove
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.removal.heightmap import HeightMap, height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.views.depth_colours import MATERIAL
from CNCStepper.simulation.views.quick_picture import LONG_SIDE, save_first_picture
from helpers.simulation.programs import FLAT, begun

STOCK = Stock((40, 20, 5))
FLOOR, TOP = (tuple(bytes.fromhex(MATERIAL[k][1:])) for k in (0, -1))


def seen(path: Path, part: HeightMap) -> np.ndarray:
    save_first_picture(path, part)
    with Image.open(path) as picture:
        return np.asarray(picture.convert("RGB"))


def test_the_cut_is_where_it_is_in_the_stock(tmp_path: Path) -> None:
    picture = seen(tmp_path / "p.png", height_map(begun().feed(-10, 5, -2).toolpath(), FLAT, STOCK))
    assert picture.shape == (LONG_SIDE // 2, LONG_SIDE, 3)
    assert tuple(picture[112, 225]) == FLOOR  # 10 mm from the left, 5 mm from the back
    assert all(tuple(picture[row, column]) == TOP for row, column in ((338, 225), (112, 675), (338, 675)))


def test_uncut_and_one_cell_wide(tmp_path: Path) -> None:
    assert (seen(tmp_path / "p.png", HeightMap(STOCK)) == TOP).all()
    assert seen(tmp_path / "p.png", HeightMap(Stock((40, 0.01, 5)), 0.1)).shape == (1, LONG_SIDE, 3)


def test_the_part_is_handed_out_before_it_is_judged() -> None:
    heard: list[str] = []
    text = "G21 G90\nT1\nM3 S10000\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F100\nG1 X10 F300\nG0 Z5\nM2\n"
    given = {"stock": STOCK, "tools": FLAT, "tell": heard.append, "see": lambda part: heard.append("seen")}
    proof = prove(text, load_machine("table-a"), **given)
    assert proof.part is not None and heard[:4] == ["read", "cut", "seen", "time"]
