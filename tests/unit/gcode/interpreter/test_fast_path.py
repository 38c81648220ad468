# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled reading of plain programs gives what reading line by line gives: to the bit, and the same refusals."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections import Counter
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect_names
from CNCStepper.gcode.interpreter.fast_path import policy
from CNCStepper.gcode.interpreter.fast_path.compiled_reader import CompiledReader
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import refusals as refusals_of_all
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.state import Start
from helpers.gcode.fast_path_programs import PlainPrograms, Watched, outcome, refusals, seen

MANY = max(6, int(os.environ.get("CNCSTEPPER_CASES", "0")) // 8)  # seeds a dialect
TESTS = Path(__file__).parents[3]
PLACED = Start(position_mm=(1.0, -2.0, 30.0), work_offsets_mm={"G54": (10.1, 20.2, -3.3)}, zero_known=True)
SENT = set("0123456789+-. \tGNXYZIJKRFgnxyzijkrf()")
STARTS = (Start(), Start.at_zero(), PLACED)
FILES = sorted([*(TESTS / "data" / "ngc").glob("*.ngc"), *(TESTS / "bad").glob("*.nc")])
RECORDINGS = sorted((TESTS / "data" / "firmware").rglob("*.json"))


def compiled(text: str, start: Start, dialect: str) -> tuple[Watched, list[ProgramError]]:
    reader = Watched(start, dialect, "part.nc")
    data = text.removeprefix("\ufeff").encode("utf-8", "surrogatepass")
    return reader, list(CompiledReader(reader).refused(data))


def check_both(text: str, start: Start, dialect: str) -> Watched:
    """Compare the two readings of a text; return the compiled one."""
    reader, errors = compiled(text, start, dialect)
    plain = Interpreter(start, dialect, "part.nc")
    expected, found = outcome(plain, refusals(plain, text)), outcome(reader, errors)
    for name, value in expected.items():
        assert found[name] == value, f"{dialect}: {name}"
    return reader


@pytest.mark.parametrize("dialect", dialect_names())
@pytest.mark.parametrize("seed", range(12))
def test_random_programs_are_read_alike(dialect: str, seed: int) -> None:
    check_random(dialect, seed, 120)


@pytest.mark.slow
def test_plain_python_reads_alike_and_overflows_in_no_byte() -> None:
    names = "test_random_programs_are_read_alike and (0- or 1-) or test_numbers_are_sent"
    words = ["-W", "error::RuntimeWarning", "-m", "pytest", "-q", "-p", "no:cacheprovider", __file__, "-k", names]
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    run = subprocess.run([sys.executable, *words], env=environment, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout


@pytest.mark.slow
@pytest.mark.parametrize("dialect", dialect_names())
@pytest.mark.parametrize("seed", range(100, 100 + MANY))
def test_many_random_programs_are_read_alike(dialect: str, seed: int) -> None:
    check_random(dialect, seed, 400)


def check_random(dialect: str, seed: int, count: int) -> Watched:
    start = STARTS[seed % len(STARTS)]
    text = PlainPrograms(seed, dialect, start).program(count)
    print(f"seed {seed}, dialect {dialect}")
    return check_both(text, start, dialect)


@pytest.mark.slow
@pytest.mark.parametrize("dialect", ["grbl", "linuxcnc"])
def test_the_random_programs_hold_the_hard_cases_and_the_kernel_runs_them(dialect: str) -> None:
    found: Counter[str] = Counter()
    run: set[str] = set()
    codes: Counter[str] = Counter()
    lines_run = lines = 0
    for seed in range(60):
        start = STARTS[seed % len(STARTS)]
        text = PlainPrograms(seed, dialect, start).program(120)
        reader, errors = compiled(text, start, dialect)
        lines_run, lines = lines_run + reader.lines_run, lines + reader.line_number
        run |= reader.modes_run
        codes.update(error.code for error in errors)
        found.update(seen(text, reader))
    assert lines_run > lines / 5
    assert run >= {"XY", "ZX", "YZ", "mm", "inch", "absolute", "incremental", "incremental centres"}
    assert dialect == "grbl" or "absolute centres" in run
    marks = {"R", "(", ";", "/", "\t", "x", "\r", "G93", "N"}
    kinds = {"kind 0", "kind 1", "kind 2", "kind 3", "plane 1", "plane 2"}
    assert all(found[name] >= 3 for name in marks | kinds), found
    refused = {"arc-ends", "arc-radius", "no-feed", "bad-number", "repeated-word", "line-number", "no-motion"}
    assert refused <= set(codes), codes


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_files_are_read_alike(path: Path) -> None:
    text = path.read_text("utf-8")
    for dialect, start in product(dialect_names(), STARTS):
        check_both(text, start, dialect)


def whole(text: str, dialect: str) -> dict[str, Any]:
    reader = Interpreter(PLACED, dialect, "part.nc")
    return outcome(reader, list(refusals_of_all(reader, text)))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_whole_programs_are_read_alike(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Those with O-words too: their first lines are read in runs."""
    text = path.read_text("utf-8")
    line_by_line = {dialect: whole(text, dialect) for dialect in ("grbl", "linuxcnc")}
    monkeypatch.setattr(policy, "PAYS", 0)
    assert {dialect: whole(text, dialect) for dialect in line_by_line} == line_by_line


@pytest.mark.parametrize("text", ["F254\nG20\nG1 X1 F10", "G20 F254\nG1 X1 F254", "F100\nG20\nG1 X1", "F9\nG1 F8 X1"])
def test_the_number_of_the_feed_is_known_after_a_run(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    numbers = []
    for pays in (1 << 30, 0):
        monkeypatch.setattr(policy, "PAYS", pays)
        reader = Interpreter(PLACED, "linuxcnc")
        list(refusals_of_all(reader, text + "\nG0 X0\n" * 9 + "#1=#<_feed>\nM2"))
        numbers.append(reader.model.parameters.get(1))
    assert numbers[0] == numbers[1] == float(text.rpartition("F")[2].split()[0])


@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_recorded_programs_are_read_alike(path: Path) -> None:
    recording = json.loads(path.read_text("utf-8"))
    check_both("\n".join(recording["program"]), Start.at_zero(), "grbl")


def prepared(text: str, dialect: str) -> tuple[Any, ...]:
    try:
        wire = prepare(text, dialect, "part.nc")
    except ProgramError as error:
        return error.code, error.place, str(error)
    return wire.lines, wire.file_lines.tobytes(), dict(wire.messages)


@pytest.mark.slow
@pytest.mark.parametrize("dialect", dialect_names())
def test_wire_text_is_made_alike(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Random programs without the lines that are refused, so that most can be sent."""
    texts = [path.read_text("utf-8") for path in FILES]
    for seed in range(12):
        writer = PlainPrograms(seed, dialect, Start.at_zero())
        writer.program(150)
        texts += ["\n".join(line for line in writer.lines if set(line) <= SENT), "\r\n".join(writer.lines)]
    line_by_line = [prepared(text, dialect) for text in texts]
    monkeypatch.setattr(policy, "PAYS", 0)
    assert [prepared(text, dialect) for text in texts] == line_by_line
    lathes = ("mini-lathe", "fanuc-lathe", "mach-turn")
    assert dialect in lathes or sum(not isinstance(found[0], str) for found in line_by_line) > 20


@pytest.mark.parametrize(
    "line, wire",
    [
        ("n5 g01 x-0.50 y+.5 z-0.000", "G1X-0.5Y0.5Z0"),
        ("G1 X 0 0 1 2 . 5 0 Y-.0", "G1X12.5Y0"),
        ("X5. Y-00 F0100.0", "X5Y0F100"),
        ("X.10203040506070809010 Z-1000000", "X0.1020304050607080901Z-1000000"),
    ],
)
def test_numbers_are_sent_in_their_shortest_form(line: str, wire: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for pays in (0, 1 << 30):
        monkeypatch.setattr(policy, "PAYS", pays)
        assert prepare(f"G1 F1\n(MSG, look)\n{line}\n\nN7\nM2\n").lines == ("G1F1", wire, "M2")
        assert prepare(f"G1 F1\n(MSG, look)\n{line}").messages == {1: "look"}
