# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template makes a job of a drawing: rules, nesting, stock, placement, and refusals with their reason."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import ezdxf
import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.templates.drawing_job import DrawingJob, job_of_drawing
from CNCStepper.job.templates.template import read_template

EXAMPLES = Path(__file__).parents[4] / "examples"
HEAD = """
machine = "table-a"
clearance_mm = 10
retract_mm = 2
[stock]
thickness_mm = 6
margin_mm = 10
[[tool]]
number = 1
shape = "flat"
diameter_mm = 3
feed_mm_min = 600
plunge_mm_min = 200
spindle_rpm = 10000
[[tool]]
number = 2
shape = "drill"
diameter_mm = 4
feed_mm_min = 200
plunge_mm_min = 200
spindle_rpm = 8000
"""
RULES = """
[[rule]]
layer = "NOTES*"
ignore = true
[[rule]]
title = "holes"
layer = "holes"
operation = { cycle = "drill", tool = 2, depth_mm = "through" }
[[rule]]
title = "pocket"
layer = "pocket"
closed = true
operation = { cycle = "pocket", tool = 1, depth_mm = 2, stepdown_mm = 1, stepover_mm = 1.2 }
[[rule]]
title = "part"
closed = true
operation = { cycle = "contour", tool = 1, side = "outside", depth_mm = "through", stepdown_mm = 2 }
"""


def drawing(folder: Path, shift: float = 0.0) -> Path:
    """Write an outline, a pocket with an island and a pocket in that, two holes, a note and a stray line."""
    document = ezdxf.new(units=ezdxf.units.MM)
    space = document.modelspace()
    space.add_lwpolyline([(-20, 5), (100, 5), (100, 85), (-20, 85)], close=True, dxfattribs={"layer": "outline"})
    for radius in (30, 20, 10):
        space.add_circle((30 + shift, 45), radius, dxfattribs={"layer": "pocket"})
    for x in (80, 90):
        space.add_circle((x, 15), 2, dxfattribs={"layer": "holes"})
    space.add_circle((300, 300), 2, dxfattribs={"layer": "notes 1"})
    space.add_line((85, 30), (85, 60), dxfattribs={"layer": "stray"})
    document.saveas(folder / "part.dxf")
    return folder / "part.dxf"


def made(folder: Path, rules: str = RULES, head: str = HEAD, **keys: Any) -> DrawingJob:
    (folder / "shop.toml").write_text(head + rules, encoding="utf-8")
    path = drawing(folder)
    (folder / "jobs").mkdir(exist_ok=True)
    return job_of_drawing(read_template(folder / "shop.toml"), path, folder / "jobs" / "job.toml", **keys)


def test_every_rule_makes_its_operation_in_the_order_of_the_rules(tmp_path: Path) -> None:
    job = made(tmp_path)
    assert [operation.cycle for operation in job.job.operation] == ["drill", "pocket", "pocket", "contour"]
    drill, pocket, inner, contour = job.job.operation
    assert drill.depth_mm == contour.depth_mm == 6.2
    assert [hole.diameter_mm for hole in drill.pattern.holes()] == pytest.approx([4, 4])
    assert [abs(curve.area_mm2) for curve in pocket.outlines] == pytest.approx([2827.43], abs=0.01)
    assert [abs(curve.area_mm2) for curve in pocket.islands] == pytest.approx([1256.64], abs=0.01)
    assert [abs(curve.area_mm2) for curve in inner.outlines] == pytest.approx([314.16], abs=0.01)
    assert job.counts == (("rule 1", 1), ("holes", 2), ("pocket", 3), ("part", 1))
    assert [(count.layer, count.open) for count in job.untaken] == [("stray", 1)]


def test_the_stock_is_the_box_of_what_is_cut_and_the_margin(tmp_path: Path) -> None:
    job = made(tmp_path).job
    assert job.stock.size_mm == (140, 100, 6)
    assert job.operation[-1].curves[0].box_mm == pytest.approx((10, 10, 130, 90))
    middle = made(tmp_path, head=HEAD.replace("margin_mm = 10", 'margin_mm = 10\norigin = "top-centre"')).job
    assert middle.operation[-1].curves[0].box_mm == pytest.approx((-60, -40, 60, 40))
    fixed = made(tmp_path, head=HEAD.replace("margin_mm = 10", "size_mm = [300, 200]\nmargin_mm = 4"), thickness_mm=9)
    assert fixed.job.stock.size_mm == (300, 200, 9) and fixed.job.operation[0].depth_mm == 9.2
    assert fixed.job.operation[-1].curves[0].box_mm == pytest.approx((4, 4, 124, 84))


def test_the_job_file_follows_the_drawing(tmp_path: Path) -> None:
    job = made(tmp_path)
    job.write(tmp_path / "jobs" / "job.toml")
    loaded, machine = load_job(tmp_path / "jobs" / "job.toml")
    assert make_program(loaded, machine).program == make_program(job.job.model_copy(), machine).program
    drawing(tmp_path, shift=5.0)
    followed, _ = load_job(tmp_path / "jobs" / "job.toml")
    before, after = (each.operation[1].outlines[0].box_mm for each in (loaded, followed))
    assert [b - a for a, b in zip(before, after, strict=True)] == pytest.approx([5, 0, 5, 0])


@pytest.mark.parametrize(
    ("rules", "head", "keys", "code", "words"),
    [
        (RULES, HEAD, {"strict": True}, "rule-missing", "stray"),
        (RULES, HEAD.replace("margin_mm = 10", "size_mm = [50, 50]"), {}, "drawing-size", "120 by 80"),
        (RULES, HEAD.replace("margin_mm = 10", 'placement = "drawing"'), {}, "drawing-size", "beyond the stock"),
        ('[[rule]]\nlayer = "x"\nignore = true\n', HEAD, {}, "rule-none", "no rule"),
        (RULES.replace("stepover_mm", "stepver_mm"), HEAD, {}, "bad-value", "shop.toml rule 'pocket': there is no key"),
        (RULES.replace("tool = 2, ", ""), HEAD, {}, "bad-value", "shop.toml rule 'holes': the key tool is missing"),
        (RULES.replace("closed = true", "", 1).replace('layer = "pocket"', 'layer = "*"'), HEAD, {}, "rule-open",
         "open chains"),
    ],
)  # fmt: skip
def test_what_makes_no_job_is_refused(
    tmp_path: Path, rules: str, head: str, keys: dict[str, Any], code: str, words: str
) -> None:
    with pytest.raises(JobError) as refusal:
        made(tmp_path, rules, head, **keys)
    assert refusal.value.code == code and words in str(refusal.value)


@pytest.mark.parametrize(
    ("rules", "words"),
    [
        ("[[rule]]\nlayer = 'x'\n", "one of operation, marks_for and ignore"),
        ("[[rule]]\noperation = { cycle = 'poket' }\n", "no cycle 'poket'"),
        ("[[rule]]\noperation = { cycle = 'pocket', region = 'x' }\n", "leave region out"),
        ("[[rule]]\noperation = { cycle = 'circular_pocket', tool = 1 }\n", "takes no shapes"),
        ("[[rule]]\nmarks_for = 'cut'\n", "no rule with a sheet_cut"),
        ("[[rule]]\ntitle = 'a'\nignore = true\n[[rule]]\ntitle = 'a'\nignore = true\n", "same title"),
        ("[[operation]]\ncycle = 'pocket'\n", "no key 'operation'"),
        ("[[rule]]\nignore = true\nclosed = 'yes'\n", "closed: must be true or false (value 'yes')"),
        ("[rule]\nignore = true\n", "rule: must be a list"),
        ("", "rule"),
    ],
)
def test_a_template_that_is_none_is_refused_with_the_key(tmp_path: Path, rules: str, words: str) -> None:
    with pytest.raises(JobError) as refusal:
        made(tmp_path, rules)
    assert words in str(refusal.value) and "shop.toml" in str(refusal.value)


def test_marks_of_another_rule_are_marks_of_the_sheet(tmp_path: Path) -> None:
    rules = """
    [[rule]]
    layer = "pocket"
    marks_for = "cut"
    [[rule]]
    title = "cut"
    layer = ["outline", "holes"]
    operation = { cycle = "sheet_cut" }
    """
    head = HEAD.partition("[[tool]]")[0].replace("table-a", "laser-table")
    head = 'process = "laser"\nmaterial = "plywood"\n' + head.replace("thickness_mm = 6", "thickness_mm = 3")
    (operation,) = made(tmp_path, rules, head).job.operation
    assert len(operation.marks) == 3 and len(operation.curves) == 3


def test_a_later_rule_does_not_take_what_an_earlier_one_has_when_the_job_is_read(tmp_path: Path) -> None:
    rules = """
    [[rule]]
    title = "small"
    layer = "hol*"
    operation = { cycle = "bore", tool = 1, depth_mm = 3, pitch_mm = 0.5 }
    [[rule]]
    layer = "*"
    closed = true
    operation = { cycle = "engrave", tool = 1, depth_mm = 1 }
    """
    job = made(tmp_path, rules).job
    assert len(job.operation[0].pattern.holes()) == 2 and len(job.operation[1].curves) == 5


def test_a_drawing_that_becomes_nested_deeper_is_noted(tmp_path: Path) -> None:
    job = made(tmp_path)
    assert not job.job.notes
    job.write(tmp_path / "jobs" / "job.toml")
    document = ezdxf.readfile(tmp_path / "part.dxf")
    for radius in (8, 4):
        document.modelspace().add_circle((30, 45), radius, dxfattribs={"layer": "pocket"})
    document.saveas(tmp_path / "part.dxf")
    deeper, _ = load_job(tmp_path / "jobs" / "job.toml")
    assert [note for note in deeper.notes if "nesting level 3, 4" in note]


def test_the_job_of_the_sign_is_what_the_template_makes_of_its_drawing() -> None:
    template, path = EXAMPLES / "templates" / "sign.toml", EXAMPLES / "jobs" / "sign.toml"
    job = job_of_drawing(read_template(template), EXAMPLES / "drawings" / "sign.svg", path, strict=True)
    assert job.text == path.read_text("utf-8"), "make it anew: cncstepper job ... -o examples/jobs/sign.toml"
    letters, pocket, contour = job.job.operation
    assert [curve.box_mm for curve in contour.curves] == [pytest.approx((12, 12, 168, 88), abs=0.005)]
    # the hole sticks out of the pocket's left side: an even-odd fill paints what is in one of them alone, in two areas
    assert [len(pocket.outlines), len(pocket.islands), len(letters.outlines)] == [2, 0, 2]
    assert letters.outlines[0].box_mm == pytest.approx((86, 36, 125.2, 72.4), abs=0.005)
    assert letters.outlines[1].box_mm == pytest.approx((133.6, 36, 156, 72.4), abs=0.005)


@pytest.mark.parametrize("name", ["sign", "sheet-plasma", "laser"])
def test_the_templates_that_ship_are_templates(name: str) -> None:
    assert read_template(EXAMPLES / "templates" / f"{name}.toml").rule
