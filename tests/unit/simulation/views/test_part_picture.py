# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from matplotlib.image import imread

from CNCStepper.errors import JobError
from CNCStepper.quantities import duration_text
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.views.proof_picture import facts_of, save_picture
from CNCStepper.simulation.views.scene import scene_at
from CNCStepper.toolpath import ARC_CCW
from helpers.simulation.programs import FLAT, Program, begun, square_pocket

STOCK = Stock((60, 50, 20))


def picture(program, path, stock=STOCK):
    toolpath = program.toolpath()
    scene = scene_at(toolpath, np.arange(1.0, len(toolpath) + 1), height_map(toolpath, FLAT, stock, 0.5), FLAT)
    save_picture(path, scene, "p.nc", facts_of(scene, "flat 6 mm", 75.0))
    return imread(path)[..., :3] if path.suffix == ".png" else path.read_text("utf-8")


@pytest.mark.slow
def test_pictures_are_the_same_for_the_same_program_and_differ_for_another(tmp_path):
    one, same, other = (
        picture(program, tmp_path / f"{k}.png")
        for k, program in enumerate((square_pocket(), square_pocket(), square_pocket(skip=(8,))))
    )
    assert one.shape[1:] == (1600, 3)
    assert (one == same).all()
    assert np.abs(one - other).max(axis=2).astype(bool).mean() > 0.005
    edge = np.concatenate([one[0], one[-1], one[:, 0], one[:, -1]])
    assert (edge == 1.0).all()  # nothing is cut off


@pytest.mark.slow
@pytest.mark.parametrize(
    "size_mm",
    [
        (60, 50, 20),
        *(pytest.param(size, marks=pytest.mark.slow) for size in [(310, 200, 15), (40, 200, 4), (200, 20, 60)]),
    ],
)
def test_no_band_of_a_picture_is_empty(size_mm, tmp_path):
    one = picture(square_pocket(), tmp_path / "p.png", Stock(size_mm))
    inked = (one < 1.0).any(axis=(1, 2))
    bands = np.diff(np.flatnonzero(np.r_[True, inked, True]))
    assert bands.max() < 100  # pixels, of some 700


@pytest.mark.slow
def test_the_legend_tells_what_there_is_and_no_more(tmp_path):
    plain = picture(begun().feed(10, 0, 3), tmp_path / "p.svg")
    cut = picture(begun().feed(0, 0, -1).arc(ARC_CCW, (4, 0, -1), (2, 0, -1)).rapid(9, 0, 5), tmp_path / "q.svg")
    for word in ("plunge", "arc", "rapid"):
        assert f"<!-- {word} -->" not in plain and f"<!-- {word} -->" in cut
    assert "<!-- feed -->" in plain and "<!-- work zero -->" in plain


@pytest.mark.slow
def test_a_program_that_cuts_nothing_has_a_picture(tmp_path):
    assert picture(Program().up_first(5), tmp_path / "p.png").shape[1] == 1600


def test_another_kind_of_file_is_refused(tmp_path):
    with pytest.raises(JobError, match=r"end it in \.png or \.svg"):
        picture(Program().up_first(5), tmp_path / "p.jpg")


@pytest.mark.parametrize(
    ("time_s", "text"), [(4.26, "4.3 s"), (59.97, "1 min 00 s"), (61, "1 min 01 s"), (3725, "1 h 02 min 05 s")]
)
def test_times_read_as_people_write_them(time_s, text):
    assert duration_text(time_s) == text
