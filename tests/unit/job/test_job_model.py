# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job files: what they say, and what is refused in them."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import CNCStepperError, JobError
from CNCStepper.geometry.curve import circle
from CNCStepper.job.make import make_program
from CNCStepper.job.make_certificate import stock_digest
from CNCStepper.job.model import Job, load_job, operation_of, save_job
from CNCStepper.job.prove import prove_job
from CNCStepper.simulation.checks.clamps import Clamp
from CNCStepper.simulation.stock import Cylinder, HeightField, Stock

EXAMPLES = Path(__file__).parents[3] / "examples"
POCKET = EXAMPLES / "jobs" / "elliptical-pocket.toml"
BRAZIL = EXAMPLES / "jobs" / "brazil-engraving.toml"


def changed(tmp_path: Path, old: str, new: str) -> Path:
    """Return a copy of the pocket's job with one text replaced; the machine is a shipped profile."""
    text = POCKET.read_text("utf-8").replace('"../machines/table-a.toml"', '"table-a"')
    assert old in text
    path = tmp_path / "job.toml"
    path.write_text(text.replace(old, new), encoding="utf-8")
    return path


@pytest.mark.parametrize("path", [POCKET, BRAZIL])
def test_the_examples_load_with_their_machine(path: Path) -> None:
    job, machine = load_job(path)
    assert machine.name == "Cutting table A"
    assert job.setup(job.operation[0]).tool.number == job.operation[0].tool


@pytest.mark.parametrize("path", [POCKET, BRAZIL])
def test_a_saved_job_makes_the_same_program(path: Path, tmp_path: Path) -> None:
    job, machine = load_job(path)
    job = job.model_copy(update={"machine": "table-a"})
    save_job(job, tmp_path / "ação.json")
    again, machine_again = load_job(tmp_path / "ação.json")
    assert make_program(again, machine_again).program == make_program(job, machine).program


REFUSALS = [
    ("depth_mm = 10 ", "depth_mm = -10 ", "depth_mm"),
    ("depth_mm = 10 ", "depth_mm = nan ", "depth_mm"),
    ("depth_mm = 10 ", "dept_mm = 10 ", "depth_mm"),
    ('cycle = "elliptical_pocket"', 'cycle = "eliptical"', "elliptical_pocket"),
    ('cycle = "elliptical_pocket"\ntool = 1', 'cycle = "elliptical_pocket"\ntool = 7', "tool 7"),
    ('"table-a"', '"table-z"', "table-a, table-b"),
    ('units = "mm"', 'units = "cm"', "units"),
    ('work_offset = "G54"', 'work_offset = "G60"', "G54"),
    ("clearance_mm = 10 ", "clearance_mm = 1 ", "clearance_mm"),
    ("size_mm = [100, 70, 20]", "size_mm = [100, 70]", "stock.size_mm"),
    ("number = 1", "number = one", "TOML"),
    ("diameter_mm = 6.0", "diameter_mm = 0", "diameter_mm"),
    (
        "depth_mm = 10 ",
        "",
        "operation 1: the key depth_mm is missing; add depth_mm = a number from 0.001 to 10000 mm",
    ),
    (
        "diameter_mm = 6.0",
        "",
        "the key diameter_mm is missing in tool 1; add diameter_mm = a number from 0.001 to 10",
    ),
    (
        'origin = "',
        'oring = "',
        "there is no key stock.oring; correct its spelling or take it out; known in stock",
    ),
]


@pytest.mark.parametrize(("old", "new", "told"), REFUSALS)
def test_bad_jobs_are_refused_naming_the_key(old: str, new: str, told: str, tmp_path: Path) -> None:
    with pytest.raises(JobError) as caught:
        load_job(changed(tmp_path, old, new))
    assert told in str(caught.value)


TABLES = [
    (
        {"tabs": {"count": 2, "width_mm": 6}},
        "the key height_mm is missing in tabs; add height_mm = a number from 0.001",
    ),
    (
        {"tabs": {"count": 2, "wide_mm": 6}},
        "key tabs.wide_mm; correct its spelling or take it out; known in tabs are: co",
    ),
    ({"lead_in": {"kind": "arc", "radius": 3}}, "known in lead_in are: angle_deg, kind, length_mm, radius_mm"),
]


@pytest.mark.parametrize(("table", "told"), TABLES)
def test_a_wrong_key_in_a_table_of_an_operation_is_told_with_that_tables_keys(table: dict, told: str) -> None:
    raw = {
        "cycle": "contour",
        "tool": 1,
        "curves": (circle((0, 0), 9),),
        "depth_mm": 3,
        "stepdown_mm": 3,
        "side": "outside",
    } | table
    with pytest.raises(JobError) as caught:
        operation_of(raw, Path(), "job.toml operation 2")
    assert told in str(caught.value) and "job.toml operation 2" in str(caught.value)


def test_a_pattern_without_a_key_is_told_what_that_pattern_wants() -> None:
    pattern = {"kind": "bolt_circle", "centre_mm": [0, 0], "count": 4}
    with pytest.raises(JobError) as caught:
        operation_of({"cycle": "drill", "tool": 1, "depth_mm": 3, "pattern": pattern}, Path(), "job.toml operation 1")
    assert "the key radius_mm is missing in pattern; add radius_mm = a number" in str(caught.value)


CUTTING_REFUSALS = [
    ("diameter_mm = 6.0", "diameter_mm = 60", "wider than the pocket"),
    ("stepover_mm = 2.4", "stepover_mm = 6.1", "larger than the tool"),
    ("feed_mm_min = 800", "feed_mm_min = 0", "feed_mm_min"),
]


@pytest.mark.parametrize(("old", "new", "told"), CUTTING_REFUSALS)
def test_what_cannot_be_cut_is_refused_with_value_limit_and_advice(
    old: str, new: str, told: str, tmp_path: Path
) -> None:
    job, machine = load_job(changed(tmp_path, old, new))
    with pytest.raises(CNCStepperError) as caught:
        make_program(job, machine)
    assert told in str(caught.value) and caught.value.advice


def test_a_missing_job_and_a_file_that_is_none(tmp_path: Path) -> None:
    with pytest.raises(JobError, match="no such file"):
        load_job(tmp_path / "none.toml")
    (tmp_path / "list.json").write_text("[1, 2]", encoding="utf-8")
    with pytest.raises(JobError, match="holds no object"):
        load_job(tmp_path / "list.json")


def test_two_tools_of_one_number_are_refused() -> None:
    job, _ = load_job(POCKET)
    with pytest.raises(ValueError, match="same number"):
        Job.model_validate(job.model_dump() | {"tool": job.tool * 2, "operation": job.operation})


@pytest.mark.slow
def test_clamps_and_the_sheets_edge_are_kept_and_go_into_the_proof(tmp_path: Path) -> None:
    stock = 'origin = "top-centre"'
    path = changed(tmp_path, stock, f"{stock}\nedge_mm = 30\n\n[[clamp]]\ncorners_mm = [[-2, -2], [2, 2]]\ntop_mm = 6")
    job, machine = load_job(path)
    save_job(job, tmp_path / "job.json")
    again, _ = load_job(tmp_path / "job.json")
    assert again.clamps == job.clamps == [Clamp(((-2, -2), (2, 2)), 6)]
    codes = {finding.code for finding in prove_job(again, machine, make_program(again, machine).program).findings}
    assert {"clamp", "sheet-edge"} <= codes


def test_a_clamp_that_encloses_nothing_is_refused(tmp_path: Path) -> None:
    stock = 'origin = "top-centre"'
    path = changed(tmp_path, stock, f"{stock}\n\n[[clamp]]\ncorners_mm = [[-2, 2], [-2, 4]]\ntop_mm = 6")
    with pytest.raises(JobError, match="enclose nothing"):
        load_job(path)


def test_stocks_of_every_form_are_made_saved_and_certified(tmp_path: Path) -> None:
    (tmp_path / "campo.csv").write_text("# mm\n20; 20;19,5\n20;20;20\n", encoding="utf-8")
    size = "size_mm = [100, 70, 20]"
    kinds = {}
    for form, text in (
        ("box", size),
        ("sheet", f'{size}\nform = "sheet"\nedge_mm = 5'),
        ("cylinder", 'form = "cylinder"\nsize_mm = [100, 100, 20]'),
        ("height_field", f'{size}\nform = "height_field"\nheights = "campo.csv"'),
    ):
        job, _ = load_job(changed(tmp_path, size, text))
        assert job.stock.form == form
        save_job(job, tmp_path / "job.json")
        again, _ = load_job(tmp_path / "job.json")
        assert stock_digest(again.stock.stock()) == stock_digest(job.stock.stock())
        kinds[form] = type(job.stock.stock())
    assert kinds == {"box": Stock, "sheet": Stock, "cylinder": Cylinder, "height_field": HeightField}
    assert job.stock.stock().heights_mm.tolist() == [[20, 20, 19.5], [20, 20, 20]]


@pytest.mark.parametrize(
    ("new", "told"),
    [
        ('form = "cylinder"\nsize_mm = [100, 70, 20]', "as long in X as in Y"),
        ('form = "ball"\nsize_mm = [100, 70, 20]', "height_field"),
        ('form = "height_field"\nsize_mm = [100, 70, 20]', "heights belong"),
        ("size_mm = [100, 70, 20]\nheights_mm = [[20.0, 20.0], [20.0, 20.0]]", "heights belong"),
        ('form = "height_field"\nsize_mm = [100, 70, 20]\nheights_mm = [[20.0], [20.0, 20.0]]', "differ in length"),
        ('form = "height_field"\nsize_mm = [100, 70, 20]\nheights = "none.csv"', "none.csv"),
        ('form = "height_field"\nsize_mm = [100, 70, 20]\nheights = "bad.csv"', "bad.csv:2: "),
        ('form = "height_field"\nsize_mm = [100, 70, 20]\nheights = "uneven.csv"', "different numbers"),
        (
            "size_mm = [0, 70, 20]",
            "stock.size_mm.0 must be a number within its bounds (value 0 mm, limit 0.001 to",
        ),
    ],
)
def test_stocks_that_are_none_are_refused(new: str, told: str, tmp_path: Path) -> None:
    (tmp_path / "bad.csv").write_text("20,20\n20,x\n", encoding="utf-8")
    (tmp_path / "uneven.csv").write_text("20 20\n20 20 20\n", encoding="utf-8")
    with pytest.raises(JobError) as caught:
        load_job(changed(tmp_path, "size_mm = [100, 70, 20]", new))
    assert told in str(caught.value)


def test_tools_take_every_key_of_their_shape(tmp_path: Path) -> None:
    v = 'shape = "v"\ntip_angle_deg = 60\ntip_diameter_mm = 0.2\nflute_length_mm = 8\nlength_mm = 30'
    job, _ = load_job(changed(tmp_path, 'shape = "flat"', v))
    assert (job.tool[0].tip_angle_deg, job.tool[0].flute_length_mm) == (60.0, 8.0)
    with pytest.raises(JobError, match="a flat tool has no tip_angle_deg"):
        load_job(changed(tmp_path, 'shape = "flat"', 'shape = "flat"\ntip_angle_deg = 60'))


def test_a_job_file_without_operations_is_refused(tmp_path: Path) -> None:
    text = POCKET.read_text("utf-8").partition("[[operation]]")[0].replace('"../machines/table-a.toml"', '"table-a"')
    path = tmp_path / "job.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(JobError, match="has no operation"):
        load_job(path)
