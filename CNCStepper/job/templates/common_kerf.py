# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kerf of a job's sheet cuts: parts that share cuts have their size only where it is that of their nest."""

from __future__ import annotations

from collections.abc import Mapping

from CNCStepper.cycles.sheet_cutting.sheet_cut import SheetCut
from CNCStepper.cycles.sheet_cutting.sheet_parameter_checks import measures_of
from CNCStepper.errors import JobError, Text
from CNCStepper.job.model import Job
from CNCStepper.tolerances import COMMON_LINE_MM


def kerfs_mm(job: Job) -> dict[int, float]:
    """Return the kerf of each operation that cuts sheets, by its number from 1; raises CycleError for a wrong one."""
    setups = [job.setup(operation) for operation in job.operation]
    return {
        number: measures_of(operation, setup).kerf_mm
        for number, (operation, setup) in enumerate(zip(job.operation, setups, strict=True), start=1)
        if isinstance(operation, SheetCut)
    }


def common_kerf_mm(job: Job) -> float:
    """Return the one kerf by which a job cuts; raises JobError where there is none, or cuts of another cycle."""
    found = kerfs_mm(job)
    widths_mm = sorted(set(found.values()))
    if len(found) < len(job.operation) or len(widths_mm) != 1 or not widths_mm[0] > 0.0:
        what = "common lines need one kerf: all of the template's operations have to cut sheets with it"
        told = ", ".join(f"{width:g} mm" for width in widths_mm) or Text("no sheet_cut")
        raise JobError("common-kerf", what, value=told, advice="take another template, or leave common lines out")
    return widths_mm[0]


def require_kerf(job: Job, nested_mm: Mapping[int, float]) -> None:
    """Raise JobError where a sheet whose parts share cuts, nested for a kerf, is cut with another one.

    nested_mm: the kerf of the nest, by the number from 1 of each operation that cuts such a sheet.
    """
    for number, kerf_mm in (kerfs_mm(job) if nested_mm else {}).items():
        if abs(kerf_mm - nested_mm.get(number, kerf_mm)) > COMMON_LINE_MM:
            raise JobError(
                "common-kerf",
                Text("operation {number} has another kerf than the nest whose parts share cuts", number=number),
                value=f"{kerf_mm:g} mm",
                limit=f"{nested_mm[number]:g} mm",
                advice=Text("nest again with kerf_mm = {kerf:g}, or correct the operation", kerf=kerf_mm),
            )
