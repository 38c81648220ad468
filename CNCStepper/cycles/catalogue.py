# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cycles by the names that job files use."""

from __future__ import annotations

from CNCStepper.cycles.elliptical_pocket import EllipticalPocket
from CNCStepper.cycles.engrave import Engrave
from CNCStepper.errors import JobError

CYCLES: dict[str, type[EllipticalPocket] | type[Engrave]] = {"elliptical_pocket": EllipticalPocket, "engrave": Engrave}


def cycle_class(name: str) -> type[EllipticalPocket] | type[Engrave]:
    """Return the parameter model of a cycle; raises JobError for a name that is none."""
    if name not in CYCLES:
        raise JobError(
            "cycle-unknown", f"there is no cycle '{name}'", advice=f"use one of: {', '.join(sorted(CYCLES))}"
        )
    return CYCLES[name]
