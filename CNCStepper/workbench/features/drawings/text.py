# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Text: letters as wires of lines and arcs, in any font of the system or in a single-line font."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.job.shape_forms.text_parameters import ALONG, TextParameters
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    ANGLE,
    DISTANCE,
    ENUMERATION,
    HIDDEN,
    INTEGER,
    POSITION,
    Feature,
    Property,
    values,
)
from CNCStepper.workbench.features.parameters import MADE, properties_of
from CNCStepper.workbench.services.translation import later

if TYPE_CHECKING:
    from CNCStepper.geometry.curve import Curve
    from CNCStepper.job.shape_forms.text_form import TextForm

ON_LINE, ON_ARC = ("along", ("line",)), ("along", ("arc",))
CURVED = ("along", ("line", "arc"))


class Text(Feature):
    """The proxy of a text; it lies in the object's own plane, which `Placement` sets."""

    Type = "CNCStepper_Text"
    PROPERTIES = (
        *properties_of(TextParameters),
        Property("along", "Along", ENUMERATION, ALONG, later("Along"), later("What the letters stand on"), "none",
                 choices=("none", "line", "arc")),
        Property("line_begin_mm", "LineBegin", POSITION, ALONG, later("From"), later("Where the line begins"),
                 (0.0, 0.0), only=ON_LINE, plane=True),
        Property("line_end_mm", "LineEnd", POSITION, ALONG, later("To"), later("Where the line ends"),
                 (100.0, 0.0), only=ON_LINE, plane=True),
        Property("arc_centre_mm", "ArcCentre", POSITION, ALONG, later("Centre"), later("Of the arc"), (0.0, 0.0),
                 only=ON_ARC, plane=True),
        Property("arc_radius_mm", "ArcRadius", DISTANCE, ALONG, later("Radius"), later("Of the arc"), 50.0,
                 only=ON_ARC),
        Property("arc_start_deg", "ArcStart", ANGLE, ALONG, later("Start"),
                 later("Where the arc begins; counter-clockwise from X"), 180.0, only=ON_ARC),
        Property("arc_sweep_deg", "ArcSweep", ANGLE, ALONG, later("Sweep"),
                 later("How far the arc goes; below 0 clockwise, with the letters outside"), -180.0, only=ON_ARC),
        Property("above_mm", "Above", DISTANCE, ALONG, later("Above"), later("How far above it the letters stand"),
                 0.0, only=CURVED),
        Property("curves", "CurveCount", INTEGER, MADE, later("Contours"), later("How many there are"), 0, output=True),
    )  # fmt: skip

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and show what counts."""
        super().add_properties(obj)
        self.show_what_counts(obj)

    def show_what_counts(self, obj: Any) -> None:
        """Hide what the way along which the letters stand does not have."""
        for entry in self.PROPERTIES:
            if entry.only:
                obj.setEditorMode(entry.name, 0 if obj.Along in entry.only[1] else HIDDEN)

    def onChanged(self, obj: Any, name: str) -> None:
        """Show what counts along another line; FreeCAD calls this at every change."""
        if name == "Along" and "CurveCount" in obj.PropertiesList and "Restore" not in obj.State:
            self.show_what_counts(obj)

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the form of the text among an object's values."""
        content = {key: value for key, value in found.items() if key in TEXT_KEYS}
        if content["file"]:
            content["font"] = content["style"] = ""
        elif content["font"] in single_line_fonts():
            content["single_line"], content["font"] = content["font"], ""
        if found["along"] != "none":
            content["along"] = _along(found)
        return content

    def question(self, obj: Any) -> dict[str, Any]:
        """Return what the cut process is asked for the curves."""
        return {"text": form_of(obj).model_dump(mode="json"), "folder": str(_folder(obj))}

    def make(self, obj: Any) -> None:
        """Make the wires; raises JobError for letters that the font lacks."""
        packages.require()
        import Part

        from CNCStepper.workbench.drawings.wires import wire_of

        curves = self._curves(obj)
        placement = obj.Placement
        obj.Shape = Part.makeCompound([wire_of(curve, 0.0) for curve in curves])
        obj.Placement = placement
        obj.CurveCount = len(curves)

    def _curves(self, obj: Any) -> tuple[Curve, ...]:
        from CNCStepper.workbench.calculation import result_cache

        if result_cache.any_known() and (answer := result_cache.answer_to(self.question(obj))) is not None:
            return answer.curves  # type: ignore[union-attr, no-any-return]
        return form_of(obj).curves(_folder(obj))


TEXT_KEYS = {entry.key for entry in properties_of(TextParameters)}


def single_line_fonts() -> tuple[str, ...]:
    """Return the names of the single-line fonts."""
    from CNCStepper.drawing.text.stroke_font import FILES

    return tuple(FILES)


def form_of(obj: Any) -> TextForm:
    """Return the form of a text object; raises JobError for a bad value."""
    packages.require()
    from CNCStepper.job.shape_forms.text_form import TextForm
    from CNCStepper.machine.profile import validated

    form: TextForm = validated(TextForm, obj.Proxy.given(values(obj)), obj.Label)
    return form


def _folder(obj: Any) -> Path:
    """Return where a font's file is looked for: beside the document."""
    return Path(obj.Document.FileName).parent if obj.Document.FileName else Path.home()


def _along(found: dict[str, Any]) -> dict[str, Any]:
    line = (found["line_begin_mm"], found["line_end_mm"])
    arc = {
        "centre": found["arc_centre_mm"],
        "radius": found["arc_radius_mm"],
        "start_deg": found["arc_start_deg"],
        "sweep_deg": found["arc_sweep_deg"],
    }
    return {("line" if found["along"] == "line" else "arc"): line if found["along"] == "line" else arc,
            "above_mm": found["above_mm"]}  # fmt: skip
