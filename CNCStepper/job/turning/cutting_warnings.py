# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person should know of a lathe's cut before it is made: motor, chuck or bar too weak, and a preset speed."""

from __future__ import annotations

from CNCStepper.cycles.turning.turning_operation import TurningOperation
from CNCStepper.cycles.turning.turning_setup import TurningAnswer
from CNCStepper.errors import Text
from CNCStepper.job.turning.turning_job import TurningJob
from CNCStepper.machine.feeds_and_speeds import Remark
from CNCStepper.machine.materials import material
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.turning_forces import Holding, TurningCut, turning_remarks

ROUGHING = ("turn_bore", "turn_face", "turn_rough", "turn_taper")  # the cycles whose depth of cut is known
SHOWN_RPM = 0.5  # speeds are shown in whole numbers


def cutting_warnings(answer: TurningAnswer, job: TurningJob, machine: Machine) -> tuple[str, ...]:
    """Return where motor, chuck or bar are too weak for an operation; nothing where the job names no material.

    The bar is judged at its raw diameter, and bends for cuts along it from outside alone.
    """
    if not job.material or answer.cycle not in ROUGHING:
        return ()
    figures, is_along = answer.figures, answer.cycle in ("turn_rough", "turn_taper") and not answer.inside
    stickout_mm = job.stock.length_mm if is_along else 0.0
    sizes = (job.stock.diameter_mm, figures["ap_mm"], figures["feed_mm_rev"], figures["rpm"])
    cut = TurningCut(material(job.material).turning_data(), *sizes)
    holding = Holding(stickout_mm, job.tailstock is not None, job.chuck.grip_n)
    return tuple(map(_sentence, turning_remarks(cut, machine.spindle.power_w, holding)))


def preset_speed_warnings(
    operation: TurningOperation, rpm: float, job: TurningJob, machine: Machine
) -> tuple[str, ...]:
    """Return that the spindle turns at the nearest of its preset speeds, where another one is asked for."""
    wanted = operation.spindle_rpm or (
        0.0 if operation.constant_surface_speed else job.tools[operation.tool].spindle_rpm
    )
    if not machine.spindle.preset_rpm or not wanted or abs(wanted - rpm) <= SHOWN_RPM:
        return ()
    what = "the spindle turns at {rpm:.0f} rpm, the nearest of the machine's speeds to {wanted:.0f} rpm"
    return (Text(what, rpm=rpm, wanted=wanted),)


def _sentence(remark: Remark) -> str:
    what = "{what}: {value:.4g} {unit}, limit {limit:.4g} {unit}; {advice}"
    value, limit = remark.value or 0.0, remark.limit or 0.0
    return Text(what, what=Text(remark.text), value=value, limit=limit, unit=remark.unit, advice=remark.advice)
