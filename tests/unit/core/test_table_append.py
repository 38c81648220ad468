# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table that takes another's rows says the same as if they had been made in it."""

from __future__ import annotations

import numpy as np

from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CW, COLUMNS, TableBuilder, Toolpath


def cut(table: TableBuilder) -> None:
    """Make a few moves with spans and an event."""
    table.open_span("level", "level 1", floor_mm=-1.0)
    table.rapid((0, 0, 5))
    table.event("dwell", 2.0)
    table.feed((1, 0, -1), 100)
    table.open_span("pass", "roughing 1")
    table.arc(ARC_CW, (2, 1, -1), (2, 0, 0), 200)
    table.close_span()
    table.close_span()


def built(replayed: bool) -> Toolpath:
    """Return two cuts with two tools, made in one table or taken over from tables of their own."""
    table = TableBuilder(Start())
    for tool in (1, 2):
        table.set_state(State(tool=tool))
        table.open_span("operation", f"operation {tool}")
        if replayed:
            alone = TableBuilder(Start())
            cut(alone)
            table.append(alone.toolpath())
        else:
            cut(table)
        table.close_span()
    return table.toolpath()


def test_rows_events_and_spans_are_the_same() -> None:
    made, taken = built(False), built(True)
    assert (taken.states, taken.events, taken.spans) == (made.states, made.events, made.spans)
    for name in COLUMNS:
        assert np.array_equal(getattr(taken.table(), name), getattr(made.table(), name)), name
    lengths = [len(chunk) for chunk in taken.chunks]
    assert [chunk.first for chunk in taken.chunks] == [sum(lengths[:number]) for number in range(len(lengths))]


def test_a_table_is_joined_once_and_its_chunks_are_parts_of_it() -> None:
    path, other = built(True), built(True)
    chunks, table = other.chunks, path.table()
    assert path.table() is table and len(table) == len(path) == 6
    assert [chunk.first for chunk in path.chunks] == [chunk.first for chunk in chunks]
    for part, chunk in zip(path.chunks, chunks, strict=True):
        for name in COLUMNS:
            assert np.array_equal(getattr(part, name), getattr(chunk, name)), name
            assert np.shares_memory(getattr(part, name), getattr(table, name)), name
    assert len(Toolpath(Start(), [], []).table()) == 0
