# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs of processes with a cut chart: tool, feeds and power come from its row, heights from the machine."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest
import shapely

from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.errors import JobError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job, load_job, read_job, save_job
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.state import Start, State
from CNCStepper.toolpath import RAPID, TableBuilder

CHART = """
[[cut]]
process = "plasma"
material = "brass"
thickness_mm = 3.0
consumable = "45A"
feed_mm_min = 4000
kerf_mm = 1.4
pierce_delay_s = 0.4
[[cut]]
process = "hot-wire"
material = "foam"
thickness_mm = 50.0
feed_mm_min = 300
kerf_mm = 2.0
kerf_by_feed = [[150, 2.6], [300, 2.0], [600, 1.4]]
power = 420
"""
JOB = """
machine = "torch-table"
process = "plasma"
material = "brass"
chart = "chart.toml"
clearance_mm = 10
retract_mm = 2

[stock]
form = "sheet"
size_mm = [230, 150, 3]
origin = "top-left-front"

[[shape]]
name = "part"
circle_mm = { centre = [50, -50], radius = 20 }

[[operation]]
cycle = "contour"
curves = ["part"]
side = "outside"
depth_mm = 3
"""


def read(folder: Path, *changes: tuple[str, str]) -> tuple[Job, Machine]:
    (folder / "chart.toml").write_text(CHART, encoding="utf-8")
    text = JOB
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / "job.toml"
    path.write_text(text, encoding="utf-8")
    return load_job(path)


def setup_of(folder: Path, *changes: tuple[str, str]) -> Setup:
    job, machine = read(folder, *changes)
    return job.on(machine).setup(job.operation[0])


FOAM = (
    ('process = "plasma"', 'process = "hot-wire"'),
    ('material = "brass"', 'material = "foam"'),
    ("230, 150, 3]", "230, 150, 50]"),
)
WIRE = (*FOAM, ("torch-table", "wire-table"), ("clearance_mm = 10\nretract_mm = 2\n", ""))


def test_the_tool_is_made_from_the_charts_row(tmp_path: Path) -> None:
    setup = setup_of(tmp_path)
    tool = setup.tool
    assert (tool.number, tool.shape, tool.diameter_mm) == (1, "jet", 1.4)
    assert (tool.feed_mm_min, tool.plunge_mm_min) == (4000, load_machine("torch-table").axis["z"].max_rate_mm_min)
    assert setup.process.name == "plasma"
    assert setup.cut_data == CutData(
        process="plasma", material="brass", thickness_mm=3, consumable="45A", feed_mm_min=4000, kerf_mm=1.4,
        pierce_delay_s=0.4,
    )  # fmt: skip
    assert (setup.has_z, setup.power_s) == (True, load_machine("torch-table").spindle.max_rpm)


def test_the_charts_that_ship_serve_where_the_job_names_none(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ('chart = "chart.toml"\n', ""), ("brass", "mild-steel"))
    assert setup.cut_data is not None
    assert setup.cut_data.material == "mild-steel"
    assert setup.tool.diameter_mm == setup.cut_data.kerf_mm


def test_a_tool_that_is_given_wins_key_by_key(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, ("[[shape]]", "[[tool]]\nnumber = 1\ndiameter_mm = 1.8\n[[shape]]"))
    assert (setup.tool.diameter_mm, setup.tool.feed_mm_min, setup.tool.shape) == (1.8, 4000, "jet")
    assert setup.cut_data is not None
    assert (setup.cut_data.kerf_mm, setup.cut_data.feed_mm_min) == (1.8, 4000)


@pytest.mark.parametrize(
    ("own", "kerf_mm"), [("", 2.0), ("feed_mm_min = 450", 1.7), ("feed_mm_min = 450\ndiameter_mm = 1.9", 1.9)]
)
def test_the_kerf_is_that_of_the_tools_feed_for_cycle_and_simulation_alike(
    own: str, kerf_mm: float, tmp_path: Path
) -> None:
    table = ("[[operation]]", f"[[tool]]\nnumber = 1\n{own}\n[[operation]]")
    setup = setup_of(tmp_path, *WIRE, *([table] if own else []))
    assert setup.tool.diameter_mm == pytest.approx(kerf_mm) and setup.cut_data is not None
    assert setup.cut_data.kerf_at(setup.tool.feed_mm_min) == pytest.approx(kerf_mm)


def test_a_feed_at_which_the_chart_has_no_kerf_is_refused(tmp_path: Path) -> None:
    with pytest.raises(JobError, match="150 to 600 mm/min"):
        setup_of(tmp_path, *WIRE, ("[[operation]]", "[[tool]]\nnumber = 1\nfeed_mm_min = 700\n[[operation]]"))


def test_a_job_without_material_describes_its_tool(tmp_path: Path) -> None:
    bare = (('material = "brass"\nchart = "chart.toml"\n', ""),)
    with pytest.raises(JobError, match="names no material and has no tool"):
        read(tmp_path, *bare)
    tool = '[[tool]]\nnumber = 1\nshape = "jet"\ndiameter_mm = 1.8\nfeed_mm_min = 900\n[[shape]]'
    setup = setup_of(tmp_path, *bare, ("[[shape]]", tool))
    assert setup.cut_data is None
    assert setup.tool.feed_mm_min == 900


def test_the_power_of_a_wire_is_the_charts_and_heights_may_be_left_out_without_z(tmp_path: Path) -> None:
    setup = setup_of(tmp_path, *WIRE)
    assert (setup.tool.shape, setup.has_z, setup.power_s) == ("wire", False, 420)
    assert setup.thickness_mm == 50


def test_a_torch_that_is_a_switch_is_on_at_one(tmp_path: Path) -> None:
    job, machine = read(tmp_path)
    switch = Machine.model_validate({**machine.model_dump(exclude={"spindle"}), "processes": ["plasma"]})
    assert job.on(switch).setup(job.operation[0]).power_s == 1.0


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('process = "plasma"', 'process = "glue"', "no process 'glue'"),
        ('process = "plasma"', "process = 3", "process must be a text"),
        ('process = "plasma"', 'process = "oxyfuel"', "the chart has no row of oxyfuel"),
        ('material = "brass"', 'material = "glass"', "no material 'glass'.*use one of: brass"),
        ("230, 150, 3]", "230, 150, 30]", "30"),
        ('chart = "chart.toml"', 'chart = "none.toml"', "none.toml"),
        ("clearance_mm = 10\n", "", "clearance_mm"),
        ("[[shape]]", '[[tool]]\nnumber = 1\nshape = "flat"\n[[shape]]', "does not cut with a flat tool"),
        ("[[shape]]", "[[tool]]\nnumber = 2\n[[shape]]", "uses tool 1"),
    ],
)
def test_bad_jobs_are_refused_with_what_would_do(old: str, new: str, told: str, tmp_path: Path) -> None:
    with pytest.raises(JobError, match=told):
        read(tmp_path, (old, new))


def test_a_process_that_the_machine_does_not_name_is_refused(tmp_path: Path) -> None:
    job, _ = read(tmp_path)
    with pytest.raises(JobError, match=r"Laser table does not cut by plasma.*use one of: laser"):
        make_program(job, load_machine("laser-table"))


@pytest.mark.parametrize("changes", [(), WIRE], ids=["torch", "wire"])
def test_a_saved_job_is_the_same_without_its_chart(changes: tuple, tmp_path: Path) -> None:
    job, machine = read(tmp_path, *changes)
    saved = tmp_path / "saved.json"
    save_job(job, saved)
    (tmp_path / "chart.toml").unlink()
    again = read_job(saved)
    assert again.model_copy(update={"operation": job.operation}) == job
    assert again.on(machine).setup(again.operation[0]) == job.on(machine).setup(job.operation[0])


@dataclass(frozen=True)
class TwoCuts:
    """Two straight cuts as the contract of contour-powered cycles wants them."""

    cycle: str = "contour"
    tool: int = 1

    def kept(self) -> tuple:
        return ()

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        off = table.state
        on = State(**{**off.__dict__, "spindle": "cw", "spindle_rpm": setup.power_s})
        z = setup.clearance_mm if setup.has_z else 0.0
        for x in (10.0, 60.0):
            table.rapid((x, -20.0, z))
            table.set_state(on)
            table.event("dwell", setup.cut_data.pierce_delay_s if setup.cut_data else 0.0)
            table.feed((x + 30.0, -20.0, z), setup.tool.feed_mm_min)
            table.set_state(off)
        table.rapid((0.0, 0.0, z))
        return Answer([Removal(shapely.box(10, -21, 40, -19), 0.0, -3.0)])


@pytest.mark.parametrize(
    ("machine", "has_s"),
    [("torch-table", True), ("switch", False)],
)
def test_a_torch_program_switches_at_each_cut(machine: str, has_s: bool, tmp_path: Path) -> None:
    job, torch = read(tmp_path)
    job = job.model_copy(update={"operation": (TwoCuts(),)})
    if machine == "switch":
        content = torch.model_dump(exclude={"spindle"})
        del content["axis"]["z"]
        torch = Machine.model_validate(content)
    text = make_program(job, torch).program
    lines = [line for line in text.splitlines() if not line.startswith("(")]
    assert lines.count("M3 S1000" if has_s else "M3") == 2
    for number, line in enumerate(lines):
        if line.startswith("M3"):
            assert lines[number + 1] == "G4 P0.4"
    path = interpret(text, Start(), torch.language())
    table = path.table()
    on = [path.states[state].spindle_turns for state in table.state]
    assert on == [kind != RAPID for kind in table.kind]


def test_old_jobs_are_milling() -> None:
    job, machine = load_job(Path(__file__).parents[3] / "examples" / "jobs" / "elliptical-pocket.toml")
    setup = job.on(machine).setup(job.operation[0])
    assert (job.process, setup.process.name, setup.cut_data, setup.has_z) == ("milling", "milling", None, True)
