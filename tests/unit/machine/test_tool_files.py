# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's and LinuxCNC's own tool files: read, written, read again; nothing is lost unsaid."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.errors import JobError
from CNCStepper.job.model import load_job, save_job
from CNCStepper.machine.tools.stored_tool import StoredTool, given_keys
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_files import read_tools, write_tools

DATA = Path(__file__).parents[2] / "data" / "tools"
BITS = sorted((DATA / "Bit").glob("*.fctb"))
LIBRARY = DATA / "Library" / "Default.fctl"
SAMPLES = Path("/usr/share/doc/linuxcnc/examples/sample-configs")
TABLE = SAMPLES / "common" / "tool.tbl"
TABLES = [TABLE, SAMPLES / "sim/axis/vismach/millturn/millturn.tbl", SAMPLES / "by_machine/boss/boss.tbl"]
RICH = [
    Tool(number=1, shape="flat", diameter_mm=6.35, flutes=2, made_of="hss", feed_mm_min=800, length_offset_mm=12.5),
    Tool(number=2, shape="bullnose", diameter_mm=10, corner_radius_mm=1.23456789, flute_length_mm=22),
    Tool(number=3, shape="v", diameter_mm=6, tip_angle_deg=60, tip_diameter_mm=0.2),
    Tool(number=4, shape="engraver", diameter_mm=3.175, tip_angle_deg=20, tip_diameter_mm=0.1),
    Tool(number=5, shape="drill", diameter_mm=3.3, point_angle_deg=118, length_mm=40, holder_diameter_mm=20),
    Tool(number=6, shape="ball", diameter_mm=2, chip_load_max_mm=0.02, flutes=4),
]


def stored(tool: Tool) -> StoredTool:
    return StoredTool(tool.number, f"{tool.words}, nº {tool.number}", tool)


@pytest.mark.parametrize(
    ("name", "keys"),
    [
        ("5mm_Drill", {"shape": "drill", "diameter_mm": 5.0, "point_angle_deg": 119.0}),
        ("60degree_Vbit", {"shape": "v", "tip_angle_deg": 60.0, "tip_diameter_mm": 1.0, "flute_length_mm": 1.0}),
        ("6mm_Bullnose", {"shape": "bullnose", "corner_radius_mm": 1.5, "flute_length_mm": 40.0}),
        ("6mm_Bullnose-1.1", {"shape": "bullnose", "corner_radius_mm": 1.5, "flute_length_mm": 40.0}),
        ("3.175mm_Endmill", {"shape": "flat", "diameter_mm": 3.175, "flute_length_mm": 25.0}),
    ],
)
def test_the_bits_of_real_freecads_are_read(name: str, keys: dict[str, object]) -> None:
    (found,) = read_tools(DATA / "Bit" / f"{name}.fctb")
    assert found.tool is not None and not found.notes
    assert {key: getattr(found.tool, key) for key in keys} == keys


def test_a_flat_radius_is_that_of_the_flat_and_not_of_the_corner(tmp_path: Path) -> None:
    bit = json.loads((DATA / "Bit" / "6mm_Bullnose.fctb").read_text("utf-8"))
    bit["parameter"]["FlatRadius"] = "1.0000 mm"
    (tmp_path / "a.fctb").write_text(json.dumps(bit), encoding="utf-8")
    assert read_tools(tmp_path / "a.fctb")[0].tool.corner_radius_mm == 2.0  # type: ignore[union-attr]


def test_a_flat_radius_without_a_diameter_is_told(tmp_path: Path) -> None:
    bit = {"shape": "bullnose.fcstd", "parameter": {"FlatRadius": "1.0000 mm"}}
    (tmp_path / "a.fctb").write_text(json.dumps(bit), encoding="utf-8")
    (found,) = read_tools(tmp_path / "a.fctb")
    assert found.tool is None and "diameter_mm" in found.notes[0]


@pytest.mark.parametrize("name", ["slittingsaw", "375-16_Tap"])
def test_a_shape_that_we_do_not_have_is_told_and_kept_whole(name: str, tmp_path: Path) -> None:
    (found,) = read_tools(DATA / "Bit" / f"{name}.fctb")
    assert found.tool is None and "its shape" in found.notes[0]
    with pytest.raises(JobError, match="cannot be used"):
        found.required("a.fctb")
    write_tools([found], tmp_path / "a.fctb")
    assert json.loads((tmp_path / "a.fctb").read_text("utf-8")) == found.raw
    assert "left out" in write_tools([found], tmp_path / "a.tbl")[0]
    assert (tmp_path / "a.tbl").read_text("utf-8") == ""


@pytest.mark.parametrize("path", BITS, ids=lambda path: path.stem)
def test_a_bit_read_and_written_says_what_it_said(path: Path, tmp_path: Path) -> None:
    write_tools(read_tools(path), tmp_path / "a.fctb")
    assert json.loads((tmp_path / "a.fctb").read_text("utf-8")) == json.loads(path.read_text("utf-8"))


def test_a_library_finds_its_bits_and_tells_those_that_it_does_not_find() -> None:
    tools = read_tools(LIBRARY)
    assert [tool.number for tool in tools] == list(range(1, 10))
    assert {tool.number for tool in tools if tool.tool is not None} == {2, 4, 5}
    assert "neither here nor in ../Bit" in tools[0].notes[0] and tools[0].name == "5mm_Endmill"


@pytest.mark.parametrize("ending", ["fctl", "fctb"])
def test_our_tools_come_back_from_freecads_files_as_they_were(ending: str, tmp_path: Path) -> None:
    folder = tmp_path / "Library"
    folder.mkdir()
    if ending == "fctl":
        assert write_tools([stored(tool) for tool in RICH], folder / "oficina.fctl") == []
        assert len(list((tmp_path / "Bit").glob("*.fctb"))) == len(RICH)
        assert [each.tool for each in read_tools(folder / "oficina.fctl")] == RICH
        return
    for tool in RICH:
        write_tools([stored(tool)], folder / "a.fctb")
        (again,) = read_tools(folder / "a.fctb")
        assert again.tool == tool.model_copy(update={"number": 1}) and again.name == stored(tool).name
    with pytest.raises(JobError, match=r"write a library.*fctl"):
        write_tools([stored(tool) for tool in RICH], folder / "a.fctb")


def test_linuxcncs_own_table_is_read_in_its_unit() -> None:
    tools = read_tools(TABLE, unit_mm=25.4)
    assert [(each.number, each.tool and each.tool.shape) for each in tools] == [
        (1, "flat"),
        (2, "flat"),
        (3, "drill"),
        (99999, None),
    ]
    assert tools[0].tool is not None and tools[0].tool.diameter_mm == pytest.approx(3.175)
    assert tools[0].tool.length_offset_mm == pytest.approx(12.9794)
    assert "no diameter" in tools[3].notes[0]


@pytest.mark.parametrize("path", TABLES, ids=lambda path: path.stem)
def test_a_table_read_and_written_has_the_same_words_also_those_of_a_lathe(path: Path, tmp_path: Path) -> None:
    tools = read_tools(path)
    write_tools(tools, tmp_path / "tool.tbl")
    again = read_tools(tmp_path / "tool.tbl")
    assert [each.raw["words"] for each in again] == [each.raw["words"] for each in tools]
    assert [each.tool for each in again] == [each.tool for each in tools]


def test_every_sample_table_of_linuxcnc_is_read_or_refused_with_its_line() -> None:
    paths = [path for path in sorted(SAMPLES.rglob("*.tbl")) if path.is_file()]
    refused = []
    for path in paths:
        try:
            assert read_tools(path)
        except JobError as error:
            refused.append(path)
            assert "TOOLNO POCKET" in str(error) and error.place is not None and error.place.line == 1
    assert len(paths) > 50 and len(refused) <= 3  # the format that LinuxCNC left in 2010


def test_our_tools_come_back_from_a_table_and_what_it_cannot_hold_is_told(tmp_path: Path) -> None:
    notes = write_tools([stored(tool) for tool in RICH], tmp_path / "tool.tbl", unit_mm=25.4)
    again = read_tools(tmp_path / "tool.tbl", unit_mm=25.4)
    for before, after in zip(RICH, again, strict=True):
        assert after.tool is not None
        assert after.tool.diameter_mm == pytest.approx(before.diameter_mm, abs=2e-5)
        assert after.tool.length_offset_mm == pytest.approx(before.length_offset_mm, abs=2e-5)
        lost = set(given_keys(before)) - {"number", "shape", "diameter_mm", "length_offset_mm"}
        assert all(any(f"tool {before.number} " in note and key in note for note in notes) for key in lost)


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("a.tbl", "T1 P1 D6\nfeed 800\n", "a.tbl:2: not a tool of a table"),
        ("a.tbl", "P1 D6\n", "a.tbl:1"),
        ("a.fctb", "{", "a.fctb: not a JSON file"),
        ("a.fctb", "[]", "no object"),
        ("a.fctb", "{}", "not a tool bit"),
        ("a.fctb", '{"shape": "drill", "parameter": {}, "attribute": [1]}', "its attribute is no object"),
        ("a.fctb", '{"shape": "drill", "parameter": {}, "CNCStepper": "x"}', "its CNCStepper is no object"),
        ("a.fctl", '{"tools": 3}', "not a tool library"),
        ("a.fctl", '{"tools": [{"path": "a.fctb"}]}', "no number nr or no path"),
        ("a.fctl", '{"tools": [{"nr": null, "path": "a.fctb"}]}', "no number nr or no path"),
        ("a.fctl", '{"tools": [{"nr": Infinity, "path": "a.fctb"}]}', "no number nr or no path"),
        ("a.fctl", '{"tools": [{"nr": 1, "path": 7}]}', "no number nr or no path"),
        ("a.fctl", '{"tools": ["a.fctb"]}', "no number nr or no path"),
        ("a.csv", "", "ends in .fctb, .fctl, .tbl"),
    ],
)
def test_what_is_no_tool_file_is_refused_with_its_place(name: str, text: str, told: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(JobError) as caught:
        read_tools(tmp_path / name)
    assert told in str(caught.value)
    with pytest.raises(JobError):
        read_tools(tmp_path / f"none-{name}")


JOB = """
machine = "table-a"
clearance_mm = 10
retract_mm = 2
tools = {tools}
stock = {{ size_mm = [60, 50, 10], origin = "top-centre" }}
[[operation]]
cycle = "elliptical_pocket"
tool = {number}
radius_x_mm = 20
radius_y_mm = 12
depth_mm = 4
stepdown_mm = 2
stepover_mm = 0.5
{more}
"""


def job_with(folder: Path, tools: str, number: int = 1, more: str = "") -> Path:
    (folder / "job.toml").write_text(JOB.format(tools=tools, number=number, more=more), encoding="utf-8")
    return folder / "job.toml"


def test_a_job_takes_its_tools_from_a_file_and_says_more_of_them(tmp_path: Path) -> None:
    (tmp_path / "tool.tbl").write_bytes(TABLE.read_bytes())
    more = "[[tool]]\nnumber = 1\nfeed_mm_min = 500\nplunge_mm_min = 90\nspindle_rpm = 9000"
    job, _ = load_job(job_with(tmp_path, '{ file = "tool.tbl", unit_mm = 25.4 }', more=more))
    assert [tool.number for tool in job.tool] == [1]
    assert job.tool[0].diameter_mm == pytest.approx(3.175) and job.tool[0].feed_mm_min == 500
    save_job(job, tmp_path / "a.json")
    (tmp_path / "tool.tbl").unlink()
    assert load_job(tmp_path / "a.json")[0] == job


def test_what_was_guessed_of_a_tool_goes_with_the_job(tmp_path: Path) -> None:
    (tmp_path / "tool.tbl").write_text("T1 D1 ;mysterious\nT2 D3 ;odd\n", encoding="utf-8")
    job, _ = load_job(job_with(tmp_path, '"tool.tbl"'))
    assert len(job.notes) == 1 and "tool 1 of tool.tbl: read as a flat mill" in job.notes[0]


def test_a_job_takes_its_tools_from_a_library(tmp_path: Path) -> None:
    write_tools([stored(tool) for tool in RICH], tmp_path / "oficina.fctl")
    job, _ = load_job(job_with(tmp_path, '"oficina.fctl"'))
    assert job.tool == (RICH[0],)


@pytest.mark.parametrize(
    ("tools", "number", "told"),
    [
        ('"none.fctl"', 1, "none.fctl"),
        ('"tool.tbl"', 99999, "'big tool number' cannot be used: the table gives it no diameter"),
        ('"tool.tbl"', 8, "uses tool 8, which neither the job nor tool.tbl has"),
        ("{ file = 'tool.tbl', unit = 25.4 }", 1, "unit_mm"),
    ],
)
def test_a_tool_that_a_file_does_not_have_is_refused(tools: str, number: int, told: str, tmp_path: Path) -> None:
    (tmp_path / "tool.tbl").write_bytes(TABLE.read_bytes())
    with pytest.raises(JobError) as caught:
        load_job(job_with(tmp_path, tools, number))
    assert told in str(caught.value)


def test_the_command_lists_and_converts(tmp_path: Path) -> None:
    result = CliRunner().invoke(group, ["tools", str(LIBRARY), "--to", str(tmp_path / "tool.tbl")])
    assert result.exit_code == 0, result.output
    assert "4: 6 mm Bull Nose: bullnose 6 mm, corner_radius_mm 1.5, flute_length_mm 40" in result.output
    assert "7: Slitting Saw: not a tool that cuts here" in result.output and "is left out" in result.output
    again = CliRunner().invoke(group, ["tools", str(tmp_path / "tool.tbl"), "--to", str(tmp_path / "b.fctl")])
    assert "2: 5mm Drill: drill 5 mm" in again.output and again.exit_code == 0
