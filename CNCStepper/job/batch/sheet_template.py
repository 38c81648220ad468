# SPDX-License-Identifier: LGPL-2.1-or-later
"""A shop's template, for whole sheets: the chains of all parts lie on layers by the rule that takes them.

    part's chain ──► first rule that takes it ──► layer "rule 3" of the sheet's drawing ──► the same rule, by that layer

A rule may ask for names, groups or filled areas, which the drawing of a sheet does not keep; the layer says it for all.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.drawing.selection import Selection
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.job.batch.task_files import below
from CNCStepper.job.templates.drawing_job import read_by_template, with_stock
from CNCStepper.job.templates.rules import assigned
from CNCStepper.job.templates.template import DrawingRule, Template, read_template
from CNCStepper.machine.profile import load_machine, profile_names

ANY_CHAIN: dict[str, Any] = Selection().model_dump()


def template_of(task: Mapping[str, Any], root: Path) -> Template:
    """Return the template of a task below a root, with the row's thickness and the machine's own profile."""
    template = with_stock(read_template(below(root, task["template"])), task["thickness_mm"])
    if not task["machine"]:
        return template
    machine = str(below(root, task["machine"]))
    return template.model_copy(update={"job": template.job | {"machine": machine}})


def cut_chains(template: Template, drawing: Path) -> list[tuple[int, Chain]]:
    """Return the chains of a drawing that are cut or marked, each with the number of its rule.

    Raises JobError for a drawing that cannot be read, and where no rule takes a chain.
    """
    found = assigned(template.rule, read_by_template(template, drawing).chains)
    pairs = [
        (number, chain)
        for number, (rule, chains) in enumerate(zip(template.rule, found.taken, strict=True))
        for chain in chains
        if not rule.ignore
    ]
    if not pairs:
        what, advice = "no rule of the template takes a chain of the drawing", "correct the template's rules"
        raise JobError("rule-none", what, advice=advice, place=Place(str(drawing)))
    return pairs


def layer_of(number: int) -> Attributes:
    """Return the layer of a rule's chains in the drawing of a sheet."""
    return Attributes(layer=f"rule {number + 1}")


def for_sheets(template: Template, size_mm: tuple[float, float]) -> Template:
    """Return the template for drawings of sheets of a size, in the sheet's own coordinates."""
    rules = [
        rule.model_copy(update=ANY_CHAIN | {"layer": (layer_of(number).layer,), "title": rule.named(number + 1)})
        for number, rule in enumerate(template.rule)
    ]
    stock = template.stock.model_copy(update={"size_mm": size_mm, "placement": "drawing"})
    drawing = DrawingRule(tolerance_mm=template.drawing.tolerance_mm, by_colour=False)
    return template.model_copy(update={"rule": tuple(rules), "stock": stock, "drawing": drawing})


def sheet_size_mm(template: Template, wanted: tuple[float, float] | None) -> tuple[float, float]:
    """Return the size of the sheets on which parts are nested: as wanted, the template's, or the machine's travel."""
    if wanted or template.stock.size_mm:
        return wanted or template.stock.size_mm or (0.0, 0.0)
    name = str(template.job.get("machine", ""))
    machine = load_machine(name if name in profile_names() else template.path.parent / name)
    if "y" not in machine.axis:
        what, advice = Text("{machine} takes no sheets: it has no Y", machine=machine.name), "name another machine"
        raise JobError("batch-sheet", what, advice=advice, place=Place(str(template.path)))
    x, y = machine.axis["x"], machine.axis["y"]
    return x.travel_max_mm - x.travel_min_mm, y.travel_max_mm - y.travel_min_mm
