# SPDX-License-Identifier: LGPL-2.1-or-later
"""One job that holds all that dialects differ in; a lathe gets those of its moves that lie in X and Z."""

from __future__ import annotations

from dataclasses import replace

from CNCStepper.canned_cycle_expansion import Canned
from CNCStepper.state import UNKNOWN, Start, State
from CNCStepper.toolpath import ARC_CCW, ARC_CW, ZX, TableBuilder, Toolpath

FIRST = State(tool=1, spindle="cw", spindle_rpm=10_000, flood=True)
SECOND = replace(FIRST, tool=2, spindle_rpm=8000, flood=False, tool_length_mm=0.0)


def one_job(is_lathe: bool = False) -> Toolpath:
    """Return lines, arcs of two planes, a helix, a full circle, turns, holes, a dwell, a pause and two tools."""
    table = TableBuilder(Start(), FIRST)

    def at(x: float, y: float, z: float) -> tuple[float, float, float]:
        return x, UNKNOWN if is_lathe else y, z

    table.open_span("operation", "peça nº 1")
    table.rapid(at(0, 0, 10))
    table.rapid(at(0, 0, 2))
    table.feed(at(0, 0, -1), 200)
    table.feed(at(10, 0, -1.5), 800)
    table.event("dwell", 0.5)
    table.arc(ARC_CW, at(0, 0, 8.5), (0, 0, -1.5), 800, plane=ZX)
    if not is_lathe:
        _in_xy(table)
    table.close_span()
    table.event("pause", text="turn the part")
    table.rapid(at(0, 0, 10))
    table.set_state(SECOND)
    table.rapid(at(20, 0, 10))
    if not is_lathe:
        _holes(table)
    table.rapid(at(20, 0, 10))
    table.feed(at(20, 0, -1), 100)
    table.rapid(at(20, 0, 10))
    return table.toolpath()


def _in_xy(table: TableBuilder) -> None:
    table.arc(ARC_CW, (10, 0, 6.5), (5, 0, 8.5), 800)
    table.arc(ARC_CW, (10, 0, 6.5), (5, 0, 6.5), 800)
    table.arc(ARC_CCW, (0, 0, 0.5), (5, 0, 6.5), 400, turns=3)


def _holes(table: TableBuilder) -> None:
    """Drill three holes as the cycles do: by G81 and G83."""
    for cycle in (Canned("G81", -4, 1, to_initial=True), Canned("G83", -6, 1, 3, to_initial=True)):
        for x, y in ((20.0, 5.0), (25.0, 5.0)):
            words = {"X": x, "Y": y, "Z": cycle.z, "R": cycle.r, "Q": cycle.own, "G": 98.0}
            table.open_span("cycle", cycle.name, **words)
            (strokes,) = cycle.holes(10.0, 10.0, [(x, y)])
            for stroke in strokes:
                table.rapid(stroke.end) if stroke.kind == "rapid" else table.feed(stroke.end, 120)
            table.close_span()
