# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example job of the gasket, and the same job with other drawings and sheets, as programs for a grbl table."""

from __future__ import annotations

import re
from pathlib import Path

import ezdxf
import pytest

from CNCStepper.drawing.dxf.reader import read_dxf
from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.job.make import Made, make_program
from CNCStepper.job.model import Job
from CNCStepper.machine.profile import load_machine
from helpers.cycles.sheet_judge import faults, strokes

EXAMPLE = Path(__file__).parents[4] / "examples" / "jobs" / "gasket-plasma.toml"
GASKET = EXAMPLE.parent.parent / "drawings" / "gasket.dxf"


def made(path: Path) -> Made:
    job = Job.load(path)
    return make_program(job, load_machine(job.machine))


def curves_of(drawing: Path) -> list[Curve]:
    layers = read_dxf(drawing, 0.01).layers
    found = layers.values() if isinstance(layers, dict) else layers
    return [curve for layer in found if layer.name == "CUT" for curve in layer.curves]


def job_with(folder: Path, drawing: Path, size_mm: str) -> Path:
    """Return the example with another drawing and sheet, the drawing where it is drawn."""
    text = re.sub(r"size_mm = \[.*\]", f"size_mm = {size_mm}", EXAMPLE.read_text())
    text = re.sub(r"offset_mm = .*\n", "", text)
    text = re.sub(r"dxf = \{.*\}", f'dxf = {{ file = "{drawing.as_posix()}", layer = "CUT" }}', text)
    path = folder / "job.toml"
    path.write_text(text)
    return path


def check_words(program: str) -> None:
    """Assert that a G4 stands behind each M3, an M5 before each rapid, and that nothing is on twice."""
    lines, on, motion = program.splitlines(), False, "G0"
    for number, line in enumerate(lines):
        words = re.sub(r"\(.*?\)", "", line).split()
        motion = next((word for word in words if word in ("G0", "G1", "G2", "G3")), motion)
        if "M3" in words:
            assert not on and lines[number + 1].startswith("G4 P0."), line
        on = (on or "M3" in words) and "M5" not in words
        if motion == "G0" and any(word[0] in "XYZ" for word in words):
            assert not on, line
    assert not on


def test_the_gasket_is_cut_holes_first_with_power_only_in_the_cut() -> None:
    found = made(EXAMPLE)
    check_words(found.program)
    answer = found.answers[0]
    kerf_mm, curves = answer.figures["kerf_mm"], [curve.moved(15.0, 15.0) for curve in curves_of(GASKET)]
    assert len(strokes(found.toolpath)) == len(curves) == 7
    assert [span.name for span in found.toolpath.spans if span.kind == "contour"][-1].startswith("part")
    sheet = rectangle((0.0, 0.0), (230.0, 150.0))
    delay_s = strokes(found.toolpath)[0].dwell_s
    assert delay_s > 0 and faults(found.toolpath, curves, sheet, kerf_mm, 2.0, delay_s) == []


@pytest.mark.parametrize("scale", [0.5, 3.0])
def test_a_scaled_drawing_in_another_sheet_is_cut_as_well(tmp_path: Path, scale: float) -> None:
    drawing = tmp_path / "scaled.dxf"
    document = ezdxf.new(units=4)
    space = document.modelspace()
    for curve in curves_of(GASKET):
        points = [(*point, bulge) for point, bulge in zip(curve.scaled(scale).xy[:-1], curve.bulge, strict=True)]
        space.add_lwpolyline(points, format="xyb", close=True, dxfattribs={"layer": "CUT"})
    document.saveas(drawing)
    found = made(job_with(tmp_path, drawing, f"[{220 * scale}, {140 * scale}, 3]"))
    check_words(found.program)
    assert len(strokes(found.toolpath)) == 7 and len(found.answers[0].parts) == 1


def test_a_sheet_full_of_parts_is_cut(tmp_path: Path) -> None:
    drawing = tmp_path / "full.dxf"
    document = ezdxf.new(units=4)
    space = document.modelspace()
    for number in range(12):
        x, y = 12.0 + 45.0 * (number % 4), 12.0 + 40.0 * (number // 4)
        space.add_lwpolyline([(x, y), (x + 38, y), (x + 38, y + 33), (x, y + 33)], close=True,
                             dxfattribs={"layer": "CUT"})  # fmt: skip
        space.add_circle((x + 19.0, y + 16.0), 6.0, dxfattribs={"layer": "CUT"})
    document.saveas(drawing)
    found = made(job_with(tmp_path, drawing, "[220, 150, 3]"))
    check_words(found.program)
    kerf_mm = found.answers[0].figures["kerf_mm"]
    delay_s = strokes(found.toolpath)[0].dwell_s
    sheet = rectangle((0.0, 0.0), (220.0, 150.0))
    assert faults(found.toolpath, curves_of(drawing), sheet, kerf_mm, 2.0, delay_s) == []
    assert len(found.answers[0].parts) == 12


def test_the_rib_of_the_wire_is_cut_by_the_torch_as_well(tmp_path: Path) -> None:
    rib = GASKET.with_name("rib.dxf")
    found = made(job_with(tmp_path, rib, "[200, 40, 6]"))
    check_words(found.program)
    kerf_mm = found.answers[0].figures["kerf_mm"]
    sheet = rectangle((-30.0, -30.0), (230.0, 70.0))  # half of the rib lies below the sheet's corner
    (stroke,) = strokes(found.toolpath)
    assert faults(found.toolpath, curves_of(rib), sheet, kerf_mm, 2.0, stroke.dwell_s) == []
    assert len(found.answers[0].parts) == 1


def test_a_thickness_beyond_the_chart_is_refused_with_its_range(tmp_path: Path) -> None:
    with pytest.raises(JobError, match=r"0\.5 to 6 mm") as refused:
        made(job_with(tmp_path, GASKET, "[230, 150, 40]"))
    assert refused.value.code == "chart-thickness"
