# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Threads on a lathe: passes that follow the spindle, each deeper than the one before, as LinuxCNC's G76 makes them.

    drive line  ----------------------------------------------------------  begin of start k: k pitches farther out
                                                          clearance
    crest       ===============================================
                   \_ pull-out ____ pass n: depth J n^(1/R) __|...approach   R = 2: every pass takes the same area
                 z_end                                       z_start

Infeed: radial goes straight in; flank along one side of the groove; alternating from side to side. Where the tool is
not yet deep, it may stand (depth - d) tan(angle) beside the middle. A taper moves crest and floor along Z: `slope` is
the radius gained a mm towards the chuck. z = 0 is the end face.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, radians, tan
from typing import Literal, Protocol

from CNCStepper.cycles.turning.thread_standards import Side, ThreadForm
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.step_wait_tables import PULL_OUT_TICK_S

Infeed = Literal["radial", "flank", "alternating"]
MOST_PASSES = 500
GRID_MM = 0.0001  # of the first depth, so that the words of G76 hold it
ROUNDING_MM = 1e-6
MOST_LEAD_ERROR = 0.001  # of the lead, of a timer that knows whole ticks


@dataclass(frozen=True)
class ThreadCut:
    """A thread to be cut, in mm and deg.

    crest_radius_mm, floor_radius_mm: at z_start_mm. slope: radius gained a mm towards the chuck. first_depth_mm: of
    the first pass at most. degression: R of G76. spring: passes at the full depth besides the last.
    """

    form: ThreadForm
    side: Side
    crest_radius_mm: float
    floor_radius_mm: float
    z_start_mm: float
    z_end_mm: float
    rpm: float
    approach_mm: float
    clearance_mm: float
    first_depth_mm: float
    infeed: Infeed = "radial"
    infeed_deg: float = 0.0
    degression: float = 2.0
    spring: int = 1
    pull_out_mm: float = 0.0
    slope: float = 0.0

    @property
    def depth_mm(self) -> float:
        """Of the groove, on the radius."""
        return abs(self.crest_radius_mm - self.floor_radius_mm)

    @property
    def way(self) -> float:
        """The sense of X into the material."""
        return -1.0 if self.side == "outside" else 1.0

    @property
    def drive_radius_mm(self) -> float:
        """Where the tool is clear of the thread's crest, from end to end."""
        crests = (self.crest_radius_mm, self.crest_at_mm(self.z_end_mm))
        return (max(crests) if self.side == "outside" else min(crests)) - self.way * self.clearance_mm

    @property
    def feed_mm_min(self) -> float:
        """Along Z."""
        return self.form.lead_mm * self.rpm

    @property
    def slide(self) -> float:
        """Z beside the middle of the groove a mm that is still to be cut."""
        return 0.0 if self.infeed == "radial" else tan(radians(self.infeed_deg))

    @property
    def is_g76(self) -> bool:
        """Whether LinuxCNC's G76 can express it."""
        return self.slope == 0.0 and self.infeed != "alternating"

    def crest_at_mm(self, z_mm: float) -> float:
        """Return the crest's radius at a Z."""
        return self.crest_radius_mm + self.slope * (self.z_start_mm - z_mm)

    def begin_z_mm(self, start: int) -> float:
        """Return where start `start`, counted from 0, begins."""
        return self.z_start_mm + self.approach_mm + start * self.form.pitch_mm

    @property
    def first_mm(self) -> float:
        """J of G76: the first depth with which the last pass just reaches the whole one, on the grid."""
        count = max(1, ceil((self.depth_mm / self.first_depth_mm) ** self.degression - 1e-9))
        return min(ceil(self.depth_mm / count ** (1.0 / self.degression) / GRID_MM - 1e-9) * GRID_MM, self.depth_mm)

    def depths_mm(self) -> list[float]:
        """Return the depths of all passes, those without a cut at the end too; raises CycleError for too many."""
        first, found, count = self.first_mm, list[float](), 1
        while (depth := first * count ** (1.0 / self.degression)) < self.depth_mm - ROUNDING_MM:
            found.append(depth)
            count += 1
            if count > MOST_PASSES:
                least = self.depth_mm / MOST_PASSES ** (1.0 / self.degression)
                raise CycleError(
                    "passes-many",
                    "the thread takes too many passes",
                    value=f"{self.first_depth_mm:g} mm",
                    limit=f"{least:.3g} mm",
                    advice="raise first_depth_mm",
                )
        return [*found, *[self.depth_mm] * (self.spring + 1)]


class SpindleMoves(Protocol):
    """What makes the rows; places are those of the tool's control point, z and radius in the part's coordinates."""

    def rapid_tip(self, z_mm: float, r_mm: float) -> None:
        """Rapid to a place."""

    def thread_tip(self, z_mm: float, r_mm: float, lead_mm: float, rpm: float) -> None:
        """Cut straight to a place; Z follows the spindle by `lead_mm` a turn."""

    def open_cycle(self, name: str, words: dict[str, float]) -> None:
        """Begin the span of a cycle."""

    def close_cycle(self) -> None:
        """End it."""


def add_thread(cut: ThreadCut, moves: SpindleMoves) -> None:
    """Append the rows of a thread, which end where they begin: beside the thread, in front of it."""
    for start in range(cut.form.starts):
        begin_z_mm = cut.begin_z_mm(start)
        moves.rapid_tip(begin_z_mm, cut.drive_radius_mm)
        moves.open_cycle("G76" if cut.is_g76 else "G33", _words(cut))
        for number, depth_mm in enumerate(cut.depths_mm()):
            _pass(cut, moves, depth_mm, number, begin_z_mm)
        moves.close_cycle()
    moves.rapid_tip(cut.begin_z_mm(0), cut.drive_radius_mm)


def _pass(cut: ThreadCut, moves: SpindleMoves, depth_mm: float, number: int, begin_z_mm: float) -> None:
    """Add one pass: beside the thread, in, along, out."""
    left_mm = cut.depth_mm - depth_mm
    side = -1.0 if cut.infeed == "alternating" and number % 2 else 1.0
    beside_mm = left_mm * cut.slide * side
    top_mm = begin_z_mm + beside_mm - (cut.depth_mm * cut.slide if cut.is_g76 else 0.0)
    end_mm = cut.z_end_mm + beside_mm
    aside = cut.drive_radius_mm - cut.way * left_mm
    moves.rapid_tip(top_mm, aside)
    moves.rapid_tip(top_mm, cut.crest_at_mm(top_mm) + cut.way * depth_mm)
    turn_mm = end_mm + cut.pull_out_mm
    moves.thread_tip(turn_mm, cut.crest_at_mm(turn_mm) + cut.way * depth_mm, cut.form.lead_mm, cut.rpm)
    if cut.pull_out_mm:
        moves.thread_tip(end_mm, cut.crest_at_mm(end_mm) - cut.way * left_mm, cut.form.lead_mm, cut.rpm)
    moves.rapid_tip(end_mm, aside)


def _words(cut: ThreadCut) -> dict[str, float]:
    """Return the words of G76 as LinuxCNC takes them, radii and mm; empty where it cannot express the thread."""
    if not cut.is_g76:
        return {}
    words = {
        "P": cut.form.lead_mm,
        "Z": cut.z_end_mm,
        "I": cut.crest_radius_mm - cut.drive_radius_mm,
        "J": cut.first_mm,
        "K": cut.depth_mm,
        "R": cut.degression,
        "Q": cut.infeed_deg if cut.infeed == "flank" else 0.0,
        "H": float(cut.spring),
    }
    return {**words, "E": cut.pull_out_mm, "L": 2.0} if cut.pull_out_mm else words


# -- what cannot be cut ------------------------------------------------------------------------------


def check_thread(cut: ThreadCut, machine: Machine) -> None:
    """Raise CycleError, with the number that would do, for a thread that the machine or the model cannot have."""
    length_mm = cut.z_start_mm - cut.z_end_mm
    if length_mm <= cut.pull_out_mm:
        what = "the thread is not longer than its pull-out"
        limit = Text("above {least:g} mm", least=cut.pull_out_mm)
        raise CycleError("thread-length", what, value=f"{length_mm:g} mm", limit=limit, advice="lengthen the thread")
    if not cut.depth_mm > 0.0 or (cut.floor_radius_mm - cut.crest_radius_mm) * cut.way <= 0.0:
        what = "the crest of the thread lies below its floor"
        needs = "above {floor:.3f} mm" if cut.side == "outside" else "below {floor:.3f} mm"
        limit = Text(needs, floor=2 * cut.floor_radius_mm)
        value = f"{2 * cut.crest_radius_mm:.3f} mm"
        raise CycleError("thread-crest", what, value=value, limit=limit, advice="correct diameter_mm")
    if min(cut.floor_radius_mm, cut.floor_radius_mm + cut.slope * length_mm) <= 0.0:
        what = "the floor of the thread crosses the axis"
        value = f"{2 * cut.floor_radius_mm:.3f} mm"
        raise CycleError("thread-axis", what, value=value, limit="above 0 mm", advice="lower taper_deg or its length")
    _check_rates(cut, machine)


def _check_rates(cut: ThreadCut, machine: Machine) -> None:
    """Raise CycleError where an axis cannot follow the spindle."""
    rates = {name: axis.max_rate_mm_min for name, axis in machine.own_axes.items()}
    rise = max(abs(cut.slope), cut.depth_mm / cut.pull_out_mm if cut.pull_out_mm else 0.0)
    for name, speed in (("z", cut.feed_mm_min), ("x", cut.feed_mm_min * rise)):
        if speed > rates[name] * (1.0 + 1e-9):
            most = rates[name] / speed * cut.rpm
            raise CycleError(
                "thread-speed",
                Text(
                    "lead times speed is more than axis {axis} can: {lead:.4g} mm at {rpm:.4g} rpm",
                    axis=name.upper(),
                    lead=cut.form.lead_mm,
                    rpm=cut.rpm,
                ),
                value=f"{speed:.0f} mm/min",
                limit=f"{rates[name]:.0f} mm/min",
                advice=Text("turn with at most {most:.4g} rpm", most=most),
            )


def check_cylinder(cut: ThreadCut, profile: Curve) -> None:
    """Raise CycleError where the thread leaves the cylinder or cone of its crest in a profile of (z, r).

    Segments belong to it whose ends are within half the thread's depth of the crest.
    """
    parts = []
    for (z_from, r_from), (z_to, r_to), bulge in zip(profile.xy[:-1], profile.xy[1:], profile.bulge, strict=True):
        off = max(abs(r_from - cut.crest_at_mm(z_from)), abs(r_to - cut.crest_at_mm(z_to)))
        if bulge == 0.0 and z_from != z_to and off <= cut.depth_mm / 2.0:
            parts.append((min(z_from, z_to), max(z_from, z_to)))
    low = high = cut.z_start_mm
    for z_low, z_high in sorted(parts, reverse=True):
        if z_high >= low - ROUNDING_MM and z_low < low:
            low, high = z_low, max(high, z_high)
    if cut.z_end_mm < low - ROUNDING_MM:
        raise CycleError(
            "thread-cylinder",
            Text(
                "the thread is longer than its cylinder of {diameter:.4g} mm",
                diameter=2.0 * cut.crest_radius_mm,
            ),
            value=f"{cut.z_start_mm - cut.z_end_mm:.4g} mm",
            limit=f"{cut.z_start_mm - low:.4g} mm",
            advice=Text("write length_mm = {length:.4g}, or lengthen the cylinder", length=cut.z_start_mm - low),
        )


def timer_warnings(cut: ThreadCut, machine: Machine) -> tuple[str, ...]:
    """Return a warning where the whole ticks of a mini-lathe's timer make another lead."""
    if machine.link is None:
        return ()
    steps_s = cut.feed_mm_min / 60.0 * machine.own_axes["z"].steps_per_mm
    ticks = max(1, round(1.0 / (steps_s * PULL_OUT_TICK_S)))
    lead_mm = cut.form.lead_mm / (ticks * PULL_OUT_TICK_S * steps_s)
    if abs(lead_mm / cut.form.lead_mm - 1.0) <= MOST_LEAD_ERROR:
        return ()
    what = (
        "the lathe's timer makes a lead of {lead:.4f} mm, not {wanted:.4f} mm: over the thread {off:.3f} mm; "
        "at {rpm:.2f} rpm it is right"
    )
    off_mm = abs(lead_mm / cut.form.lead_mm - 1.0) * (cut.z_start_mm - cut.z_end_mm)
    right_rpm = cut.rpm * lead_mm / cut.form.lead_mm
    return (Text(what, lead=lead_mm, wanted=cut.form.lead_mm, off=off_mm, rpm=right_rpm),)
