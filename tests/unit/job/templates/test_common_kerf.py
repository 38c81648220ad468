# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet whose parts share cuts is cut with the kerf for which it was nested, or refused with both numbers."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.errors import JobError
from CNCStepper.job.templates.common_kerf import common_kerf_mm
from CNCStepper.job.templates.drawing_job import job_of_drawing
from CNCStepper.job.templates.template import read_template
from helpers.batch.small_orders import write_order


def test_a_nested_sheet_is_refused_by_an_operation_of_another_kerf(tmp_path: Path) -> None:
    write_order(tmp_path, [])
    template, sheet = read_template(tmp_path / "laser.toml"), tmp_path / "sheet.dxf"
    chains = read_drawing(tmp_path / "square.dxf", ReadOptions()).chains
    kerf_mm = common_kerf_mm(job_of_drawing(template, tmp_path / "square.dxf", tmp_path / "job.toml").job)
    sheet.write_bytes(dxf_bytes(Drawing(tuple(chains), kerf_mm=kerf_mm)))
    assert read_drawing(sheet, ReadOptions()).kerf_mm == kerf_mm
    job_of_drawing(template, sheet, tmp_path / "job.toml")

    sheet.write_bytes(dxf_bytes(Drawing(tuple(chains), kerf_mm=1.0625)))
    with pytest.raises(JobError, match=rf"another kerf.*{kerf_mm:g} mm.*1\.0625 mm.*nest again") as refused:
        job_of_drawing(template, sheet, tmp_path / "job.toml")
    assert refused.value.code == "common-kerf"


@pytest.mark.parametrize("told", ["", "wide", "-1", "nan", "1e9"])
def test_a_kerf_that_is_none_is_not_taken(tmp_path: Path, told: str) -> None:
    write_order(tmp_path, [])
    chains = read_drawing(tmp_path / "square.dxf", ReadOptions()).chains
    text = dxf_bytes(Drawing(chains, kerf_mm=1.0625)).decode("utf-8")
    (tmp_path / "sheet.dxf").write_text(text.replace("1.0625", told), "utf-8")
    assert read_drawing(tmp_path / "sheet.dxf", ReadOptions()).kerf_mm is None
