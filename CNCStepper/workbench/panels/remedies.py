# SPDX-License-Identifier: LGPL-2.1-or-later
"""What mends a refusal or warning of an operation at one click: a button below the sentence.

tool of a wrong shape ──► the job's last that suits, or a new one
wider than the tool   ──► a share of the tool
deeper than the stock ──► the depth of the stock
beside the stock      ──► the stock round the drawings
feeds out of range    ──► those of the job's material
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.tools.tool_shapes import SUITED
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.drawings.shapes import box_round, placed_shape
from CNCStepper.workbench.features.base import JOB, edit, entry_of, value_of
from CNCStepper.workbench.features.cycle_operation import jobs_of, linked_drawings
from CNCStepper.workbench.panels.tools.tool_words import tool_words
from CNCStepper.workbench.panels.unit_values import text_of
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.remedy_bar import Remedy
from CNCStepper.workbench.services.translation import tr

Limits = Sequence[tuple[str, float | None]]
Take = Callable[[dict[str, Any]], None]  # writes values of the operation, by key


def of_refusal(obj: Any, error: CNCStepperError, take: Take) -> list[Remedy]:
    """Return what mends a refused operation; nothing where a person has to decide."""
    if obj.Proxy.JOB_TYPE != JOB or not jobs_of(obj):
        return []
    if error.code == "tool-shape" and obj.Proxy.CYCLE in SUITED:
        return [_suited_tool(obj, jobs_of(obj)[0], take)]
    if error.code == "stepover-wide" and hasattr(obj, "Stepover") and obj.Tool is not None:
        width_mm = round(default_values.SHARE_OF_TOOL * float(obj.Tool.Diameter), 3)
        return [_value(obj, "stepover_mm", width_mm, take)]
    return []


def of_stock(obj: Any, limits: Limits, take: Take, fitted: Callable[[], None]) -> list[Remedy]:
    """Return what mends that an operation goes beyond the stock.

    limits: the codes of the findings, each with its limit in mm. fitted: is called when the stock was changed.
    """
    found = []
    for code, limit_mm in limits:
        depth_mm = round((limit_mm or 0.0) - float(getattr(obj, "Through", 0.0)), 3)
        if code == "below-stock" and depth_mm > 0.0:
            found.append(_value(obj, "depth_mm", depth_mm, take))
        if code == "beside-stock" and linked_drawings(obj):
            text = tr("Fit the stock to the drawings")
            found.append(Remedy("stock", text, partial(_fit_stock, jobs_of(obj)[0], fitted)))
    return found


def of_feeds(obj: Any, remade: Callable[[], None]) -> list[Remedy]:
    """Return what mends feeds that the job's material does not bear; remade: is called when they were changed."""
    from CNCStepper.workbench.document.machine_of_job import remarks
    from CNCStepper.workbench.features.tool import model_of

    jobs = jobs_of(obj) if getattr(obj.Proxy, "CYCLE", "") and obj.Proxy.JOB_TYPE == JOB else []
    if not jobs or obj.Tool is None or obj.Tool.FromChart:
        return []
    own = {key: 0.0 for key in default_values.FEEDS if value_of(obj.Tool, entry_of(obj.Tool.Proxy, key))}
    try:
        if not own or not remarks(model_of(obj.Tool), jobs[0]):
            return []
    except CNCStepperError:  # the panel says it beside its field
        return []

    def take_those_of_material() -> None:
        edit(obj.Tool, **own)
        remade()

    return [Remedy("feeds", tr("Take the feeds of the material"), take_those_of_material)]


def _suited_tool(obj: Any, job: Any, take: Take) -> Remedy:
    shapes = SUITED[obj.Proxy.CYCLE]
    present = [tool for tool in job.Tools if tool.ToolShape in shapes]
    if present:
        return Remedy("tool", tr("Take {0}").format(tool_words(present[-1])), partial(take, {"tool": present[-1]}))

    def add() -> None:
        from CNCStepper.workbench import api

        take({"tool": api.add_tool(job, shape=shapes[0], **default_values.tool(job))})

    return Remedy("tool", tr("Add a tool: {0}").format(words_of(shapes[0])), add)


def _value(obj: Any, key: str, value: float, take: Take) -> Remedy:
    entry = entry_of(obj.Proxy, key)
    text = tr("{0}: {1}").format(tr(entry.label), text_of(value, entry))
    return Remedy(key, text, partial(take, {key: value}))


def _fit_stock(job: Any, fitted: Callable[[], None]) -> None:
    edit(job, **fitting_stock(job))
    fitted()


def fitting_stock(job: Any) -> dict[str, Any]:
    """Return the values of a job with which its stock lies round the drawings of all of its operations."""
    drawn = [placed_shape(drawing) for operation in job.Operations for drawing in linked_drawings(operation)]
    return default_values.stock_around(box_round([shape for shape in drawn if not shape.isNull()]), job)
