# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Tool: a cutter with its limits, linked by the operations that use it."""

from __future__ import annotations

from typing import Any

from CNCStepper.job.request_digest import Content
from CNCStepper.machine.processes import MILLING, PROCESSES
from CNCStepper.machine.tools.tool_shapes import SHAPES, foreign_keys
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    ANGLE,
    BOOL,
    DISTANCE,
    ENUMERATION,
    FLOAT,
    HIDDEN,
    INTEGER,
    JOB,
    SPEED,
    Feature,
    Property,
    proxy_type,
    set_value,
    show,
    value_of,
    values,
)
from CNCStepper.workbench.services.translation import later

TOOL, CUTTING, FORM, LIMITS = later("Tool"), later("Cutting"), later("Tip"), later("Lengths and limits")
USED = later("In the program")


class Tool(Feature):
    """The proxy of a tool; its keys are those of a job file's `[[tool]]`."""

    Type = "CNCStepper_Tool"
    WHY_FIXED = later("A tool of this shape has none")
    PROPERTIES = (
        Property("number", "Number", INTEGER, TOOL, later("Number"), later("The T word of the program"), 1),
        Property("shape", "ToolShape", ENUMERATION, TOOL, later("Shape"), later("The form of the cutter"), "flat",
                 choices=SHAPES),
        Property("from_chart", "FromChart", BOOL, TOOL, later("From chart"),
                 later("Whether form, kerf and feeds are those of the job's cut chart"), False),
        Property("diameter_mm", "Diameter", DISTANCE, TOOL, later("Diameter"), later("The diameter of the cutter"),
                 6.0),
        Property("feed_mm_min", "Feed", SPEED, CUTTING, later("Feed"),
                 later("The speed of cutting moves; 0: that of the job's material"), 800.0),
        Property("plunge_mm_min", "Plunge", SPEED, CUTTING, later("Plunge feed"),
                 later("The speed straight down; 0: that of the job's material"), 200.0),
        Property("spindle_rpm", "SpindleSpeed", FLOAT, CUTTING, later("Spindle"),
                 later("Spindle turns a minute; 0: those of the job's material"), 10000.0),
        Property("made_of", "MadeOf", ENUMERATION, CUTTING, later("Made of"), later("Material of the cutter"),
                 "carbide", choices=("carbide", "hss")),
        Property("corner_radius_mm", "CornerRadius", DISTANCE, FORM, later("Corner radius"),
                 later("Of a bull nose; 0: not given"), 0.0),
        Property("tip_diameter_mm", "TipDiameter", DISTANCE, FORM, later("Tip diameter"),
                 later("The flat at the tip of a V-bit or engraver; 0: it is pointed"), 0.0),
        Property("tip_angle_deg", "TipAngle", ANGLE, FORM, later("Tip angle"),
                 later("Between the two sides of a V-bit or engraver; 0: not given"), 0.0),
        Property("point_angle_deg", "PointAngle", ANGLE, FORM, later("Point angle"),
                 later("Between the two sides of a drill's point; 0: not given"), 0.0),
        Property("taper_deg", "Taper", ANGLE, FORM, later("Taper"),
                 later("Of one wall that a jet or wire leaves, against the vertical; 0: none"), 0.0),
        Property("core_diameter_mm", "CoreDiameter", DISTANCE, FORM, later("Core diameter"),
                 later("The middle of a mill's end that does not cut; 0: it cuts over its centre"), 0.0),
        Property("flute_length_mm", "FluteLength", DISTANCE, LIMITS, later("Flute length"),
                 later("The length of the cutting edges; 0: not given"), 0.0),
        Property("length_mm", "Length", DISTANCE, LIMITS, later("Free length"),
                 later("From the tip to the holder; 0: not given"), 0.0),
        Property("length_offset_mm", "LengthOffset", DISTANCE, LIMITS, later("Length offset"),
                 later("Length that the controller adds to Z, if the machine uses a table of lengths; 0: not given"),
                 0.0),
        Property("holder_diameter_mm", "HolderDiameter", DISTANCE, LIMITS, later("Holder diameter"),
                 later("The diameter of the tool holder; 0: not given"), 0.0),
        Property("ramp_max_deg", "RampMax", ANGLE, LIMITS, later("Steepest ramp"),
                 later("For a mill that does not cut over its centre; 0: 10°"), 0.0),
        Property("flutes", "Flutes", INTEGER, LIMITS, later("Flutes"), later("How many teeth; 0: not given"), 0),
        Property("chip_load_min_mm", "ChipLoadMin", DISTANCE, LIMITS, later("Least chip load"),
                 later("The thinnest chip of a tooth, below which it rubs; 0: not given"), 0.0),
        Property("chip_load_max_mm", "ChipLoadMax", DISTANCE, LIMITS, later("Greatest chip load"),
                 later("The thickest chip that a tooth bears; 0: not given"), 0.0),
        Property("engagement_max_deg", "EngagementMax", ANGLE, LIMITS, later("Greatest engagement"),
                 later("How much of the rim may be in the material, as an angle; 0: not given"), 0.0),
        Property("used_feed_mm_min", "FeedUsed", SPEED, USED, later("Feed"),
                 later("The feed of the program"), 0.0, output=True),
        Property("used_plunge_mm_min", "PlungeUsed", SPEED, USED, later("Plunge feed"),
                 later("The plunge feed of the program"), 0.0, output=True),
        Property("used_spindle_rpm", "SpindleUsed", FLOAT, USED, later("Spindle"),
                 later("The spindle's speed in the program"), 0.0, output=True),
    )  # fmt: skip

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and let only those be typed that a tool of its shape has."""
        super().add_properties(obj)
        _fix_foreign(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Let one of an older version catch up, and take a copied or pasted one into its job; FreeCAD calls this."""
        super().onDocumentRestored(obj)
        if self.is_copy:
            from CNCStepper.workbench.document.operation_order import take_in

            take_in(obj)

    model: Any = None  # until the object changes
    content: Content | None = None  # the model as plain data
    chart_keys: dict[str, Any] | None = None  # of the chart's row that the model was made from

    def onChanged(self, obj: Any, name: str) -> None:
        """Let only those values be typed that the shape has; FreeCAD calls this at every change."""
        self.model = self.content = None
        if name in ("ToolShape", "FromChart") and "EngagementMax" in obj.PropertiesList:
            _fix_foreign(obj)

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the values that are given: no 0 that means "not given", and nothing of other shapes."""
        foreign = {"from_chart", *foreign_keys(found["shape"])}
        return {key: value for key, value in found.items() if key not in foreign and (value or key not in OPTIONAL)}

    def check(self, obj: Any) -> None:
        """Raise JobError that names the value that cannot be."""
        model_of(obj)

    def make(self, obj: Any) -> None:
        """Show feeds and speed as the program has them, which the material of the tool's job may give."""
        tool = model_of(obj)
        _fix_foreign(obj)
        if is_from_chart(obj):
            _show_chart(obj, tool)
        from CNCStepper.workbench.document.cut_chart_of_job import fed

        tool = fed(tool, job_with(obj))
        keys = [entry.key for entry in self.PROPERTIES if entry.output]
        show(obj, {key: getattr(tool, key.removeprefix("used_")) for key in keys})


CHART_KEYS = ("shape", "diameter_mm", "feed_mm_min", "plunge_mm_min", "spindle_rpm")  # what a cut chart says of a tool
FORM_KEYS = {entry.key for entry in Tool.PROPERTIES if entry.group == FORM}
BY_CHART = later("The cut chart gives this value; change it in the job")
OPTIONAL = {entry.key for entry in Tool.PROPERTIES if entry.group in (FORM, LIMITS)}


def _fix_foreign(obj: Any) -> None:
    foreign, by_chart = foreign_keys(obj.ToolShape), is_from_chart(obj)
    obj.Proxy.WHY_FIXED = BY_CHART if by_chart else Tool.WHY_FIXED
    fixed = {*foreign, *FORM_KEYS} if by_chart else foreign
    for entry in Tool.PROPERTIES:
        if entry.name in obj.PropertiesList and (entry.group == FORM or entry.key in CHART_KEYS):
            obj.setEditorMode(entry.name, int(entry.key in fixed or (by_chart and entry.key in CHART_KEYS)))
    obj.setEditorMode("FromChart", 0 if _charted_job(obj) is not None else HIDDEN)


def job_with(obj: Any) -> Any:
    """Return the job that a tool object belongs to, None for none."""
    return next((other for other in obj.InList if proxy_type(other) == JOB), None)


def is_from_chart(obj: Any) -> bool:
    """Return whether the cut chart of its job describes a tool object; milling has none."""
    return bool(obj.FromChart) and _charted_job(obj) is not None


def _charted_job(obj: Any) -> Any:
    job = job_with(obj)  # one of an older document gets its process only behind its tools
    process = getattr(job, "Process", MILLING.name)
    return job if PROCESSES[process].uses_chart else None


def _show_chart(obj: Any, tool: Any) -> None:
    """Show in the object's properties what the chart says."""
    for entry in Tool.PROPERTIES:
        if entry.key in CHART_KEYS and value_of(obj, entry) != getattr(tool, entry.key):
            set_value(obj, entry, getattr(tool, entry.key))


def _chart_keys(obj: Any) -> dict[str, Any] | None:
    """Return what the chart says of a tool object, None where it does not; raises JobError."""
    if not is_from_chart(obj):
        return None
    from CNCStepper.workbench.document.cut_chart_of_job import chart_tool_keys

    return chart_tool_keys(job_with(obj))


def model_of(obj: Any) -> Any:
    """Return a tool object as `machine.tools.tool.Tool`, made anew where it has changed; raises JobError."""
    packages.require()
    from CNCStepper.machine.profile import validated
    from CNCStepper.machine.tools.tool import Tool as Model

    proxy, chart = obj.Proxy, _chart_keys(obj)
    if proxy.model is None or proxy.chart_keys != chart:
        given = proxy.given(values(obj)) if chart is None else {"number": obj.Number, **chart}
        proxy.model, proxy.content, proxy.chart_keys = validated(Model, given, obj.Label), None, chart
    return obj.Proxy.model


def tool_content(obj: Any) -> Content:
    """Return a tool object as plain data, kept with its model; raises JobError."""
    model = model_of(obj)
    if obj.Proxy.content is None:
        obj.Proxy.content = Content(model.model_dump(mode="json"))
    return obj.Proxy.content  # type: ignore[no-any-return]
