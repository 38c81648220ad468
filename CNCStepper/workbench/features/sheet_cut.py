# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_SheetCut: parts and their holes cut out of sheet by torch, laser, jet, knife or point."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from CNCStepper.cycles.contours.contour_parameters import LINES
from CNCStepper.cycles.parameter import LEADS, TABS
from CNCStepper.cycles.sheet_cutting.sheet_parameters import RULES, SheetParameters
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.workbench.features.base import DISTANCE, DRAWINGS, ENUMERATION, INTEGER, Property, entry_of, values
from CNCStepper.workbench.features.cycle_operation import MARKED, OPERATION, drawn, jobs_of
from CNCStepper.workbench.features.operation import Operation, drawn_lines, marked_lines
from CNCStepper.workbench.features.parameters import MADE, properties_of
from CNCStepper.workbench.services.translation import later

USUAL, OWN, NONE = "usual", "own", "none"
TABLES = ("small_holes", "corners", "arcs", "loops", "power_ramp", "tabs", "lead_in", "lead_out")
PROCESS = "process"  # of the job, on which it depends what counts
LASER, KNIFE = ("laser",), ("drag-knife",)
PIERCING = tuple(name for name, one in PROCESSES.items() if one.entry == "pierce")
LOWERED = tuple(name for name, one in PROCESSES.items() if one.entry == "lower")
TORCHES = ("plasma", "oxyfuel")


def _chooser(table: str, group: str, label: str, text: str, choices: tuple[str, ...]) -> Property:
    return Property(f"{table}_by", f"{table}_by".title().replace("_", ""), ENUMERATION, group, label, text, choices[0],
                    choices=choices)  # fmt: skip


CHOOSERS = (
    Property("tabs_by", "TabsBy", ENUMERATION, TABS, later("Tabs"),
             later("Joints that hold the part until it is broken out"), NONE, choices=(NONE, "count", "spacing")),
    _chooser("lead_in", LEADS, later("Leads"), later("Leads as usual for the process, or with values of your own"),
             (USUAL, OWN)),
    _chooser("small_holes", RULES, later("Small holes"), later("Small holes at a feed of their own"), (USUAL, OWN)),
    _chooser("corners", RULES, later("Corners"), later("A lower feed at corners"), (USUAL, OWN)),
    _chooser("arcs", RULES, later("Narrow arcs"), later("A lower feed on arcs of a small radius"), (NONE, OWN)),
    _chooser("loops", RULES, later("Loops"), later("Loops in the scrap, which make outside corners sharp"),
             (NONE, OWN)),
    _chooser("power_ramp", RULES, later("Power ramp"), later("A laser's power that rises behind the pierce"),
             (NONE, OWN)),
)  # fmt: skip
BY_TABS: dict[str, tuple[str, ...]] = {
    "tabs_count": ("count",),
    "tabs_spacing_mm": ("spacing",),
    "tabs_width_mm": ("count", "spacing"),
}
CHOOSER_OF = {"lead_out": "lead_in_by"}  # other tables have a chooser of their own
BY_PROCESS = {
    "pierce_mm": PIERCING,
    "pierce_delay_s": PIERCING,
    "depth_mm": LOWERED,
    "passes": (*LASER, *LOWERED),
    "dynamic_power": LASER,
    "blade_offset_mm": KNIFE,
    "small_holes_by": PIERCING,
    "corners_by": PIERCING,
    "arcs_by": PIERCING,
    "loops_by": PIERCING,
    "power_ramp_by": LASER,
    "mark_drawings": (*LASER, *LOWERED),
    "mark_power": LASER,
    "mark_feed_mm_min": (*LASER, *LOWERED),
    "spot_below_mm": (*TORCHES, *LASER),
    "spot_s": (*TORCHES, *LASER),
}
MARKS = Property(
    "mark_drawings", MARKED, DRAWINGS, LINES, later("Marks"),
    later("Lines that are marked with low power or lightly scribed before anything is cut"), (),
)  # fmt: skip


def _with_what_decides(entry: Property) -> Property:
    """Return a property that counts only with the process or the chooser of its table."""
    if entry.key in BY_PROCESS:
        return replace(entry, only=(PROCESS, BY_PROCESS[entry.key]))
    table = next((name for name in TABLES if entry.key.startswith(f"{name}_")), "")
    if not table or entry.only or entry.key.endswith("_by"):
        return entry
    if table == "tabs":
        return replace(entry, only=("tabs_by", BY_TABS[entry.key]))
    return replace(entry, only=(CHOOSER_OF.get(table, f"{table}_by"), (OWN,)))


def _properties() -> tuple[Property, ...]:
    """Return the cycle's properties, each chooser before its table, the rules last."""
    found = properties_of(SheetParameters, *CHOOSERS)
    ordered = sorted(found, key=lambda entry: (entry.group == RULES, _place(entry) if entry.group == RULES else 0))
    return tuple(map(_with_what_decides, ordered))


def _place(entry: Property) -> tuple[int, bool]:
    tables = [place for place, name in enumerate(TABLES) if entry.key.startswith(f"{name}_")]
    return (tables[0] if tables else len(TABLES), not entry.key.endswith("_by"))


class SheetCut(Operation):
    """The proxy of a cut of all chains of lines in a drawing out of the job's sheet."""

    Type = "CNCStepper_SheetCut"
    CYCLE = "sheet_cut"
    BY = (*PIERCING, *LOWERED)
    TABLES = TABLES
    OWN = (MARKS.key, *(entry.key for entry in CHOOSERS))
    PROPERTIES = (
        *OPERATION,
        *drawn(LINES, later("The sketch, wires or faces to cut: closed lines are parts and holes in turn")),
        _with_what_decides(MARKS),
        *_properties(),
        Property("parts", "Parts", INTEGER, MADE, later("Parts"), later("How many parts are cut free"), 0,
                 output=True),
        Property("pierces", "Pierces", INTEGER, MADE, later("Pierces"), later("How often the tool pierces"), 0,
                 output=True),
        Property("cut_length_mm", "CutLength", DISTANCE, MADE, later("Cut length"), later("The length of all cuts"),
                 0.0, output=True),
    )  # fmt: skip

    def known(self, obj: Any) -> dict[str, Any]:
        """Return the object's values by key, and its job's process."""
        process = self.process(obj)
        return {**values(obj), **({PROCESS: process} if process else {})}

    def process(self, obj: Any) -> str:
        """Return its job's process, "" without a job."""
        jobs = jobs_of(obj)
        return jobs[0].Process if jobs else ""

    def counts(self, entry: Property, found: dict[str, Any]) -> bool:
        """Return whether a property counts with the other values, and with the process where that is known."""
        if entry.only and entry.only[0] == PROCESS:
            return PROCESS not in found or found[PROCESS] in entry.only[1]
        return super().counts(entry, found)

    def make(self, obj: Any) -> None:
        """Cut it for trial, and show what its job's process has."""
        self.show_what_counts(obj)
        super().make(obj)

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the parameters and the drawings' curves."""
        found = self.known(obj)
        curves = drawn_lines(obj, origin_mm, "choose a sketch, wires or faces for it").curves
        given = {**self.given(found), "curves": tuple(each.curve for each in curves)}
        if found[MARKS.key] and self.counts(entry_of(self, MARKS.key), found):
            given["marks"] = tuple(each.curve for each in marked_lines(obj, origin_mm).curves)
        return given
