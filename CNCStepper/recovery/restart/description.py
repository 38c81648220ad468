# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a restart does, and where a program may be restarted, in words for people.

The restart places of a program as plain data for a window.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from math import isnan
from typing import Any

import numpy as np

from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.recovery.restart.interrupted_program import Program
from CNCStepper.recovery.restart.restart_places import contours
from CNCStepper.recovery.restart.restart_program import Restart
from CNCStepper.state import Start

SENSES = {"cw": "turning clockwise (M3)", "ccw": "turning counter-clockwise (M4)"}


def words_of(restart: Restart) -> Iterator[str]:
    """Yield the steps of a restart: entrance, height, outputs that are on, and the reason for the entrance."""
    program, entrance, approach = restart.program, restart.entrance, restart.approach
    row, line = entrance.row, program.file_line(entrance.row)
    place = program.tips(np.array([approach.at_mm]), np.array([row]))[0]
    yield Text("enters line {line} at {place}", line=line, place=_point(place))
    if entrance.share:
        yield Text("with {share:.0%} of its move done", share=entrance.share)
    yield from (
        Text("in the operation {span}", span=span.name) for span in program.operations if span.first <= row < span.last
    )
    yield from (Text("enters there because {note}", note=note) for note in entrance.notes)
    if entrance.overlap_mm:
        yield Text("cuts {overlap_mm:.3g} mm before the place again", overlap_mm=entrance.overlap_mm)
    state = approach.state
    if state.tool:
        yield Text("with tool {tool} in the spindle", tool=state.tool)
    if not isnan(approach.safe_mm):
        yield (
            Text(
                "goes to Z {height_mm:.3f} first, straight up (it is not sent while the tool stands "
                "higher), then over the place",
                height_mm=height_mm(restart),
            )
        )
    yield from _switched_on(restart)
    if approach.plunge_mm_min:
        yield Text("goes down at {plunge_mm_min:g} mm/min", plunge_mm_min=approach.plunge_mm_min)
    if any(state.g92_mm):
        yield Text("sets G92 as it was: {array}", array=_point(np.array(state.g92_mm)))
    own = int((restart.file_lines > 0).sum())
    yield Text("then runs {own} lines of the program unchanged; everything before them counts as cut", own=own)


def height_mm(restart: Restart) -> float:
    """Return the Z of the work to which a restart goes first; NaN for a table without Z."""
    approach = restart.approach
    return float(approach.safe_mm - restart.program.frame_mm[2] - approach.state.tool_length_mm)


def _switched_on(restart: Restart) -> Iterator[str]:
    """Yield the outputs that are switched on, and the waits for them."""
    state, approach = restart.approach.state, restart.approach
    if not state.spindle_turns:
        yield "leaves the spindle off, as the program has it there"
    elif approach.is_beam:
        yield Text("switches the beam on at S{spindle_rpm:g} once it is down", spindle_rpm=state.spindle_rpm)
    else:
        yield Text(
            "starts the spindle at {spindle_rpm:g} rpm, {sense}",
            spindle_rpm=state.spindle_rpm,
            sense=SENSES[state.spindle],
        )
    if state.mist or state.flood:
        yield "switches the coolant on"
    if approach.dwell_s:
        yield Text("waits for {dwell_s:g} s", dwell_s=approach.dwell_s)


def proven_against(has_stock: bool, has_shapes: bool) -> str:
    """Return what was simulated of a restart, and what was not."""
    if has_shapes:
        return "cut on the stock that the moves before it have left, and judged against the shapes of the job"
    if has_stock:
        return (
            "simulated on the stock that the earlier moves have left; the wanted shape is unknown and was not compared"
        )
    return (
        "NOT simulated on a stock: the machine's limits are checked, but not whether a rapid meets material; give "
        "--job, or --stock and --tool"
    )


def operation_table(program: Program) -> Iterator[tuple[int, int, str]]:
    """Yield (number, line, name) of each operation of a program; the line is that of its first move."""
    last = len(program.table) - 1
    for number, span in enumerate(program.operations, start=1):
        yield number, program.file_line(min(span.first, last)), span.name


def contour_table(program: Program) -> Iterator[tuple[int, int, str, str, float]]:
    """Yield (number, line, operation, where it begins, length in mm) of each contour of a program."""
    for number, stretch in enumerate(contours(program), start=1):
        rows = np.array([stretch.first])
        place = program.tips(program.begins[rows], rows)[0]
        names = (span.name for span in program.operations if span.first <= stretch.first < span.last)
        length_mm = float(np.nansum(program.ways.length_mm[stretch.first : stretch.last]))
        yield number, program.file_line(stretch.first), next(names, ""), _point(place), length_mm


def _point(point: np.ndarray) -> str:
    known = zip("XYZ", point.tolist(), strict=True)
    return " ".join(f"{axis}{value + 0.0:.3f}" for axis, value in known if not isnan(value))


MOST_CONTOURS = 5000  # that are listed; the picture shows them all


def contours_as_data(lines: Sequence[str], dialect: str, start: Start | None, file: str) -> dict[str, Any]:
    """Return the operations and contours of a program as plain values, or why it cannot be restarted at all.

    operations: [number, line, name] each. contours: [number, line, operation, where it begins, length in mm] each.
    more: how many contours were left out.
    """
    from CNCStepper.recovery.restart.interrupted_program import read_program
    from CNCStepper.recovery.restart.restart_places import contours

    try:
        program = read_program("\n".join(lines) + "\n", dialect, start, file)
    except CNCStepperError as error:
        return {"contours": [], "operations": [], "more": 0, "error_of_contours": error_to_json(error)}
    return {
        "contours": list(islice(contour_table(program), MOST_CONTOURS)),
        "operations": list(operation_table(program)),
        "more": max(0, len(contours(program)) - MOST_CONTOURS),
    }
