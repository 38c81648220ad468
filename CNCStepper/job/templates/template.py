# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template of a shop: all of a job but its drawing, and rules that say how each chain of a drawing is cut.

    machine = "table-a"                     the keys of a job file, its tools too

    [stock]                                 its size is that of the drawing and the margin
    thickness_mm = 12
    margin_mm = 10

    [drawing]                               how drawings are read; mend = {} repairs them within the usual limits
    tolerance_mm = 0.01

    [[rule]]                                the first rule that takes a chain has it
    title = "outline"
    colour = "#ff0000"                      layer, colour, name, group: a pattern or a list; closed, filled: true, false
    operation = { cycle = "contour", tool = 1, side = "outside", depth_mm = "through", stepdown_mm = 3 }

    [[rule]]
    layer = ["notes", "dim*"]
    ignore = true

The keys of an operation are those of a job file without its shapes. A depth_mm of "through" is the thickness and what
the stock's `through_mm` adds.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, StrictBool, model_validator

from CNCStepper.cycles.catalogue import cycle_class
from CNCStepper.drawing.repair.problems import RepairLimits
from CNCStepper.drawing.selection import Selection
from CNCStepper.drawing.trace.options import TraceOptions
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.job.shapes import SHAPE_KEYS
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.processes import is_turning
from CNCStepper.machine.profile import validated
from CNCStepper.quantities import Bounds, Depth, DepthOr0, Length, LengthOr0, Unit

MOST_RULES = 200
THROUGH = "through"
OPEN_CYCLES = ("engrave", "contour", "sheet_cut", "wire_cut")  # that take open chains too


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class StockRule(_Checked):
    """How large the stock is, and where the drawing lies on it.

    size_mm: X and Y of a stock of fixed size, for a cylinder its diameter twice; left out, the drawing's box and
    margin_mm on each side. placement: "box" puts the drawing's box margin_mm from the stock's corner, or its middle on
    that of the stock where the origin is there; "drawing" leaves the drawing's own coordinates. through_mm: how much
    deeper than the stock "through" is.
    """

    form: Literal["box", "sheet", "cylinder"] = "sheet"
    thickness_mm: Depth
    margin_mm: LengthOr0 = 5.0
    size_mm: tuple[Length, Length] | None = None
    origin: Literal["top-left-front", "top-centre"] = "top-left-front"
    placement: Literal["box", "drawing"] = "box"
    through_mm: DepthOr0 = 0.2
    edge_mm: LengthOr0 | None = None


class DrawingRule(_Checked):
    """How drawings are read."""

    tolerance_mm: Annotated[float, Bounds("tolerance", most=1.0)] = 0.005
    unit_mm: Unit | None = None
    by_colour: StrictBool = True
    mend: RepairLimits | None = None
    trace: TraceOptions = TraceOptions()


class Rule(Selection):
    """Which chains a rule takes, and what becomes of them: an operation, marks of another rule's, or nothing."""

    title: str = Field(default="", max_length=100)
    operation: dict[str, Any] | None = None
    marks_for: str = ""
    ignore: StrictBool = False

    @model_validator(mode="after")
    def _does_one_thing(self) -> Rule:
        if (self.operation is not None) + bool(self.marks_for) + self.ignore != 1:
            raise ValueError("a rule has one of operation, marks_for and ignore = true")
        if self.operation is not None:
            self._require_cycle(self.operation)
        return self

    @staticmethod
    def _require_cycle(operation: dict[str, Any]) -> None:
        cycle = str(operation.get("cycle", ""))
        try:
            cycle_class(cycle)
        except JobError as error:
            raise ValueError(Text("{error}; {advice}", error=error.what, advice=error.advice)) from error
        if cycle not in SHAPE_KEYS:
            raise ValueError(Text("the cycle '{cycle}' takes no shapes of a drawing", cycle=cycle))
        named = {key.says.partition(".")[0] for key in SHAPE_KEYS[cycle]} & set(operation)
        if named:
            raise ValueError(Text("the rule gives the shapes: leave {named} out", named=", ".join(sorted(named))))

    @property
    def cycle(self) -> str:
        """The cycle of the rule's operation, "" without one."""
        return str(self.operation["cycle"]) if self.operation else ""

    @property
    def selection(self) -> Selection:
        """The keys by which it takes chains."""
        return Selection(**{key: getattr(self, key) for key in Selection.model_fields})

    def named(self, number: int) -> str:
        """Return its title, or one made of its cycle and its number."""
        return self.title or f"{self.cycle or 'rule'} {number}"


class Template(_Checked):
    """A template that can be used. job: the keys of a job file that it gives; path: of the template's file."""

    stock: StockRule
    drawing: DrawingRule = DrawingRule()
    rule: tuple[Rule, ...] = Field(min_length=1, max_length=MOST_RULES)
    job: dict[str, Any]
    path: Path

    @model_validator(mode="after")
    def _parts_fit_together(self) -> Template:
        titles = [rule.title for rule in self.rule if rule.title]
        if len(set(titles)) < len(titles):
            raise ValueError("two rules have the same title")
        cutting = {rule.title for rule in self.rule if rule.cycle == "sheet_cut"}
        for rule in self.rule:
            if rule.marks_for and rule.marks_for not in cutting:
                raise ValueError(
                    Text("marks_for names '{title}', which is no rule with a sheet_cut", title=rule.marks_for)
                )
        return self


OWN_KEYS = ("stock", "drawing", "rule")
NOT_IN_TEMPLATES = ("shape", "operation", "notes", "cut_data", "job", "path")


def read_template(path: Path) -> Template:
    """Return the template in a TOML file; raises JobError that names the file, the key and its value."""
    with placed(Place(str(path))):
        return template_of(read_toml(path), path)


def template_of(content: dict[str, Any], path: Path) -> Template:
    """Return the template of a file's content; raises JobError that names the key and its value."""
    if is_turning(content):
        what, advice = "this is the template of a lathe, which takes no drawings", "begin a new lathe job with it"
        raise JobError("process-turning", what, advice=advice)
    for key in NOT_IN_TEMPLATES:
        if key in content:
            what, advice = Text("a template has no key '{key}'", key=key), "write rules: [[rule]]"
            raise JobError("bad-value", what, advice=advice)
    own = {key: content[key] for key in OWN_KEYS if key in content}
    job = {key: value for key, value in content.items() if key not in OWN_KEYS}
    return validated(Template, own | {"job": job, "path": path}, str(path))
