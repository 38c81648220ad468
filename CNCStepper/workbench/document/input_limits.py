# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values that go far beyond a job's stock or machine: slips of a unit or a point, refused before anything is computed.

A panel says them beside its fields (`workbench/panels/field_errors.py`); whoever sets a property otherwise finds
them in the object's
problem.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError, JobError, Text
from CNCStepper.job.deferred_fitting import once

if TYPE_CHECKING:
    from CNCStepper.job.input_limits import Limit, Reach

UNITS = {"_mm": "mm", "_mm_min": "mm/min"}


def limits_passed(job: Any, found: dict[str, Any], most: dict[str, float] | None = None) -> dict[str, Limit]:
    """Return the limits that values by key go beyond on the stock and machine of a job object, by key.

    most: the largest of the values of each kind, where they are at hand.
    """
    try:
        reach = once("reach", job, lambda: _reach(job))
    except CNCStepperError:  # what is wrong with the machine is said at the job
        return {}
    if most is not None and reach.holds(most):
        return {}
    refused = {key: reach.refusal(key, value) for key, value in found.items()}
    return {key: limit for key, limit in refused.items() if limit is not None}


def _reach(job: Any) -> Reach:
    from CNCStepper.job.input_limits import reach_of
    from CNCStepper.workbench.document.machine_of_job import machine_of
    from CNCStepper.workbench.document.stock_of_job import size_mm

    return reach_of(size_mm(job), machine_of(job))


def require_within_reach(job: Any, found: dict[str, Any], most: dict[str, float] | None = None) -> None:
    """Raise JobError for the first of some values by key that goes beyond stock or machine; None: there is no job.

    most: the largest of the values of each kind, where they are at hand.
    """
    for key, limit in limits_passed(job, found, most).items() if job is not None else ():
        unit = next((unit for end, unit in UNITS.items() if key.endswith(end)), "")
        raise JobError(
            "beyond-reach",
            _what(key, limit.reason),
            value=f"{found[key]} {unit}".strip(),
            limit=f"{limit.most:g} {unit}".strip(),
            advice="correct the value or its unit",
        )


def _what(key: str, reason: str) -> str:
    return {
        "depth": Text("{key} goes far beyond the stock", key=key),
        "travel": Text("{key} goes beyond what the machine can travel", key=key),
        "width": Text("{key} goes far beyond the stock and the machine", key=key),
        "feed": Text("{key} goes far beyond the machine's fastest axis", key=key),
    }[reason]
