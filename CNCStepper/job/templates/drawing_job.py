# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of a drawing and a template: stock, placement, shapes that follow the drawing, and operations.

    drawing ──► chains ──► rules ──► operations ─┐
                  └──► box ──► stock, placement ──┴──► content of a job file ──► Job, checked whole ──► text

The job's shapes name the drawing and the selections of the rules, so that the job follows the drawing when it changes.
"""

from __future__ import annotations

import copy
import math
import operator
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.drawing.chain_list import Count, drawing_box_mm
from CNCStepper.drawing.crossing_areas import without_crossings
from CNCStepper.drawing.drawing import Chain, Drawing, Share
from CNCStepper.drawing.nesting_levels import nesting_levels
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.drawing.repair.mend import mended
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.job.drawings.read_any import read_any_drawing
from CNCStepper.job.files.job_text import content_text
from CNCStepper.job.model import Job, job_of_content
from CNCStepper.job.shapes import DrawingForm
from CNCStepper.job.templates.common_kerf import kerfs_mm, require_kerf
from CNCStepper.job.templates.rules import Assignment, assigned, exceptions_of
from CNCStepper.job.templates.template import OPEN_CYCLES, THROUGH, Rule, StockRule, Template
from CNCStepper.machine.profile import profile_names
from CNCStepper.output_files import MADE_BY

Content = dict[str, Any]
AREA_CYCLES = {"pocket": "islands"}  # cycles that clear an area, and their key for what stays in it
HOLE_CYCLES = ("drill", "bore", "thread")
FILES = ("machine", "chart", "tools")  # keys of a template that name files
MICRON = 1000.0  # in a mm


@dataclass(frozen=True)
class DrawingJob:
    """A job that a template made of a drawing.

    content: of the job file; title: its first line. untaken: the chains that no rule takes, by layer and colour.
    counts: how many chains each rule takes, by title, ignored ones too.
    """

    content: Content
    title: str
    job: Job
    untaken: tuple[Count, ...]
    counts: tuple[tuple[str, int], ...]

    @property
    def text(self) -> str:
        """The text of the job file."""
        return content_text(self.content, self.title)

    def write(self, path: Path) -> None:
        """Write the job file; its paths are those of the place for which it was made."""
        write_whole(path, self.text.encode("utf-8"))


def job_of_drawing(
    template: Template,
    drawing_path: Path,
    job_path: Path,
    *,
    thickness_mm: float | None = None,
    material: str = "",
    unit_mm: float | None = None,
    strict: bool = False,
    share: Share = lambda share: None,
) -> DrawingJob:
    """Return the job that a template makes of a drawing, for a job file at `job_path`, whose folder exists.

    thickness_mm, material, unit_mm: instead of those of the template. strict: chains that no rule takes are refused.
    Raises JobError for a drawing that cannot be read or does not fit, and for what no job can be made of.
    """
    template = with_stock(template, thickness_mm, unit_mm)
    drawing = read_by_template(template, drawing_path, share)
    found = assigned(template.rule, drawing.chains)
    if strict and found.untaken:
        raise _untaken(found, drawing_path)
    content = _Maker(template, drawing_path, job_path.parent, found).content(material)
    title = f"{drawing_path.name} by the template {template.path.name}, {MADE_BY}"
    job = job_by_template(template, copy.deepcopy(content), job_path)
    with placed(Place(str(template.path))):
        require_kerf(job, {} if drawing.kerf_mm is None else dict.fromkeys(kerfs_mm(job), drawing.kerf_mm))
    counts = tuple(
        (rule.named(number), len(chains))
        for number, (rule, chains) in enumerate(zip(template.rule, found.taken, strict=True), start=1)
    )
    return DrawingJob(content, title, job, found.untaken_counts, counts)


def job_by_template(template: Template, content: Content, job_path: Path) -> Job:
    """Return the job of a content that a template made, which is used up; an error of an operation names its rule."""
    titles = enumerate(map(operation_title, content["operation"]), start=1)
    rules = {f"{job_path} operation {number}": f"{template.path} rule '{title}'" for number, title in titles}
    try:
        with placed(Place(str(template.path))):
            return job_of_content(content, job_path)
    except JobError as error:
        if error.place is None or error.place.file not in rules:
            raise
        raise error.at(Place(rules[error.place.file])) from error


def operation_title(operation: Mapping[str, Any]) -> str:
    """Return the name of the first shape of an operation, which is its rule's."""
    shapes = next(operation[key] for key in ("region", "outlines", "curves", "pattern") if key in operation)
    return str((shapes["circles"] if isinstance(shapes, dict) else shapes)[0])


def content_in_place(template: Template, drawing_path: Path, found: Assignment) -> tuple[Content, tuple[float, float]]:
    """Return the content of a job whose curves lie as the drawing has them, and by how much a job file moves them, mm.

    Files are named by their whole paths. Raises JobError as `job_of_drawing`.
    """
    maker = _Maker(template, drawing_path, None, found)
    content = maker.content("")
    for shape in content["shape"]:
        shape["drawing"].pop("offset_mm", None)
    return content, maker.offset_mm


def with_stock(template: Template, thickness_mm: float | None, unit_mm: float | None = None) -> Template:
    """Return the template with another thickness and unit, where they are given."""
    stock = template.stock.model_dump() | ({"thickness_mm": thickness_mm} if thickness_mm else {})
    drawing = template.drawing.model_copy(update={"unit_mm": unit_mm} if unit_mm else {})
    return template.model_copy(update={"stock": StockRule.model_validate(stock), "drawing": drawing})


def _form(template: Template, file: str, **keys: Any) -> DrawingForm:
    told = template.drawing
    given: Content = {
        "tolerance_mm": told.tolerance_mm,
        "unit_mm": told.unit_mm,
        "by_colour": told.by_colour,
        "trace": told.trace,
    }
    return DrawingForm(file=file, mend=told.mend, **given, **keys)


def reading_of(template: Template, path: Path) -> ReadOptions:
    """Return how a template reads a drawing."""
    return _form(template, path.name).options()


def read_by_template(template: Template, path: Path, share: Share = lambda share: None) -> Drawing:
    """Return a drawing as the template has it read and mended; raises JobError where it cannot be read."""
    drawing = read_any_drawing(path, reading_of(template, path), share)
    return mended(drawing, template.drawing.mend)[0] if template.drawing.mend else drawing


def _untaken(found: Assignment, path: Path) -> JobError:
    counts = ", ".join(
        f"'{count.layer}' {count.colour}".strip() + f": {count.closed + count.open}" for count in found.untaken_counts
    )
    return JobError(
        "rule-missing",
        Text("no rule of the template takes chains of the drawing: {counts}", counts=counts),
        value=Text("{untaken} chains", untaken=len(found.untaken)),
        advice="write a rule for them, or one with ignore = true",
        place=Place(str(path)),
    )


class _Maker:
    """Makes the content of the job file in a folder; without one, files are named by their whole paths."""

    def __init__(self, template: Template, drawing: Path, folder: Path | None, found: Assignment):
        self._template, self._drawing, self._folder = template, drawing, folder
        self._found = found
        self._shapes: list[Content] = []
        self.offset_mm = (0.0, 0.0)

    def content(self, material: str) -> Content:
        """Return the content; raises JobError where no rule takes a chain, or the drawing does not fit."""
        cut = [
            chain
            for rule, chains in zip(self._template.rule, self._found.taken, strict=True)
            for chain in chains
            if not rule.ignore
        ]
        if not cut:
            raise JobError(
                "rule-none",
                "no rule of the template takes a chain of the drawing",
                advice="'cncstepper drawing' prints its layers and colours",
                place=Place(str(self._drawing)),
            )
        stock = self._stock(cut)
        operations = [operation for number in range(len(self._template.rule)) for operation in self._operations(number)]
        told = {key: self._rebased(key, value) for key, value in copy.deepcopy(self._template.job).items()}
        keys = told | ({"material": material} if material else {})
        return keys | {"stock": stock, "shape": self._shapes, "operation": operations}

    def _rebased(self, key: str, value: Any) -> Any:
        """Return a value of the template, a file as it is found from the job's folder."""
        if key not in FILES:
            return value
        if isinstance(value, Mapping):
            return {name: self._rebased(key, one) if name == "file" else one for name, one in value.items()}
        if not isinstance(value, str) or (key == "machine" and value in profile_names()):
            return value
        return self._from_folder(self._template.path.parent / value)

    def _from_folder(self, path: Path) -> str:
        """Return a path as it is found from the job's folder; without one and on another disk the whole path."""
        if self._folder is None:
            return path.resolve().as_posix()
        try:
            return Path(os.path.relpath(path.resolve(), self._folder.resolve())).as_posix()
        except ValueError:
            return path.resolve().as_posix()

    def _stock(self, cut: Sequence[Chain]) -> Content:
        """Return the stock, and note where the drawing lies on it."""
        rule, box = self._template.stock, drawing_box_mm(cut)
        size_mm = rule.size_mm or size_round(box, rule)
        self.offset_mm = offset_mm(box, rule, size_mm)
        left, front = (0.0, 0.0) if rule.origin == "top-left-front" else (-size_mm[0] / 2.0, -size_mm[1] / 2.0)
        (dx, dy), (right, back) = self.offset_mm, (left + size_mm[0], front + size_mm[1])
        beyond = max(left - box[0] - dx, front - box[1] - dy, box[2] + dx - right, box[3] + dy - back)
        if beyond > 1.0 / MICRON:
            raise JobError(
                "drawing-size",
                "the drawing reaches beyond the stock",
                value=f"{box[2] - box[0]:.6g} by {box[3] - box[1]:.6g} mm",
                limit=f"{size_mm[0]:g} by {size_mm[1]:g} mm",
                advice='take a larger stock, a smaller margin or placement = "box"',
                place=Place(str(self._drawing)),
            )
        return stock_content(rule, size_mm)

    def _operations(self, number: int) -> Iterator[Content]:
        """Yield the operations of one rule, none where it takes no chain."""
        rule, chains = self._template.rule[number], self._found.taken[number]
        if not chains or rule.operation is None:
            return
        name = rule.named(number + 1)
        told = self._depths(rule.operation)
        if rule.cycle in AREA_CYCLES:
            yield from self._areas(name, number, told, chains)
        elif rule.cycle in HOLE_CYCLES:
            yield told | {"pattern": {"kind": "circles", "circles": [self._shape(name, number)]}}
        else:
            yield (
                told
                | {"curves" if rule.cycle in OPEN_CYCLES else "outlines": [self._shape(name, number)]}
                | (self._marks(rule))
            )

    def _areas(self, name: str, number: int, told: Content, chains: Sequence[Chain]) -> Iterator[Content]:
        """Yield an operation for each two levels of nesting: outlines, and the islands in them."""
        closed = [chain for chain in chains if chain.curve.closed]
        apart = without_crossings(closed)
        levels = set(nesting_levels([chain.curve for chain in apart]).tolist())
        if len(closed) < len(chains) or not levels:
            raise JobError(
                "rule-open",
                Text("the rule '{name}' clears areas, but takes open chains of the drawing", name=name),
                value=f"{len(chains) - len(closed)}",
                advice="add closed = true to the rule, or mend the drawing",
                place=Place(str(self._drawing)),
            )
        if levels == {0} and len(apart) == len(closed) and all(map(operator.is_, apart, closed)):
            yield told | {"region": [self._shape(name, number)]}
            return
        for level in range(0, max(levels) + 1, 2):
            label = name if level == 0 else f"{name} in islands {level // 2}"
            operation = told | {"region": [self._shape(label, number, level)]}
            if level + 1 in levels:
                operation["islands"] = [self._shape(f"{label} islands", number, level + 1)]
            yield operation

    def _marks(self, rule: Rule) -> Content:
        """Return the marks that other rules give to a rule's operation."""
        names = [
            self._shape(other.named(number + 1), number)
            for number, other in enumerate(self._template.rule)
            if other.marks_for and other.marks_for == rule.title and self._found.taken[number]
        ]
        return {"marks": names} if names else {}

    def _shape(self, name: str, number: int, nesting: int | None = None) -> str:
        """Add the shape of a rule's chains, and return its name."""
        rules = self._template.rule
        keys: Content = {"nesting": nesting} if nesting is not None else {}
        form = _form(
            self._template,
            self._from_folder(self._drawing),
            **rules[number].selection.model_dump(),
            without=exceptions_of(rules, number),
            offset_mm=self.offset_mm,
            **keys,
        )
        told = _plain(form.model_dump(mode="json", exclude_defaults=True))
        self._shapes.append({"name": name, "drawing": {"file": form.file} | told})
        return name

    def _depths(self, operation: Mapping[str, Any]) -> Content:
        """Return an operation's keys with depths of "through" as numbers."""
        stock = self._template.stock
        deep_mm = round(stock.thickness_mm + stock.through_mm, 6)
        return {
            key: deep_mm if key == "depth_mm" and value == THROUGH else value
            for key, value in copy.deepcopy(dict(operation)).items()
        }


def _plain(content: Any) -> Any:
    """Return tables with a list of one pattern as that pattern."""
    if not isinstance(content, Mapping):
        return [_plain(one) for one in content] if isinstance(content, list) else content
    return {
        key: one[0] if isinstance(one, list) and len(one) == 1 and isinstance(one[0], str) else _plain(one)
        for key, one in content.items()
    }


def stock_content(rule: StockRule, size_mm: tuple[float, float]) -> Content:
    """Return the `[stock]` table of a job file, X and Y of the stock given."""
    told: Content = {"form": rule.form, "size_mm": [*size_mm, rule.thickness_mm], "origin": rule.origin}
    return told | ({"edge_mm": rule.edge_mm} if rule.edge_mm is not None else {})


def size_round(box: tuple[float, float, float, float], rule: StockRule) -> tuple[float, float]:
    """Return X and Y of the stock round a drawing's box (left, front, right, back), mm, to whole microns."""
    left, front, right, back = box
    if rule.placement == "drawing":
        reach = (right, back) if rule.origin == "top-left-front" else (
            2.0 * max(abs(left), abs(right)), 2.0 * max(abs(front), abs(back))
        )  # fmt: skip
        sides = 1.0 if rule.origin == "top-left-front" else 2.0
        x, y = (value + sides * rule.margin_mm for value in reach)
    else:
        x, y = right - left + 2.0 * rule.margin_mm, back - front + 2.0 * rule.margin_mm
    return _to_micron(x), _to_micron(y)


def _to_micron(length_mm: float) -> float:
    return max(math.ceil(length_mm * MICRON - 1e-3), 1) / MICRON


def offset_mm(
    box: tuple[float, float, float, float], rule: StockRule, size_mm: tuple[float, float]
) -> tuple[float, float]:
    """Return by how much a drawing of that box is moved to lie on a stock of that size, mm."""
    if rule.placement == "drawing":
        return 0.0, 0.0
    left, front, right, back = box
    if rule.origin == "top-centre":
        return round(-(left + right) / 2.0, 6) + 0.0, round(-(front + back) / 2.0, 6) + 0.0
    return round(rule.margin_mm - left, 6) + 0.0, round(rule.margin_mm - front, 6) + 0.0
