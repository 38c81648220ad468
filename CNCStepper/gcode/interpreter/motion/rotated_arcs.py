# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs in the planes ZX and YZ of a work system that is turned about Z: they lie in no plane of the machine.

The table gets chords, whose middles lie within a tolerance of the arc:  sagitta = radius (1 - cos(angle / 2))
"""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, ceil, cos, hypot, sin

from CNCStepper.gcode.interpreter.motion.arc_geometry import FULL_TURN
from CNCStepper.gcode.interpreter.motion.moves import Arc, sweep
from CNCStepper.gcode.interpreter.state.model import Model, Point
from CNCStepper.toolpath import ARC_CW, PLANE_AXES

TOLERANCE_MM = 0.002


def chords(model: Model, motion: int, arc: Arc, end: Point) -> Iterator[Point]:
    """Yield the ends of chords along an arc from the model's position to `end` (machine mm)."""
    begin_work, end_work, centre_work = model.work(model.position), model.work(end), model.work(arc.centre)
    first, second, normal = PLANE_AXES[arc.plane]
    x, y = begin_work[first] - centre_work[first], begin_work[second] - centre_work[second]
    begin, end_flat, centre = ((point[first], point[second]) for point in (begin_work, end_work, centre_work))
    angle = sweep(begin, end_flat, centre, motion == ARC_CW) + (arc.turns - 1) * FULL_TURN
    angle = -angle if motion == ARC_CW else angle
    widest = 2 * acos(max(0.0, 1 - TOLERANCE_MM / hypot(x, y)))
    count = max(1, ceil(abs(angle) / widest))
    for step in range(1, count):
        turn, share = angle * step / count, step / count
        place = [0.0, 0.0, 0.0]
        place[first] = centre_work[first] + x * cos(turn) - y * sin(turn)
        place[second] = centre_work[second] + x * sin(turn) + y * cos(turn)
        place[normal] = begin_work[normal] + share * (end_work[normal] - begin_work[normal])
        yield model.machine((place[0], place[1], place[2]))
    yield end
