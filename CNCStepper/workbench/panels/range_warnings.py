# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values that go far beyond a job's stock or machine, as sentences beside the fields: slips of a unit or a point."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.workbench.document.input_limits import limits_passed
from CNCStepper.workbench.features.base import JOB, proxy_type
from CNCStepper.workbench.features.operation import LINKS
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.services.translation import later

SENTENCES = {
    "depth": later("goes far beyond the stock; at most {0}"),
    "travel": later("goes beyond what the machine can travel; at most {0}"),
    "width": later("goes far beyond the stock and the machine; at most {0}"),
    "feed": later("goes far beyond the machine's fastest axis; at most {0}"),
}


def beyond(obj: Any, changes: dict[str, Any], shown: Callable[[str, float], str]) -> dict[str, Refused]:
    """Return what of some changed values goes beyond stock or machine of the object's job, by key.

    shown: gives a limit as the user reads it, from a key and a number in the unit of that key.
    """
    job = obj if proxy_type(obj) == JOB else next((other for other in obj.InList if proxy_type(other) == JOB), None)
    if job is None or not changes:
        return {}
    passed = limits_passed(job, {key: value for key, value in changes.items() if key not in LINKS})
    return {key: Refused(SENTENCES[limit.reason], shown(key, limit.most)) for key, limit in passed.items()}
