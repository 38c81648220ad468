# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_TurningTool: a lathe's tool with its insert and limits, linked by the operations that use it."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    ANGLE,
    BOOL,
    DISTANCE,
    ENUMERATION,
    FLOAT,
    INTEGER,
    LATHE_JOB,
    TEXT,
    Feature,
    Property,
    entry_of,
    is_job,
    values,
)
from CNCStepper.workbench.services.translation import later

TOOL, CUTTING, INSERT, LIMITS = later("Tool"), later("Cutting"), later("Insert"), later("Lengths and limits")
TURNING, BORING, PARTING, DRILL, THREADING = KINDS = ("turning", "boring", "parting", "drill", "threading")
EDGED = (TURNING, BORING)
WITH_INSERT = (*EDGED, THREADING)
BY_INSERT, BY_ANGLES = "insert", "angles"
OPTIONAL = ("orientation", "nose_radius_mm", "tip_angle_deg")  # of which 0 is that of the insert


def _of(*kinds: str) -> tuple[str, tuple[str, ...]]:
    return "kind", kinds


class TurningTool(Feature):
    """The proxy of a lathe's tool; its keys are those of a job file's `[[tool]]`."""

    Type = "CNCStepper_TurningTool"
    JOB_TYPE = LATHE_JOB
    PROPERTIES = (
        Property("number", "Number", INTEGER, TOOL, later("Number"), later("The T word of the program"), 1),
        Property("kind", "Kind", ENUMERATION, TOOL, later("Kind"), later("What the tool is for"), TURNING,
                 choices=KINDS),
        Property("insert", "Insert", TEXT, INSERT, later("Insert"),
                 later("Its code of ISO 1832, such as CNMG 120408; empty: by its angles"), "CNMG 120408",
                 only=_of(*WITH_INSERT)),
        Property("hand", "Hand", ENUMERATION, INSERT, later("Cutting hand"), later("Right hand cuts towards the chuck"),
                 "right", choices=("right", "left")),
        Property("inside", "Inside", BOOL, INSERT, later("Inside"), later("Whether it works in a bore"), False,
                 only=_of(PARTING, THREADING, TURNING)),
        Property("lead_deg", "LeadAngle", ANGLE, INSERT, later("Entering angle"),
                 later("Between the front edge and the feed, given by the holder"), 95.0, only=_of(*EDGED)),
        Property("edges", "Edges", ENUMERATION, INSERT, later("Edges"),
                 later("Whether their directions are those of insert and holder, or given by two angles"), BY_INSERT,
                 choices=(BY_INSERT, BY_ANGLES), only=_of(*EDGED)),
        Property("front_deg", "FrontAngle", ANGLE, INSERT, later("Front edge"),
                 later("The direction of the front edge away from the nose, from Z+ towards X+"), 85.0,
                 only=("edges", (BY_ANGLES,))),
        Property("back_deg", "BackAngle", ANGLE, INSERT, later("Back edge"),
                 later("The direction of the back edge away from the nose, from Z+ towards X+"), 5.0,
                 only=("edges", (BY_ANGLES,))),
        Property("orientation", "Orientation", INTEGER, INSERT, later("Tip orientation"),
                 later("1 to 9, where the tip lies; 0: by kind and hand"), 0),
        Property("nose_radius_mm", "NoseRadius", DISTANCE, INSERT, later("Nose radius"),
                 later("Of the tip; 0: that of the insert"), 0.0, only=_of(TURNING, BORING, PARTING, THREADING)),
        Property("edge_length_mm", "EdgeLength", DISTANCE, INSERT, later("Edge length"),
                 later("Of the cutting edges; 0: that of the insert"), 0.0, only=_of(*WITH_INSERT)),
        Property("width_mm", "Width", DISTANCE, INSERT, later("Width"), later("Of a parting blade"), 3.0,
                 only=_of(PARTING)),
        Property("diameter_mm", "Diameter", DISTANCE, INSERT, later("Diameter"), later("Of a drill"), 8.0,
                 only=_of(DRILL)),
        Property("point_angle_deg", "PointAngle", ANGLE, INSERT, later("Point angle"),
                 later("Between the two sides of a drill's point"), 118.0, only=_of(DRILL)),
        Property("tip_angle_deg", "TipAngle", ANGLE, INSERT, later("Tip angle"),
                 later("Between the flanks of a threading tool; 0: that of the insert"), 0.0, only=_of(THREADING)),
        Property("feed_mm_rev", "FeedPerTurn", FLOAT, CUTTING, later("Feed per turn"),
                 later("Millimetres a turn of the spindle, where the operation says nothing"), 0.1),
        Property("spindle_rpm", "SpindleSpeed", FLOAT, CUTTING, later("Spindle"),
                 later("Spindle turns a minute; 0: by the surface speed"), 500.0),
        Property("surface_speed_m_min", "SurfaceSpeed", FLOAT, CUTTING, later("Surface speed"),
                 later("Metres a minute at the bar's diameter; 0: not given"), 0.0),
        Property("max_rpm", "MostTurns", FLOAT, CUTTING, later("Fastest spindle"),
                 later("The limit of the surface speed; 0: none"), 0.0),
        Property("ap_max_mm", "GreatestDepth", DISTANCE, LIMITS, later("Greatest depth of cut"),
                 later("What the insert takes, on the radius; 0: not given"), 0.0),
        Property("feed_min_mm_rev", "LeastFeed", FLOAT, LIMITS, later("Least feed"),
                 later("Millimetres a turn that the insert needs; 0: not given"), 0.0),
        Property("feed_max_mm_rev", "GreatestFeed", FLOAT, LIMITS, later("Greatest feed"),
                 later("Millimetres a turn that the insert takes; 0: not given"), 0.0),
        Property("reach_mm", "Reach", DISTANCE, LIMITS, later("Reach"),
                 later("How far a bar or drill gets along Z, a blade along X; 0: not given"), 0.0),
        Property("shank_mm", "Shank", DISTANCE, LIMITS, later("Shank"), later("The width of the holder; 0: not given"),
                 0.0, only=_of(TURNING, PARTING, THREADING)),
        Property("bar_mm", "Bar", DISTANCE, LIMITS, later("Bar"), later("The diameter of a boring bar; 0: not given"),
                 0.0, only=_of(BORING, THREADING)),
        Property("smallest_bore_mm", "SmallestBore", DISTANCE, LIMITS, later("Smallest bore"),
                 later("Into which a boring bar fits; 0: not given"), 0.0, only=_of(BORING, THREADING)),
    )  # fmt: skip

    model: Any = None  # until the object changes

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and show those that a tool of its kind has."""
        super().add_properties(obj)
        self.show_what_counts(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Let one of an older version catch up, and take a copied or pasted one into its job; FreeCAD calls this."""
        super().onDocumentRestored(obj)
        if self.is_copy:
            from CNCStepper.workbench.document.operation_order import take_in

            take_in(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        """Show those values that its kind has; FreeCAD calls this at every change."""
        self.model = None
        if name in ("Kind", "Edges") and "SmallestBore" in obj.PropertiesList:
            self.show_what_counts(obj)
        if name == "Diameter" and "Restore" not in obj.State:
            for job in filter(is_job, obj.InList):  # what goes into its hole depends on it too
                for operation in job.Operations:
                    operation.touch()

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the values that are given: none of other kinds, and no 0 that means "by the insert"."""
        counting = {key: found[key] for key in found if self.counts(entry_of(self, key), found)}
        return {key: value for key, value in counting.items() if key != "edges" and (value or key not in OPTIONAL)}

    def check(self, obj: Any) -> None:
        """Raise JobError that names the value that cannot be."""
        model_of(obj)

    def make(self, obj: Any) -> None:
        """Look whether there is such a tool."""
        model_of(obj)


def model_of(obj: Any) -> Any:
    """Return a tool object as `machine.tools.turning_tool.TurningTool`; raises JobError."""
    packages.require()
    from CNCStepper.machine.profile import validated
    from CNCStepper.machine.tools.turning_tool import TurningTool as Model

    if obj.Proxy.model is None:
        obj.Proxy.model = validated(Model, obj.Proxy.given(values(obj)), obj.Label)
    return obj.Proxy.model


def keys_of(model: Any) -> dict[str, Any]:
    """Return the values by key of the object of a core's tool; edges of which one is given are given both."""
    found = model.model_dump(exclude_none=True)
    if model.front_deg is not None or model.back_deg is not None:
        front_deg, back_deg = model.edges_deg
        found |= {"edges": BY_ANGLES}
        found |= {"front_deg": model.front_deg if model.front_deg is not None else front_deg}
        found |= {"back_deg": model.back_deg if model.back_deg is not None else back_deg}
    return found
