# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job templates: a job saved under a name, and the beginning of a new job by a template; no Qt.

job ──► content_of ──► the shop's template folder ──► JobBeginning.take ──► values and tools of a new job

A job template is a template of the shop whose only rule leaves all contours out; those with rules begin jobs too.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.job.templates.begun_job import begun_job
from CNCStepper.job.templates.drawing_job import offset_mm, size_round
from CNCStepper.job.templates.template import StockRule, read_template
from CNCStepper.job.templates.template_files import with_whole_paths, write_template
from CNCStepper.machine.files.profile_files import SUFFIX
from CNCStepper.tolerances import TOUCHING_MM
from CNCStepper.workbench import api, packages
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.document.default_values import FEEDS, untyped_feeds
from CNCStepper.workbench.document.job_files import JOB_KEYS, add_tool_of_file, job_values
from CNCStepper.workbench.document.stock_of_job import CYLINDER, size_mm
from CNCStepper.workbench.document.template_jobs import job_keys
from CNCStepper.workbench.drawings.shapes import box_of, box_of_boxes
from CNCStepper.workbench.features.base import edit
from CNCStepper.workbench.features.cycle_operation import linked_drawings
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.templates.around import Around
from CNCStepper.workbench.templates.beginning import Beginning, shop_choices
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

    One that cannot be read is there, and says why when it is chosen.
    """
    examples = sorted((packages.ROOT / "examples" / "templates").glob(f"*{SUFFIX}"))
    return [*shop_choices(of_lathe=False), *((str(path), tr("{0} (example)").format(path.stem)) for path in examples)]


class JobBeginning(Beginning):
    """The beginning of a job of milling or sheet cutting, its stock laid round what it is made round."""

    KEYS = KEYS
    FEEDS = FEEDS

    def __init__(self, job: Any, around: Around):
        super().__init__(job)
        self._around = around

    def of_template(self, path: Path) -> tuple[Any, dict[str, Any]]:
        """Return the job that a template begins, and the values of its object: those of its stock round the box."""
        template, box = read_template(path), self._around.box
        length, width, _ = self.usual["stock_size_mm"]
        if box is None:
            model = begun_job(template, (length, width))
            return model, job_values(model, path.stem)
        rule = _round_solid(template.stock, box) if self._around.is_solid else template.stock
        flat = (box.XMin, box.YMin, box.XMax, box.YMax)
        size = rule.size_mm or size_round(flat, rule)
        x_mm, y_mm = offset_mm(flat, rule, size)
        model = begun_job(template.model_copy(update={"stock": rule}), size)
        place = (round(-x_mm, 4), round(-y_mm, 4), round(box.ZMax, 4))
        return model, job_values(model, path.stem) | {"work_origin_mm": place}

    def add_tool(self, tool: Any) -> None:
        """Add a tool of a template."""
        add_tool_of_file(self.job, tool)

    def add_first_tool(self) -> None:
        """Add the tool that a job has which begins with no template."""
        api.add_tool(self.job, **default_values.tool(self.job))

    def follow(self, tools: Sequence[Any]) -> None:
        """Let the material's feeds count for tools that stay, where nobody has typed their own."""
        for each in tools:
            edit(each, **untyped_feeds(each, self.job))


def _round_solid(rule: StockRule, box: Any) -> StockRule:
    """Return a template's stock as that of a solid: as large as its box."""
    size = {"form": "box", "size_mm": None, "thickness_mm": box.ZLength, "margin_mm": 0.0, "placement": "box"}
    return rule.model_copy(update=size)
