# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long programs are looked at a chunk at a time: what is found is what the whole table says."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.simulation.checks.program_report import report
from CNCStepper.simulation.tip_segments import segments, segments_of_chunks, tips_mm, tips_of_chunks
from CNCStepper.toolpath import CHUNK_ROWS, COLUMNS, Toolpath, join_chunks

TEXT = (
    "G21 G90 G17 F600\nG0 Z5\nG0 X0 Y0\nG43.1 Z4\nG1 Z-1\nX10\nG2 X20 I5 J0\nG3 I-5 P2 Z-2\nG18 G2 X30 Z-2 I5 K0\n"
    "G55 G0 Z9\nG49 G1 X1 Y2\nG92 X5\nX9 Y9 F900\nZ-3\nM2\n"
)


def parted(size: int) -> tuple[Toolpath, Toolpath]:
    """Return the table of a program in one chunk, and in chunks of `size` rows."""
    whole = interpret(TEXT, dialect="linuxcnc")
    table = whole.table()
    rows = [slice(first, first + size) for first in range(0, len(table), size)]
    chunks = [type(table)(part.start, *(getattr(table, name)[part] for name in COLUMNS)) for part in rows]
    return whole, Toolpath(whole.start, chunks, whole.states, whole.events, whole.spans)


@pytest.mark.parametrize("size", [1, 2, 5, CHUNK_ROWS])
def test_segments_and_tips_chunk_by_chunk_are_those_of_the_whole(size: int) -> None:
    whole, chunks = parted(size)
    wanted, found = segments(whole, 0.01), list(segments_of_chunks(chunks, 0.01))
    for name in ("begin", "end", "row"):
        assert np.array_equal(getattr(wanted, name), np.concatenate([getattr(p, name) for p in found]), equal_nan=True)
    for side, points in enumerate(tips_mm(whole)):
        own = np.concatenate([part[side + 1] for part in tips_of_chunks(chunks)])
        assert np.array_equal(points, own, equal_nan=True)


@pytest.mark.parametrize("size", [1, 4])
def test_a_report_does_not_depend_on_chunks(size: int) -> None:
    whole, chunks = parted(size)
    times_s = np.arange(1.0, len(whole) + 1)
    assert report(whole, times_s) == report(chunks, times_s)


def test_a_joined_table_holds_the_same_and_its_chunks_look_into_it() -> None:
    whole, chunks = parted(3)
    wanted = join_chunks(list(chunks.chunks))
    joined = chunks.table()
    assert joined is chunks.table() and joined.first == 0
    for name in COLUMNS:
        column = getattr(joined, name)
        assert column.dtype == getattr(wanted, name).dtype
        assert np.array_equal(column, getattr(wanted, name), equal_nan=column.dtype == float)
        assert all(np.shares_memory(getattr(chunk, name), column) for chunk in chunks.chunks)
    assert [chunk.first for chunk in chunks.chunks] == list(range(0, len(whole), 3))
    assert len(Toolpath(whole.start, [], whole.states).table()) == 0
