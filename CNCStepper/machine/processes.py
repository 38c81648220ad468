# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutting processes as data: when the tool has power, how it enters, what a rapid may do, what holds the checks.

process      tool      power       entry    a rapid over the sheet        may stand with power
milling      any mill  operation   plunge   above the stock               any time
plasma       jet       contour     pierce   without power                 no longer than the pierce delay
oxyfuel      jet       contour     pierce   without power                 no longer than preheat and pierce
laser        jet       contour     pierce   without power                 no longer than the pierce delay
waterjet     jet       contour     pierce   without power                 no longer than the pierce delay
hot-wire     wire      always      edge     never: the wire would cut     a few seconds, then it melts a hole
drag-knife   knife     none        lower    with the knife lifted         any time
scribe       point     none        lower    with the point lifted         any time
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.tools.tool_shapes import Shape

ProcessName = Literal["milling", "plasma", "oxyfuel", "laser", "waterjet", "hot-wire", "drag-knife", "scribe"]
Power = Literal["operation", "contour", "always", "none"]
Entry = Literal["plunge", "pierce", "edge", "lower"]
Rapid = Literal["above", "unpowered", "never", "lifted"]


@dataclass(frozen=True)
class Process:
    """One way to cut.

    shapes: of the tools it cuts with. power: "operation" (a spindle, on for a whole operation), "contour" (on only
    while a contour is cut), "always" (a hot wire, from the program's begin to its end), "none" (nothing is switched).
    entry: "plunge" (down into the stock), "pierce" (power on over scrap, a delay, then the lead-in), "edge" (from
    outside the sheet), "lower" (Z down on the line). rapid: where rapids are safe: "above" the stock, "unpowered"
    anywhere, "never" inside the sheet's outline, "lifted". cuts_through: it cuts the whole thickness at any height.
    stand_s: how long the tool may stand still with power beyond its pierce; infinite where that does no harm.
    pause_power: what an M0 means: the power is "kept", must be "off" before it, or stands "limited" to stand_s.
    run_up_mm: how far behind an interruption it is pierced again, in its own kerf.
    tips_parts: a part that is cut free may tip up and be hit. uses_chart: speeds and kerf come from a cut chart.
    passes: a contour may be cut in several passes, each of which begins where the one before did.
    """

    name: ProcessName
    title: str
    shapes: tuple[Shape, ...]
    power: Power
    entry: Entry
    rapid: Rapid
    cuts_through: bool
    stand_s: float
    pause_power: Literal["kept", "off", "limited"]
    tips_parts: bool = False
    uses_chart: bool = True
    run_up_mm: float = 0.0
    passes: bool = False

    @property
    def is_thermal(self) -> bool:
        """Whether a beam or wire cuts, so that the kerf and not a cutter's diameter counts."""
        return self.cuts_through


_MILLS: tuple[Shape, ...] = ("flat", "ball", "bullnose", "v", "drill", "engraver")
_JET: tuple[Shape, ...] = ("jet",)

PROCESSES: dict[str, Process] = {
    one.name: one
    for one in (
        Process("milling", "Milling", _MILLS, "operation", "plunge", "above", False, math.inf, "kept", False, False),
        Process("plasma", "Plasma", _JET, "contour", "pierce", "unpowered", True, 0.0, "off", True, run_up_mm=3.0),
        Process("oxyfuel", "Oxyfuel", _JET, "contour", "pierce", "unpowered", True, 0.0, "off", True, run_up_mm=5.0),
        Process("laser", "Laser", _JET, "contour", "pierce", "unpowered", True, 0.0, "off", True, passes=True),
        Process("waterjet", "Water jet", _JET, "contour", "pierce", "unpowered", True, 0.0, "off", True, run_up_mm=3.0),
        Process("hot-wire", "Hot wire", ("wire",), "always", "edge", "never", True, 2.0, "limited"),
        Process("drag-knife", "Drag knife", ("engraver",), "none", "lower", "lifted", False, math.inf, "kept"),
        Process("scribe", "Scribe", ("engraver", "v"), "none", "lower", "lifted", False, math.inf, "kept"),
    )
}
MILLING = PROCESSES["milling"]
TURNING = "turning"  # of a lathe's jobs, which have a model of their own: job/turning


def is_turning(content: Any) -> bool:
    """Return whether the content of a job file is a lathe's."""
    return isinstance(content, dict) and content.get("process") == TURNING


def process_named(name: str) -> Process:
    """Return the process of that name; raises JobError that names those there are."""
    if name == TURNING:
        what, advice = "this is the job of a lathe, not of a table", "make and prove it with `cncstepper run`"
        raise JobError("process-turning", what, advice=advice)
    if name not in PROCESSES:
        raise JobError(
            "process-unknown",
            Text("there is no process '{name}'", name=name[:60]),
            advice=Text("use one of: {processes}", processes=", ".join(PROCESSES)),
        )
    return PROCESSES[name]
