# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two lathe programs of one bar: diameters, volumes, bars, tools, and that a mill's program is refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely

from CNCStepper.errors import JobError
from CNCStepper.job.comparison.compare_programs import (
    ComparedProgram,
    ProgramComparison,
    compare_programs,
    report_of,
    rows,
    sentences,
)
from CNCStepper.job.comparison.lathe_setup import LatheSetup, setup_of_bar, setup_of_job
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.prove_program import TurnedBar
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.turning_tool import TurningTool

JOBS = Path(__file__).parents[4] / "examples" / "jobs"
BLADE = TurningTool(number=1, kind="parting", width_mm=3, reach_mm=30)
HEAD = "G21 G18 G7 G90 G94\nT1 M6\nS1000 M3\nG0 X60 Z5\n"
STEP = HEAD + "G0 X60 Z-43\nG1 X50 F100\nG1 Z5\nG0 X60\nM2\n"  # the blade's right corner is at Z-40
DRILLED = HEAD + "T2 M6\nG0 X0 Z5\nG1 Z-30 F100\nG0 Z5\nM2\n"
THREAD = HEAD + "G0 X52 Z4\nG33 Z-20 K{pitch}\nG0 X60\nG0 Z5\nM2\n"


def setup(*tools: TurningTool, diameter_mm: float = 55.0) -> LatheSetup:
    stock = TurnedBar(diameter_mm, 170.0, face_mm=1.0)
    known = {tool.number: tool for tool in tools or (BLADE,)}
    return setup_of_bar(stock, known, load_machine("mini-lathe"), "linuxcnc", None)


def compared(first: str, second: str, lathe: LatheSetup, other: LatheSetup | None = None) -> ProgramComparison:
    programs = [
        ComparedProgram(name, text, "linuxcnc", lathe=each)
        for name, text, each in (("a.ngc", first, lathe), ("b.ngc", second, other or lathe))
    ]
    return compare_programs(*programs)


def test_a_step_that_is_a_tenth_smaller_is_told_with_both_diameters_and_the_volume() -> None:
    found = compared(STEP, STEP.replace("X50", "X49.9"), setup())
    assert found.part is not None
    corner = shapely.box(-43, 24.95, 1, 25)  # of the judge: what lies between both cylinders
    volume_mm3 = 2 * np.pi * corner.area * corner.centroid.y
    assert found.part.only_second_mm3 == pytest.approx(volume_mm3, rel=0.002)
    assert found.part.only_first_mm3 == pytest.approx(0.0, abs=1e-6)
    (ring,) = report_of(found)["part"]["rings"]
    assert ring["first"] is False and ring["diameters_mm"] == pytest.approx((49.9, 50), abs=1e-6)
    assert ring["z_mm"] == pytest.approx((-43, 1), abs=0.2)
    shown = {name: values for name, *values in rows(found)}
    assert shown[f"diameter at Z{ring['at_z_mm']:.3f}"] == ["ø50.000", "ø49.900"]
    assert shown["cut length"] == ["53.00 mm", "53.05 mm"] and shown["Y"] == ["-", "-"]
    told = next(each for each in sentences(found) if "turned parts" in each)
    assert "by up to 0.050 mm" in told and "ø50.000 and ø49.900, 0.100 mm in diameter" in told
    json.dumps(report_of(found), allow_nan=False)
    same = compared(STEP, STEP.replace("X50", "X50.01"), setup())
    assert "the turned parts are the same within 0.02 mm" in list(sentences(same))


def test_a_bore_and_a_thread_are_compared_by_their_profiles() -> None:
    drills = [TurningTool(number=2, kind="drill", diameter_mm=size) for size in (20, 20.5)]
    bores = compared(DRILLED, DRILLED, *(setup(BLADE, drill) for drill in drills))
    assert bores.paths.same and bores.part is not None
    assert bores.part.rings[0].side == "bore" and bores.part.rings[0].of_both_mm == pytest.approx((20, 20.5))
    assert any("bores of ø20.000 and ø20.500" in each for each in sentences(bores))
    insert = TurningTool(number=1, kind="threading", tip_angle_deg=60, nose_radius_mm=0)
    threads = compared(THREAD.format(pitch="1.5"), THREAD.format(pitch="2"), setup(insert, diameter_mm=54))
    assert threads.part is not None and len(threads.part.rings) > 10
    shown = [name for name, *_ in rows(threads) if name.startswith("diameter at")]
    assert 1 < len(shown) <= 12
    assert f"the turned parts differ at {len(threads.part.rings)} places" in list(sentences(threads))


def test_bars_that_differ_nothing_cut_and_unknown_tools_are_told() -> None:
    air = HEAD + "G1 Z-40 F100\nM2\n"
    told = list(sentences(compared(STEP, air, setup(), setup(diameter_mm=54))))
    what = "the bars differ, ø55 × 171 mm and ø54 × 171 mm: both parts are cut out of the first one"
    assert what in told and "b.ngc cuts nothing of the bar" in told
    unknown = list(sentences(compared(STEP, DRILLED, setup())))
    assert "b.ngc: the shape of tool 2 is not known, its cuts from line 7 on are left out" in unknown


@pytest.mark.parametrize("as_lathe", [True, False])
def test_a_mills_program_is_refused_beside_a_lathes(as_lathe: bool) -> None:
    plate = "G21 G90\nM3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X40 Y10\nM2\n"
    turned = ComparedProgram("shaft.ngc", STEP, "linuxcnc", lathe=setup() if as_lathe else None)
    milled = ComparedProgram("plate.ngc", plate, "linuxcnc")
    for pair in ((turned, milled), (milled, turned), (turned, replace(milled, text="G0 X1\nM2\n", milled=True))):
        with pytest.raises(JobError, match=r"plate\.ngc is a mill's program and shaft\.ngc a lathe's"):
            compare_programs(*pair)
    with pytest.raises(JobError, match="moves along Y"):
        compare_programs(replace(milled, lathe=setup()), milled)


def test_a_program_of_a_split_job_is_cut_behind_those_before_it() -> None:
    job, machine = load_turning_job(JOBS / "lathe-shaft.toml")
    text = make_turning(job, machine)[2].program
    deeper = text.replace("X-45.0000", "X-45.2000")  # from ø75: the groove's floor
    lathe, start = setup_of_job(job, machine, [deeper, text], None, None)
    programs = [
        ComparedProgram(name, each, machine.language(), start, lathe)
        for name, each in (("a.nc", text), ("b.nc", deeper))
    ]
    found = compare_programs(*programs)
    assert found.turned is not None and found.part is not None
    assert found.turned[0].section.diameter_mm(-20) == pytest.approx(24, abs=0.01)  # of the program before
    assert found.part.rings[0].of_both_mm == pytest.approx((30, 29.8), abs=1e-3)
    assert found.part.rings[0].at_z_mm < 0 and not found.part.rings[0].first
    with pytest.raises(JobError, match="this is not one of them"):
        setup_of_job(job, machine, [deeper], None, None)
    with pytest.raises(JobError, match="one program"):
        setup_of_job(*load_turning_job(JOBS / "lathe-cylinder.toml"), [], 1, None)
