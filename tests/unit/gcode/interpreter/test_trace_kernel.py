# SPDX-License-Identifier: LGPL-2.1-or-later
"""The calls of compiled runs are those of reading line by line, to the byte; numbers are rounded as `printf` does."""

from __future__ import annotations

import math
from collections import Counter
from random import Random

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls, canonical_text, default_start
from CNCStepper.gcode.interpreter.fast_path import policy
from CNCStepper.gcode.interpreter.fast_path.trace_kernel import put_number
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import Start
from helpers.gcode.fast_path_programs import PlainPrograms

SEEDS = range(12)


def valid_program(seed: int, dialect: str) -> str:
    """Return a random program without the lines that are refused or lead elsewhere, and with M2 at its end alone."""
    writer = PlainPrograms(seed, dialect, Start.at_zero())
    writer.program(400)
    reader, lines = Interpreter(default_start(), dialect), []
    for line in (*writer.lines, "M2"):
        if reader.leads(line) or (line in ("M2", "%") and line is not writer.lines[0] and len(lines) < 200):
            continue
        try:
            reader.line(line)
        except ProgramError:
            continue
        lines.append(line)
    return "\n".join(lines) + "\n"


def told(text: str, dialect: str) -> tuple[list[str], str]:
    """Return the calls up to the line that is refused, and why it is."""
    calls: list[str] = []
    try:
        calls += canonical_text(text, default_start(), dialect)
    except ProgramError as error:
        return calls, str(error)
    return calls, ""


@pytest.mark.parametrize("dialect", ["grbl", "linuxcnc"])
def test_runs_are_told_as_line_by_line(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    found: Counter[str] = Counter()
    for seed in SEEDS:
        print(f"seed {seed}")
        text = valid_program(seed, dialect)
        plain, refusal = told(text, dialect)
        with monkeypatch.context() as patched:
            patched.setattr(policy, "PAYS", 0)
            runs, same_refusal = told(text, dialect)
        assert "".join(runs) == "".join(plain)
        assert refusal == same_refusal
        many = "".join(block for block in runs if block.count("\n") > 1)
        found.update(
            {"run": many.count("\n"), "all": "".join(plain).count("\n"), "N": many.count(" N") - many.count(" N.")}
        )
        found.update(
            call
            for call in ("TRAVERSE", "STRAIGHT_FEED", "ARC_FEED", "SET_FEED_RATE", ", -1, ", ", 1, ")
            if call in many
        )
    assert found["run"] > found["all"] / 8
    assert found["N"] > 100
    assert all(
        found[call] >= 3 for call in ("TRAVERSE", "STRAIGHT_FEED", "ARC_FEED", "SET_FEED_RATE", ", -1, ", ", 1, ")
    )


def test_calls_before_a_refused_line_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(policy, "PAYS", 0)
    calls, refusal = told("G21\nF100\nG1 X1\nG1 X2\nG1 X-\nG1 X4\n", "linuxcnc")
    assert refusal
    assert "STRAIGHT_FEED(2.0000" in "".join(calls)


def test_places_beyond_the_digits_of_an_integer_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "G21 G91\n" + "G0 X999999999999999 Y-.00004\n" * 12_000 + "M2\n"
    plain = list(canonical_calls(text))
    monkeypatch.setattr(policy, "PAYS", 0)
    assert list(canonical_calls(text)) == plain
    assert any("9223372036854775" in call or "11999999999999988" in call for call in plain)


def test_numbers_are_rounded_as_printf_rounds_them() -> None:
    random, out = Random(5), np.zeros(64, np.uint8)
    ties = [(2 * random.randrange(10**6) + 1) / 32 for _ in range(2000)]
    near = [math.nextafter(value, random.choice((-1e9, 1e9))) for value in ties]
    halves = [random.randrange(10**7) / 10**4 + 0.00005 for _ in range(2000)]
    some = [random.uniform(-1, 1) * 10 ** random.randint(-9, 15) for _ in range(4000)]
    assert sum(f"{value:.5f}".endswith("5") and value * 32 == int(value * 32) for value in ties) == len(ties)
    for value in (*ties, *near, *halves, *some, 0.0, -0.0, -0.00004, 0.99995, 999.99995, 1e16):
        for signed in (value, -value):
            end = put_number(out, 0, signed)
            assert out[:end].tobytes().decode() == f"{signed:.4f}", signed.hex()
