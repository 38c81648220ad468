# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of a tool's feed or speed that surely mend a finding; none where a second value has a part in it.

spindle-speed     the limit of the spindle
feed-above-rate   the one feed that is too fast, at the rate of the axis
chip-load         the feed at which a tooth takes the tool's limit
feeds             the speed or the feed at the end of the material's range, else all values of the material
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.tolerances import SAME_SHARE
from CNCStepper.toolpath import LINE, RAPID, XY
from CNCStepper.workbench.document.default_values import FEEDS
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.simulation.proven_job import Change, ProvenJob, change_of, value

if TYPE_CHECKING:
    from CNCStepper.machine.feeds_and_speeds import Remark
    from CNCStepper.simulation.finding import Finding
    from CNCStepper.simulation.tip_track import TipTrack

ROUNDED_RPM = 0.5  # between the speed of a tool and the S of its program
SPEED_STEP_RPM = 10.0


def spindle_speed(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the speed that the machine can turn, for the one tool that turns as the finding says."""
    turning = [tool for tool in proven.tools if abs(tool.SpindleUsed - _number(finding.value)) <= ROUNDED_RPM]
    if len(turning) != 1 or not turning[0].SpindleSpeed:
        return None
    return change_of(turning[0], "spindle_rpm", _number(finding.limit))


def feed_above_rate(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the rate of the axis for the only feed that is above it."""
    limit = _number(finding.limit)
    faster = [each for each in _feeds(proven) if each[2] > limit * (1 + SAME_SHARE)]
    if len(faster) > 1:
        faster = _vertical(proven, faster, finding)
    if len(faster) != 1 or not value(*faster[0][:2]):
        return None
    obj, key, _ = faster[0]
    return change_of(obj, key, float(math.floor(limit)))


def _feeds(proven: ProvenJob) -> Iterator[tuple[Any, str, float]]:
    """Yield each feed of the program: the object and key that give it, and how fast it is, mm/min."""
    for tool in proven.tools:
        yield tool, "feed_mm_min", value(tool, "used_feed_mm_min")
        yield tool, "plunge_mm_min", value(tool, "used_plunge_mm_min")
    for operation in proven.operations:
        for entry in operation.Proxy.PROPERTIES:
            if entry.key.endswith("feed_mm_min") and not entry.output:
                yield operation, entry.key, value(operation, entry.key)


def _vertical(
    proven: ProvenJob, faster: list[tuple[Any, str, float]], finding: Finding
) -> list[tuple[Any, str, float]]:
    """Return the plunge feed that the finding means, where no other feed can be too fast for Z on a slope."""
    speed, limit = _number(finding.value), _number(finding.limit)
    same = [each for each in faster if math.isclose(each[2], speed, rel_tol=SAME_SHARE)]
    plunges = [each for each in same if each[1] == "plunge_mm_min"]
    others = [feed for obj, key, feed in faster if (obj, key, feed) not in plunges]
    steep = steepest(proven.result.moves)
    are_flat = all(feed > speed * (1 + SAME_SHARE) and feed * steep <= limit for feed in others)
    return plunges if are_flat else []


def steepest(moves: TipTrack) -> float:
    """Return the largest share of Z in a feed that goes sideways too, 1 where that is not known."""
    cuts = moves.kind != RAPID
    arcs = cuts & (moves.kind != LINE)
    way = (moves.end - moves.begin)[cuts]
    if not np.isfinite(way).all() or (moves.plane[arcs] != XY).any():
        return 1.0
    flat = np.hypot(way[:, 0], way[:, 1])
    round_mm = 2 * np.pi * np.hypot(*(moves.begin - moves.centre)[cuts][:, :2].T)
    flat = np.where((flat < SAME_SHARE) & arcs[cuts], round_mm, flat)
    sideways = flat >= SAME_SHARE
    return float((np.abs(way[sideways, 2]) / np.hypot(flat, way[:, 2])[sideways]).max(initial=0.0))


def chip_load(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the feed at which a tooth takes the tool's limit, whatever its engagement."""
    is_thick, limit_mm = _number(finding.value) > _number(finding.limit), _number(finding.limit)
    name = "ChipLoadMax" if is_thick else "ChipLoadMin"
    tools = [tool for tool in proven.tools if math.isclose(getattr(tool, name).Value, limit_mm, rel_tol=1e-3)]
    if len(tools) != 1:
        return None
    tool = tools[0]
    teeth = float(tool.SpindleUsed) * tool.Flutes
    exact = limit_mm * teeth
    feed = float(math.floor(exact + SAME_SHARE) if is_thick else math.ceil(exact - SAME_SHARE))
    fits = _slow_enough if is_thick else _fast_enough
    if not (tool.Feed and feed > 0 and fits(proven, tool, feed) and _chips_fit(tool, feed / teeth)):
        return None
    return change_of(tool, "feed_mm_min", feed) if _adds_no_remark(proven, tool, {"feed_mm_min": feed}) else None


def _chips_fit(tool: Any, chip_mm: float) -> bool:
    least, most = tool.ChipLoadMin.Value, tool.ChipLoadMax.Value or math.inf
    return bool(least * (1 - 1e-3) <= chip_mm <= most * (1 + 1e-3))


def _slow_enough(proven: ProvenJob, tool: Any, feed: float) -> bool:
    """Return whether no other feed of the tool is above the one that is wanted."""
    others = [value(tool, "used_plunge_mm_min"), *_feeds_of_operations(proven, tool)]
    return bool(feed < value(tool, "used_feed_mm_min") and max(others) <= feed)


def _fast_enough(proven: ProvenJob, tool: Any, feed: float) -> bool:
    """Return whether the tool's feed alone is too slow, and the machine has the one that is wanted."""
    used, plunge = value(tool, "used_feed_mm_min"), value(tool, "used_plunge_mm_min")
    own = _feeds_of_operations(proven, tool)
    rate = min(axis.max_rate_mm_min for axis in proven.machine.axes[:2])
    return bool(used < feed <= rate and (plunge < used or plunge >= feed) and min(own, default=feed) >= feed)


def _feeds_of_operations(proven: ProvenJob, tool: Any) -> list[float]:
    mine = proven.operations_of(tool)
    return [feed for obj, _, feed in _feeds(proven) if feed and any(obj is one for one in mine)]


def feeds(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return the speed or feed at the end of the material's range, else to take all from the material."""
    for tool in proven.tools:
        before = _remarks(proven, tool, {})
        if any(remark.text == finding.text for remark in before):
            left = {remark.text for remark in before if remark.text != finding.text}
            return _of_range(proven, tool, finding, left) or _of_material(proven, tool)
    return None


def _of_range(proven: ProvenJob, tool: Any, finding: Finding, left: set[str]) -> Change | None:
    share = _number(finding.limit) / _number(finding.value) if finding.value else 0.0
    if finding.unit == "m/min":
        key, step = "spindle_rpm", SPEED_STEP_RPM
    else:
        key, step = "feed_mm_min", 1.0
    whole = math.floor if share < 1.0 else math.ceil
    new = float(whole(value(tool, f"used_{key}") * share / step)) * step
    if not (value(tool, key) and _can(proven, key, new)):
        return None
    after = {remark.text for remark in _remarks(proven, tool, {key: new})}
    return change_of(tool, key, new) if after <= left else None


def _can(proven: ProvenJob, key: str, new: float) -> bool:
    """Return whether the machine has a speed, or a feed in X and Y."""
    if key == "spindle_rpm":
        return proven.machine.spindle.min_rpm <= new <= proven.machine.spindle.max_rpm
    return 0 < new <= min(axis.max_rate_mm_min for axis in proven.machine.axes[:2])


def _of_material(proven: ProvenJob, tool: Any) -> Change | None:
    own = {key: 0.0 for key in FEEDS if value(tool, key)}
    if not own or _remarks(proven, tool, own):
        return None
    return Change(tool, own, tr("{0}: take the feeds of the material").format(tool.Label))


def _adds_no_remark(proven: ProvenJob, tool: Any, changes: dict[str, float]) -> bool:
    before = {remark.text for remark in _remarks(proven, tool, {})}
    return {remark.text for remark in _remarks(proven, tool, changes)} <= before


def _remarks(proven: ProvenJob, tool: Any, changes: dict[str, float]) -> list[Remark]:
    """Return the warnings about a tool with changed values in the job's material; none without a material."""
    from CNCStepper.machine.feeds_and_speeds import remarks_on
    from CNCStepper.machine.materials import material
    from CNCStepper.workbench.document.cut_chart_of_job import fed
    from CNCStepper.workbench.features.tool import model_of

    if not proven.job.Material:
        return []
    model = fed(model_of(tool).model_copy(update=changes), proven.job)
    found = remarks_on(model, material(proven.job.Material), proven.machine)
    return [remark for remark in found if remark.severity == "warning"]


def _number(number: float | None) -> float:
    return math.nan if number is None else number
