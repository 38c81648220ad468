# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compacting: fewer blocks, never farther than the tolerance, in the same order, with all feeds, stops and outputs."""

from __future__ import annotations

import math
from pathlib import Path
from random import Random

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.compact import compact
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from helpers.gcode.curve_distance import farthest, frechet, stretches

EXAMPLE = Path(__file__).parents[4] / "examples" / "jobs" / "elliptical-pocket.toml"


def interpret_at_zero(text: str) -> Toolpath:
    """Return the table from a known start, so that every row has a begin."""
    return interpret(text, Start.at_zero())


def wandering(random: Random, count: int) -> list[tuple[float, float, float]]:
    """Points along lines, arcs and helices of small steps with noise, seen in a random plane or in space."""
    points, at, heading = [], np.array([0.0, 0.0]), random.uniform(0, 6)
    height, plane = 0.0, random.choice([0, 0, 0, 1, 2])
    turn = climb = 0.0
    for k in range(count):
        if k % 25 == 0:
            turn = random.choice([0.0, 0.0, random.uniform(-0.3, 0.3)])
            climb = random.choice([0.0, 0.0, random.uniform(-0.1, 0.1)])
            heading += random.choice([0.0, random.uniform(-2, 2)])
        heading += turn
        at = at + random.uniform(0.05, 0.4) * np.array([math.cos(heading), math.sin(heading)])
        height += climb
        noisy = at + random.choice([0.0, 0.0, 0.02]) * np.array([random.uniform(-1, 1), random.uniform(-1, 1)])
        flat = (*noisy.tolist(), height)
        points.append(tuple(np.roll(flat, plane).tolist()))
    return points


def program(seed: int) -> str:
    """A program of small moves with all that ends a run between them."""
    random = Random(seed)
    lines = ["G21 G90 G17", "M3 S1000", "G0 X0 Y0 Z5", "G1 Z0 F100", "G1 X0 Y0 F800"]
    decimals = random.choice([2, 3, 3])
    relative, at, said = False, (0.0, 0.0, 0.0), ""
    for x, y, z in wandering(random, 150):
        target = tuple(round(value, decimals) + 0.0 for value in (x, y, z))
        ways = [round(b - a, decimals) + 0.0 for a, b in zip(at, target, strict=True)]
        if random.random() < 0.02:
            relative = not relative
            lines.append("G91" if relative else "G90")
        extra = random.choice(["M8", "G4 P0.1", "(here)", "F400", "F800", "M9", ""]) if random.random() < 0.03 else None
        if extra is not None:
            lines.append(extra)
        words = ["G1"] if said != "G1" or random.random() < 0.1 else []
        said = "G1"
        for letter, value, way in zip("XYZ", target, ways, strict=True):
            if way:
                words.append(f"{letter}{way if relative else value:.{decimals}f}")
        if any(ways):
            lines.append(" ".join(words))
        if random.random() < 0.01:
            said = "G0"
            lines.append(f"G0 {'Z1' if relative else f'Z{target[2] + 1:.{decimals}f}'}")
            target = (target[0], target[1], round(target[2] + 1, decimals))
        at = target
    return "\n".join([*lines, "M5", "M2", ""])


@pytest.mark.parametrize("seed", range(20))
def test_stays_within_the_tolerance_in_order_with_all_that_happens(seed: int) -> None:
    text, tolerance_mm = program(seed), [0.01, 0.03, 0.1][seed % 3]
    edited = compact(text, tolerance_mm)
    old, new = (stretches(interpret_at_zero(one), 0.04) for one in (text, edited.text))
    assert [key for key, _ in old] == [key for key, _ in new]
    assert edited.text.count("\n") <= text.count("\n")
    for (_, before), (_, after) in zip(old, new, strict=True):
        assert np.allclose(before[[0, -1]], after[[0, -1]], atol=1e-9)
        assert farthest(before, after) <= tolerance_mm + 1e-5
        assert farthest(after, before) <= tolerance_mm + 1e-5
        if len(before) * len(after) < 12_000:
            assert frechet(before, after) <= 1.5 * tolerance_mm + 0.05


@pytest.mark.parametrize("seed", range(6))
def test_a_compact_program_stays_as_it_is(seed: int) -> None:
    once = compact(program(seed), 0.05).text
    assert interpret(once).events == interpret(compact(once, 1e-2).text).events


@pytest.mark.slow
def test_the_published_pocket_takes_twenty_times_fewer_blocks(tmp_path: Path) -> None:
    job_text = EXAMPLE.read_text(encoding="utf-8")
    job_text = job_text.replace('"../machines/', f'"{EXAMPLE.parents[1].as_posix()}/machines/')
    for old, new in (('"tolerance"', '"dda"'), ("depth_mm = 10 ", "depth_mm = 2 ")):
        assert old in job_text
        job_text = job_text.replace(old, new, 1)
    path = tmp_path / "dda.toml"
    path.write_text(job_text, encoding="utf-8")
    text = make_program(*load_job(path)).program
    edited = compact(text, 0.06)
    assert text.count("\n") >= 20 * edited.text.count("\n")
    for (key, before), (other, after) in zip(
        stretches(interpret_at_zero(text), 0.05), stretches(interpret_at_zero(edited.text), 0.05), strict=True
    ):
        assert key == other
        assert farthest(before[::199], after) <= 0.06
        assert farthest(after[::199], before) <= 0.06


def test_a_circle_of_small_lines_becomes_arcs_in_its_plane() -> None:
    for plane, axes in (("G18", "ZX"), ("G19", "YZ"), ("G17", "XY")):
        way = [(10 * math.cos(k / 50), 10 * math.sin(k / 50)) for k in range(158)]
        lines = [f"{axes[0]}{a:.3f} {axes[1]}{b:.3f}" for a, b in way]
        text = "\n".join(["G21 G90", "G0 X0 Y0 Z0", f"G0 {lines[0]}", f"G1 {lines[1]} F500", *lines[2:], "M2", ""])
        made = compact(text, 0.005).text
        assert plane == "G17" or f"{plane} G3" in made
        assert plane == "G17" or "\nG17\n" in made
        assert made.count("\n") <= 9


@pytest.mark.slow
def test_a_helix_of_small_lines_becomes_helices() -> None:
    way = [(5 * math.cos(k / 20), 5 * math.sin(k / 20), -k / 100) for k in range(200)]
    lines = [f"X{x:.3f} Y{y:.3f} Z{z:.3f}" for x, y, z in way]
    text = "\n".join(["G21 G90", f"G0 {lines[0]}", f"G1 {lines[1]} F500", *lines[2:], "M2", ""])
    edited = compact(text, 0.02)
    assert edited.text.count("\n") <= 14
    old, new = stretches(interpret_at_zero(text), 0.02)[-1][1], stretches(interpret_at_zero(edited.text), 0.02)[-1][1]
    assert max(farthest(old, new), farthest(new, old)) <= 0.02


def test_corners_comments_and_form_stay() -> None:
    lines = ["%", "(a part)", "G21 G90", "G0 X0 Y0", "G1 Z-1 F100", "N5 G1 X0.1 F500"]
    lines += [f"N{k} X{k / 10:.1f}" for k in range(6, 40)] + [f"N{k} Y{(k - 39) / 10:.1f}" for k in range(40, 60)]
    lines += ["(turn)", "X0 (home)", "M2", "%"]
    made = compact("\r\n".join(lines), 0.01).text
    assert made == "\r\n".join([*lines[:6], "X3.9", "Y2.0", *lines[-4:]])


def test_what_must_not_be_merged() -> None:
    exact_stop = "G21 G90 G61.1\nG0 X0 Y0 Z0\nG1 X1 F100\nX2\nX3\nX4\nM2\n"
    assert compact(exact_stop, 0.1, "linuxcnc").changes == 0
    inverse = "G21 G90 G93\nG0 X0 Y0 Z0\nG1 X1 F100\nX2 F100\nX3 F100\nX4 F100\nM2\n"
    assert compact(inverse, 0.1, "linuxcnc").changes == 0


def test_the_motion_that_a_later_line_relies_on_is_written() -> None:
    way = [f"X{10 * math.cos(k / 50):.3f} Y{10 * math.sin(k / 50):.3f}" for k in range(100)]
    text = "\n".join(["G21 G90", f"G0 {way[0]}", f"G1 {way[1]} F500", *way[2:], "(on)", "X0 Y0 F300", "M2", ""])
    made = compact(text, 0.01).text
    assert "\n(on)\nG1 X0 Y0 F300\n" in made


@pytest.mark.parametrize(
    ("text", "tolerance_mm", "code"),
    [
        ("G1 X1\n", 0.0, "tolerance"),
        ("o100 sub\nG1 X1 F1\no100 endsub\no100 call\nM2\n", 0.1, "edit-flow"),
    ],
)
def test_refused(text: str, tolerance_mm: float, code: str) -> None:
    with pytest.raises(ProgramError) as refused:
        compact(text, tolerance_mm, "linuxcnc")
    assert refused.value.code == code
