# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of an operation does not fit into the stock, as sentences for its panel, before anything is computed."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.features.operation import jobs_of


def stock_warnings(obj: Any) -> list[str]:
    """Return the sentences for an operation with the values that it has now, the worst first.

    None for what is no operation, belongs to no job, or is refused for another reason, which its panel says.
    """
    jobs = jobs_of(obj) if getattr(obj.Proxy, "CYCLE", "") else []
    if not jobs:
        return []
    from CNCStepper.job.stock_fit import stock_findings
    from CNCStepper.workbench.document.stock_of_job import stock_of
    from CNCStepper.workbench.services.findings_list import sentence

    try:
        cycle = obj.Proxy.cycle(obj, tuple(jobs[0].WorkOrigin))
        return [sentence(finding) for finding in stock_findings(cycle, stock_of(jobs[0]))]
    except CNCStepperError:  # the panel says it beside its field
        return []
