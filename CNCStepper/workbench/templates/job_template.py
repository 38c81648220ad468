# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job templates: a job saved under a name, and the beginning of a new job by a template; no Qt.

job ──► content_of ──► the shop's template folder ──► Beginning.take ──► values and tools of a new job

A job template is a template of the shop whose only rule leaves all contours out; those with rules begin jobs too.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.job.templates.begun_job import begun_job
from CNCStepper.job.templates.drawing_job import offset_mm, size_round
from CNCStepper.job.templates.template import StockRule, read_template
from CNCStepper.job.templates.template_files import template_paths, with_whole_paths, write_template
from CNCStepper.machine.files.profile_files import SUFFIX
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.processes import is_turning
from CNCStepper.tolerances import TOUCHING_MM
from CNCStepper.workbench import api, packages
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.document.default_values import FEEDS, untyped_feeds
from CNCStepper.workbench.document.job_files import JOB_KEYS, add_tool_of_file, job_values
from CNCStepper.workbench.document.stock_of_job import CYLINDER, size_mm
from CNCStepper.workbench.document.template_jobs import job_keys
from CNCStepper.workbench.drawings.shapes import box_of, box_of_boxes
from CNCStepper.workbench.features.base import edit, entry_of, is_job, values
from CNCStepper.workbench.features.cycle_operation import linked_drawings
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.templates.around import Around
from CNCStepper.workbench.templates.draft import Content, first_rules

KEYS = (  # of a job, that a template gives
    "machine", "chart", *JOB_KEYS, "stock_size_mm", "stock_form", "stock_origin", "edge_mm", "work_origin_mm"
)  # fmt: skip


def content_of(job: Any) -> Content:
    """Return a job as the content of a template; raises CNCStepperError for a job that is wrong.

    Stock that reaches as far beyond the drawings on each side is kept as that margin, any other by its size.
    """
    keys = job_keys(job)
    length, width, _ = size_mm(job)
    margin = _margin_mm(job)
    size = {"size_mm": [length, width]} if margin is None else {"margin_mm": margin}
    content = keys | {"stock": keys["stock"] | size, "rule": first_rules(())}
    return with_whole_paths(content, Path(job.Document.FileName).parent) if job.Document.FileName else content


def save(job: Any, path: Path) -> None:
    """Write a job as a template into a file; raises CNCStepperError for a job that is wrong, or where it cannot."""
    write_template(content_of(job), path)


def _margin_mm(job: Any) -> float | None:
    """Return how far the stock reaches beyond the drawings of a job on each side, None where the sides differ."""
    drawings = [drawing for operation in job.Operations for drawing in linked_drawings(operation)]
    boxes = [box for drawing in drawings if (box := box_of(drawing)).isValid()]
    if not boxes or job.StockForm == CYLINDER:
        return None
    box, (length, width, _), (x, y, _) = box_of_boxes(boxes), size_mm(job), job.WorkOrigin
    left, front = (x - length / 2, y - width / 2) if job.StockOrigin == "top-centre" else (x, y)
    sides = (box.XMin - left, box.YMin - front, left + length - box.XMax, front + width - box.YMax)
    if min(sides) < 0 or max(sides) - min(sides) > TOUCHING_MM:
        return None
    return float(round(sides[0], 3))


def choices() -> list[tuple[str, str]]:
    """Return the templates that a job of milling or sheet cutting can begin with, the shop's first: paths and words.

    Those of a lathe are left out. One that cannot be read is there, and says why when it is chosen.
    """
    examples = sorted((packages.ROOT / "examples" / "templates").glob(f"*{SUFFIX}"))
    shop = [(str(path), path.stem) for path in template_paths() if not _is_of_lathe(path)]
    return [*shop, *((str(path), tr("{0} (example)").format(path.stem)) for path in examples)]


def _is_of_lathe(path: Path) -> bool:
    try:
        return is_turning(read_toml(path))
    except CNCStepperError:
        return False


class Beginning:
    """What a new job has begun with, so that another beginning takes its place; what a person has changed stays."""

    def __init__(self, job: Any, around: Around):
        self._job, self._around = job, around
        self._usual = _values_of(job)
        self._given = dict(self._usual)  # what no person has typed
        self._tools = {each.Name: values(each) for each in job.Tools}

    def take(self, path: str) -> None:
        """Begin with a template's file, or with what is preferred (""); raises CNCStepperError and changes nothing."""
        model, wanted = self._of_template(Path(path)) if path else (None, self._usual)
        present = _values_of(self._job)
        typed = {key for key in present if present[key] != self._given[key]}
        self._edit({key: value for key, value in wanted.items() if key not in typed})
        now = _values_of(self._job)
        self._given |= {key: now[key] for key in now if key not in typed}
        self._take_tools(model)

    def _of_template(self, path: Path) -> tuple[Any, dict[str, Any]]:
        """Return the job that a template begins, and the values of its object: those of its stock round the box."""
        template, box = read_template(path), self._around.box
        length, width, _ = self._usual["stock_size_mm"]
        if box is None:
            model = begun_job(template, (length, width))
            return model, self._usual | job_values(model, path.stem)
        rule = _round_solid(template.stock, box) if self._around.is_solid else template.stock
        flat = (box.XMin, box.YMin, box.XMax, box.YMax)
        size = rule.size_mm or size_round(flat, rule)
        x_mm, y_mm = offset_mm(flat, rule, size)
        model = begun_job(template.model_copy(update={"stock": rule}), size)
        place = (round(-x_mm, 4), round(-y_mm, 4), round(box.ZMax, 4))
        return model, self._usual | job_values(model, path.stem) | {"work_origin_mm": place}

    def _edit(self, changes: dict[str, Any]) -> None:
        before = values(self._job)
        edit(self._job, **changes)
        try:
            self._job.Proxy.check(self._job)
        except CNCStepperError:
            edit(self._job, **{key: before[key] for key in changes})
            raise

    def _take_tools(self, model: Any) -> None:
        """Put the tools of a job in place of those that nobody has changed; None: a new tool, where there is none."""
        job = self._job
        gone = [each for each in job.Tools if not self._is_typed(each)]
        kept = [each for each in job.Tools if each not in gone]
        job.Tools = kept
        for each in gone:
            job.Document.removeObject(each.Name)
        for each in kept:
            edit(each, **untyped_feeds(each, job))
        for each in model.tool if model else ():
            taken = {tool.Number for tool in job.Tools}
            number = max(taken) + 1 if each.number in taken else each.number
            add_tool_of_file(job, each.model_copy(update={"number": number}))
        if not job.Tools:
            api.add_tool(job, **default_values.tool(job))
        self._tools |= {each.Name: values(each) for each in job.Tools if each not in kept}

    def _is_typed(self, tool: Any) -> bool:
        """Return whether a person has added or changed a tool, or cuts with it; feeds by the material are no change."""
        before, now = self._tools.get(tool.Name), values(tool)
        if before is None or any(not is_job(user) for user in tool.InList):
            return True
        usual = {key: (0.0, float(entry_of(tool.Proxy, key).default)) for key in FEEDS}
        changed = [key for key in now if now[key] != before[key]]
        return any(not any(math.isclose(now[key], each) for each in usual.get(key, ())) for key in changed)


def _values_of(job: Any) -> dict[str, Any]:
    found = values(job)
    return {key: found[key] for key in KEYS}


def _round_solid(rule: StockRule, box: Any) -> StockRule:
    """Return a template's stock as that of a solid: as large as its box."""
    size = {"form": "box", "size_mm": None, "thickness_mm": box.ZLength, "margin_mm": 0.0, "placement": "box"}
    return rule.model_copy(update=size)
