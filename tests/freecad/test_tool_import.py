# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools of FreeCAD's library and of LinuxCNC's table become tools of a job, with what is not understood told."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.tools.tool_files import read_tools
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.features.tool import model_of

TOOLS = Path(__file__).parents[1] / "data" / "tools"
LIBRARY = TOOLS / "Library" / "Default.fctl"
TABLE = "T1 P1 D6.0 Z+41.5 ;6 mm end mill\nT7 P2 D3.0 Z+30 ;3 mm drill\n"


@pytest.fixture
def job(document: Any) -> Any:
    return api.new_job(document, material="plywood")


def test_a_library_of_freecad_becomes_the_tools_of_a_job(document: Any, job: Any) -> None:
    tools, notes = api.import_tools(job, LIBRARY)
    document.recompute()
    stored = [each for each in read_tools(LIBRARY) if each.tool is not None]
    assert [tool.Label for tool in tools] == [each.name for each in stored]
    assert [model_of(tool) for tool in tools] == [each.tool for each in stored]
    assert [problem_of(tool) for tool in tools] == [""] * len(tools)
    assert notes


def test_a_tool_table_in_inches_and_numbers_that_are_taken(document: Any, job: Any, tmp_path: Path) -> None:
    table = tmp_path / "mesa ç.tbl"
    table.write_text(TABLE, "utf-8")
    api.add_tool(job, number=1)
    (mill, drill), _ = api.import_tools(job, table, unit_mm=25.4)
    assert (mill.Number, drill.Number, drill.ToolShape) == (2, 7, "drill")
    assert float(mill.Diameter) == pytest.approx(152.4)
    assert float(drill.LengthOffset) == pytest.approx(762)


def test_an_imported_tool_cuts_with_the_feeds_of_the_material(document: Any, job: Any) -> None:
    tools, _ = api.import_tools(job, TOOLS / "Bit" / "3.175mm_Endmill.fctb")
    api.add_operation(job, "circular_pocket", tool=tools[0], radius_mm=10, depth_mm=2, stepover_mm=1)
    document.recompute()
    assert problem_of(job) == ""
    assert "F" in api.program_text(job)


def test_what_is_no_file_of_tools_is_refused_and_adds_nothing(job: Any, tmp_path: Path) -> None:
    before = len(job.Document.Objects)
    for name, text in (("tools.txt", ""), ("broken.fctb", "{"), ("broken.tbl", "hello\n"), ("none.fctl", None)):
        path = tmp_path / name
        if text is not None:
            path.write_text(text, "utf-8")
        with pytest.raises(JobError):
            api.import_tools(job, path)
    assert len(job.Document.Objects) == before
