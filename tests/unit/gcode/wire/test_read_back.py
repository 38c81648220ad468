# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text read back: the file's moves, lines and operations, and the file's columns in errors."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back

TEXT = """(title)
G21 G90 (a comment) G17
(begin operation: slot)
n10 g0 z5.000

G1 X10. F300 ; along
Y4
(finish operation: slot)
M2
"""


def test_it_is_the_file_s_own_table() -> None:
    back, direct = read_back(prepare(TEXT), TEXT), interpret(TEXT)
    for name in ("kind", "end", "feed", "line"):
        assert np.array_equal(getattr(back.table(), name), getattr(direct.table(), name), equal_nan=name == "end"), name
    assert [(span.name, span.first, span.last) for span in back.spans] == [("slot", 0, 3)]


def test_an_error_names_the_column_in_the_file() -> None:
    text = "G21 G90\n(long comment) G1 X10 (and more) F300\nG2 X20 Y20 I1 J1\n"
    with pytest.raises(ProgramError) as caught:
        read_back(prepare(text, "grbl", "part.nc"), text, None, "grbl", "part.nc")
    assert caught.value.place and (caught.value.place.file, caught.value.place.line) == ("part.nc", 3)


LOOP = "G21 G90 F100\no1 repeat [{0}]\nG1 X1\no1 endrepeat\nM2\n"


@pytest.mark.parametrize(("sent", "times"), [(2, 3), (3, 2)])
def test_lines_of_another_program_that_is_written_out_are_refused(sent: int, times: int) -> None:
    wire = prepare(LOOP.format(sent), "grblhal")
    with pytest.raises(ProgramError, match="another program"):
        read_back(wire, LOOP.format(times), None, "grblhal", "part.nc")


def test_lines_of_a_longer_program_are_refused() -> None:
    with pytest.raises(ProgramError, match="another program"):
        read_back(prepare(TEXT), "G21\nM2\n")
