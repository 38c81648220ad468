# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting data of a lathe: the published example figure for figure, preset speeds, and what is too weak."""

from __future__ import annotations

import math

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.materials import material
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.turning_forces import (
    Holding,
    TurningCut,
    deflection_mm,
    nearest_preset_rpm,
    rpm_of_power,
    turning_remarks,
)

PVC = material("pvc").turning_data()


def published(rpm: float = 85.7) -> TurningCut:
    return TurningCut(PVC, 100.0, 3.0, 3.0, rpm)


def test_the_published_example_comes_out_figure_for_figure():
    rpm = rpm_of_power(PVC, 100.0, 3.0, 3.0, 386.0)
    cut = published(rpm)
    assert round(cut.pressure_n_mm2, 1) == 95.6
    assert round(cut.force_n, 1) == pytest.approx(860.4, abs=0.05)
    assert round(cut.speed_m_min / 60, 3) == 0.449
    assert round(rpm, 1) == 85.7
    assert round(cut.power_w, 6) == 386
    assert round(cut.torque_nm, 1) == 43.0
    assert cut.feed_mm_min == pytest.approx(3 * rpm)


def test_torque_times_angular_speed_is_the_power():
    cut = TurningCut(material("mild-steel").turning_data(), 31.0, 1.2, 0.18, 640.0)
    assert cut.torque_nm * cut.rpm * 2 * math.pi / 60 == pytest.approx(cut.power_w)


def test_the_nearest_preset_speed():
    presets = load_machine("mini-lathe").spindle.preset_rpm
    assert [nearest_preset_rpm(presets, rpm) for rpm in (1, 85.7, 107.5, 108, 1200, 9999)] == [
        90, 90, 90, 125, 1000, 2000,
    ]  # fmt: skip
    assert nearest_preset_rpm((), 123.4) == 123.4


@pytest.mark.parametrize("tailstock", [False, True])
def test_the_deflection_is_that_of_the_beam_equation(tailstock):
    """Against the integrated bending moment, numerically."""
    cut, length = published(), 400.0
    stiffness = PVC.elasticity_n_mm2 * math.pi * 100.0**4 / 64
    z = np.linspace(0.0, length, 200_001)
    force = cut.force_n / 2
    if tailstock:  # fixed at 0, held at the end, loaded in the middle: reaction 5/16 F at the free support
        moment = 5 / 16 * force * (length - z) - force * np.clip(length / 2 - z, 0.0, None)
    else:
        moment = -force * (length - z)
    slope = np.concatenate(([0.0], np.cumsum((moment[1:] + moment[:-1]) / 2 * np.diff(z)))) / stiffness
    bend = np.concatenate(([0.0], np.cumsum((slope[1:] + slope[:-1]) / 2 * np.diff(z))))
    at = len(z) // 2 if tailstock else -1
    assert deflection_mm(cut, Holding(length, tailstock)) == pytest.approx(abs(bend[at]), rel=1e-4)


def test_a_weak_motor_is_named_with_the_depth_and_the_speed_that_would_do():
    (remark,) = turning_remarks(published(90), 386.0, Holding())
    assert "power" in remark.text and remark.limit == 386.0 and "2.86 mm deep, or 85.69 rpm" in remark.advice
    share = 386.0 / published(90).power_w
    assert not turning_remarks(TurningCut(PVC, 100.0, 3.0 * share, 3.0, 90), 386.0, Holding())
    assert not turning_remarks(published(90), 0.0, Holding())


def test_a_weak_chuck_is_named_with_the_force_that_would_do():
    (remark,) = turning_remarks(published(), 0.0, Holding(grip_n=3000.0))
    assert "chuck" in remark.text and remark.value == pytest.approx(published().torque_nm)
    needed = float(remark.advice.split()[2])
    assert not turning_remarks(published(), 0.0, Holding(grip_n=needed * 1.001))


def test_a_slender_bar_is_named_with_the_length_that_would_do():
    steel = TurningCut(material("mild-steel").turning_data(), 20.0, 0.2, 0.1, 500.0)
    (remark,) = turning_remarks(steel, 0.0, Holding(stickout_mm=100.0))
    assert "slender" in remark.text and remark.value == 5.0 and "at most 80 mm" in remark.advice
    assert not turning_remarks(steel, 0.0, Holding(stickout_mm=80.0))
    assert not turning_remarks(steel, 0.0, Holding(stickout_mm=100.0, tailstock=True))


def test_a_bar_that_bends_is_named_with_the_depth_that_would_do():
    holding = Holding(stickout_mm=400.0)
    (remark,) = turning_remarks(published(), 0.0, holding)
    assert "bends" in remark.text and remark.value == pytest.approx(deflection_mm(published(), holding))
    depth = float(remark.advice.split()[1])
    assert deflection_mm(TurningCut(PVC, 100.0, depth, 3.0, 85.7), holding) == pytest.approx(0.05, rel=0.01)


def test_a_material_without_cutting_force_is_refused_with_those_there_are():
    with pytest.raises(JobError, match="pvc"):
        material("plywood").turning_data()
