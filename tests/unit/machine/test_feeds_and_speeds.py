# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds and speeds from the table of materials: by the formulas, within the machine, else with a warning."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.errors import JobError
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job, load_job
from CNCStepper.job.prove import prove_job
from CNCStepper.machine.feeds_and_speeds import feeds_of, remarks_on, with_feeds
from CNCStepper.machine.materials import Cutting, material, material_names
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool

TABLE = load_machine("table-a")
POCKET = Path(__file__).parents[3] / "examples" / "jobs" / "elliptical-pocket.toml"


def tool(shape: str = "flat", diameter_mm: float = 6.0, **more: object) -> Tool:
    return Tool(number=1, shape=shape, diameter_mm=diameter_mm, flutes=2, **more)  # type: ignore[arg-type]


def test_the_table_has_the_materials_of_a_small_workshop_and_names_its_sources() -> None:
    wanted = "aluminium-6061 brass mild-steel stainless hardwood softwood plywood mdf acrylic pom hdpe pvc-foam "
    wanted += "polycarbonate fr4 carbon-fibre xps"
    assert set(wanted.split()) <= set(material_names())
    for name in material_names():
        assert material(name).source and material(name).title
    with pytest.raises(JobError, match="plywood"):
        material("plywod")


def test_harder_materials_are_cut_slower_and_with_hss_slower_than_with_carbide() -> None:
    speeds = [
        material(name).speed_m_min("carbide")[1] for name in ("plywood", "aluminium-6061", "mild-steel", "stainless")
    ]
    assert speeds == sorted(speeds, reverse=True)
    for name in ("plywood", "brass", "mild-steel", "stainless", "acrylic"):
        assert material(name).speed_m_min("hss")[1] < material(name).speed_m_min("carbide")[1]
    with pytest.raises(JobError, match="carbide"):
        material("fr4").speed_m_min("hss")


def test_chip_loads_lie_on_lines_between_the_published_diameters_and_go_to_nothing() -> None:
    plywood = material("plywood")
    assert plywood.chip_load_mm(3.175, "carbide") == (0.08, 0.13)
    assert plywood.chip_load_mm((3.175 + 6.35) / 2, "hss") == pytest.approx((0.115, 0.18))
    assert plywood.chip_load_mm(3.175 / 4, "carbide") == pytest.approx((0.02, 0.0325))
    assert plywood.chip_load_mm(50, "carbide") == (0.46, 0.53)
    with pytest.raises(ValueError, match="must rise"):
        Cutting(speed_m_min=(1, 2), chip_load_mm=((3, 0.1, 0.2), (2, 0.1, 0.2)))


@pytest.mark.parametrize("name", ["plywood", "aluminium-6061", "mild-steel", "fr4"])
@pytest.mark.parametrize("shape", ["flat", "drill", "v"])
@pytest.mark.parametrize("diameter_mm", [1.0, 3.0, 6.0, 12.0])
def test_the_formulas_hold_and_the_machine_bounds_them(name: str, shape: str, diameter_mm: float) -> None:
    cutter = tool(shape, diameter_mm)
    found = feeds_of(cutter, material(name), TABLE)
    cutting_mm = diameter_mm / 2 if shape == "v" else diameter_mm
    assert found.speed_m_min == pytest.approx(found.spindle_rpm * math.pi * cutting_mm / 1000)
    assert found.chip_load_mm == pytest.approx(found.feed_mm_min / found.spindle_rpm / 2)
    assert 1000 <= found.spindle_rpm <= 24000
    assert found.feed_mm_min <= (800 if shape == "drill" else 5000) and found.plunge_mm_min <= 800
    assert found.plunge_mm_min == found.feed_mm_min or shape != "drill"
    assert found.speed_m_min <= found.speed_range_m_min[1]
    thin, thick = found.chip_range_mm
    if found.spindle_rpm > 1000:
        assert thin <= found.chip_load_mm <= thick
        assert {remark.severity for remark in found.remarks} <= {"info"}
    else:  # the spindle cannot turn so slowly that Z could follow a large drill
        assert found.chip_load_mm < thin and "warning" in {remark.severity for remark in found.remarks}


def test_without_a_machine_the_middle_of_the_range_is_taken() -> None:
    found = feeds_of(tool(), material("aluminium-6061"))
    assert found.speed_m_min == pytest.approx(300, rel=0.001)
    assert found.chip_load_mm == pytest.approx(math.sqrt(0.0366667 * 0.0766667), rel=0.001)
    assert found.spindle_rpm % 10 == 0 and found.feed_mm_min % 1 == 0


def test_what_the_tool_has_stays_and_the_rest_follows_from_it() -> None:
    cutter = with_feeds(tool(feed_mm_min=600, plunge_mm_min=90), material("brass"), TABLE)
    assert (cutter.feed_mm_min, cutter.plunge_mm_min) == (600, 90) and cutter.spindle_rpm > 1000
    full = tool(feed_mm_min=600, plunge_mm_min=90, spindle_rpm=7000)
    assert with_feeds(full, material("brass"), TABLE) is full
    jet = Tool(number=1, shape="jet", diameter_mm=1)
    assert with_feeds(jet, material("mild-steel"), TABLE) is jet
    limited = feeds_of(tool(chip_load_max_mm=0.02), material("plywood"), TABLE)
    assert limited.chip_load_mm <= 0.02


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"feed_mm_min": 6000, "spindle_rpm": 5000}, "too thick a chip"),
        ({"feed_mm_min": 100, "spindle_rpm": 12000}, "too thin a chip"),
        ({"feed_mm_min": 2400, "spindle_rpm": 60000}, "too fast"),
        ({"feed_mm_min": 100, "spindle_rpm": 1000}, "slow for the material"),
    ],
)
def test_values_out_of_range_are_warned_of_with_value_limit_and_advice(given: dict[str, float], told: str) -> None:
    remarks = feeds_of(tool(**given), material("aluminium-6061"), TABLE).remarks
    found = next(remark for remark in remarks if told in remark.text)
    assert found.severity == "warning" and found.advice and found.value != found.limit


def test_a_cutter_that_is_of_no_use_is_refused_without_feeds_and_warned_of_with_them() -> None:
    with pytest.raises(JobError, match="HSS"):
        with_feeds(tool(made_of="hss"), material("fr4"), TABLE)
    full = tool(made_of="hss", feed_mm_min=300, plunge_mm_min=90, spindle_rpm=9000)
    assert with_feeds(full, material("fr4"), TABLE) is full
    (found,) = remarks_on(full, material("fr4"), TABLE)
    assert found.severity == "warning" and "HSS" in found.text and found.advice


def job_of(**changes: object) -> Job:
    job, _ = load_job(POCKET)
    bare = job.tool[0].model_copy(update={"feed_mm_min": 0.0, "plunge_mm_min": 0.0, "spindle_rpm": 0.0, **changes})
    return job.model_copy(update={"machine": "table-a", "material": "aluminium-6061", "tool": (bare,)})


def test_a_job_with_a_material_needs_no_feeds() -> None:
    job = job_of()
    found = feeds_of(job.tool[0], material("aluminium-6061"), TABLE)
    text = make_program(job, TABLE).program
    assert f"S{found.spindle_rpm:.0f}" in text and f"F{found.feed_mm_min:.0f}" in text
    with pytest.raises(ValueError, match="no feed_mm_min"):
        make_program(job.model_copy(update={"material": ""}), TABLE)
    with pytest.raises(ValueError, match="plywood"):
        Job.model_validate(dict(job) | {"material": "cheese"})


@pytest.mark.slow
def test_findings_tell_the_feeds_that_are_out_of_range_at_the_tools_first_line() -> None:
    for changes, codes in (({}, set()), ({"spindle_rpm": 2000.0, "feed_mm_min": 2000.0}, {"feeds"})):
        job = job_of(flutes=2, **changes)
        proof = prove_job(job, TABLE, make_program(job, TABLE).program)
        told = [finding for finding in proof.findings if finding.code == "feeds"]
        assert {finding.code for finding in told} == codes
        assert all(finding.severity == "warning" and finding.place.line > 1 for finding in told)


def test_flutes_that_are_assumed_are_told_where_the_feed_comes_of_them() -> None:
    cutter = tool().model_copy(update={"flutes": 0, "feed_mm_min": 0.0, "spindle_rpm": 0.0})
    (told,) = [remark for remark in remarks_on(cutter, material("plywood"), TABLE) if "flutes" in remark.text]
    assert told.severity == "info" and told.text.endswith("calculated with 2") and "flutes" in told.advice
    given = cutter.model_copy(update={"feed_mm_min": 800.0, "spindle_rpm": 16000.0})
    for other in (given, cutter.model_copy(update={"flutes": 2})):
        assert not [remark for remark in remarks_on(other, material("plywood"), TABLE) if "flutes" in remark.text]


def test_the_command_prints_the_worked_answer() -> None:
    asked = ["feeds", "--material", "plywood", "--tool", "flat:6", "--flutes", "1", "--machine", "table-a"]
    result = CliRunner().invoke(group, asked)
    assert result.exit_code == 0 and "Plywood: flat 6 mm of carbide, 1 flutes on Cutting table A" in result.output
    found = feeds_of(tool().model_copy(update={"flutes": 1}), material("plywood"), TABLE)
    assert f"{found.spindle_rpm:.0f} rpm" in result.output and f"{found.feed_mm_min:.0f} mm/min" in result.output
    assert CliRunner().invoke(group, ["feeds", "--material", "cheese", "--tool", "flat:6"]).exit_code == 2
