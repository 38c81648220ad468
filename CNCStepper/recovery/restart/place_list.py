# SPDX-License-Identifier: LGPL-2.1-or-later
"""The restart places of a program as plain data for a window."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice
from typing import Any

from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.state import Start

MOST_CONTOURS = 5000  # that are told: a longer list finds nothing any more, the picture does


def contours_as_data(lines: Sequence[str], dialect: str, start: Start | None, file: str) -> dict[str, Any]:
    """Return the operations and contours of a program as plain values, or why it cannot be restarted at all.

    operations: [number, line, name] each. contours: [number, line, operation, where it begins, length in mm] each.
    more: how many contours were left out.
    """
    from CNCStepper.recovery.restart.description import contour_table, operation_table
    from CNCStepper.recovery.restart.places import contours
    from CNCStepper.recovery.restart.program import read_program

    try:
        program = read_program("\n".join(lines) + "\n", dialect, start, file)
    except CNCStepperError as error:
        return {"contours": [], "operations": [], "more": 0, "error_of_contours": error_to_json(error)}
    return {
        "contours": list(islice(contour_table(program), MOST_CONTOURS)),
        "operations": list(operation_table(program)),
        "more": max(0, len(contours(program)) - MOST_CONTOURS),
    }
