# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table that takes another's rows says the same as if they had been made in it."""

from __future__ import annotations

import numpy as np

from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CW, TableBuilder, Toolpath


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
    for name in ("kind", "end", "centre", "plane", "turns", "feed", "state", "line"):
        assert np.array_equal(getattr(taken.table(), name), getattr(made.table(), name)), name
    assert [chunk.first for chunk in taken.chunks] == [0, 3]
