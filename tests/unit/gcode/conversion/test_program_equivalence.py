# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judge of converted programs sees every difference that would cut another part or hurt somebody."""

from __future__ import annotations

import math

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.conversion.convert import convert
from CNCStepper.gcode.conversion.program_equivalence import require_same_work
from CNCStepper.gcode.dialects import dialect_named
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write_options import WriteOptions
from CNCStepper.state import Start

ZERO = Start.at_zero()
HEAD = "G21 G90 G17 F100\n"
OLD = (
    "T1 M6\nM3 S1000\nM8\nG0 X4 Z5\nG1 Z-1\nG3 I-4\nG2 X0 Y4 I-4\nG1 X9 F250\nM5\nM9\nG4 P3\nM0\nM3 S1200\n"
    "G18\nG2 X19 I5\nG17\nG3 X4 Y-1 I-7.5 J-2.5 Z-3 P2\nM64 P1\nG0 Z9\nM2\n"
)


def judge(old: str, new: str, **options) -> None:
    chosen = WriteOptions(retract=False, work_offset="", tool_change="m6", **options)
    paths = [interpret(HEAD + text, ZERO, "linuxcnc") for text in (old, new)]
    require_same_work(*paths, chosen, dialect_named("linuxcnc"), "a.ngc")


@pytest.mark.parametrize(
    ("was", "becomes", "said", "line"),
    [
        ("G3 I-4\n", "", "would not pass this point", 7),
        ("G3 I-4\n", "G2 I-4\n", "would be bent", 7),
        ("G3 I-4\n", "G3 I-4 P2\n", "would not pass this point", 7),
        ("G2 X0 Y4 I-4\n", "G3 X0 Y4 I-4\n", "would not pass this point", 8),
        ("G2 X19 I5", "G3 X19 I5", "would be bent", 16),
        ("Z-3 P2", "Z-3", "would not pass this point", 18),
        ("G1 Z-1", "G0 Z-1", "rapids and cuts", 6),
        ("G0 Z9", "G1 Z9", "rapids and cuts", 20),
        ("F250", "F253", "the feed would be another", 9),
        ("M3 S1000", "M4 S1000", "spindle, coolant or tool", 5),
        ("S1000", "S1001", "spindle, coolant or tool", 5),
        ("M8", "M7", "spindle, coolant or tool", 5),
        ("T1", "T2", "spindle, coolant or tool", 5),
        ("M5\nM9\nG4 P3\n", "G4 P3\nM5\nM9\n", "the actions between the moves", 12),
        ("G4 P3", "G4 P2", "the actions between the moves", 12),
        ("G4 P3\n", "", "the actions between the moves", 12),
        ("M0\n", "", "the actions between the moves", 13),
        ("M0\n", "M1\n", "the actions between the moves", 13),
        ("M0\nM3 S1200\nG18\nG2 X19 I5\n", "M3 S1200\nG18\nG2 X19 I5\nM0\n", "the actions between the moves", 13),
        ("M64 P1\n", "M65 P1\n", "the actions between the moves", 19),
        ("G0 Z9\n", "G0 Z9\nX50\n", "would continue after this", 20),
        ("G0 Z9\n", "G0 Z9\nM0\n", "the actions between the moves", 0),
    ],
)
def test_it_sees(was: str, becomes: str, said: str, line: int) -> None:
    judge(OLD, OLD)
    assert was in OLD
    with pytest.raises(ProgramError, match=said) as found:
        judge(OLD, OLD.replace(was, becomes))
    assert found.value.code == "convert-differs" and found.value.place.line == line


@pytest.mark.parametrize(
    ("was", "becomes"),
    [
        ("G3 I-4\n", "G3 X-4 I-4\nG3 X4 I4\n"),
        ("G3 I-4\n", "G1 X4.0005\nG3 X4 I-4\n".replace("X4 I-4", "X4.0005 I-4.0005")),
        ("P2", "P2\nG1 Z-3.0004"),
        ("F250", "F250.4"),
        ("G1 X9 F250", "G1 X4 F250\nX9"),
        ("M0\n", "M0\nM0\n"),
    ],
)
def test_it_lets_pass_what_is_only_written_otherwise(was: str, becomes: str) -> None:
    judge(OLD, OLD.replace(was, becomes))


def test_a_path_that_crosses_itself_is_followed_in_its_order() -> None:
    way = "G0 X0 Y0 Z1\nG1 X10 Y10\nX10 Y0\nX0 Y10\nX0 Y0\nX10 Y10\nG0 Z5\nM2\n"
    judge(way, way)
    with pytest.raises(ProgramError, match="would not pass"):
        judge(way, way.replace("X10 Y0\nX0 Y10\n", "X0 Y10\nX10 Y0\n"))
    with pytest.raises(ProgramError, match="would not pass"):
        judge(way, way.replace("X0 Y10\n", ""))


def test_an_arc_of_chords_must_go_round_the_same_side() -> None:
    arc = "G0 X10 Y0 Z1\n{0}\nG0 Z5\nM2\n"
    chords = [(10 * math.cos(math.radians(angle)), 10 * math.sin(math.radians(angle))) for angle in range(2, 181, 2)]
    above, below = (
        "\n".join(f"G1 X{x:.3f} Y{sign * y:.3f}" for x, y in (*chords[:-1], (-10.0, 0.0))) for sign in (1, -1)
    )
    judge(arc.format("G3 X-10 Y0 I-10"), arc.format(above))
    with pytest.raises(ProgramError, match="through another angle"):
        judge(arc.format("G3 X-10 Y0 I-10"), arc.format(below))


@pytest.mark.parametrize("cycle", ["G73", "G83"])
@pytest.mark.parametrize("units", ["mm", "inch"])
def test_pecks_that_are_rounded_are_no_difference(cycle: str, units: str) -> None:
    other = {"mm": "inch", "inch": "mm"}[units]
    scale = 1 if units == "mm" else 25.4
    x, z, q = -12.5 / scale, -2 / scale, 0.7 / scale
    text = f"{'G21' if units == 'mm' else 'G20'} G90 G17 F100\nG0 Z{3 / scale:.4f}\n"
    text += f"G98 {cycle} X{x:.4f} Y{7.8 / scale:.4f} Z{z:.4f} R{1 / scale:.4f} Q{q:.4f}\nG80\nM2\n"
    assert cycle in convert(text, "linuxcnc", "linuxcnc", ZERO, units=other).text
