# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is written for grbl is accepted by a board of its own reader, line by line, in its check mode."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.machine import Grbl

GOLDEN = sorted((Path(__file__).parents[3] / "golden" / "gcode").glob("*.grbl.*nc"))
LINE_S = 0.1


@pytest.mark.parametrize("path", GOLDEN, ids=lambda path: path.name)
def test_grbl_accepts_every_line_that_is_written_for_it(path):
    board = Grbl(load_machine("table-a"))
    lines = prepare(path.read_text("utf-8"), "grbl").lines
    assert [answers(board, line) for line in ("$C", *lines)] == ["ok"] * (len(lines) + 1)


@pytest.mark.parametrize("line", ["G43.1Z1", "G92X0", "G10L20P1X0"])
def test_axis_words_without_a_motion_are_refused_as_grbl_does(line):
    board = Grbl(load_machine("table-a"))
    assert [answers(board, text) for text in ("G80", line, "G0", line)] == ["ok", "error:31", "ok", "ok"]
    for program in (f"G80\n{line}\n", f"G80{line}\n"):
        with pytest.raises(ProgramError, match="while G80 is in force") as refused:
            interpret(f"G90\nG0X1Y1Z1\n{program}", dialect="grbl")
        assert refused.value.code == "axis-unused"
    interpret(f"G90\nG0X1Y1Z1\nG80\nG0\n{line}\n", dialect="grbl")
    interpret(f"G90\nG0X1Y1Z1\nG80\n{line}\nM2\n", dialect="linuxcnc")


def answers(board: Grbl, line: str) -> str:
    """Return what a board answers to a line."""
    board.take_output()
    board.receive(line.encode("ascii") + b"\n")
    board.advance(LINE_S)
    return next(text for text in board.take_output().decode("ascii").split("\r\n") if text.startswith(("ok", "err")))
