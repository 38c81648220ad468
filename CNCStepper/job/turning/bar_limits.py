# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an operation lies in its bar and clear of the chuck: refused before it is cut, with the number that would do.

     jaws  ____________________
 ___|=====|                    |      free: from the jaws (in a bore from the chuck's face) to the raw end,
chuck     |        bar         |            no wider than the bar
----------'--------------------+--> z
       -length_mm              0  face_mm
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.cycles.turning.turn_taper import end_radius_mm
from CNCStepper.cycles.turning.turn_thread import thread_cut
from CNCStepper.cycles.turning.turning_operation import BY_EDGE, TurnDrill, TurningOperation
from CNCStepper.errors import CycleError, Text
from CNCStepper.job.turning.taper_profile import profile_of
from CNCStepper.job.turning.turning_job import TurningJob
from CNCStepper.tolerances import SAME_MM

WIDER_BAR = "use a thicker bar, or correct the diameter"


def require_in_bar(number: int, job: TurningJob, bore_mm: float) -> None:
    """Raise CycleError where an operation (from 1) of a job leaves the bar; bore_mm: of what is hollow before it."""
    operation = job.operation[number - 1]
    CHECKS[operation.cycle](operation, job)
    if operation.cycle in BY_EDGE and job.tools[operation.tool].is_inside and bore_mm > 0:
        _require_hole(operation, job, bore_mm, _hole_depth_mm(job.operation[: number - 1], job))


def _face(operation: Any, job: TurningJob) -> None:
    _require_free(operation.to_z_mm, "to_z_mm", job)
    if operation.to_diameter_mm >= job.stock.diameter_mm:
        what, value = "to_diameter_mm leaves nothing to face", f"{operation.to_diameter_mm:g} mm"
        limit = Text("below {most:g} mm", most=job.stock.diameter_mm)
        raise CycleError("face-diameter", what, value=value, limit=limit, advice="end nearer to the axis")


def _taper(operation: Any, job: TurningJob) -> None:
    inside = job.tools[operation.tool].is_inside
    _require_free(operation.z_mm - operation.length_mm, "length_mm", job, inside)
    _require_behind_end("taper-outside", operation.z_mm - operation.length_mm, job)
    widest_mm = max(operation.diameter_mm, 2 * end_radius_mm(operation))
    _require_narrow("taper-wide", "the cone is wider than the bar", widest_mm, job)


def _profile(operation: Any, job: TurningJob) -> None:
    points, inside = job.curves[operation.profile].points(SAME_MM * 100), job.tools[operation.tool].is_inside
    name = Text("the profile '{name}'", name=operation.profile)
    _require_free(float(points[:, 0].min()), name, job, inside, code="profile-chuck")
    _require_behind_end("profile-outside", float(points[:, 0].min()), job, name)
    _require_narrow("profile-outside", "the profile is wider than the bar", 2 * float(points[:, 1].max()), job)


def _groove(operation: Any, job: TurningJob) -> None:
    _require_free(operation.z_mm, "z_mm", job, job.tools[operation.tool].is_inside)
    _require_behind_end("groove-outside", operation.z_mm, job)
    end_mm, face_mm = operation.z_mm + operation.width_mm, job.stock.face_mm
    if end_mm > face_mm + SAME_MM:
        what, value = "the groove is wider than what lies before the raw end: width_mm", f"{operation.width_mm:g} mm"
        limit = f"{face_mm - operation.z_mm:.4g} mm"
        raise CycleError("groove-width", what, value=value, limit=limit, advice="make it narrower, or lower z_mm")


def _part(operation: Any, job: TurningJob) -> None:
    width_mm = job.tools[operation.tool].width_mm
    _require_free(operation.z_mm - width_mm, "z_mm", job, more_mm=width_mm)
    _require_behind_end("part-outside", operation.z_mm, job)


def _drill(operation: Any, job: TurningJob) -> None:
    if operation.depth_mm > job.stock.length_mm + SAME_MM:
        what, value = "depth_mm is deeper than the bar sticks out of the chuck", f"{operation.depth_mm:g} mm"
        limit = f"{job.stock.length_mm:g} mm"
        raise CycleError("drill-deep", what, value=value, limit=limit, advice="drill less deep, or use a longer bar")
    _require_narrow("drill-wide", "the drill is wider than the bar", job.tools[operation.tool].diameter_mm, job)


def _thread(operation: Any, job: TurningJob) -> None:
    inside = job.tools[operation.tool].is_inside
    _require_free(operation.z_mm - operation.length_mm, "length_mm", job, inside)
    if operation.z_mm - operation.length_mm >= job.stock.face_mm:
        _require_behind_end("thread-outside", operation.z_mm - operation.length_mm, job)
    cut = thread_cut(operation, inside, 1.0, job.curves.get(operation.profile))
    widest_mm = 2 * max(cut.crest_radius_mm, cut.floor_radius_mm)
    _require_narrow("thread-wide", "the thread is wider than the bar", widest_mm, job)


def _require_free(
    z_mm: float,
    what: str,
    job: TurningJob,
    is_inside: bool = False,
    more_mm: float = 0.0,
    code: str = "chuck-reach",
) -> None:
    """Raise CycleError for a place in the chuck or between its jaws; more_mm: how far the tool goes beyond its key."""
    jaw_mm = 0.0 if is_inside else job.chuck.jaw_mm
    end_mm = jaw_mm - job.stock.length_mm
    if z_mm < end_mm - SAME_MM:
        longer_mm = job.stock.length_mm + end_mm - z_mm
        raise CycleError(
            code,
            Text("{what} reaches into the chuck or its jaws", what=what),
            value=f"z {z_mm + more_mm:g} mm",
            limit=f"z {end_mm + more_mm:g} mm",
            advice=Text("end before it, or let the bar stick out {length:g} mm", length=longer_mm),
        )


def _require_behind_end(code: str, z_mm: float, job: TurningJob, name: str = "z_mm") -> None:
    """Raise CycleError for a place before the raw end, where there is nothing to cut."""
    if z_mm >= job.stock.face_mm - SAME_MM:
        what = Text("{name} lies before the raw end of the bar", name=name)
        limit = Text("below z {face:g} mm", face=job.stock.face_mm)
        raise CycleError(code, what, value=f"z {z_mm:g} mm", limit=limit, advice="z falls towards the chuck")


def _require_narrow(code: str, what: str, diameter_mm: float, job: TurningJob) -> None:
    """Raise CycleError for a diameter above the bar's."""
    if diameter_mm > job.stock.diameter_mm + 2 * SAME_MM:
        value, limit = f"{diameter_mm:.6g} mm", f"{job.stock.diameter_mm:g} mm"
        raise CycleError(code, what, value=value, limit=limit, advice=WIDER_BAR)


def _require_hole(operation: Any, job: TurningJob, bore_mm: float, deep_mm: float) -> None:
    """Raise CycleError for a bore that is narrower or deeper than the hole into which the boring bar goes."""
    profile = profile_of(operation, job)
    assert profile is not None
    points = profile.points(SAME_MM * 100)
    widest_mm, lowest_mm = 2 * float(points[:, 1].max()), float(points[:, 0].min())
    if widest_mm <= bore_mm:
        what, limit = "the profile lies in the hole: there is nothing to bore", Text("above {bore:g} mm", bore=bore_mm)
        raise CycleError("bore-wide", what, value=f"{widest_mm:.6g} mm", limit=limit, advice="drill a narrower hole")
    if lowest_mm < -deep_mm - SAME_MM:
        what, value = "the profile is deeper than the hole that is drilled", f"z {lowest_mm:g} mm"
        advice = Text("drill {more:.4g} mm deeper before it", more=-deep_mm - lowest_mm)
        raise CycleError("bore-deep", what, value=value, limit=f"z {-deep_mm:.4g} mm", advice=advice)


def _hole_depth_mm(before: tuple[TurningOperation, ...], job: TurningJob) -> float:
    """Return how deep what is hollow is as wide as it is: a drill's point is not."""
    if job.stock.bore_mm > 0:
        return job.stock.length_mm
    drilled = [(job.tools[one.tool].point_mm, one.depth_mm) for one in before if isinstance(one, TurnDrill)]
    return max((depth_mm - point_mm for point_mm, depth_mm in drilled), default=0.0)


CHECKS: dict[str, Callable[[Any, TurningJob], None]] = {
    "turn_bore": _profile,
    "turn_drill": _drill,
    "turn_face": _face,
    "turn_finish": _profile,
    "turn_groove": _groove,
    "turn_part": _part,
    "turn_rough": _profile,
    "turn_taper": _taper,
    "turn_thread": _thread,
}
