# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs arranged as one: where each cut lies, how often tools change, and what is refused."""

from __future__ import annotations

import random

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.arrange import Copy, arranged
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Toolpath

RING = """G21 G17 G90 G94
T1 M6
M3 S1000
G0 Z5
G0 X10 Y0
G1 Z-1 F100
G2 X10 Y0 I5 J0 F300
G0 Z5
M5
T2 M6
M3 S2000
G0 X30 Y5
G1 Z-2 F100
G1 X40 F200
G3 X40 Y15 I0 J5
G0 Z5
M5
M30
"""
PLATE = """%
G20
T1 M6
M3 S1500
G0 Z0.2
G0 X0 Y0
G1 Z-0.05 F4
X1 F10
Y1
X0 Y0
G0 Z0.3
M2
%
"""


def cuts(path: Toolpath) -> tuple[np.ndarray, np.ndarray]:
    table = path.table()
    cut = table.kind != RAPID
    return table.kind[cut], table.end[cut][:, :2]


def turned(points: np.ndarray, copy: Copy) -> np.ndarray:
    angle = np.radians(copy.rotation_deg)
    matrix = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    return points @ matrix + (copy.x_mm, copy.y_mm)


@pytest.mark.parametrize("seed", range(6))
def test_every_cut_lies_where_the_places_say_and_arcs_stay_arcs(seed: int) -> None:
    dice = random.Random(seed)
    copies = [
        Copy(
            f"{number}.nc",
            dice.choice([RING, PLATE]),
            round(dice.uniform(-100, 100), 3),
            round(dice.uniform(-100, 100), 3),
            dice.choice([0.0, 90.0, 180.0, 33.0]),
        )
        for number in range(dice.randint(2, 5))
    ]
    path = interpret(arranged(copies, "linuxcnc"), None, "linuxcnc")
    kinds, ends = cuts(path)
    wanted_kinds, wanted = [], []
    for copy in copies:
        own_kinds, own = cuts(interpret(copy.text, None, "linuxcnc"))
        wanted_kinds += own_kinds.tolist()
        wanted += turned(own, copy).tolist()
    assert sorted(kinds.tolist()) == sorted(wanted_kinds) and {LINE, ARC_CW, ARC_CCW} >= set(kinds.tolist())
    for place in wanted:
        assert np.hypot(*(ends - place).T).min() < 0.003
    assert len(ends) == len(wanted)


def test_each_tool_is_changed_to_once_and_copies_are_operations() -> None:
    copies = [Copy("ring.nc", RING, 50.0 * number) for number in range(3)]
    text = arranged(copies, "linuxcnc")
    assert text.count("M6") == 2 and text.count("(begin operation: ring.nc") == text.count("(finish operation:") >= 6
    path = interpret(text, None, "linuxcnc")
    spans = [span for span in path.spans if span.kind == "operation" and span.last > span.first]
    assert len(spans) >= 6
    table = path.table()
    tools = [path.states[int(state)].tool for state in table.state[table.kind != RAPID]]
    assert tools == sorted(tools) and set(tools) == {1, 2}


def test_the_tool_goes_between_copies_at_the_greatest_height_of_all() -> None:
    text = arranged([Copy("plate.nc", PLATE), Copy("ring.nc", RING, 80.0)], "linuxcnc")
    path = interpret(text, None, "linuxcnc")
    table, begins = path.table(), path.begins()
    far = (table.kind == RAPID) & (np.hypot(*(table.end - begins)[:, :2].T) > 40.0)
    assert far.any() and (begins[far, 2] >= 7.62 / 0.3 * 0.2 - 1e-6).all()


def test_units_are_those_of_the_first_program() -> None:
    text = arranged([Copy("ring.nc", RING), Copy("plate.nc", PLATE, 100.0)], "linuxcnc")
    assert "G20" not in text and "X125.4" in text
    assert "G21" not in arranged([Copy("plate.nc", PLATE), Copy("ring.nc", RING, 100.0)], "linuxcnc")


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("G92 X0", "arrange-offset"),
        ("G55", "arrange-offset"),
        ("G10 L20 P1 X0", "arrange-offset"),
        ("G53 G0 Z0", "arrange-offset"),
        ("G28", "arrange-offset"),
    ],
)
def test_programs_with_other_zeros_are_refused_with_the_line(line: str, code: str) -> None:
    text = RING.replace("G0 Z5\n", f"{line}\nG0 Z5\n", 1)
    with pytest.raises(ProgramError) as refused:
        arranged([Copy("ring.nc", RING), Copy("other.nc", text, 50.0)], "linuxcnc")
    assert refused.value.code == code and str(refused.value.place) == "other.nc:4:1"


def test_nothing_to_arrange_is_refused() -> None:
    with pytest.raises(ProgramError, match="no program"):
        arranged([])
