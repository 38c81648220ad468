# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether each axis' motor has the torque for the speed and acceleration that the planner commands it, row by row."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.machine.profile import Motor
from CNCStepper.simulation.check_context import CheckContext
from CNCStepper.simulation.finding import Finding
from CNCStepper.toolpath import LINE, RAPID

SPEED_STEP_MM_S = 0.1  # speeds this close are looked up once
SMALL_MM_S = 1e-6


def motors(subject: CheckContext) -> Iterator[Finding]:
    """Yield for each axis the move at which its motor lacks most torque; without an encoder it would lose steps."""
    if not len(subject.toolpath) or not any(axis.motor for axis in subject.machine.axes):
        return
    speeds, accelerations = subject.speeds_mm_s, _accelerations(subject)
    for axis, name, profile in subject.machine.numbered_axes:
        if profile.motor is not None:
            yield from _lacking(subject, name, profile.motor, speeds[:, axis], accelerations[:, axis])


def _lacking(subject: CheckContext, name: str, motor: Motor, speed: np.ndarray, acceleration: np.ndarray):
    needed, given = np.zeros(len(speed)), np.full(len(speed), np.inf)
    moving = np.flatnonzero(speed > SMALL_MM_S)
    load = np.column_stack([np.ceil(speed[moving] / SPEED_STEP_MM_S) * SPEED_STEP_MM_S, acceleration[moving]])
    pairs, which = np.unique(np.round(load, 3), axis=0, return_inverse=True)
    which = which.reshape(-1)
    needed[moving] = np.array([motor.needed_nm(a) for _, a in pairs])[which] if len(pairs) else 0.0
    given[moving] = np.array([motor.torque_at_nm(motor.rpm_at(v)) for v, _ in pairs])[which] if len(pairs) else 0.0
    rows = np.flatnonzero(needed > given)
    if len(rows):
        worst = int(rows[(needed - given)[rows].argmax()])
        yield subject.finding(
            worst,
            "warning",
            "motor-torque",
            Text(
                "the motor of {name} may lose steps: at {speed:.4g} mm/s ({rpm_at:.0f} rpm) and "
                "{acceleration:.4g} mm/s² it has too little torque",
                name=name.upper(),
                speed=speed[worst],
                rpm_at=motor.rpm_at(speed[worst]),
                acceleration=acceleration[worst],
            ),
            advice="lower the feed here, or the axis' rate and acceleration in controller and profile",
            value=float(needed[worst]),
            limit=float(given[worst]),
            unit="Nm",
            count=len(rows),
            group=name,
            rank=float((needed - given)[worst]),
            at_first=False,
        )


def _accelerations(subject: CheckContext) -> np.ndarray:
    """Return with how much each axis speeds up on every row, float64[n, 3]; on an arc each with its own greatest."""
    most = np.array([axis.acceleration_mm_s2 for axis in subject.machine.axes])
    way = np.abs(np.nan_to_num(subject.end - subject.begin))
    length = np.linalg.norm(way, axis=1)
    share = way / np.where(length > 0, length, 1.0)[:, None]
    along = (most / np.maximum(share, 1e-12)).min(axis=1)
    straight = np.isin(subject.table.kind, (RAPID, LINE)) & (length > 0)
    return np.where(straight[:, None], share * along[:, None], most)
