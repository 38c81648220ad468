# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from matplotlib.image import imread
from programs import FLAT, Program, square_pocket

from CNCStepper.simulation.heightmap import height_map
from CNCStepper.simulation.picture import duration_text, save_picture
from CNCStepper.simulation.stock import Stock

STOCK = Stock((60, 50, 20))


def picture(program, path):
    toolpath = program.toolpath()
    save_picture(path, toolpath, height_map(toolpath, FLAT, STOCK, 0.5), title="p.nc", tools="flat 6 mm", time_s=75.0)
    return imread(path)[..., :3]


def test_pictures_are_the_same_for_the_same_program_and_differ_for_another(tmp_path):
    one, same, other = (
        picture(program, tmp_path / f"{k}.png")
        for k, program in enumerate((square_pocket(), square_pocket(), square_pocket(skip=(8,))))
    )
    assert one.shape == (860, 1600, 3)
    assert (one == same).all()
    assert np.abs(one - other).max(axis=2).astype(bool).mean() > 0.005
    edge = np.concatenate([one[0], one[-1], one[:, 0], one[:, -1]])
    assert (edge == 1.0).all()  # nothing is cut off


def test_a_program_that_cuts_nothing_has_a_picture(tmp_path):
    assert picture(Program().up_first(5), tmp_path / "p.png").shape == (860, 1600, 3)


@pytest.mark.parametrize(
    ("time_s", "text"), [(4.26, "4.3 s"), (59.97, "1 min 00 s"), (61, "1 min 01 s"), (3725, "1 h 02 min 05 s")]
)
def test_times_read_as_people_write_them(time_s, text):
    assert duration_text(time_s) == text
