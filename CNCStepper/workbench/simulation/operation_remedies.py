# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of an operation or of the job that surely mend a finding; none where a person has to decide.

flute-length   the depth per pass, as long as the flutes are
below-stock    the depth of the stock
beside-stock   the stock round the drawings
not-exact      tabs for a contour that sets a piece free
piece-loose    the contour that sets the piece free, cut last
coolant        the coolant that the machine has
clamp          a clearance above the clamps, where only ways across the work meet them
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.workbench.document.default_values import MARGIN_MM
from CNCStepper.workbench.document.input_limits import limits_passed
from CNCStepper.workbench.features.base import entry_of
from CNCStepper.workbench.features.cycle_operation import drawings_of
from CNCStepper.workbench.panels.remedies import fitting_stock
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.simulation.proven_job import Change, ProvenJob, change_of, has, value

if TYPE_CHECKING:
    from CNCStepper.simulation.checks.clamps import Clamp
    from CNCStepper.simulation.finding import Finding

ROUNDED_MM = 0.01  # between a value and what a finding says of it
FREE_PIECE = "the contour goes through the stock and sets a piece free that no tab holds"
ROOM_OF_TAB = 1.5  # of what it takes along the contour, so that entries and corners find a place too
CLEARANCE_STEP_MM = 1.0


def flute_length(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the length of the flutes as depth per pass of the one operation that cuts deeper at once."""
    limit_mm = finding.limit or 0.0
    tools = [tool for tool in proven.tools if abs(tool.FluteLength.Value - limit_mm) < ROUNDED_MM]
    cut = proven.operations_of(tools[0]) if len(tools) == 1 else []
    if not cut or not all(has(each, "stepdown_mm") and _finish_mm(each) <= limit_mm for each in cut):
        return None
    deep = [each for each in cut if min(value(each, "stepdown_mm"), value(each, "depth_mm")) > limit_mm]
    return change_of(deep[0], "stepdown_mm", limit_mm) if len(deep) == 1 else None


def _finish_mm(operation: Any) -> float:
    return float(value(operation, "finish_stepdown_mm")) if has(operation, "finish_stepdown_mm") else 0.0


def below_stock(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the depth of the stock for the one operation that goes below it, as deep as the finding says."""
    thick_mm = float(proven.job.StockSize[2])
    deep = [each for each in proven.operations if _bottom_mm(each) > thick_mm]
    if len(deep) != 1 or abs(_bottom_mm(deep[0]) + (finding.value or 0.0)) > ROUNDED_MM:
        return None
    through_mm = _bottom_mm(deep[0]) - value(deep[0], "depth_mm")
    depth_mm = round(thick_mm - through_mm, 3)
    return change_of(deep[0], "depth_mm", depth_mm) if depth_mm > 0.0 else None


def _bottom_mm(operation: Any) -> float:
    """Return how deep an operation goes, as far as its values say it."""
    depth_mm = value(operation, "depth_mm") if has(operation, "depth_mm") else 0.0
    return float(depth_mm + (value(operation, "through_mm") if has(operation, "through_mm") else 0.0))


def beside_stock(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the stock round the drawings, where every operation follows one and the margin holds every tool."""
    follows = all(has(each, "drawings") and drawings_of(each) for each in proven.operations)
    if not follows or any(tool.Diameter.Value > MARGIN_MM for tool in proven.tools):
        return None
    return Change(proven.job, fitting_stock(proven.job), tr("Fit the stock to the drawings"))


def tabs(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return tabs for the contour of which the finding says that nothing holds its piece."""
    found = [each for each in proven.result.findings if each.text == FREE_PIECE]
    free = [each for each in proven.operations if FREE_PIECE in each.Proxy.warnings]
    if finding.text != FREE_PIECE or len(found) != len(free):
        return None
    contour = free[[each is finding for each in found].index(True)]
    count = int(value(contour, "tabs_count")) or entry_of(contour.Proxy, "tabs_count").default
    if not _has_room(proven, contour, count):
        return None
    text = tr("{0}, {1}: {2}").format(contour.Label, tr(entry_of(contour.Proxy, "tabs_by").label), count)
    return Change(contour, {"tabs_by": "count", "tabs_count": count}, text)


def _has_room(proven: ProvenJob, contour: Any, count: int) -> bool:
    """Return whether tabs fit on each closed line of a contour, and are lower than it is deep."""
    cycle = proven.model.operation[proven.operations.index(contour)]
    tool_mm = contour.Tool.Diameter.Value
    needed_mm = ROOM_OF_TAB * count * (value(contour, "tabs_width_mm") + 1.5 * tool_mm) + math.pi * tool_mm
    is_long = all(curve.length_mm > needed_mm for curve in cycle.curves if curve.closed)  # type: ignore[attr-defined]
    return bool(is_long and value(contour, "tabs_height_mm") < value(contour, "depth_mm"))


def piece_loose(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the order in which the contour that sets a piece free is cut behind all others."""
    from CNCStepper.job.findings import safely_last

    number = safely_last(proven.model)
    if number is None:
        return None
    last = proven.operations[number - 1]
    order = [each for each in proven.job.Operations if each is not last]
    return Change(proven.job, {"operations": [*order, last]}, tr("Cut {0} last").format(last.Label))


def coolant(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the one coolant that the machine has, or none."""
    present = proven.machine.outputs.coolant
    return change_of(proven.job, "coolant", present[0] if len(present) == 1 else "none")


def clamp(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return a clearance above all clamps, where nothing but ways at the present clearance meets one."""
    clearance_mm, clamps = float(proven.job.Clearance), proven.model.clamps
    tools = [(tool.Diameter.Value, tool.HolderDiameter.Value) for tool in proven.tools]
    reach_mm = max(max(pair) for pair in tools) / 2 + ROUNDED_MM
    top_mm = max(each.top_mm for each in clamps)
    if top_mm < clearance_mm or not all(_met_in_transit(proven, each, reach_mm, clearance_mm) for each in clamps):
        return None
    new_mm = math.ceil((top_mm + float(proven.job.Retract)) / CLEARANCE_STEP_MM) * CLEARANCE_STEP_MM
    if limits_passed(proven.job, {"clearance_mm": new_mm}):
        return None
    return change_of(proven.job, "clearance_mm", new_mm)


def _met_in_transit(proven: ProvenJob, clamp: Clamp, reach_mm: float, clearance_mm: float) -> bool:
    """Return whether all moves near a clamp are ways at the clearance."""
    import shapely

    moves = proven.result.moves
    known = np.isfinite(moves.begin).all(axis=1) & np.isfinite(moves.end).all(axis=1)
    low_mm = np.minimum(moves.begin[:, 2], moves.end[:, 2])
    below = known & (low_mm < clearance_mm - ROUNDED_MM)
    ways = shapely.linestrings(np.stack([moves.begin[below, :2], moves.end[below, :2]], axis=1))
    bows_mm = np.hypot(*(moves.begin - moves.centre)[below, :2].T)
    reaches_mm = reach_mm + np.where(moves.kind[below] > 1, 2 * np.nan_to_num(bows_mm), 0.0)
    return bool((shapely.distance(ways, clamp.outline) > reaches_mm).all())
