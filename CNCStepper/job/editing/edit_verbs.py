# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editing verbs by name, for other processes; an edit that would break the program is refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError, ProgramError
from CNCStepper.gcode.conversion import foreign_programs
from CNCStepper.gcode.edit import compact, feed_scaling, renumber, reverse_passes, transform_verbs
from CNCStepper.job.editing.edit_check import EditCheck

if TYPE_CHECKING:
    from CNCStepper.gcode.edit.edit_result import Edited
    from CNCStepper.machine.profile import Machine
    from CNCStepper.state import Start

CONVERT = "convert"  # what another controller's program needs for this machine
VERBS: dict[str, Callable[..., Edited]] = {
    "offset": transform_verbs.offset,
    "scale": transform_verbs.scale,
    "rotate": transform_verbs.rotate,
    "mirror": transform_verbs.mirror,
    "units": transform_verbs.convert_units,
    "feeds": feed_scaling.scale_feeds,
    "renumber": renumber.renumber,
    "without_numbers": renumber.without_numbers,
    "reverse": reverse_passes.reverse,
    "compact": compact.compact,
    CONVERT: foreign_programs.converted,
}


def edited(
    text: str,
    verb: str,
    values: dict[str, Any],
    dialect: str = "grbl",
    start: Start | None = None,
    file: str = "",
    machine: Machine | None = None,
) -> Edited:
    """Return the result of a verb on a program; `values` by the names of its arguments.

    Raises ProgramError where it cannot be done, or where the new program would be refused and the old one is not.
    """
    if verb not in VERBS:
        raise CNCStepperError(
            "verb-unknown",
            "there is no such verb",
            value=verb,
            limit=", ".join(VERBS),
            advice="name one of these verbs",
        )
    if verb == CONVERT and machine is not None:
        values = {"tool_change": machine.tool_change, "tool_length": machine.tool_length} | values
    result = VERBS[verb](text, **values, dialect=dialect, start=start, file=file)
    if verb == CONVERT:  # of the old program, which could not be read, no errors are known to compare with
        return result
    errors = EditCheck(dialect, start, file, machine).new_errors(text, result.text)
    if errors:
        worst = errors[0]
        raise ProgramError(worst.code, worst.text, advice=worst.advice, place=worst.place)
    return result
