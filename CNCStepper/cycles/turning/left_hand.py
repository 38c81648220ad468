# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Turning away from the chuck with a left-hand insert: the mirror image in z of turning towards it.

 bar  ----.__ lead       What a right-hand insert cannot reach, a neck behind a shoulder, is reached from the other
          |  \__         side. The tool comes down from beside the bar: the profile must end there, with a slope
shoulder  |     \----    that the back edge follows. The mirrored profile begins there, after a short lead.
          |______\  bar
"""

from __future__ import annotations

from dataclasses import replace
from math import radians, tan

import numpy as np

from CNCStepper.cycles.turning.profile_path import CLEAR_MM
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import SAME_MM

OUTWARDS = ("turn_finish", "turn_rough")  # cycles that a left-hand insert cuts
LEAST_LEAD_DEG, MOST_LEAD_DEG = 1.0, 45.0  # of the slope by which the tool comes to the bar


def from_the_chuck(setup: TurningSetup) -> TurningSetup:
    """Return the mirror image of a setup with a left-hand insert; raises CycleError for a profile that is not open."""
    assert setup.profile is not None
    _require_open(setup.profile, setup.radius_mm)
    tool = setup.tool.mirrored()
    slope_deg = MOST_LEAD_DEG if tool.is_round else min(max(tool.edges_deg[1], LEAST_LEAD_DEG), MOST_LEAD_DEG)
    profile = _with_lead(_over_the_face(setup).mirrored_x().reversed(), CLEAR_MM / tan(radians(slope_deg)))
    start = (-setup.start[0], setup.start[1])
    return replace(setup, tool=tool, profile=profile, start=start, face_mm=float(profile.xy[0, 0]), is_mirrored=True)


def _require_open(profile: Curve, radius_mm: float) -> None:
    end_mm = float(profile.xy[-1, 1])
    if end_mm < radius_mm - SAME_MM:
        what = "a left-hand insert comes from the end of the profile, which lies below the bar's surface"
        value, limit = f"radius {end_mm:g} mm", f"radius {radius_mm:g} mm"
        raise CycleError("profile-end", what, value=value, limit=limit, advice="let the profile end at the bar")


def _over_the_face(setup: TurningSetup) -> Curve:
    """Return the profile with a level piece before the raw end it begins at, so that the nose leaves the bar there."""
    profile, nose_mm = setup.profile, setup.tool.nose_mm
    assert profile is not None
    z, r = profile.xy[0].tolist()
    if z < setup.face_mm - SAME_MM:
        return profile
    return Curve(np.vstack([[(z + 2 * nose_mm + CLEAR_MM, r)], profile.xy]), np.concatenate([[0.0], profile.bulge]))


def _with_lead(profile: Curve, run_mm: float) -> Curve:
    """Return a profile with a slope down to its begin, and a short level piece before."""
    z, r = profile.xy[0].tolist()
    lead = [(z + run_mm + CLEAR_MM, r + CLEAR_MM), (z + run_mm, r + CLEAR_MM)]
    return Curve(np.vstack([lead, profile.xy]), np.concatenate([[0.0, 0.0], profile.bulge]))
