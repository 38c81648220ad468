# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Cutting data of a lathe by the published formulas, the nearest preset speed, and what is too weak for the cut.

    K_s = C_w / f^m     F_c = K_s a_p f     v_c = pi d n / 1000     P_c = F_c v_c / 60    v_f = f n    M = F_c d / 2000

    chuck |======================|      free end: y = F L³ / (3 E I)         I = pi d⁴ / 64
          |                      ^ F    with a tailstock, F in the middle: y = 7 F L³ / (768 E I)

C_w is the force on a chip of 1 mm², m its exponent. The force F that bends the bar away from the tool is taken as half
of F_c, the upper end of what handbooks give for it. Units: mm, N/mm², N, m/min, W, mm/min, Nm.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from CNCStepper.errors import Text
from CNCStepper.machine.feeds_and_speeds import Remark
from CNCStepper.machine.materials import Turning

BENDING_SHARE = 0.5  # of F_c
FRICTION = 0.25  # steel jaws on a turned bar
GRIP_SAFETY = 2.0
MOST_SLENDER = {False: 4.0, True: 10.0}  # length out of the chuck by diameter, without and with a tailstock
MOST_DEFLECTION_MM = 0.05


@dataclass(frozen=True)
class TurningCut:
    """A longitudinal cut: the material, the diameter, the depth a_p, the feed f a turn, and the speed n."""

    material: Turning
    diameter_mm: float
    depth_mm: float
    feed_mm: float
    rpm: float

    @property
    def pressure_n_mm2(self) -> float:
        """K_s, the specific cutting force."""
        return self.material.force_n_mm2 / self.feed_mm**self.material.exponent

    @property
    def force_n(self) -> float:
        """F_c, along the cut."""
        return self.pressure_n_mm2 * self.depth_mm * self.feed_mm

    @property
    def speed_m_min(self) -> float:
        """v_c, of the surface."""
        return math.pi * self.diameter_mm * self.rpm / 1000.0

    @property
    def power_w(self) -> float:
        """P_c, at the cut."""
        return self.force_n * self.speed_m_min / 60.0

    @property
    def torque_nm(self) -> float:
        """What the spindle and the chuck must bear."""
        return self.force_n * self.diameter_mm / 2000.0

    @property
    def feed_mm_min(self) -> float:
        """v_f."""
        return self.feed_mm * self.rpm


@dataclass(frozen=True)
class Holding:
    """How the bar is held: its length out of the chuck, a tailstock, and the force of all jaws; 0 is not known."""

    stickout_mm: float = 0.0
    tailstock: bool = False
    grip_n: float = 0.0


def rpm_of_power(material: Turning, diameter_mm: float, depth_mm: float, feed_mm: float, power_w: float) -> float:
    """Return the speed in rev/min at which the cut takes all of `power_w`."""
    return power_w / TurningCut(material, diameter_mm, depth_mm, feed_mm, 1.0).power_w


def nearest_preset_rpm(presets: Sequence[float], rpm: float) -> float:
    """Return the preset speed that is nearest to `rpm`, the slower of two; `rpm` itself where there are none."""
    return min(presets, key=lambda preset: (abs(preset - rpm), preset), default=rpm)


def deflection_mm(cut: TurningCut, holding: Holding) -> float:
    """Return by how much the bar bends away from the tool where it is weakest; the diameter grows by twice that."""
    inertia_mm4 = math.pi * cut.diameter_mm**4 / 64.0
    bend = BENDING_SHARE * cut.force_n * holding.stickout_mm**3 / (cut.material.elasticity_n_mm2 * inertia_mm4)
    return bend * 7.0 / 768.0 if holding.tailstock else bend / 3.0


def turning_remarks(cut: TurningCut, motor_w: float, holding: Holding) -> tuple[Remark, ...]:
    """Return what is too weak: the motor (0: not known), the chuck, the bar; each with the number that would do."""
    return (*_motor_remarks(cut, motor_w), *_chuck_remarks(cut, holding), *_bar_remarks(cut, holding))


def _motor_remarks(cut: TurningCut, motor_w: float) -> Iterator[Remark]:
    if 0.0 < motor_w < cut.power_w * (1.0 - 1e-9):
        share = motor_w / cut.power_w
        advice = Text(
            "{depth:.3g} mm deep, or {rpm:.4g} rpm, would do", depth=cut.depth_mm * share, rpm=cut.rpm * share
        )
        yield Remark("warning", "the cut needs more power than the motor has", cut.power_w, motor_w, "W", advice)


def _chuck_remarks(cut: TurningCut, holding: Holding) -> Iterator[Remark]:
    most_nm = FRICTION * holding.grip_n * cut.diameter_mm / 2000.0 / GRIP_SAFETY
    if holding.grip_n and cut.torque_nm > most_nm:
        advice = Text(
            "grip with {force:.4g} N, or cut {depth:.3g} mm deep",
            force=holding.grip_n * cut.torque_nm / most_nm,
            depth=cut.depth_mm * most_nm / cut.torque_nm,
        )
        yield Remark("warning", "the bar may turn in the chuck", cut.torque_nm, most_nm, "Nm", advice)


def _bar_remarks(cut: TurningCut, holding: Holding) -> Iterator[Remark]:
    slender, most = holding.stickout_mm / cut.diameter_mm, MOST_SLENDER[holding.tailstock]
    if slender > most:
        length_mm = most * cut.diameter_mm
        advice = Text("use a tailstock, or at most {length:.4g} mm", length=length_mm)
        if holding.tailstock:
            advice = Text("use a steady rest, or at most {length:.4g} mm", length=length_mm)
        yield Remark("warning", "the bar is slender: it bends and chatters", slender, most, "L/D", advice)
    bend_mm = deflection_mm(cut, holding)
    if bend_mm > MOST_DEFLECTION_MM:
        advice = Text("cut {depth:.3g} mm deep at most", depth=cut.depth_mm * MOST_DEFLECTION_MM / bend_mm)
        yield Remark("warning", "the bar bends away from the tool", bend_mm, MOST_DEFLECTION_MM, "mm", advice)
