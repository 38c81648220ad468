# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program with holds, overrides and resumes at given steps."""

from __future__ import annotations

import numpy as np

from CNCStepper.motion.planner.live_motion import Motion

WAY = np.cumsum(np.random.default_rng(3).normal(0, 0.8, (40, 3)) * (1, 1, 0.1), axis=0)


def meddled(limits, acts):
    """Run WAY through a live motion, with acts so many time steps apart; returns it when all is done."""
    motion = Motion(limits, record=True)
    waiting, acts = [tuple(point) for point in WAY], list(acts)
    clock = 0
    while waiting or acts or not motion.idle:
        while waiting and motion.room:
            motion.line(waiting.pop(0), 1800, rapid=len(waiting) % 7 == 0)
        motion.advance(0.005)
        clock += 1
        if acts and clock % acts[0][0] == 0:
            meddle(motion, *acts.pop(0)[1:])
        if not acts:
            motion.resume()
        assert motion.time_s < 900
    return motion


def meddle(motion, act, factor):
    if act == "hold":
        motion.hold()
    elif act == "resume":
        motion.resume()
    elif act == "starve":
        motion.advance(0.7)
    else:
        motion.override(*((factor, 1.0) if act == "feed" else (1.0, min(factor, 1.0))))


def held_on_a_line(limits, after, factor, steps_per_mm):
    """Hold two collinear moves of 40 mm while an override acts, and resume; returns the motion and its accelerations.

    after: of 5 ms, how many before the override. The accelerations, mm/s², are those of every 50 ms.
    """
    motion = Motion(limits, record=True)
    motion.line((40, 0, 0), 3000)
    motion.line((80, 0, 0), 1000)
    motion.advance(after * 0.005)
    motion.override(factor, 1.0)
    motion.advance(0.1)
    motion.hold()
    motion.advance(20)
    assert motion.held
    motion.resume()
    motion.advance(400)
    steps = motion.step_path()
    grid = np.arange(0, steps[-1, 0], 0.05)
    places = np.concatenate([[0], steps[:, 1]])[np.searchsorted(steps[:, 0], grid, side="right")] / steps_per_mm
    return motion, np.abs(np.diff(places, 2)) / 0.05**2
