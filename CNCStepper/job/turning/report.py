# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a turned part once its program is read back: findings, profile, dimensions, and the picture.

TurningJob ─► setup_of ──┐
program read back ─► moves_of ─► judge ─► TurnedVerdict: findings · report() · dimension_at() · draw()
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, radians
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.cycles.turning.turn_thread import thread_cut, thread_form
from CNCStepper.cycles.turning.turning_operation import (
    TurnDrill,
    TurnFace,
    TurnFinish,
    TurnGroove,
    TurningOperation,
    TurnPart,
    TurnRough,
    TurnTaper,
    TurnThread,
)
from CNCStepper.job.turning.taper_profile import taper_profile
from CNCStepper.job.turning.turning_job import TurningJob
from CNCStepper.simulation.finding import Finding, refused
from CNCStepper.simulation.turning.half_section import HalfSection, bar
from CNCStepper.simulation.turning.obstacles import chuck_region, tailstock_region
from CNCStepper.simulation.turning.swept_outline import Moves, swept_at
from CNCStepper.simulation.turning.tool_section import CHORD_MM, ToolSection
from CNCStepper.simulation.turning.turned_part import CONTACT_MM, TurnedPart, turned_part
from CNCStepper.simulation.turning.turning_checks import TurningSetup, check_turning
from CNCStepper.simulation.turning.wanted_profile import FAR_MM, WantedProfile, gouge, wanted_chain, wanted_ring

DECIMALS = 6


@dataclass(frozen=True)
class TurnedVerdict:
    """A turned part with all that the checks found; x_is: how the program gives X, "diameter" or "radius"."""

    part: TurnedPart
    setup: TurningSetup
    findings: list[Finding]
    x_is: str

    @property
    def refused(self) -> bool:
        """Whether a finding forbids sending the program."""
        return refused(self.findings)

    def report(self, first: int = 0) -> dict[str, Any]:
        """Return the keys of report.json about the part; "profile" holds points [z_mm, diameter_mm], z growing.

        first: the first row of the program, behind those of the programs before it.
        """
        section, stock = self.part.section, self.part.stock
        worst = gouge(section, stock, self.setup.wanted) if self.setup.wanted else None
        left_mm = [one.value for one in self.findings if one.code == "left-over" and one.value is not None]
        return {
            "x_is": self.x_is,
            **self.lengths(first),
            "gouge_mm": _number(worst.depth_mm if worst else 0.0) if self.setup.wanted else None,
            "left_over_mm": _number(max(left_mm, default=0.0)) if self.setup.wanted else None,
            "profile": _points(section.outer_profile),
            "bore_profile": _points(section.bore_profile),
            "volume_mm3": _number(section.volume_mm3),
            "removed_volume_mm3": _number(stock.volume_mm3 - section.volume_mm3),
            "deepest_cut_mm": _number(float(self.part.depths_mm.max(initial=0.0))),
            "pieces": [self._piece(one.section, one.move) for one in self.part.fallen],
        }

    def lengths(self, first: int, last: int | None = None) -> dict[str, float]:
        """Return how far the feeds go in material and in air, in the rows [first, last); None: to the end."""
        moves = self.part.moves
        mine = (moves.row >= first) & (moves.row < (np.inf if last is None else last))
        length_mm = np.hypot(*(moves.end - moves.begin).T)
        cuts = (self.part.depths_mm > CONTACT_MM) | (moves.pitch_mm > 0)
        feeds = {"cut_length_mm": ~moves.rapid & cuts, "air_length_mm": ~moves.rapid & ~cuts}
        return {name: _number(length_mm[mine & those].sum()) for name, those in feeds.items()}

    def dimension_at(self, z_mm: float) -> tuple[float, float]:
        """Return outer diameter and bore of the part as cut at a z, mm; 0 for none."""
        section = self.part.section
        return section.diameter_mm(z_mm), section.bore_mm(z_mm)

    def draw(self, file: Path, title: str = "", time: str = "", row: int | None = None) -> None:
        """Write the picture; row: of the table, after which the part is shown, None for the end."""
        from CNCStepper.simulation.views.half_section_picture import TurnedScene, save_half_section, turned_facts

        moves, setup = self.part.moves, self.setup
        count = len(moves) if row is None else int(np.searchsorted(moves.row, row, side="right"))
        section = self.part.section if row is None else self.part.at(row)
        shown = moves[:count]
        tool = setup.tools[int(shown.tool[-1])] if count and row is not None else None
        tip = tuple(shown.end[-1].tolist()) if count else None
        radius_mm = self.part.stock.region.bounds[3]
        chains = [np.minimum(profile.points, (np.inf, radius_mm)) for profile in setup.wanted]
        scene = TurnedScene(self.part.stock, section, shown, chains, setup.obstacles, tool, tip, setup.x_factor)
        words = ", ".join(setup.tools[number].words for number in np.unique(moves.tool).tolist())
        facts = turned_facts(section, self.part.stock, words, time, len(np.unique(shown.row)))
        save_half_section(file, scene, title, facts)

    def _piece(self, section: HalfSection, move: int) -> dict[str, Any]:
        low, _, high, radius = section.region.bounds
        sizes = {"z_min_mm": low, "z_max_mm": high, "diameter_mm": 2 * radius, "volume_mm3": section.volume_mm3}
        return {name: _number(value) for name, value in sizes.items()} | {
            "falls_at_line": int(self.part.moves.line[move])
        }


def judge_turning(moves: Moves, setup: TurningSetup, x_is: str) -> TurnedVerdict:
    """Return the verdict on the moves of a program, in the part's coordinates."""
    part = turned_part(moves, setup.stock, setup.tools)
    return TurnedVerdict(part, setup, check_turning(part, setup), x_is)


def setup_of(job: TurningJob, file: str = "") -> TurningSetup:
    """Return what a job says of stock, tools, chuck and wanted profiles; file: the program's name in findings."""
    stock = job.stock
    obstacles = {"chuck": chuck_region(stock.length_mm, job.chuck.diameter_mm)}
    if job.chuck.jaw_mm:
        jaws_end = stock.length_mm - job.chuck.jaw_mm
        obstacles["jaws"] = chuck_region(jaws_end, job.chuck.jaw_diameter_mm, job.chuck.jaw_mm)
    if job.tailstock:
        centre = job.tailstock
        obstacles["tailstock"] = tailstock_region(stock.face_mm, centre.diameter_mm, centre.angle_deg, centre.hole_mm)
    return TurningSetup(
        bar(stock.diameter_mm, stock.length_mm, stock.face_mm, stock.bore_mm),
        {number: ToolSection.of(tool, _pitch_mm(job, number)) for number, tool in job.tools.items()},
        obstacles,
        wanted_of(job),
        2.0 if job.x_is == "diameter" else 1.0,
        file,
    )


def _pitch_mm(job: TurningJob, tool: int) -> float:
    """Return the travel a turn with which a tool's feeds follow the spindle, along its way; 0 for none."""
    for operation in job.operation:
        if isinstance(operation, TurnThread) and operation.tool == tool:
            return thread_form(operation).lead_mm / cos(radians(operation.taper_deg))
    return 0.0


def wanted_of(job: TurningJob) -> list[WantedProfile]:
    """Return what the operations of a job are to cut: each profile once, and the regions of the other operations."""
    found = [_of_profile(job, name) for name in job.curves if _cutting(job, name)]
    return found + [one for operation in job.operation if (one := _of_operation(job, operation)) is not None]


def _cutting(job: TurningJob, name: str) -> list[TurnRough | TurnFinish]:
    """Return the operations that cut a profile, in their order."""
    return [one for one in job.operation if isinstance(one, TurnRough | TurnFinish) and one.profile == name]


def _of_profile(job: TurningJob, name: str) -> WantedProfile:
    cutting = _cutting(job, name)
    last = cutting[-1]
    has_steps = isinstance(last, TurnRough) and last.along != "profile"
    return wanted_chain(
        job.curves[name].points(CHORD_MM),
        job.tools[last.tool].is_inside,
        leave_mm=last.stock_to_leave_mm,
        left_mm=last.ap_mm if isinstance(last, TurnRough) and has_steps else 0.0,
        tools=tuple(sorted({one.tool for one in cutting})),
        name=name,
    )


def _of_operation(job: TurningJob, operation: TurningOperation) -> WantedProfile | None:
    """Return what an operation without a profile may cut; None for one with a profile."""
    radius_mm, face_mm = job.stock.diameter_mm / 2, job.stock.face_mm
    if isinstance(operation, TurnFace):
        z, inner = operation.to_z_mm, operation.to_diameter_mm / 2
        ring = wanted_ring((z, face_mm + radius_mm), (inner, FAR_MM))
        return replace(ring, points=np.array([(z, radius_mm), (z, inner)]))
    if isinstance(operation, TurnGroove):
        z = operation.z_mm
        return wanted_ring((z, z + operation.width_mm), (operation.diameter_mm / 2, FAR_MM))
    if isinstance(operation, TurnPart):
        z = operation.z_mm
        return wanted_ring((z - job.tools[operation.tool].width_mm, z), (operation.to_diameter_mm / 2, FAR_MM))
    if isinstance(operation, TurnTaper):
        inside, left_mm = job.tools[operation.tool].is_inside, 0.0 if operation.last_pass_mm else operation.ap_mm
        points = taper_profile(operation, inside).points(CHORD_MM)
        return wanted_chain(points, inside, left_mm=left_mm, tools=(operation.tool,), name=operation.cycle)
    if isinstance(operation, TurnDrill):
        outline = ToolSection.of(job.tools[operation.tool]).cutting_parts[0]
        ends = np.array([(-operation.depth_mm, 0.0), (face_mm + radius_mm, 0.0)])
        region = swept_at(outline, ends)
        return WantedProfile(region, (-operation.depth_mm, face_mm), np.asarray(region.exterior.coords))
    return _of_thread(job, operation) if isinstance(operation, TurnThread) else None


def _of_thread(job: TurningJob, operation: TurnThread) -> WantedProfile:
    """Return what a thread may cut: all above its floor, half a pitch beyond its end for the insert's flank."""
    inside = job.tools[operation.tool].is_inside
    cut = thread_cut(operation, inside, 1.0, job.curves.get(operation.profile))
    ends = np.array([cut.z_start_mm + cut.form.pitch_mm, cut.z_end_mm - cut.form.pitch_mm / 2.0])
    floors = cut.floor_radius_mm + cut.slope * (cut.z_start_mm - ends)
    return wanted_chain(np.column_stack([ends, floors]), inside)


def _points(profile: list[tuple[float, float]]) -> list[list[float]]:
    return [[_number(z), _number(diameter)] for z, diameter in profile]


def _number(value: float) -> float:
    return round(float(value), DECIMALS) + 0.0
