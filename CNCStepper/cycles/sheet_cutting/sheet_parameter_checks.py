# SPDX-License-Identifier: LGPL-2.1-or-later
"""Requirements of a sheet's cut on process, tool and chart, and the measures that follow from them."""

from __future__ import annotations

from dataclasses import dataclass

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.moves import require_feed
from CNCStepper.cycles.sheet_cutting.sheet_model import SheetModel
from CNCStepper.cycles.sheet_cutting.strokes import Rules
from CNCStepper.errors import CycleError, Text

POINT_DEPTH_MM = 0.2
MARK_SHARE = 0.05


@dataclass(frozen=True)
class Measures:
    """The kerf, how far pierces keep off parts and cut edges, the depth, the rules and the share of power of marks."""

    kerf_mm: float
    pierce_mm: float
    depth_mm: float
    rules: Rules
    mark_share: float


def measures_of(cycle: SheetModel, setup: Setup) -> Measures:
    """Return the measures of an operation; raises CycleError for keys that do not go with the process."""
    _require_process(cycle, setup)
    require_feed(setup.tool, "feed_mm_min")
    process, data = setup.process, setup.cut_data
    kerf_mm = cycle.kerf_mm or (setup.tool.diameter_mm if process.is_thermal else 0.0)
    pierce_mm = max(cycle.pierce_mm or (data.lead_in_mm if data else 0.0), kerf_mm / 2.0)
    thickness_mm = setup.thickness_mm or (data.thickness_mm if data else 0.0)
    lead = cycle.lead_of(process, kerf_mm, pierce_mm)
    if lead.kind == "none" and process.entry == "pierce" and pierce_mm > kerf_mm / 2.0:
        raise CycleError(
            "lead-none",
            "without a lead-in the pierce lies on the cut, beside the part",
            value=f"{kerf_mm / 2.0:g} mm",
            limit=Text("{pierce_mm:g} mm from parts", pierce_mm=pierce_mm),
            advice=Text("set a lead_in, or pierce_mm to half of the kerf, {half_mm:g}", half_mm=kerf_mm / 2.0),
        )
    rules = _rules(cycle, setup, kerf_mm, thickness_mm)
    return Measures(kerf_mm, pierce_mm, _depth_mm(cycle, setup, thickness_mm), rules, _mark_share(cycle, setup))


def _rules(cycle: SheetModel, setup: Setup, kerf_mm: float, thickness_mm: float) -> Rules:
    process = setup.process
    return Rules(
        setup.tool.feed_mm_min,
        kerf_mm,
        thickness_mm,
        1 if cycle.good_side == "right" else -1,
        cycle.passes,
        cycle.overcut_mm,
        cycle.small_holes_of(process),
        cycle.arcs,
        cycle.corners_of(process),
        cycle.tabs if process.passes else None,
        cycle.power_ramp,
    )


def _depth_mm(cycle: SheetModel, setup: Setup, thickness_mm: float) -> float:
    if setup.process.is_thermal:
        return thickness_mm
    return cycle.depth_mm or (thickness_mm if setup.process.name == "drag-knife" else POINT_DEPTH_MM)


def _mark_share(cycle: SheetModel, setup: Setup) -> float:
    full = setup.power_s
    return min(cycle.mark_power / full, 1.0) if cycle.mark_power else MARK_SHARE


def _require_process(cycle: SheetModel, setup: Setup) -> None:
    process = setup.process
    if process.power not in ("contour", "none"):
        raise CycleError(
            "process-cycle",
            Text("sheet_cut does not cut by {process}", process=process.title.lower()),
            advice='set process to "plasma", "oxyfuel", "laser", "waterjet", "drag-knife" or "scribe"',
        )
    if setup.tool.shape not in process.shapes:
        raise CycleError(
            "tool-shape",
            Text("{process} does not cut with a {shape} tool", process=process.title, shape=setup.tool.shape),
            advice=Text("use one of: {shapes}", shapes=", ".join(process.shapes)),
        )
    graded = process.name == "laser"
    for key, given in (
        ("marks", cycle.marks),
        ("power_ramp", cycle.power_ramp),
        ("dynamic_power", cycle.dynamic_power),
    ):
        if given and not graded and not (key == "marks" and process.power == "none"):
            raise CycleError(
                "process-key",
                Text("{key} needs a laser: {process} has one power and pierces anew", key=key, process=process.title),
                advice=Text("leave {key} out", key=key),
            )
    if cycle.tabs and process.entry != "pierce":
        raise CycleError(
            "process-key",
            Text("{process} does not cut through the sheet: it needs no tabs", process=process.title),
            advice=Text("leave {key} out", key="tabs"),
        )
    if cycle.blade_offset_mm and process.name != "drag-knife":
        raise CycleError("process-key", "only a drag knife has a blade offset", advice="leave blade_offset_mm out")
    if process.power == "none" and not setup.has_z:
        raise CycleError(
            "process-z",
            Text("{process} is lowered and lifted, but the machine has no Z", process=process.title),
            advice="choose a machine with a Z axis",
        )
