# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editing verbs by name, for who asks from another process; what an edit would spoil is refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError, ProgramError
from CNCStepper.gcode import foreign
from CNCStepper.gcode.edit import compact, feeds, geometry, renumber, reverse
from CNCStepper.job.check_edit import EditCheck

if TYPE_CHECKING:
    from CNCStepper.gcode.edit.edited import Edited
    from CNCStepper.machine.profile import Machine
    from CNCStepper.state import Start

CONVERT = "convert"  # what another controller's program needs for this machine
VERBS: dict[str, Callable[..., Edited]] = {
    "offset": geometry.offset,
    "scale": geometry.scale,
    "rotate": geometry.rotate,
    "mirror": geometry.mirror,
    "units": geometry.convert_units,
    "feeds": feeds.scale_feeds,
    "renumber": renumber.renumber,
    "without_numbers": renumber.without_numbers,
    "reverse": reverse.reverse,
    "compact": compact.compact,
    CONVERT: foreign.converted,
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
    """Return what a verb makes of a program; `values` by the names of its arguments.

    Raises ProgramError where it cannot be done, or where the new program would be refused and the old one is not.
    """
    if verb not in VERBS:
        raise CNCStepperError("verb-unknown", "there is no such verb", value=verb, limit=", ".join(VERBS))
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
