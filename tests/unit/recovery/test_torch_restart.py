# SPDX-License-Identifier: LGPL-2.1-or-later
"""A torch that begins again in the middle of its cut: behind the place, in its own kerf, pierced as before."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.recovery.restart.prove_restart import restart_program
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.recovery.tool_power_on import cut_begin, own_wait_s, pierce_height_mm
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID

WITH_Z = """G21 G17 G90
G54
G0 Z10
G0 X10 Y10
G0 Z3.8
M3 S1000
G4 P0.4
G1 Z1.5 F2000
G1 X20 F3000
G1 X60
G3 X60 Y50 I0 J20
G1 X10
M5
G0 Z10
G0 X100 Y100
G0 Z3.8
M3 S1000
G4 P0.6
G1 Z1.5 F2000
G1 X160 F3000
M5
G0 Z10
M2
"""
FLAT = "".join(line for line in WITH_Z.splitlines(keepends=True) if "Z" not in line)


def flat_table(process: str, spindle: bool) -> Machine:
    content = load_machine("torch-table").model_dump(mode="json") | {"processes": [process]}
    del content["axis"]["z"]
    if not spindle:
        del content["spindle"]
    return Machine.model_validate(content)


def restarted(program: str, machine: Machine, line: int) -> tuple[list[str], str]:
    """Return the restart's lines up to the program's own, and its whole text."""
    made = restart_program(program, machine, RequestedPlace(line=line), start=Start()).restart
    own = int(np.argmax(made.file_lines > 0))
    return made.text.splitlines()[:own], made.text


def test_it_pierces_at_its_height_behind_the_place_and_goes_down_to_the_cut() -> None:
    entry, text = restarted(WITH_Z, load_machine("torch-table"), 11)
    moves = [line for line in entry if not line.startswith("(")]
    begin = f"G0 X{60 - load_machine('torch-table').run_up_mm:g} Y10"
    assert moves[-6:] == [begin, "G1 Z3.8 F2000", "M3 S1000", "G4 P0.4", "G1 Z1.5 F2000", "G1 X60 Y10 Z1.5 F3000"]
    path = interpret(text, Start())
    on = np.array([path.states[state].spindle_turns for state in path.table().state])
    assert not (on & (path.table().kind == RAPID)).any(), "off on every way"


def test_on_an_arc_it_runs_up_along_the_arc() -> None:
    machine = load_machine("torch-table")
    _, text = restarted(WITH_Z, machine, 12)
    table = interpret(text, Start()).table()
    first = int(np.flatnonzero(table.turns)[0])
    begin = table.end[first - 1]
    assert np.hypot(begin[0] - 60, begin[1] - 30) == pytest.approx(20.0, abs=1e-4)
    assert np.arctan2(60 - begin[0], begin[1] - 30) * -20.0 == pytest.approx(machine.run_up_mm, abs=1e-3)


@pytest.mark.parametrize("spindle", [True, False])
def test_without_z_no_height_is_written(spindle: bool) -> None:
    program = FLAT if spindle else FLAT.replace(" S1000", "")
    entry, _ = restarted(program, flat_table("plasma", spindle), 8)
    code = [line for line in entry if not line.startswith("(")]
    assert not any("Z" in line for line in code)
    assert code[-4:] == ["G0 X57 Y10", "M3 S1000" if spindle else "M3", "G4 P0.4", "G1 X60 Y10 F3000"]


def test_the_wait_is_that_of_the_contour_that_is_entered() -> None:
    entry, _ = restarted(WITH_Z.replace("G1 X160", "G1 X130\nG1 X160"), load_machine("torch-table"), 21)
    assert "G4 P0.6" in entry


def test_a_laser_goes_on_where_it_stopped() -> None:
    machine = load_machine("laser-table")
    entry, _ = restarted(FLAT, machine, 8)
    assert "G0 X60 Y10" in entry
    assert machine.run_up_mm == 0.0


def test_a_wire_is_entered_from_the_edge_only() -> None:
    machine = flat_table("hot-wire", True)
    with pytest.raises(ProgramError, match="nothing is cut before this place; send the whole program"):
        restarted(FLAT, machine, 8)
    entry, _ = restarted(FLAT, machine, 14)
    assert "G0 X100 Y100" in entry


def test_how_a_program_switches_on() -> None:
    path = interpret(WITH_Z, Start())
    lines = path.table().line
    row = {line: int(np.argmax(lines == line)) for line in lines.tolist()}
    assert [own_wait_s(path, row[line]) for line in (4, 9, 12, 20)] == [0.0, 0.4, 0.4, 0.6]
    assert [cut_begin(path, row[line]) for line in (9, 12, 20)] == [row[8], row[8], row[19]]
    assert cut_begin(path, row[4]) == row[4]
    assert pierce_height_mm(path, row[11]) == 3.8
    assert pierce_height_mm(path, row[20]) == 3.8
