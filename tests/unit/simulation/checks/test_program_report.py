# SPDX-License-Identifier: LGPL-2.1-or-later
import json

import numpy as np
import pytest

from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.checks.program_report import report
from CNCStepper.simulation.exact.swept_area import judge
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock
from helpers.simulation.programs import FLAT, Program, begun, square_pocket, square_removal

STOCK = Stock((60, 50, 20))


def whole_report(program):
    toolpath = program.toolpath()
    judgement = judge(toolpath, FLAT, [square_removal()], STOCK)
    findings = check(toolpath, load_machine("table-a"), stock=STOCK, tools=FLAT, judgement=judgement)
    times_s = np.arange(1.0, len(toolpath) + 1)
    part = height_map(toolpath, FLAT, STOCK, 0.2)
    return report(toolpath, times_s, file="p.nc", findings=findings, judgement=judgement, part=part)


def test_the_report_is_strict_json_and_the_same_each_time():
    texts = [json.dumps(whole_report(square_pocket()), allow_nan=False) for _ in range(2)]
    assert texts[0] == texts[1]
    told = json.loads(texts[0])
    assert told["errors"] == 0
    assert told["findings"] == []
    assert told["gouge_mm"] < 0.001
    assert told["removed_volume_mm3"] == pytest.approx(4 * square_removal().region.area, rel=0.01)
    assert told["bounding_box_mm"] == {"min": [-17, -17, -4], "max": [17, 17, 5]}


def test_lengths_plunges_and_operations():
    program = begun()
    program.table.open_span("operation", "slot")
    program.feed(0, 0, -2).feed(10, 0, -2).feed(10, 0, 3)
    program.table.close_span()
    program.rapid(0, 0, 3)
    told = report(program.toolpath(), np.array([1.0, 2.0, 4.0, 7.0, 9.0, 10.0]))
    assert told["cut_length_mm"] == pytest.approx(2 + 10 + 2)
    assert told["air_length_mm"] == pytest.approx(5 + 3)
    assert told["rapid_length_mm"] == pytest.approx(10)
    assert told["plunges"] == 1
    (operation,) = told["operations"]
    assert (operation["name"], operation["time_s"], operation["moves"]) == ("slot", 7.0, 3)


def test_a_faulty_program_tells_what_is_wrong():
    told = whole_report(square_pocket(wall_mm=0.5).rapid(25, 0, 5).rapid(25, 0, -1))
    assert told["errors"] == 2
    assert len(told["rapids_in_stock"]) == 1
    assert told["gouge_mm"] == pytest.approx(1, abs=0.001)  # the rapid's; the wall's is 0.7
    assert whole_report(Program(zero_mm=(-10, -10, -40)).up_first(5).rapid(20, 0, 5))["limits_exceeded"]


def test_an_empty_program_is_told_without_nan():
    told = report(Program().toolpath(), np.zeros(0))
    assert json.dumps(told, allow_nan=False)
    assert told["bounding_box_mm"]["min"] == [None, None, None]


def test_pecks_and_levels_at_one_place_are_one_pierce_and_air_is_none():
    program = begun().feed(0, 0, 1).feed(0, 0, -1).rapid(0, 0, 3).feed(0, 0, -2)
    program.rapid(0, 0, 3).rapid(5, 0, 3).feed(5, 0, -1).feed(9, 0, -2).rapid(9, 0, 3).feed(9, 0, 1)
    told = report(program.toolpath(), np.zeros(len(program.toolpath())))
    assert (told["plunges"], told["pierces"]) == (5, 2)
