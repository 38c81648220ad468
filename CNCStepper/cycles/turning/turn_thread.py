# SPDX-License-Identifier: LGPL-2.1-or-later
"""Threading as an operation of a job: the thread by its designation, its cylinder or cone from the profile."""

from __future__ import annotations

from dataclasses import replace
from math import radians, tan

import numpy as np

from CNCStepper.cycles.turning.thread import ThreadCut, add_thread, check_cylinder, check_thread, timer_warnings
from CNCStepper.cycles.turning.thread_standards import Side, ThreadForm, thread_named
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import TurnThread
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_MM

FLANK_CLEAR_DEG = 1.0  # by which the infeed is steeper than the flank, so that the other edge does not rub


def thread(operation: TurnThread, setup: TurningSetup, moves: TurningMoves) -> dict[str, float]:
    """Append a thread and return its figures; raises CycleError or JobError before the first move."""
    if setup.tool.kind != "threading":
        what, advice = "a thread is cut with a threading tool", "use another tool"
        raise CycleError("thread-tool", what, value=setup.tool.kind_words, limit="a threading tool", advice=advice)
    if setup.tool.hand == "left":
        what, limit = "a thread is cut towards the chuck, by a right-hand insert", "a right-hand insert"
        advice = "use a right-hand insert, ER outside or IR inside"
        raise CycleError("thread-hand", what, value=setup.tool.kind_words, limit=limit, advice=advice)
    cut = thread_cut(operation, setup.tool.is_inside, setup.rpm, setup.profile)
    if setup.tool.pitch_mm and abs(setup.tool.pitch_mm - cut.form.pitch_mm) > SAME_MM:
        what, value = "the insert is of another pitch than the thread", f"{setup.tool.pitch_mm:g} mm"
        limit = f"{cut.form.pitch_mm:g} mm"
        raise CycleError("thread-insert", what, value=value, limit=limit, advice="use an insert of that pitch")
    if setup.machine is not None:
        check_thread(cut, setup.machine)
    if setup.profile is not None:
        check_cylinder(cut, setup.profile)
    depths = cut.depths_mm()
    begin = moves.tip(cut.begin_z_mm(0), cut.drive_radius_mm)
    if cut.begin_z_mm(0) > setup.face_mm:
        moves.approach_front(*begin)
    else:
        moves.approach_top(*begin)
    add_thread(cut, moves)
    moves.go_home()
    return {
        "lead_mm": cut.form.lead_mm,
        "crest_diameter_mm": round(2.0 * cut.crest_radius_mm, 6),
        "floor_diameter_mm": round(2.0 * cut.floor_radius_mm, 6),
        "passes": float(len(depths)),
        "first_depth_mm": round(depths[0], 6),
    }


def thread_warnings(operation: TurnThread, setup: TurningSetup) -> tuple[str, ...]:
    """Return what a person should know of a thread: one pass for its depth, or a lead that is not made exactly."""
    cut = thread_cut(operation, setup.tool.is_inside, setup.rpm, setup.profile)
    what = "the first pass cuts the thread's whole depth of {depth:.4g} mm; lower first_depth_mm"
    at_once = (Text(what, depth=cut.depth_mm),) if cut.first_depth_mm >= cut.depth_mm else ()
    return at_once + (timer_warnings(cut, setup.machine) if setup.machine is not None else ())


def thread_cut(operation: TurnThread, inside: bool, rpm: float, profile: Curve | None) -> ThreadCut:
    """Return the thread of an operation; raises JobError for a designation that is none."""
    form = thread_form(operation)
    side: Side = "inside" if inside else "outside"
    crest_mm, floor_mm = _radii_mm(operation, form, side, profile)
    infeed_deg = operation.infeed_deg or form.angle_deg / 2.0 - FLANK_CLEAR_DEG
    return ThreadCut(
        form=form,
        side=side,
        crest_radius_mm=crest_mm,
        floor_radius_mm=floor_mm,
        z_start_mm=operation.z_mm,
        z_end_mm=operation.z_mm - operation.length_mm,
        rpm=rpm,
        approach_mm=operation.approach_mm,
        clearance_mm=operation.clearance_mm,
        first_depth_mm=operation.first_depth_mm,
        infeed=operation.infeed,
        infeed_deg=infeed_deg,
        degression=operation.degression,
        spring=operation.spring_passes,
        pull_out_mm=operation.pull_out_mm,
        slope=tan(radians(operation.taper_deg)),
    )


def thread_form(operation: TurnThread) -> ThreadForm:
    """Return the thread of an operation's designation, with its own number of starts where that is given."""
    form = thread_named(operation.thread)
    return replace(form, starts=operation.starts) if operation.starts else form


def _radii_mm(operation: TurnThread, form: ThreadForm, side: Side, profile: Curve | None) -> tuple[float, float]:
    """Return the radii of crest and floor where the thread begins; a cone's thread has its depth below its crest."""
    fit = form.fit(side)
    crest = operation.diameter_mm / 2.0 or sum(fit.crest_mm) / 4.0
    if profile is not None and not operation.diameter_mm:
        order = np.argsort(profile.xy[:, 0], kind="stable")
        crest = float(np.interp(operation.z_mm, profile.xy[order, 0], profile.xy[order, 1]))
    if operation.diameter_mm or operation.taper_deg:
        return crest, crest + (form.depth_mm(side) if side == "inside" else -form.depth_mm(side))
    return crest, form.floor_mm(side) / 2.0
