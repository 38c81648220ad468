# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines that are sent are a sequence as a tuple of them is, though they are held as bytes."""

from __future__ import annotations

import pytest

from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.wire_text import AT_ONCE, WireLines


@pytest.mark.parametrize("count", [0, 1, 3, AT_ONCE - 1, AT_ONCE, 2 * AT_ONCE + 1])
def test_lines_are_what_a_tuple_of_them_is(count: int) -> None:
    expected = tuple(f"G1X{n}" for n in range(count))
    lines = WireLines("".join(f"{line}\n" for line in expected).encode())
    assert len(lines) == count and bool(lines) == bool(count)
    assert tuple(lines) == expected and lines == expected and expected == lines
    assert lines == WireLines(lines.data) and hash(lines) == hash(WireLines(lines.data))
    assert lines != (*expected, "M2") and lines != list(expected)
    for place in {0, count // 2, count - 1, -1, -count} if count else ():
        assert lines[place] == expected[place]
    assert lines[1:7:2] == expected[1:7:2] and lines[-2:] == expected[-2:]
    for place in (count, -count - 1):
        with pytest.raises(IndexError):
            lines[place]


def test_the_wire_text_is_its_lines() -> None:
    wire = prepare("(MSG, look)\ng21 g90\nN5 G1 X1.50 F100\n\nM2\n")
    assert wire.lines == ("G21G90", "G1X1.5F100", "M2") and wire.text == "G21G90\nG1X1.5F100\nM2\n"
    assert dict(wire.messages) == {0: "look"} and wire.file_lines.tolist() == [2, 3, 5]
