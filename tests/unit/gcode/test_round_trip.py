# SPDX-License-Identifier: LGPL-2.1-or-later
"""Written and read back a table is the same in every dialect that can express it; written again so is the text."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import Counter
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.gcode.dialects import dialect, dialect_names
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.writer.write import WriteOptions, write, written
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from helpers.gcode.round_trip_toolpaths import Drawn, drawn_path
from helpers.gcode.rs274_runs import run_rs274, same_call

COLUMNS = ("kind", "end", "plane", "turns", "feed")
PHYSICAL = ("tool", "spindle", "spindle_rpm", "mist", "flood", "work_system", "offset_mm")
TOLD = ("dwell", "comment", "pause")
TORCHES = ("qtplasmac",)  # whose tables are those of a torch: `test_qtplasmac.py`
LANGUAGES = [
    *(name for name in dialect_names() if name not in TORCHES),
    "mach:dwell=ms",
    "mini-lathe:g20=diameter,g70=inch",
    "fanuc-lathe:x=radius,point=free",
]
SEEDS = range(60)


@cache
def drawn(language: str, seed: int) -> Drawn:
    return drawn_path(dialect(language), seed)


def options(language: str, units: str) -> WriteOptions:
    changes = dialect(language).writing.tool_change
    change = "m6" if "m6" in changes else changes[0]
    rapid = 3000.0 if dialect(language).writing.rapid_feed else 0.0
    return WriteOptions(units=units, work_offset="", tool_change=change, retract=False, rapid_mm_min=rapid)


def same_rows(a: Toolpath, b: Toolpath, exact: bool = True) -> bool:
    one, other = a.table(), b.table()
    if len(one) != len(other):
        return False
    close = np.array_equal if exact else np.allclose
    return all(
        close(getattr(one, name), getattr(other, name), equal_nan=name in ("end", "centre"))
        for name in (*COLUMNS, "centre")
    )


def physical(path: Toolpath) -> list[tuple]:
    """Return what each row's state means for the machine; the speed of a spindle that stands is nobody's."""
    states = [tuple(getattr(state, name) for name in PHYSICAL) for state in path.states]
    rows = [states[index] for index in path.table().state]
    return [(*row[:2], row[2] if row[1] != "off" else 0.0, *row[3:]) for row in rows]


def told(path: Toolpath) -> list[tuple]:
    return [(event.index, event.kind, event.value, event.text) for event in path.events if event.kind in TOLD]


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_what_is_written_is_read_as_the_same_table_and_written_as_the_same_text(language):
    for seed in SEEDS:
        one = drawn(language, seed)
        given = options(language, one.units)
        print(f"seed {seed}, {one.units}, {len(one.path)} rows")
        made = written(one.path, language, given)
        read = interpret(made.text, Start(), language)
        assert not made.notes
        assert same_rows(one.path, read, exact=False), made.text
        assert physical(one.path) == physical(read), made.text
        assert told(one.path) == told(read), made.text
        again = write(read, language, given)
        assert again == made.text
        reread = interpret(again, Start(), language)
        assert same_rows(read, reread)
        assert read.states == reread.states and read.events == reread.events


@pytest.mark.slow
@pytest.mark.parametrize("language", LANGUAGES)
def test_the_wire_text_is_the_program_in_every_dialect(language):
    for seed in SEEDS[:20]:
        one = drawn(language, seed)
        text = write(one.path, language, options(language, one.units))
        wire = prepare(text, language)
        of_file, of_wire = (interpret(each, Start(), language) for each in (text, wire.text))
        assert same_rows(of_file, of_wire) and physical(of_file) == physical(of_wire)
        assert np.array_equal(of_file.table().line, wire.file_lines[of_wire.table().line - 1])
        assert not any(mark in wire.text for mark in "(;%?! N")
        assert prepare(wire.text, language).lines == wire.lines


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_random_tables_hold_what_the_dialect_can_express(language):
    one, counts = dialect(language), Counter()
    for seed in SEEDS:
        counts += drawn(language, seed).counts
    rows = counts["rapid"] + counts["line"] + sum(counts[f"arc {plane}"] for plane in range(3))
    assert counts["rapid"] > 0.05 * rows and counts["line"] > 0.2 * rows
    assert all(counts[units] > 0.25 * len(SEEDS) for units in one.writing.units)
    if "G2" in one.codes:
        planes = [plane for plane, name in enumerate(("G0", "G18", "G19")) if name in one.codes]
        planes = [1] if one.is_lathe else planes
        assert all(counts[f"arc {plane}"] > 0.05 * rows for plane in planes)
        arcs = sum(counts[f"arc {plane}"] for plane in range(3))
        assert not one.writing.helices or counts["helix"] > 0.2 * arcs
        assert not one.writing.full_circles or counts["full circle"] > 0.1 * arcs
        assert "P" not in one.codes["G2"].takes or counts["turns"] > 0.2 * arcs
    for name, code in (("spindle", "M3"), ("coolant", "M8"), ("dwell", "G4"), ("pause", "M0"), ("tool", "M6")):
        assert code not in one.codes or counts[name] > 0.2 * len(SEEDS), name


def test_linuxcnc_reads_what_is_written_for_it_as_we_do(tmp_path):
    lengths = {1: 10.0, 2: 20.0, 3: 30.0}
    (tmp_path / "tool.tbl").write_text("".join(f"T{tool} P{tool} Z{z / 25.4:.6f}\n" for tool, z in lengths.items()))
    for seed in SEEDS[:12]:
        one = drawn("linuxcnc", seed)
        text = write(one.path, "linuxcnc", options("linuxcnc", one.units))
        (tmp_path / "program.ngc").write_text(text, "ascii")
        run = run_rs274(tmp_path, "-t", "tool.tbl", "program.ngc")
        assert run.returncode == 0, run.stdout + run.stderr
        theirs = [line for line in map(str.rstrip, run.stdout.splitlines()) if line]
        ours = list(canonical_calls(text, tool_lengths_mm=lengths))
        assert len(ours) == len(theirs)
        for mine, real in zip(ours, theirs, strict=True):
            assert same_call(mine, real), f"ours {mine}\nreal {real}"


def test_the_comparison_can_fail():
    one = drawn("grbl", 1)
    text = write(one.path, "grbl", options("grbl", one.units))
    read = interpret(text, Start(), "grbl")
    line = next(line for line in text.splitlines() if line.startswith("G1"))
    other = text.replace(line, line.replace("G1", "G0"), 1)
    assert not same_rows(read, interpret(other, Start(), "grbl"))


@pytest.mark.slow
@pytest.mark.parametrize("language", ["grbl", "iso"])
def test_the_text_is_the_same_in_every_process(language):
    """Neither dates nor the order of hashes are in it, so that a program can live in version control."""
    one = drawn(language, 3)
    here = write(one.path, language, options(language, one.units))
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); from helpers.gcode.round_trip_toolpaths import drawn_path; "
        "from CNCStepper.gcode.dialects import dialect; from CNCStepper.gcode.writer.write import WriteOptions, write; "
        f"one = drawn_path(dialect('{language}'), 3); "
        f"print(write(one.path, '{language}', WriteOptions(units=one.units, work_offset='', retract=False, "
        f"tool_change='{options(language, one.units).tool_change}')), end='')"
    )
    for seed in ("1", "2"):
        command = [sys.executable, "-c", code, str(Path(__file__).parents[2])]
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        run = subprocess.run(command, capture_output=True, text=True, env=environment)
        assert run.returncode == 0, run.stderr
        assert run.stdout == here
