# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of a profile as lines of text: written and read back with all digits; what is no row is refused."""

from __future__ import annotations

import itertools
from pathlib import Path

import ezdxf
import ezdxf.units
import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.model import machine_path
from CNCStepper.job.turning.profile_form import ProfileForm
from CNCStepper.job.turning.profile_rows import content_of_lines, in_x, lines_of
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.job.turning.turning_job_text import save_turning_job

ROOT = Path(__file__).parents[4]
ROWS = [
    (0.1 + 0.2, 0.0),
    {"to": (24.0, -1 / 3), "fillet_mm": 2.5},
    (36.0, -30.0),
    {"to": (50.0, -37.0), "arc": "ccw", "radius_mm": 7.0},
    {"to": (60.0, -42.0), "arc": "cw", "centre": (60.0, -37.0)},
    {"to": (60.0, -60.0), "chamfer_mm": 1.0},
    (70.0, -60.0),
]


def test_rows_come_back_from_their_lines() -> None:
    assert content_of_lines(lines_of(ROWS)) == ROWS
    assert lines_of(ROWS)[3] == "50; -37; ccw radius 7"


def test_a_line_may_have_decimal_commas_and_spaces() -> None:
    assert content_of_lines(["24,5 ;  -30", "", " 24,5; -40;  chamfer   1,5 "]) == [
        (24.5, -30.0),
        {"to": (24.5, -40.0), "chamfer_mm": 1.5},
    ]


@pytest.mark.parametrize("line", ["24", "24; x", "1e400; 0; fillet", "24; -3; radius 2", "24; 3; ccw", "a; b; c"])
def test_what_is_no_row_is_refused_with_its_number(line: str) -> None:
    with pytest.raises(JobError, match="row 2"):
        content_of_lines(["24; 0", line])


def test_diameters_and_radii_say_the_same_profile() -> None:
    by_diameter = ProfileForm.model_validate({"name": "one", "points": ROWS}).curve("diameter", Path())
    by_radius = ProfileForm.model_validate({"name": "one", "points": in_x(ROWS, 0.5)}).curve("radius", Path())
    assert np.array_equal(by_diameter.xy, by_radius.xy) and np.array_equal(by_diameter.bulge, by_radius.bulge)


@pytest.mark.parametrize("name", ["cone", "cylinder", "shaft", "thread"])
def test_a_saved_job_file_holds_the_same_job(name: str, tmp_path: Path) -> None:
    path = ROOT / "examples" / "jobs" / f"lathe-{name}.toml"
    job, _ = load_turning_job(path)
    whole = job.model_copy(update={"machine": machine_path(job.machine, path.parent)})
    save_turning_job(whole, tmp_path / "out.toml")
    again, _ = load_turning_job(tmp_path / "out.toml")
    assert again.model_dump() == whole.model_dump()


@pytest.mark.parametrize("backwards", [False, True])
def test_a_profile_of_a_dxf_is_that_of_its_points(tmp_path: Path, backwards: bool) -> None:
    """X of the drawing is z, its Y the radius, whichever end its lines begin at."""
    places = [(0.0, 10.0), (-20.0, 10.0), (-30.0, 15.0), (-45.0, 15.0)]
    drawing = ezdxf.new(units=ezdxf.units.MM)
    drawn = places[::-1] if backwards else places
    for begin, end in itertools.pairwise(drawn):
        drawing.modelspace().add_line(begin, end, dxfattribs={"layer": "PROFILE"})
    drawing.modelspace().add_circle((0, 50), 5, dxfattribs={"layer": "else"})
    drawing.saveas(tmp_path / "eixo ç.dxf")
    table = {"name": "one", "dxf": {"file": "eixo ç.dxf", "layer": "PROFILE"}}
    by_drawing = ProfileForm.model_validate(table).curve("diameter", tmp_path)
    points = [(2 * radius, z) for z, radius in places]
    by_points = ProfileForm.model_validate({"name": "one", "points": points}).curve("diameter", tmp_path)
    assert np.allclose(by_drawing.xy, by_points.xy, atol=1e-9) and not by_drawing.bulge.any()
