# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools, materials and charts as tables: what is typed is judged, saved as the user's own, and used from then on."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.cut_charts import cut_data_for, shipped_chart, write_chart
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.files import profile_files
from CNCStepper.machine.libraries.chart_library import CHARTED, ChartLibrary
from CNCStepper.machine.libraries.material_library import MaterialLibrary
from CNCStepper.machine.libraries.table_draft import Column, Library, TableDraft, text_of, value_of
from CNCStepper.machine.libraries.tool_library import ToolLibrary, keep_tool, library_path, library_tools
from CNCStepper.machine.materials import material, material_names, shipped_materials
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_files import read_tools


@pytest.fixture(autouse=True)
def config(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give the user an empty folder of his own."""
    for module in ("libraries.tool_library", "materials", "cut_charts"):
        monkeypatch.setattr(f"CNCStepper.machine.{module}.config_folder", lambda: tmp_path / "config")
    assert profile_files.config_folder() != tmp_path
    return tmp_path / "config"


def with_cells(library: Library, row: int, **cells: str) -> TableDraft:
    draft = TableDraft(library)
    if row == len(draft.table):
        draft.add(row - 1)
    draft.table[row].texts.update(cells)
    return draft


def test_a_tool_that_is_typed_comes_back_from_freecad_s_own_files() -> None:
    draft = with_cells(ToolLibrary(), 0, name="Sign cutter", shape="v", diameter_mm="6,35", tip_angle_deg="60")
    assert draft.is_changed and not draft.judged()[1]
    assert draft.save() == library_path() and not draft.is_changed
    [stored] = read_tools(library_path())
    assert (stored.name, stored.tool) == ("Sign cutter", Tool(number=1, shape="v", diameter_mm=6.35, tip_angle_deg=60))
    assert keep_tool("Mill", Tool(number=1, shape="flat", diameter_mm=3, flutes=2)) == 2
    assert [each.name for each in library_tools()] == ["Sign cutter", "Mill"]
    draft = TableDraft(ToolLibrary())
    assert draft.found("mill 2") == [1] and draft.found("SIGN") == [0] and draft.found("drill") == []
    draft.delete([0])
    draft.save()
    assert [path.name for path in library_path().parent.glob("*.fctb")] == ["2_Mill.fctb"]


def test_every_bad_cell_has_its_sentence_and_a_copy_a_number_of_its_own() -> None:
    draft = with_cells(ToolLibrary(), 0, diameter_mm="six", flutes="2.5", shape="spade")
    keys = {key for _, key in draft.judged()[1]}
    assert keys == {"diameter_mm", "flutes", "shape"}
    draft = with_cells(ToolLibrary(), 0, diameter_mm="6")
    assert draft.duplicate(0) == 1 and draft.table[1].texts == {**draft.table[0].texts, "number": "2"}
    draft.table[1].texts["number"] = "1"
    draft.table[0].texts.update(shape="drill", corner_radius_mm="1")
    assert set(draft.judged()[1]) == {(1, "number"), (0, "corner_radius_mm")}


@pytest.mark.parametrize("ending", [".fctl", ".tbl"])
def test_tools_go_to_other_programs_and_come_back_under_free_numbers(tmp_path: Path, ending: str) -> None:
    draft = with_cells(ToolLibrary(), 0, name="flat mill", diameter_mm="8")
    assert draft.export_file(tmp_path / f"other{ending}", [0]) == []
    draft.import_file(tmp_path / f"other{ending}")
    assert [row.texts["number"] for row in draft.table] == ["1", "2"]
    assert [row.texts["diameter_mm"] for row in draft.table] == ["8", "8"] and not draft.judged()[1]


def test_a_changed_material_takes_the_place_of_the_shipped_one_and_a_new_one_joins(config: Path) -> None:
    names, shipped = material_names(), shipped_materials()["hdpe"]
    draft = TableDraft(MaterialLibrary())
    assert not draft.judged()[1] and [row.texts["key"] for row in draft.table] == names
    draft.table[names.index("hdpe")].texts["carbide_speed_m_min"] = "111 222"
    added = draft.add(len(names) - 1)
    draft.table[added].texts["key"] = "cork"
    path = draft.save()
    assert path == config / "materials.toml" and path.read_text("utf-8").count("carbide =") == 0
    assert material("hdpe").carbide.speed_m_min == (111, 222) != shipped.carbide.speed_m_min
    assert material_names() == [*names, "cork"]
    draft.delete([names.index("hdpe")])
    draft.save()
    assert material("hdpe") == shipped
    draft.table[0].texts["carbide_chip_load_mm"] = "5 0.07 0.03"
    assert {key for _, key in draft.judged()[1]} == {"carbide_speed_m_min"}


@pytest.mark.parametrize("process", CHARTED)
def test_a_shipped_chart_that_is_only_looked_at_is_whole(process: str) -> None:
    rows, problems = TableDraft(ChartLibrary(process)).judged()
    assert not problems
    read = [
        CutData.model_validate({"process": process, **{k: v for k, v in row.items() if v is not None}})
        for row, _ in rows
    ]
    assert tuple(read) == shipped_chart(process)


def test_a_chart_of_one_s_own_takes_the_place_of_the_shipped_one(tmp_path: Path, config: Path) -> None:
    draft = with_cells(ChartLibrary("laser"), 0, feed_mm_min="1234")
    row = draft.judged()[0][0][0]
    assert draft.save() == config / "charts" / "laser.toml"
    assert cut_data_for("laser", row["material"], row["thickness_mm"], row["consumable"]).feed_mm_min == 1234
    write_chart(tmp_path / "two.toml", [*shipped_chart("laser")[:1], *shipped_chart("plasma")[:1]])
    notes = draft.import_file(tmp_path / "two.toml")
    assert len(notes) == 1 and {key for _, key in draft.judged()[1]} == {"thickness_mm"}
    with pytest.raises(JobError, match="library"):
        draft.export_file(tmp_path / "two.txt", [0])


def test_cells_are_read_as_they_are_shown() -> None:
    assert text_of(((5.0, 0.03), (8.0, 0.05))) == "5 0.03; 8 0.05"
    assert value_of("5 0,03; 8 0.05", Column("loads", "rows")) == ((5.0, 0.03), (8.0, 0.05))
    assert (
        value_of(" ", Column("feed")) is None and value_of("false", Column("thc", "choice", ("true", "false"))) is False
    )
    for text in ("1.2.3", "nan", "1e999", "x"):
        with pytest.raises(ValueError, match="no number"):
            value_of(text, Column("feed"))


def test_a_material_goes_to_freecad_and_comes_back(tmp_path: Path) -> None:
    draft = TableDraft(MaterialLibrary())
    row = material_names().index("pvc")
    assert draft.export_file(tmp_path / "pvc.FCMat", [row]) == []
    draft.delete([row])
    assert draft.import_file(tmp_path / "pvc.FCMat") == [] and not draft.judged()[1]
    assert draft.judged()[0][-1][0]["turning_force_n_mm2"] == 161.4447
    assert draft.table[-1].texts == TableDraft(MaterialLibrary()).table[row].texts
    with pytest.raises(JobError, match="fcmat-one"):
        draft.export_file(tmp_path / "two.FCMat", [0, 1])
    assert not (tmp_path / "two.FCMat").exists()
