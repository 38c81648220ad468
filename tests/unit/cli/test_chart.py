# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper chart`: what it prints, what it converts, and tests of kerf and speed that are jobs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.errors import JobError
from CNCStepper.job.cut_tests import kerf_test
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.machine.cut_charts import cut_data_for, read_chart, shipped_chart


def run(*words: object) -> Result:
    return CliRunner().invoke(group, ["chart", *map(str, words)])


def test_a_chart_is_listed_and_a_row_shown_with_what_lies_between() -> None:
    listed = run("list", "--process", "hot-wire")
    assert listed.exit_code == 0 and "eps 1 mm nichrome 0.4 mm: feed_mm_min 300, kerf_mm 1.2" in listed.stdout
    shown = run("show", "--material", "mild-steel", "--thickness", "5", "--consumable", "45A")
    assert shown.exit_code == 0 and "feed_mm_min = 1775.0" in shown.stdout and "interpolated" in shown.stdout


def test_a_thickness_beyond_the_chart_is_refused_with_its_range() -> None:
    refused = run("show", "--material", "mild-steel", "--thickness", "80")
    assert isinstance(refused.exception, JobError) and refused.exception.code == "chart-thickness"


def test_a_chart_becomes_qtplasmacs_file_and_comes_back(tmp_path: Path) -> None:
    shipped = Path(__file__).parents[3] / "CNCStepper" / "machine" / "charts" / "plasma.toml"
    cfg, back = tmp_path / "table_material.cfg", tmp_path / "back.toml"
    made = run("convert", shipped, "--to", cfg, "--to-units", "inch")
    assert made.exit_code == 0 and "a material file has no lead_in_mm: left out" in made.stdout
    assert run("convert", cfg, "--to", back).exit_code == 0
    rows = read_chart(back)
    for one, other in zip(rows, shipped_chart("plasma"), strict=True):
        assert (one.material, one.consumable, one.amperes) == (other.material, other.consumable, other.amperes)
        assert one.feed_mm_min == pytest.approx(other.feed_mm_min, abs=1e-3)
    listed = run("list", "--chart", cfg)
    assert listed.stdout.startswith("1: mild-steel 0.5 mm 45A: feed_mm_min 9000")


@pytest.mark.parametrize(
    ("process", "material", "machine", "cuts"),
    [
        ("plasma", "mild-steel", "torch-table", 2),
        ("laser", "plywood", "laser-table", 2),
        ("hot-wire", "eps", "wire-table", 1),
    ],
)
def test_a_kerf_test_is_a_job_that_cuts_squares_of_the_size_it_says(
    process: str, material: str, machine: str, cuts: int, tmp_path: Path
) -> None:
    out = tmp_path / "kerf.toml"
    made = run(
        "kerf-test", "--process", process, "--material", material, "--thickness", 3, "--machine", machine, "-o", out
    )
    assert made.exit_code == 0, made.output
    job, profile = load_job(out)
    answers = make_program(job, profile).answers
    (part,) = answers[0].parts
    assert len(part.interiors) == cuts - 1
    assert part.area == pytest.approx(80**2 - (40**2 if cuts == 2 else 0), rel=1e-4)


def test_a_speed_test_is_a_job_for_each_feed_from_70_to_130_percent(tmp_path: Path) -> None:
    out = tmp_path / "speed.toml"
    words = ("--material", "mild-steel", "--thickness", 3, "--machine", "torch-table", "--count", 3, "-o", out)
    assert run("speed-test", *words).exit_code == 0
    texts = []
    for number in (1, 2, 3):
        job, profile = load_job(tmp_path / f"speed-{number}.toml")
        texts.append(make_program(job, profile).program)
    assert ["F2695" in texts[0], "F3850" in texts[1], "F5005" in texts[2]] == [True] * 3
    places = [float(re.search(r"X([\d.]+)", text)[1]) for text in texts]  # type: ignore[index]
    assert 30 < places[1] - places[0] == pytest.approx(places[2] - places[1])  # side by side


def test_what_has_no_kerf_or_no_room_is_refused() -> None:
    with pytest.raises(JobError, match="no kerf"):
        kerf_test(cut_data_for("scribe", "brass", 1), "torch-table")
    with pytest.raises(JobError, match="too small"):
        kerf_test(cut_data_for("plasma", "mild-steel", 3), "torch-table", 10.0)
