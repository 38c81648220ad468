# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Standard threads by their designations: angle, pitch, starts, diameters and fits; the table is thread_table.toml.

    M20x2.5   M20   M20x1.5-LH   1/2-13 UNC   1/4-28 UNF   #10-24 UNC   3/8-16 BSW   G1/2   Tr20x4   Tr40x14P7

            |<- P ->|          metric, UN   60°   depth outside 0.61343 P    inside 0.54127 P    d2 = d - 0.64952 P
        ____         ____      Whitworth    55°   0.64033 P on both sides                        d2 = d - 0.64033 P
    d  /    \       /    \     trapezoidal  30°   outside 0.5 P + a_c        inside 0.5 P + a_c  d2 = d - 0.5 P
      /      \_____/      \                       (an inner one ends at d + 2 a_c)

The pitch diameter's tolerances come from the formulas of ISO 965-1 and ASME B1.1, before these round them.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from importlib import resources
from itertools import pairwise
from math import sqrt
from typing import Any, Literal

from CNCStepper.errors import JobError, Text
from CNCStepper.units import MM_PER_INCH

Side = Literal["outside", "inside"]
Standard = Literal["metric", "unified", "whitworth", "trapezoidal"]
ANGLES_DEG: dict[Standard, float] = {"metric": 60.0, "unified": 60.0, "whitworth": 55.0, "trapezoidal": 30.0}
DEPTH_60 = {"outside": 0.61343, "inside": 0.54127}  # of the pitch
PITCH_LINE_60 = 0.64952
DEPTH_55 = 0.640327
DIAMETER_RANGES_MM = (0.99, 1.4, 2.8, 5.6, 11.2, 22.4, 45.0, 90.0, 180.0, 355.0)  # of ISO 965-1
INNER_SHARE = 1.32  # tolerance of an inner pitch diameter by that of an outer one, of ISO 965-1
GRADE_7 = 1.25  # by grade 6
MOST_FINE_MM = 1.5  # the fine pitch of most diameters above 14 mm
_METRIC = re.compile(r"M(\d+(?:\.\d+)?)(?:x(\d+(?:\.\d+)?))?")
_INCH = re.compile(r"(#\d+|\d+(?: \d+/\d+)?|\d+/\d+)-(\d+(?:\.\d+)?) ?(UNC|UNF|BSW)")
_PIPE = re.compile(r"G ?(\d+(?: \d+/\d+)?|\d+/\d+)")
_TRAPEZOIDAL = re.compile(r"Tr(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)(?:\(?P(\d+(?:\.\d+)?)\)?)?")


@dataclass(frozen=True)
class Fit:
    """Limits of an outer or inner thread in mm: of its crest (the surface turned before), and of its pitch diameter."""

    name: str
    crest_mm: tuple[float, float]
    pitch_line_mm: tuple[float, float]


@dataclass(frozen=True)
class ThreadForm:
    """One thread; pitch_mm: between neighbouring grooves, lead_mm: a turn. clearance_mm: a_c of a trapezoidal one."""

    designation: str
    standard: Standard
    major_mm: float
    pitch_mm: float
    starts: int = 1
    left: bool = False
    clearance_mm: float = 0.0

    @property
    def lead_mm(self) -> float:
        """The travel a turn."""
        return self.pitch_mm * self.starts

    @property
    def angle_deg(self) -> float:
        """Between the flanks."""
        return ANGLES_DEG[self.standard]

    @property
    def pitch_line_mm(self) -> float:
        """The basic pitch diameter d2."""
        share = {"whitworth": DEPTH_55, "trapezoidal": 0.5}.get(self.standard, PITCH_LINE_60)
        return self.major_mm - share * self.pitch_mm

    def depth_mm(self, side: Side) -> float:
        """Return the depth of the groove below the crest, on the radius."""
        if self.standard == "trapezoidal":
            return 0.5 * self.pitch_mm + self.clearance_mm
        return (DEPTH_55 if self.standard == "whitworth" else DEPTH_60[side]) * self.pitch_mm

    def crest_mm(self, side: Side) -> float:
        """Return the basic diameter of the surface into which the groove is cut."""
        if side == "outside":
            return self.major_mm
        if self.standard == "trapezoidal":
            return self.major_mm - self.pitch_mm
        return self.major_mm - 2.0 * self.depth_mm(side)

    def root_mm(self, side: Side) -> float:
        """Return the basic diameter of the groove's floor."""
        way = -2.0 if side == "outside" else 2.0
        return self.crest_mm(side) + way * self.depth_mm(side)

    def fit(self, side: Side) -> Fit:
        """Return the limits of the usual fit: 6g 6H, 2A 2B, 7e 7H; of a Whitworth thread the basic sizes alone."""
        name, shift, crest, line = _FITS[self.standard](self, side)
        way = -1.0 if side == "outside" else 1.0
        limits = [
            tuple(sorted((size + way * shift_mm, size + way * (shift_mm + tolerance))))
            for size, shift_mm, tolerance in (
                (self.crest_mm(side), 0.0 if self.standard == "trapezoidal" else shift, crest),
                (self.pitch_line_mm, shift, line),
            )
        ]
        return Fit(name, limits[0], limits[1])  # type: ignore[arg-type]

    def floor_mm(self, side: Side) -> float:
        """Return the diameter of the floor with which the pitch diameter comes to the middle of the fit."""
        low, high = self.fit(side).pitch_line_mm
        return self.root_mm(side) + (low + high) / 2.0 - self.pitch_line_mm


def thread_named(designation: str) -> ThreadForm:
    """Return the thread of a designation; raises JobError that says which there are."""
    text = " ".join(designation.strip().split())
    left = text.upper().endswith("LH")
    body = text[:-2].rstrip(" -") if left else text
    for pattern, reader in ((_METRIC, _metric), (_INCH, _inch), (_PIPE, _pipe), (_TRAPEZOIDAL, _trapezoidal)):
        if found := pattern.fullmatch(body):
            return reader(text, left, *found.groups())
    raise JobError(
        "thread-unknown",
        Text("'{designation}' is no designation of a thread", designation=text[:60]),
        advice="write one such as M20x2.5, M20, 1/2-13 UNC, 1/4-28 UNF, 3/8-16 BSW, G1/2, Tr20x4 or Tr40x14P7",
    )


@cache
def thread_table() -> dict[str, Any]:
    """Return the table as it was read."""
    return tomllib.loads((resources.files("CNCStepper.cycles.turning") / "thread_table.toml").read_text("utf-8"))


def _metric(text: str, left: bool, diameter: str, pitch: str | None) -> ThreadForm:
    coarse = {float(row[0]): float(row[1]) for row in thread_table()["metric"]["coarse"]}
    if pitch is None and float(diameter) not in coarse:
        raise _no_coarse_pitch(text, diameter, left)
    used = float(pitch) if pitch else coarse[float(diameter)]
    _row("metric", "tolerances", used, text)
    return _deep_enough(ThreadForm(text, "metric", float(diameter), used, left=left))


def _no_coarse_pitch(text: str, diameter: str, left: bool) -> JobError:
    """Return the refusal of a metric thread without its pitch; its advice has a fine one of ISO 261's usual series."""
    finest, *rest = sorted(float(row[0]) for row in thread_table()["metric"]["tolerances"])
    fine = max([finest, *(pitch for pitch in rest if pitch <= min(float(diameter) / 10.0, MOST_FINE_MM))])
    what = Text("the thread '{text}' is not in the table of coarse pitches", text=text)
    example = f"M{diameter}x{fine:g}{' LH' if left else ''}"
    return JobError("thread-unknown", what, advice=Text("write its pitch too, such as {example}", example=example))


def _inch(text: str, left: bool, size: str, per_inch: str, series: str) -> ThreadForm:
    standard: Standard = "whitworth" if series == "BSW" else "unified"
    rows = thread_table()[standard][series.lower()]
    if [size, float(per_inch)] not in [[row[0], float(row[1])] for row in rows]:
        raise _refusal(text, ", ".join(f"{row[0]}-{row[1]:g}" for row in rows) + f" {series}")
    return ThreadForm(text, standard, _inches(size) * MM_PER_INCH, MM_PER_INCH / float(per_inch), left=left)


def _pipe(text: str, left: bool, size: str) -> ThreadForm:
    rows = {row[0]: row for row in thread_table()["whitworth"]["g"]}
    if size not in rows:
        raise _refusal(text, "G" + ", G".join(rows))
    return ThreadForm(text, "whitworth", float(rows[size][1]), MM_PER_INCH / float(rows[size][2]), left=left)


def _trapezoidal(text: str, left: bool, diameter: str, lead: str, pitch: str | None) -> ThreadForm:
    rows = {float(row[0]): [float(one) for one in row[1:]] for row in thread_table()["trapezoidal"]["pitches"]}
    used = float(pitch or lead)
    starts = float(lead) / used
    if float(diameter) not in rows:
        raise _refusal(text, "Tr" + ", Tr".join(f"{size:g}" for size in rows))
    if used not in rows[float(diameter)]:
        raise _refusal(text, ", ".join(f"Tr{diameter}x{one:g}" for one in rows[float(diameter)]))
    if starts != round(starts):
        limit = f"Tr{diameter}x{max(1, round(starts)) * used:g}P{used:g}"
        what = Text("the lead of '{text}' is no whole number of pitches", text=text)
        raise JobError("thread-starts", what, limit=limit, advice="write a lead that is")
    clearance = _row("trapezoidal", "rows", used, text)[1]
    return ThreadForm(text, "trapezoidal", float(diameter), used, round(starts), left, clearance)


def _deep_enough(form: ThreadForm) -> ThreadForm:
    """Return the thread; raises JobError where its grooves would reach the axis."""
    if form.pitch_mm * 3.0 > form.major_mm:
        what = Text("the pitch of '{designation}' is too coarse for its diameter", designation=form.designation)
        raise JobError("thread-pitch", what, limit=f"{form.major_mm / 3.0:.3g} mm", advice="write a finer pitch")
    return form


def _row(standard: str, key: str, pitch_mm: float, text: str) -> list[float]:
    """Return the table's row of a pitch; raises JobError that names the pitches there are."""
    rows = thread_table()[standard][key]
    for row in rows:
        if float(row[0]) == pitch_mm:
            return [float(one) for one in row]
    raise _refusal(text, ", ".join(f"{row[0]:g}" for row in rows) + " mm")


def _refusal(text: str, known: str) -> JobError:
    what = Text("the thread '{text}' is not in the table", text=text)
    return JobError("thread-unknown", what, advice=Text("use one of: {known}", known=known))


def _inches(size: str) -> float:
    if size.startswith("#"):
        return 0.060 + 0.013 * int(size[1:])
    return float(sum(Fraction(part) for part in size.split()))


def _range_mean_mm(diameter_mm: float) -> float:
    """Return the geometric mean of the standard's range in which a diameter lies."""
    for low, high in pairwise(DIAMETER_RANGES_MM):
        if diameter_mm <= high:
            return sqrt(low * high)
    return diameter_mm


def _iso_line_mm(form: ThreadForm, side: Side) -> float:
    """Return the tolerance of the pitch diameter, grade 6."""
    tolerance = 0.090 * form.pitch_mm**0.4 * _range_mean_mm(form.major_mm) ** 0.1
    return tolerance * (INNER_SHARE if side == "inside" else 1.0)


def _metric_fit(form: ThreadForm, side: Side) -> tuple[str, float, float, float]:
    """Return name, shift, tolerance of the crest and of the pitch diameter, in mm; so do the others."""
    _, shift, outer, inner = _row("metric", "tolerances", form.pitch_mm, form.designation)
    if side == "inside":
        return "6H", 0.0, inner / 1000.0, _iso_line_mm(form, side)
    return "6g", shift / 1000.0, outer / 1000.0, _iso_line_mm(form, side)


def _unified_fit(form: ThreadForm, side: Side) -> tuple[str, float, float, float]:
    diameter, pitch = form.major_mm / MM_PER_INCH, form.pitch_mm / MM_PER_INCH
    line = 0.0015 * diameter ** (1 / 3) + 0.0015 * sqrt(diameter) + 0.015 * pitch ** (2 / 3)
    if side == "outside":
        outer = 0.060 * pitch ** (2 / 3)
        return "2A", 0.3 * line * MM_PER_INCH, outer * MM_PER_INCH, line * MM_PER_INCH
    inner = 0.25 * pitch - 0.4 * pitch**2
    return "2B", 0.0, inner * MM_PER_INCH, 1.3 * line * MM_PER_INCH


def _trapezoidal_fit(form: ThreadForm, side: Side) -> tuple[str, float, float, float]:
    _, _, shift, outer, inner = _row("trapezoidal", "rows", form.pitch_mm, form.designation)
    line = GRADE_7 * _iso_line_mm(form, side)
    return ("7H", 0.0, inner / 1000.0, line) if side == "inside" else ("7e", shift / 1000.0, outer / 1000.0, line)


def _basic_fit(form: ThreadForm, side: Side) -> tuple[str, float, float, float]:
    return "basic", 0.0, 0.0, 0.0


_FITS = {
    "metric": _metric_fit,
    "unified": _unified_fit,
    "whitworth": _basic_fit,
    "trapezoidal": _trapezoidal_fit,
}
