# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathe programs: cycles that never end, and the nose's compensation against an exact offset, for all orientations.

Programs with which published interpreters failed (a shoulder square to the end face, stock to leave at the face, an arc
whose ends are rounded, a pocket behind a cylinder) are in tests/data/ngc and judged by test_canonical_trace.py.
"""

from __future__ import annotations

import subprocess
from dataclasses import replace
from math import hypot
from pathlib import Path

import numpy as np
import pytest
from shapely import LineString, Point

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.state import Start, ToolEntry
from CNCStepper.toolpath import LINE, RAPID
from helpers.cycles.seeds import SEEDS
from helpers.gcode.rs274_runs import run_rs274, same_call

# Of a profile that does not come back to the X of the cycle; LinuxCNC 2.9 fills all memory with it.
ENDLESS = """G21 G18 G54 G90 G8 G91.1
O200 SUB
G01 X10 Z0
G01 X10 Z-14
G01 X3
G01 X7 Z-22
O200 ENDSUB
F225
G71.2 Q200 X15.0 Z0 D0.04 I0.5 R1
M2
"""
# From the nose's centre to the control point, in radii along X and Z, as LinuxCNC's manual draws the orientations.
CONTROL_POINT = {
    1: (-1, 1),
    2: (-1, -1),
    3: (1, -1),
    4: (1, 1),
    5: (0, 1),
    6: (-1, 0),
    7: (0, -1),
    8: (1, 0),
    9: (0, 0),
}
RADIUS = 0.4


def test_a_cycle_that_would_never_end_is_refused_with_what_to_change():
    with pytest.raises(ProgramError) as refusal:
        list(canonical_calls(ENDLESS))
    assert refusal.value.code == "passes-many" and "end the profile at the X" in refusal.value.advice
    assert list(canonical_calls(ENDLESS.replace("X7 Z-22", "X7 Z-22\nG01 X15")))


def test_a_profile_that_crosses_itself_comes_to_an_end_or_is_refused(tmp_path):
    text = ENDLESS.replace("X3", "X12 Z-2").replace("X7 Z-22", "X15 Z-22")
    (tmp_path / "program.ngc").write_text(text)
    try:
        theirs = run_rs274(tmp_path, "program.ngc", timeout_s=10)
    except subprocess.TimeoutExpired:
        theirs = None
    try:
        ours = [call.rstrip() for call in canonical_calls(text) if call.strip()]
    except ProgramError:
        assert theirs is None or theirs.returncode
        return
    assert theirs is not None
    lines = [line.rstrip() for line in theirs.stdout.splitlines() if line.strip()]
    assert len(lines) == len(ours) and all(map(same_call, ours, lines))


def profile_of(seed: int) -> np.ndarray:
    """Return corners (x, z) of a profile towards the chuck, with room for the nose between them."""
    random = np.random.default_rng(seed)
    z = -np.cumsum(random.uniform(4.0, 9.0, 6))
    x = 12.0 + np.cumsum(random.uniform(-2.5, 3.5, 6))
    return np.column_stack([x, z])


def program_of(corners: np.ndarray, orientation: int, x_factor: float = 1.0, of_tool: bool = False) -> str:
    """x_factor: 2 with X as diameter. of_tool: radius and orientation are the tool table's, not D and L."""
    words = [f"X{x_factor * x:.6f} Z{z:.6f}" for x, z in corners]
    return "\n".join(
        [
            "G21 G18 G90 G8 F100",
            *(["T7 M6", "G43"] if of_tool else []),
            "G7" if x_factor == 2.0 else "G8",
            f"G0 X{40 * x_factor} Y0 Z10",
            "G42" if of_tool else f"G42.1 D{x_factor * 2 * RADIUS} L{orientation}",
            *[f"G1 {word}" for word in words],
            f"G40 G1 X{60 * x_factor} Z0",
            "M2",
        ]
    )


def with_an_arc(text: str, sign: float) -> str:
    """Return a program of a bore or a shaft in which the third line along the profile is an arc; sign: of its I."""
    lines = text.splitlines()
    at = [number for number, line in enumerate(lines) if line.startswith("G1 X")][2]
    lines[at] = lines[at].replace("G1", "G2" if sign > 0 else "G3") + f" R{30.0:.6f}"
    return "\n".join(lines)


def rs274_with_tool(text: str, orientation: int, folder: Path) -> tuple[list[str], bool]:
    """Return rs274's calls with tool 7, and whether it took the program; its stand-alone table is in inches."""
    row = f"T7 P7 D{2 * RADIUS / 25.4:.8f} Q{orientation} X{1.5 / 25.4:.8f} Z{-2.0 / 25.4:.8f}\n"
    (folder / "tool.tbl").write_text(row)
    (folder / "program.ngc").write_text(text)
    run = run_rs274(folder, "-t", "tool.tbl", "program.ngc")
    return [line.rstrip() for line in run.stdout.splitlines() if line.strip()], run.returncode == 0


@pytest.mark.parametrize("orientation", CONTROL_POINT)
def test_rs274_drives_the_compensated_moves_of_a_lathe_program(orientation, tmp_path):
    """G41 and G42, X as radius and diameter, nose and orientation from words and from the tool, lines and arcs."""
    of_tool, has_arc, is_left = orientation % 2 == 0, orientation % 3 == 0, orientation % 4 > 1
    taken = 0
    for x_factor in (1.0, 2.0):
        for seed in SEEDS[orientation - 1 :: 9]:
            text = program_of(profile_of(seed), orientation, x_factor, of_tool)
            text = with_an_arc(text, 1.0 if seed % 2 else -1.0) if has_arc else text
            text = text.replace("G42", "G41") if is_left else text
            theirs, is_taken = rs274_with_tool(text, orientation, tmp_path)
            tool = ToolEntry(7, (1.5, 0.0, -2.0, *[0.0] * 6), 2 * RADIUS, orientation=orientation)
            start = replace(Start.at_zero(), tools={7: tool})
            try:
                ours = [call.rstrip() for call in canonical_calls(text, start=start) if call.strip()]
            except ProgramError as refusal:
                assert not is_taken, (seed, text, refusal)
                continue
            assert is_taken, (seed, text, theirs[-3:])
            assert [pair for pair in zip(ours, theirs, strict=True) if not same_call(*pair)] == []
            taken += 1
    assert taken >= 2


@pytest.mark.parametrize("orientation", CONTROL_POINT)
def test_the_nose_touches_the_profile_all_along_and_never_cuts_into_it(orientation):
    for seed in SEEDS[orientation - 1 :: 9]:
        corners = profile_of(seed)
        profile = LineString(corners[:, ::-1])
        path = interpret(program_of(corners, orientation), Start.at_zero(), "linuxcnc")
        table, begins = path.table(), path.begins()
        to_centre = -RADIUS * np.array(CONTROL_POINT[orientation])
        rows = [row for row in range(len(table)) if table.kind[row] != RAPID][1:-1]
        assert len(rows) >= len(corners) - 1
        off = []
        for row in rows:
            for share in (0.0, 0.25, 0.5, 0.75, 1.0):
                x, z = _place(begins[row], table, row, share) + to_centre
                off.append(profile.distance(Point(z, x)) - RADIUS)
        assert max(map(abs, off)) < 0.0005, (seed, min(off), max(off))


def _place(begin: np.ndarray, table, row: int, share: float) -> np.ndarray:
    """Return X and Z on a row, a line or an arc."""
    end = table.end[row]
    if table.kind[row] == LINE:
        return (begin + share * (end - begin))[[0, 2]]
    centre = table.centre[row]
    from_, to = (np.arctan2(point[0] - centre[0], point[2] - centre[2]) for point in (begin, end))
    turn = (to - from_ + np.pi) % (2 * np.pi) - np.pi  # of corners: always below half a turn
    radius = hypot(begin[0] - centre[0], begin[2] - centre[2])
    angle = from_ + share * turn
    return np.array([centre[0] + radius * np.sin(angle), centre[2] + radius * np.cos(angle)])
