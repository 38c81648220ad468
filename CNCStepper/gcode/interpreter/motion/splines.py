# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines in the plane XY: G5 (cubic), G5.1 (quadratic), and NURBS, G5.2 to G5.3, as arcs within a tolerance.

p1 o . . . . o p2          G5: p0 + (I, J) and p3 + (P, Q);  G5.1: one control point, p0 + (I, J)
  .            .           Without I and J, G5 continues smoothly: they are the former P and Q, negated.
 .              .
p0 *            * p3       A Bezier curve is a NURBS of its control points with equal weights.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from CNCStepper.errors import GeometryError, ProgramError, Text
from CNCStepper.gcode.dialects.codes import MOTION_NAMES, NO_MOTION, Code
from CNCStepper.gcode.interpreter.block import Block, check_feed
from CNCStepper.gcode.interpreter.motion.arcs import Arc, Flat
from CNCStepper.gcode.interpreter.motion.end_points import end_point
from CNCStepper.gcode.interpreter.motion.nurbs import Nurbs, nurbs_knots, nurbs_points
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, XY

TOLERANCE_MM = 0.002  # of the arcs that replace a spline in the table
STRAIGHT = 1e-9  # bulge below which a piece is a line


def bezier(block: Block, motion: int, before: int) -> None:
    """Execute G5 or G5.1; raises ProgramError."""
    name = MOTION_NAMES[motion]
    block.uncompensated("no spline may be cut", name)
    _check_feed(block, motion)
    if block.model.nurbs is not None:  # LinuxCNC 2.9 takes its control points for this curve's
        what: str = Text("{name} is between G5.2 and G5.3", name=name)
        raise ProgramError("spline-open", what, value=name, advice="write G5.3 on a line before")
    if block.model.state.plane != "XY":
        raise ProgramError("plane", "splines lie in the plane XY", value=name, advice="write G17 before")
    for letter in "ZABC":
        if letter in block.plan.slots:
            what = "a spline moves X and Y only"
            raise ProgramError(
                "unused-word", what, value=letter, advice=Text("move {letter} on a line of its own", letter=letter)
            )
    begin, end = _ends(block)
    first = _first_control(block, name, begin)
    points = [begin, first, end]
    if name == "G5":
        if not {"P", "Q"} <= block.plan.slots.keys():
            raise ProgramError("missing-word", "G5 needs both P and Q", value=name, advice="add them")
        p, q = block.value("P") * block.model.scale, block.value("Q") * block.model.scale
        points.insert(2, (end[0] + p, end[1] + q))
        block.model.spline_ij = (-p, -q)
    _cut(block, Nurbs(tuple(points), (1.0,) * len(points), len(points)), motion)


def _check_feed(block: Block, motion: int) -> None:
    """Refuse a spline without a feed; in inverse time LinuxCNC 2.9 cuts it at the feed that was in force before."""
    if block.model.state.feed_mode == "inverse_time":
        what, name = "no spline is cut in inverse time", MOTION_NAMES[motion]
        raise ProgramError("feed-mode", what, value=name, advice="write G94 and an F word before")
    check_feed(block.model, motion, block.plan, block.values)


def _first_control(block: Block, name: str, begin: Flat) -> Flat:
    """Return the control point of the beginning: I and J from there, or as the G5 before ended."""
    given = [letter for letter in "IJ" if letter in block.plan.slots]
    if len(given) == 1 or (not given and name == "G5.1"):
        what = "G5 needs both I and J or neither" if name == "G5" else Text("{name} needs both I and J", name=name)
        raise ProgramError("missing-word", what, value=name, advice="add them")
    i, j = (block.value(letter) * block.model.scale for letter in given) if given else block.model.spline_ij
    return begin[0] + i, begin[1] + j


def control_point(block: Block, motion: int, before: int) -> None:
    """Execute a block of G5.2: a control point more; raises ProgramError."""
    model, slots = block.model, block.plan.slots
    if ("X" in slots) != ("Y" in slots):
        raise ProgramError("missing-word", "a control point needs both X and Y", value="G5.2", advice="add the other")
    weight = block.value("P") if "P" in slots else 0.0
    nurbs = model.nurbs
    if nurbs and weight <= 0:
        raise ProgramError("bad-value", "a control point needs a weight P above 0", value="G5.2", advice="add P")
    if nurbs and "X" not in slots:
        raise ProgramError(
            "missing-word", "only the first control point goes without X and Y", value="G5.2", advice="add X and Y"
        )
    _check_feed(block, motion)
    if nurbs is None:
        own = weight if "X" not in slots and weight > 0 else 1.0
        nurbs = Nurbs((_ends(block)[0],), (own,))
    if "L" in slots:
        nurbs = nurbs._replace(order=max(nurbs.order, block.whole("L", 0, 100)))
    if "X" in slots:
        points, weights = (*nurbs.points, _ends(block)[1]), (*nurbs.weights, weight)
        nurbs = nurbs._replace(points=points, weights=weights)
    model.nurbs = nurbs


def end_nurbs(block: Block, code: Code) -> None:
    """G5.3: cut the NURBS whose control points the blocks of G5.2 have given."""
    nurbs, model = block.model.nurbs, block.model
    other = next((one.name for one in block.plan.codes if one.motion is not None and one.name != "G5.2"), "")
    if other:
        what = "G5.3 ends a NURBS: no other motion may share its line"
        raise ProgramError("axis-conflict", what, value=other, advice="write it on the next line")
    if nurbs is None or MOTION_NAMES[model.motion] != "G5.2":
        raise ProgramError("no-spline", "G5.3 without a G5.2 before it", value="G5.3", advice="write G5.2 before")
    if len(nurbs.points) < nurbs.order:
        what = Text("a NURBS of order {order} needs as many control points", order=nurbs.order)
        raise ProgramError("control-points", what, value="G5.3", limit=str(nurbs.order), advice="add control points")
    _check_feed(block, MOTION_NAMES.index("G5.2"))
    model.nurbs = None
    model.motion = NO_MOTION
    _cut(block, nurbs, LINE)


def _ends(block: Block) -> tuple[Flat, Flat]:
    """Return where the block begins and ends, in work mm."""
    local = block.model.local()
    for axis in (0, 1):
        block.known(axis)
    return local.position[:2], end_point(local, block.plan, block.values)[:2]


def _cut(block: Block, nurbs: Nurbs, motion: int) -> None:
    """Emit the call and make a row of each arc; a spline that stays where it is makes none."""
    block.call(f"NURBS_FEED({len(nurbs.points)}, ...)")
    block.unheard = True
    stood = stand_alone_position.machine_position_at(block.model)
    z = block.model.local().position[2]
    end = (*nurbs.points[-1], z)
    feed = block.feed_of(motion, block.model.machine(end), length=_length(nurbs))
    for piece_end, bulge in _pieces(nurbs):
        _row(block, (*piece_end, z), bulge, feed)
    block.unheard = False
    block.model.position = block.model.machine(end)
    stand_alone_position.spline_made(block.model, stood)


def _row(block: Block, end: tuple[float, float, float], bulge: float, feed: float) -> None:
    model = block.model
    x, y, z = model.local().position
    if abs(bulge) < STRAIGHT:
        block.move(LINE, model.machine(end), None, feed)
        return
    # the centre lies on the bisector of the chord; bulge is the tangent of a quarter of the arc's angle
    chord = complex(end[0] - x, end[1] - y)
    centre = complex(x, y) + chord / 2 + 1j * chord * (1 - bulge * bulge) / (4 * bulge)
    radius, angle = abs(complex(x, y) - centre), 4 * abs(float(np.arctan(bulge)))
    arc = Arc(model.machine((centre.real, centre.imag, z)), XY, 1, radius, angle)
    block.move(ARC_CCW if bulge > 0 else ARC_CW, model.machine(end), arc, feed)


def _pieces(nurbs: Nurbs) -> list[tuple[Flat, float]]:
    """Return the ends and bulges of the arcs, none where the curve is a point."""
    if all(point == nurbs.points[0] for point in nurbs.points):
        return []
    from CNCStepper.geometry.fitting.curve_to_arcs import fit_curve  # with the kernels, which a sender does without

    inner = sorted({*nurbs_knots(nurbs).tolist()})
    try:
        curve = fit_curve(lambda at: nurbs_points(nurbs, at), 0.0, inner[-1], TOLERANCE_MM, inner[1:-1])
    except GeometryError as error:
        raise ProgramError("spline", error.what, value="", advice="write the curve as lines and arcs") from error
    return [((float(x), float(y)), float(bulge)) for (x, y), bulge in zip(curve.xy[1:], curve.bulge, strict=True)]


def _length(nurbs: Nurbs) -> float:
    at = np.linspace(0.0, float(nurbs_knots(nurbs)[-1]), 1000)
    return float(np.hypot(*np.diff(nurbs_points(nurbs, at), axis=0).T).sum())


SPLINE_ACTS: dict[str, Callable[[Block, Code], None]] = {"end_nurbs": end_nurbs}
