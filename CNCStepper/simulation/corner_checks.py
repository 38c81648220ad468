# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the machine leaves the programmed path by leave of the program itself: corners that G64 lets it cut."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.subject import Subject
from CNCStepper.toolpath import LINE


def blended(subject: Subject) -> Iterator[Finding]:
    """Yield how far corners between straight feeds may be cut at most (G64 P), and where nothing says how far (G64)."""
    states, table = subject.toolpath.states, subject.table
    of_state = np.array([state.blend_mm if state.path_mode == "blend" else -1.0 for state in states])
    allowed = np.where(table.kind == LINE, of_state[table.state], -1.0)
    at_corner = np.minimum(allowed[:-1], allowed[1:])
    if len(rows := np.flatnonzero(at_corner > 0.0)):
        widest = int(rows[at_corner[rows].argmax()])
        yield subject.finding(
            widest,
            "warning",
            "corners-cut",
            "G64 P lets the machine cut corners: times and pulses do so, the simulated part shows the programmed path",
            advice="the part may differ from it by as much: lower P, or follow the exact path with G61",
            value=float(at_corner[widest]),
            unit="mm",
            count=len(rows),
        )
    if len(rows := np.flatnonzero(at_corner == 0.0)):
        yield subject.finding(
            int(rows[0]),
            "warning",
            "corners-cut",
            "G64 without P does not say how far the machine may cut corners; all is worked out for the programmed path",
            advice="give G64 a P, or follow the exact path with G61",
            count=len(rows),
        )
