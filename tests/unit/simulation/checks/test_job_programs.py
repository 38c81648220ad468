# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example jobs, made, read back from their text and judged; then broken on purpose."""

from functools import cache
from pathlib import Path

import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start

JOBS = Path(__file__).parents[4] / "examples" / "jobs"
START = Start.with_work_zero((-300.0, -300.0, -40.0))


@cache
def made(name):
    job, machine = load_job(JOBS / name)
    return job, machine, make_program(job, machine)


def findings(name, change=lambda text: text, diameter_mm=0.0):
    job, machine, program = made(name)
    toolpath = interpret(change(program.program), START, machine.controller, name)
    tools = {
        number: tool.model_copy(update={"diameter_mm": diameter_mm or tool.diameter_mm})
        for number, tool in job.tools.items()
    }
    found = check(toolpath, machine, file=name, stock=job.stock.stock(), tools=tools, removals=program.removals)
    return [(finding.code, round(finding.value or 0, 3)) for finding in found]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["elliptical-pocket.toml", "brazil-engraving.toml"])
def test_the_examples_are_clean(name):
    assert findings(name) == []


@pytest.mark.slow
def test_a_floor_two_hundredths_off_is_found():
    deep = findings("elliptical-pocket.toml", lambda text: text.replace("Z-10.000", "Z-10.020"))
    assert deep == [("gouge", pytest.approx(0.02, abs=0.0015))]  # with the wall's own 0.006 beside it
    high = findings("elliptical-pocket.toml", lambda text: text.replace("Z-10.000", "Z-9.980"))
    assert high == [("left-over", pytest.approx(0.02, abs=0.0015))]


@pytest.mark.slow
def test_another_tool_than_the_programs_is_found():
    ((code, thick),) = findings("elliptical-pocket.toml", diameter_mm=6.1)
    assert (code, thick) == ("gouge", pytest.approx(0.05, abs=0.01))
    ((code, thick),) = findings("elliptical-pocket.toml", diameter_mm=5.9)
    assert (code, thick) == ("left-over", pytest.approx(0.05, abs=0.01))


def test_an_engraving_with_one_point_moved_is_found():
    found = dict(findings("brazil-engraving.toml", lambda text: text.replace("Y36.378", "Y36.428")))
    assert found == {"gouge": pytest.approx(0.05, abs=0.01), "left-over": pytest.approx(0.05, abs=0.01)}


def test_a_drawing_larger_than_the_stock_cuts_air_beside_it():
    job, machine, program = made("brazil-engraving.toml")
    toolpath = interpret(program.program, START, machine.controller)
    small = Stock((150.0, 150.0, 6.0), "top-left-front")
    assert check(toolpath, machine, stock=small, tools=job.tools, removals=program.removals) == []


@pytest.mark.slow
def test_a_missing_finishing_pass_is_found():
    """The last pass of the deepest level follows the last straight link of the program."""

    def shortened(text):
        lines = text.splitlines()
        link = max(k for k, line in enumerate(lines) if line.startswith("G1 "))
        after = max(k for k, line in enumerate(lines) if line.startswith("G3 ")) + 1
        return "\n".join(lines[:link] + lines[after:])

    ((code, thick),) = findings("elliptical-pocket.toml", shortened)
    assert (code, thick) == ("left-over", pytest.approx(0.3, abs=0.1))
