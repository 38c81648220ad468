# SPDX-License-Identifier: LGPL-2.1-or-later
"""`[[shape]] text`: letters at their places, the parts of letters, what is refused, and the example proven."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from CNCStepper.errors import JobError, Place
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import prove_job
from CNCStepper.job.shapes import SHAPE_KEYS, Drawn, Shapes, read_shapes
from CNCStepper.state import Start

EXAMPLE = Path(__file__).parents[3] / "examples" / "jobs" / "name-plate.toml"


def shapes(text: str) -> Shapes:
    """Return the shapes of a job whose only shape is a text with these keys."""
    table = tomllib.loads(f'[[shape]]\nname = "t"\ntext = {{ height_mm = 5, {text} }}')
    return read_shapes(table["shape"], Path(), "job.toml", Drawn())


def curves(text: str) -> tuple[Curve, ...]:
    """Return the curves of such a text."""
    return shapes(text).curves["t"]


def test_a_text_stands_at_its_place_and_is_turned_about_it() -> None:
    stem, foot = curves(
        'text = "I", single_line = "engraving", position_mm = [10, 20], rotation_deg = 90, align = "center"'
    )[0].xy
    assert np.allclose(sorted([stem.tolist(), foot.tolist()]), [(5.0, 20.0), (10.0, 20.0)], atol=1e-9)


def test_letters_stand_outside_of_an_arc_that_runs_clockwise_and_inside_of_the_other() -> None:
    arc = "arc = { centre = [60, 40], radius = 30, start_deg = %d, sweep_deg = %d }"
    for start_deg, sweep_deg, least, most in ((180, -180, 30.0, 35.3), (180, 180, 24.7, 30.0)):
        along = arc % (start_deg, sweep_deg)
        found = curves(f'text = "HHHH", single_line = "engraving", align = "center", along = {{ {along} }}')
        places = np.vstack([curve.xy for curve in found]) - (60.0, 40.0)
        away_mm = np.hypot(*places.T)
        assert away_mm.min() >= least - 0.2 and away_mm.max() <= most + 0.2
        assert (places[:, 1] > 0.0).all() == (sweep_deg < 0)


def test_parts_of_letters() -> None:
    font = 'font = "DejaVu Sans", text = "BO"'
    assert len(curves(font)) == 5
    assert all(curve.area_mm2 > 0.0 for curve in curves(font + ', part = "outlines"'))
    assert len(curves(font + ', part = "holes"')) == 3
    with pytest.raises(JobError) as refusal:
        curves('text = "I", font = "DejaVu Sans", part = "holes"')
    assert refusal.value.code == "text-part"


@pytest.mark.parametrize(
    "text",
    [
        'text = "a"',
        'text = "a", font = "DejaVu Sans", single_line = "engraving"',
        'text = "", font = "DejaVu Sans"',
        'text = "a", single_line = "engraving", along = { }',
        'text = "a", single_line = "engraving", along = { line = [[0, 0], [9, 0]], arc = { } }',
        'text = "a", single_line = "gothic"',
        'text = "a", font = "No Such Font"',
        'text = "a", file = "missing.ttf"',
        'text = "a", file = "examples/jobs/plate.toml"',
        'text = "日", single_line = "engraving"',
        'text = "long enough", single_line = "engraving", along = { line = [[0, 0], [9, 0]] }',
    ],
)
def test_what_is_wrong_is_refused_with_its_shape(text: str) -> None:
    with pytest.raises(JobError) as refusal:
        shapes(text)
    assert "shape 1" in str(refusal.value) or "examples" in str(refusal.value) or "missing" in str(refusal.value)


@pytest.mark.parametrize(
    "along", ["line = [[0, 0], [90, 0]]", "arc = { centre = [0, 0], radius = 30, start_deg = 180, sweep_deg = -180 }"]
)
@pytest.mark.parametrize("font", ['single_line = "engraving"', 'font = "DejaVu Sans"'])
def test_a_letter_that_the_font_lacks_is_refused_along_a_line_and_an_arc_too(along: str, font: str) -> None:
    text = '%s, align = "center", along = { %s }, text = "%s"'
    assert curves(text % (font, along, "a\u00e7\u00e3"))
    with pytest.raises(JobError) as refusal:
        curves(text % (font, along, "a日b"))
    assert refusal.value.code == "text-glyph" and "U+65E5" in str(refusal.value)


def test_open_letters_are_refused_where_a_closed_shape_is_needed() -> None:
    found, key = shapes('text = "L", single_line = "engraving"'), SHAPE_KEYS["pocket"][0]
    with pytest.raises(JobError) as refusal:
        found.named("t", key, Place("job.toml"))
    assert refusal.value.code == "shape-open"


@pytest.mark.slow
def test_the_example_is_proven() -> None:
    job, machine = load_job(EXAMPLE)
    proof = prove_job(job, machine, make_program(job, machine).program, start=Start.with_work_zero((-300, -300, -40)))
    assert not proof.findings
    cut: Any = proof.report["removed_volume_mm3"]
    assert 20.0 < cut < 200.0
