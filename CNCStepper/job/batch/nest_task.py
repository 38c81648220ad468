# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nests the parts of one template, material and thickness on equal sheets, with one seed of the random search.

The search counts its attempts and not its time, and packs no strips, so that each worker finds the same layout.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import shapely
from shapely import Polygon

from CNCStepper.drawing.drawing import Chain, Drawing
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.job.batch.sheet_template import cut_chains, layer_of, sheet_size_mm, template_of
from CNCStepper.job.batch.task_files import below
from CNCStepper.job.nesting.nest_files import density_of, placements_json, remnant_drawing, remnants
from CNCStepper.job.nesting.order_file import Order, named, outline_region
from CNCStepper.job.nesting.shared_cuts import block_chains, on_sheet, part_chains, saving_of, shared_cuts
from CNCStepper.job.templates.common_kerf import common_kerf_mm
from CNCStepper.job.templates.drawing_job import job_of_drawing
from CNCStepper.job.templates.template import Template
from CNCStepper.nesting.common_lines import CommonCuts
from CNCStepper.nesting.nest import nest
from CNCStepper.nesting.nesting_model import Budget, Item, Layout, Placement, Sheet, Spacing, placed
from CNCStepper.nesting.outlines import EXACT_MM, holding_polygon, simplified

TURNS_DEG: Mapping[str, tuple[float, ...] | None] = {
    "none": (0.0,),
    "half": (0.0, 180.0),
    "quarter": (0.0, 90.0, 180.0, 270.0),
    "any": None,
}
SEARCH_TOLERANCE_MM = 0.02
AMPLE_S = 1e6  # the attempts end the search
SPARE_SHEETS = 3.0  # times those that the parts' boxes fill


def nested(task: Mapping[str, Any], root: Path) -> dict[str, Any]:
    """Return a layout: where each part lies, what lies nowhere, and `rank`, of which the least is best.

    task: `parts` with drawing and count of each; seed, attempts, turn, gap_mm, sheet_mm (None: the template's),
    common_lines.
    """
    _, order = _order(task, root)
    budget = Budget(AMPLE_S, task["attempts"])
    more = {"seed": task["seed"], "common_lines": order.common_lines}
    layout = nest(order.items, order.sheets, order.spacing, budget, **more)
    return {
        "placements": [[p.sheet, p.item, p.x_mm, p.y_mm, p.rotation_deg] for p in layout.placements],
        "unplaced": [{"part": each.item, "count": each.count, "why": str(each.why)} for each in layout.unplaced],
        "rank": _rank(order, layout),
    }


def laid_out(task: Mapping[str, Any], root: Path, out: Path) -> dict[str, Any]:
    """Return the files of a layout: drawings of the sheets, remnants, placements, picture; how many parts lie where.

    task: as of `nested`, and its `placements`.
    """
    template, order = _order(task, root)
    layout = Layout(tuple(Placement(*values) for values in task["placements"]))
    size_mm = order.sheets[0].outline.bounds[2:]
    shared = shared_cuts(order, layout)
    return {
        "sheet_mm": list(size_mm),
        "density": density_of(order, layout),
        "sheets": [_counts(layout, number, len(order.items)) for number in layout.sheets],
        "notes": [saving_of(shared).sentence, *saving_of(shared).notes] if shared else [],
        "files": _files(task["group"], template, order, layout, out, shared),
    }


def _order(task: Mapping[str, Any], root: Path) -> tuple[Template, Order]:
    template = template_of(task, root)
    size_mm = sheet_size_mm(template, task["sheet_mm"] and tuple(task["sheet_mm"]))
    kerf_mm = _kerf_mm(template, task, root) if task["common_lines"] else 0.0
    margin_mm = template.stock.margin_mm
    gap_mm = kerf_mm or (margin_mm if task["gap_mm"] is None else task["gap_mm"])
    drawn = [_item(part, template, root, TURNS_DEG[task["turn"]]) for part in task["parts"]]
    items = tuple(item for item, _ in drawn)
    sheet = Sheet("sheet", shapely.box(0.0, 0.0, *size_mm))
    sheets = (sheet,) * _most_sheets(items, sheet, gap_mm)
    chains = tuple(lines for _, lines in drawn)
    order = Order(items, sheets, Spacing(gap_mm, margin_mm), chains, kerf_mm, common_lines=task["common_lines"])
    return template, order


def _kerf_mm(template: Template, task: Mapping[str, Any], root: Path) -> float:
    """Return the kerf by which the parts are cut, that of a job of the first one; raises JobError for several."""
    drawing = below(root, task["parts"][0]["drawing"])
    job_file = below(root, task["folder"]) / "part.toml"
    return common_kerf_mm(job_of_drawing(template, drawing, job_file, material=task["material"]).job)


def _item(
    part: Mapping[str, Any], template: Template, root: Path, turns_deg: tuple[float, ...] | None
) -> tuple[Item, tuple[Chain, ...]]:
    """Return a part with the outline of all that is cut of it, and its chains on the layers of their rules."""
    path = below(root, part["drawing"])
    pairs = cut_chains(template, path)
    with named(path.stem):
        region = outline_region([chain.curve for number, chain in pairs if not template.rule[number].marks_for])
        exact = _without_holes(holding_polygon(region, EXACT_MM), template)
        item = Item(path.stem, simplified(exact, SEARCH_TOLERANCE_MM), exact, part["count"], turns_deg)
    return item, tuple(Chain(chain.curve, layer_of(number)) for number, chain in pairs)


def _without_holes(polygon: Polygon, template: Template) -> Polygon:
    """Return the polygon; its holes only where all is cut through, in an order that suits parts in holes."""
    through = all(rule.cycle in ("", "sheet_cut") for rule in template.rule)
    return polygon if through else Polygon(polygon.exterior)


def _most_sheets(items: Sequence[Item], sheet: Sheet, gap_mm: float) -> int:
    """Return a number of sheets that certainly suffices where each part finds its place at all."""
    boxes = sum(item.count * shapely.box(*item.outline.bounds).buffer(gap_mm).area for item in items)
    parts = sum(item.count for item in items)
    return min(parts, 2 + math.ceil(SPARE_SHEETS * boxes / sheet.outline.area))


def _rank(order: Order, layout: Layout) -> list[float]:
    """Return parts without a place, sheets, and how far the last sheet is used."""
    last = max(layout.sheets, default=0)
    ends = [placed(order.items[each.item].exact, each).bounds[2] for each in layout.placements if each.sheet == last]
    return [sum(each.count for each in layout.unplaced), len(layout.sheets), round(max(ends, default=0.0), 6)]


def _counts(layout: Layout, number: int, items: int) -> list[int]:
    """Return how many of each part lie on a sheet."""
    lie = [each.item for each in layout.placements if each.sheet == number]
    return [lie.count(item) for item in range(items)]


def _files(
    group: int, template: Template, order: Order, layout: Layout, out: Path, shared: Mapping[int, CommonCuts]
) -> dict[str, bytes]:
    """Return the files of a layout; the drawings of the sheets have their zero where the template has it."""
    from CNCStepper.job.nesting.nest_picture import save_nest_picture  # a third of the start of a worker

    wide_mm, deep_mm = order.sheets[0].outline.bounds[2:]
    shift = (-wide_mm / 2.0, -deep_mm / 2.0) if template.stock.origin == "top-centre" else (0.0, 0.0)
    files = {f"placements-{group}.json": placements_json(layout).encode("utf-8")}
    for number in layout.sheets:
        lie, cuts = on_sheet(layout, number), shared.get(number, CommonCuts())
        chains = (*part_chains(order, lie, cuts), *block_chains(order, lie, cuts, lines=None))
        moved = tuple(Chain(chain.curve.moved(*shift), chain.attributes) for chain in chains)
        drawing = Drawing(moved, kerf_mm=order.kerf_mm if cuts.blocks else None)
        files[f"sheet-{group}-{number + 1}.dxf"] = dxf_bytes(drawing)
        for count, remnant in enumerate(remnants(order, layout, number), start=1):
            files[f"remnant-{group}-{number + 1}-{count}.dxf"] = dxf_bytes(remnant_drawing(remnant))
    picture = out / f"nest-{group}.png"
    save_nest_picture(picture, order, layout, density_of(order, layout), shared)
    return files | {picture.name: picture.read_bytes()}


def best_of(results: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return the result of the best layout, the first of equal ones; an error only where all seeds have one."""
    sound = [result for result in results if "error" not in result]
    return min(sound, key=lambda result: result["rank"]) if sound else results[0]
