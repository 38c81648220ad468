# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool changes as each machine wants them, with its rule of lengths; LinuxCNC's own interpreter reads its texts."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.simulation.tip_segments import tips_mm
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from helpers.gcode.rs274_runs import run_rs274, same_call
from helpers.gcode.writer_toolpaths import two_tools

LENGTHS = {1: 41.5, 2: 63.25}
OPTIONS = WriteOptions(title="Peça nº 1", spin_up_s=3, tools={1: "flat 6 mm", 2: "ball 2 mm"}, tool_lengths_mm=LENGTHS)
START = Start(tool_lengths_mm=LENGTHS)
WAYS = [
    ("grbl", "pause", "touch_off", "mm", "nc"),
    ("grbl", "pause", "table", "mm", "nc"),
    ("grbl", "pause", "table", "inch", "nc"),
    ("linuxcnc", "m6", "touch_off", "mm", "ngc"),
    ("linuxcnc", "m6", "table", "mm", "ngc"),
    ("linuxcnc", "m6", "table", "inch", "ngc"),
    ("linuxcnc", "pause", "none", "mm", "ngc"),
]


def written(dialect: str, change: str, length: str, units: str) -> str:
    options = replace(OPTIONS, tool_change=change, tool_length=length, units=units)  # type: ignore[arg-type]
    return write(two_tools(), dialect, options)


def code(text: str) -> list[str]:
    return [line for line in text.splitlines() if not line.startswith("(")]


@pytest.mark.parametrize(("dialect", "change", "length", "units", "suffix"), WAYS)
def test_golden_programs_of_each_way_to_change_tools(dialect, change, length, units, suffix, golden) -> None:
    text = written(dialect, change, length, units)
    golden(f"gcode/change.{dialect}.{change}.{length}.{units}.{suffix}", text)
    assert not re.search(r"^T\d+$", text.split("M5\n", 1)[1], re.MULTILINE) or "M0\n" in text


@pytest.mark.parametrize(("dialect", "change", "length", "units", "suffix"), WAYS)
def test_before_a_change_the_tool_is_up_and_everything_off_and_the_spindle_waits_after_it(
    dialect, change, length, units, suffix
) -> None:
    path = interpret(written(dialect, change, length, units), START, dialect)
    stop = next(event for event in path.events if event.kind in ("pause", "tool_change") and event.index)
    state, (_, tips) = path.states[stop.state], tips_mm(path)
    assert state.spindle == "off" and not state.flood
    assert tips[stop.index - 1, 2] >= 10.0 - 1e-9
    after = path.states[path.table().state[stop.index]]
    assert (after.tool, after.spindle, after.spindle_rpm) == (2, "cw", 8000)
    assert any(event.kind == "dwell" and event.value == 3.0 and event.index == stop.index for event in path.events)


def tip_table(path: Toolpath) -> np.ndarray:
    return tips_mm(path)[1]


@pytest.mark.parametrize("dialect", ["grbl", "linuxcnc"])
def test_with_length_offsets_the_tips_path_is_that_of_tools_of_one_length(dialect) -> None:
    change = "m6" if dialect == "linuxcnc" else "pause"
    level = interpret(written(dialect, change, "none", "mm"), START, dialect)
    offset = interpret(written(dialect, change, "table", "mm"), START, dialect)
    assert [state.tool_length_mm for state in offset.states[-1:]] == [63.25]
    assert np.allclose(tip_table(level)[2:8], tip_table(offset)[2:8])
    assert np.allclose(tip_table(level)[-4:], tip_table(offset)[-4:])
    assert np.allclose(offset.table().end[-1, 2] - level.table().end[-1, 2], 63.25)


def test_a_longer_tool_clears_the_stock_where_the_shorter_one_stood() -> None:
    path = interpret(written("grbl", "pause", "table", "mm"), START)
    lifted = next(event.index for event in path.events if event.kind == "pause")
    assert tip_table(path)[lifted - 1, 2] == pytest.approx(10.0 + 63.25 - 41.5)
    begins, _ = tips_mm(path)
    assert begins[lifted, 2] == pytest.approx(10.0)


def test_a_length_that_nobody_knows_is_refused_where_the_text_must_name_it() -> None:
    options = replace(OPTIONS, tool_length="table", tool_lengths_mm={1: 41.5})
    with pytest.raises(ProgramError, match=r"tool 2 is not known.*length_offset_mm"):
        write(two_tools(), "grbl", options)
    assert "G43 H2" in write(two_tools(), "linuxcnc", replace(options, tool_change="m6"))


@pytest.mark.parametrize("length", ["touch_off", "table", "none"])
@pytest.mark.parametrize("units", ["mm", "inch"])
def test_rs274_reads_the_text_as_we_do(length, units, tmp_path: Path) -> None:
    text = written("linuxcnc", "m6", length, units)
    (tmp_path / "program.ngc").write_text(text, "ascii")
    rows = "".join(f"T{number} P{number} Z{z_mm / 25.4:.6f}\n" for number, z_mm in LENGTHS.items())
    (tmp_path / "tool.tbl").write_text(rows, "ascii")  # the stand-alone interpreter's table is in inches
    run = run_rs274(tmp_path, "-t", "tool.tbl", "program.ngc")
    assert run.returncode == 0, run.stdout + run.stderr
    theirs = [line for line in map(str.rstrip, run.stdout.splitlines()) if line]
    ours = list(canonical_calls(text, tool_lengths_mm=LENGTHS))
    assert sum("CHANGE_TOOL(" in call for call in ours) == 2
    assert sum("USE_TOOL_LENGTH_OFFSET" in call for call in ours) == (3 if length == "table" else 1)
    assert len(ours) == len(theirs)
    for mine, real in zip(ours, theirs, strict=True):
        assert same_call(mine, real), f"ours {mine}\nreal {real}"
