# SPDX-License-Identifier: LGPL-2.1-or-later
"""Beams on axes with play: what takes the play up in the sheet is no rapid with the beam on."""

import numpy as np
import pytest

from CNCStepper.job.prove import prove
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import RAPID

SQUARE = """G21 G90 G17 G94
G0 X-20 Y-15 Z1.5
{beam} S1000
G4 P3
G1 X20 F600
Y15
X-20
Y-15
M5
G0 Z10
M2
"""
TABLE = load_machine("table-a")


@pytest.mark.parametrize(("laser", "beam"), [(False, "M3"), (True, "M3"), (True, "M4")])
def test_play_is_taken_up_in_the_sheet_without_a_finding(laser: bool, beam: str) -> None:
    axes = {name: axis.model_copy(update={"backlash_mm": 0.2}) for name, axis in TABLE.axis.items()}
    spindle = TABLE.spindle.model_copy(update={"laser": laser})
    machine = TABLE.model_copy(update={"axis": axes, "spindle": spindle})
    tool = Tool(number=1, shape="jet", diameter_mm=0.8)
    proof = prove(SQUARE.format(beam=beam), machine, stock=Stock((60, 50, 3)), tools=tool)
    assert [finding for finding in proof.findings if finding.severity == "error"] == []
    table = proof.motors.table()
    stands = np.abs(proof.toolpath.table().end - proof.toolpath.begins()).max(axis=1) < 1e-6
    on = np.array([state.spindle_turns for state in proof.motors.states])[table.state]
    taken_up = table.kind[stands & on]
    assert len(taken_up) >= 3 and ((taken_up == RAPID) == laser).all()
