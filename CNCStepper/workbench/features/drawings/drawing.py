# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Drawing: a group of ordinary Part objects that came from the file of a drawing and follow it.

file ──► form(obj) ──► read_imported ──► applied: the objects of the group, matched with those of before
  └── looked at now and then: State says "changed" or "missing", and Problem why; nothing changes by itself
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict, astuple
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper import text_json
from CNCStepper.errors import JobError, Place
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    BOOL,
    DISTANCE,
    ENUMERATION,
    FLOAT,
    HIDDEN,
    INTEGER,
    TEXT,
    Feature,
    Property,
    entry_of,
    values,
)
from CNCStepper.workbench.services.translation import later

if TYPE_CHECKING:
    from CNCStepper.drawing.repair.problems import RepairLimits
    from CNCStepper.job.drawings.imported_drawing import ImportedDrawing
    from CNCStepper.job.drawings.linked_file import FileState
    from CNCStepper.job.shape_forms.drawing_form import DrawingForm

FILE, REPAIR, PICTURE, FOUND = later("File"), later("Repair"), later("Picture"), later("What was read")
CURRENT, CHANGED, MISSING, UNREAD = "current", "changed", "missing", "unread"
KINDS = {".png": "picture", ".jpg": "picture", ".jpeg": "picture"} | dict.fromkeys(
    (".stl", ".step", ".stp", ".brep", ".brp", ".fcstd"), "solid"
)
PICTURES, SOLIDS = ("kind", ("picture",)), ("kind", ("solid",))
TABLES = ("mend", "trace")
SECTION = "section"
READ = "ReadWith"  # the name of the property that says how the objects were read


class Drawing(Feature):
    """The proxy of an imported drawing; an option of 0 is found from the file."""

    Type = "CNCStepper_Drawing"
    PROPERTIES = (
        Property("file", "File", TEXT, FILE, later("File"), later("The drawing that the objects follow"), ""),
        Property("kind", "Kind", TEXT, FILE, later("Kind"), later("Drawing, solid or picture"), "", output=True),
        Property("split", "Split", ENUMERATION, FILE, later("Objects"), later("What becomes one object"), "automatic",
                 choices=("automatic", "layer", "chain")),
        Property("unit_mm", "Unit", DISTANCE, FILE, later("Unit"),
                 later("The length of the file's unit; 0: as the file says, or as its program usually means it"), 0.0),
        Property("tolerance_mm", "Tolerance", DISTANCE, FILE, later("Tolerance"),
                 later("How far lines and arcs may leave other curves"), 0.005),
        Property("by_colour", "ByColour", BOOL, FILE, later("By colour"),
                 later("Join only lines of one colour"), True),
        Property("cut_at", "Section", ENUMERATION, FILE, later("Contours"),
                 later("The outline seen from above, or the faces or the section at a height"), "outline",
                 choices=("outline", SECTION), only=SOLIDS),
        Property("height_mm", "Height", DISTANCE, FILE, later("Height"),
                 later("Z of the faces or of the section"), 0.0, only=("cut_at", (SECTION,))),
        Property("mending", "Mend", BOOL, REPAIR, later("Mend"),
                 later("Repair what is wrong, as far as these values allow"), False),
        Property("mend_join_mm", "Join", DISTANCE, REPAIR, later("Join ends"),
                 later("Ends that are nearer than this are moved together"), 0.05),
        Property("mend_close_mm", "Close", DISTANCE, REPAIR, later("Close gaps"),
                 later("Gaps up to this are closed"), 0.5),
        Property("mend_double_mm", "Double", DISTANCE, REPAIR, later("Doubles"),
                 later("Lines nearer than this to another one are drawn twice"), 0.005),
        Property("mend_tiny_mm", "Tiny", DISTANCE, REPAIR, later("Tiny"),
                 later("Lines up to this long are left out"), 0.02),
        Property("mend_fit_mm", "Simplify", DISTANCE, REPAIR, later("Simplify"),
                 later("Lines of many points become fewer lines and arcs within this; 0: they stay"), 0.0),
        Property("trace_threshold", "Threshold", INTEGER, PICTURE, later("Threshold"),
                 later("Below this grey, 1 to 255, it is dark; 0: found from the picture"), 0, only=PICTURES),
        Property("trace_invert", "Invert", BOOL, PICTURE, later("Light areas"),
                 later("Trace what is light instead of what is dark"), False, only=PICTURES),
        Property("trace_blur_px", "Blur", FLOAT, PICTURE, later("Blur"),
                 later("Radius in pixels of a blur that takes out noise"), 0.0, only=PICTURES),
        Property("trace_width_mm", "Width", DISTANCE, PICTURE, later("Width"),
                 later("The width of the picture; 0: as its resolution says"), 0.0, only=PICTURES),
        Property("trace_dpi", "Resolution", FLOAT, PICTURE, later("Resolution"),
                 later("Pixels an inch; 0: as the file says"), 0.0, only=PICTURES),
        Property("trace_simplify_mm", "TraceTolerance", DISTANCE, PICTURE, later("Simplify"),
                 later("How far lines and arcs may leave the pixels; 0: half a pixel"), 0.0, only=PICTURES),
        Property("trace_speck_mm2", "Speck", FLOAT, PICTURE, later("Specks"),
                 later("Smaller areas, in mm², are left out; 0: four pixels"), 0.0, only=PICTURES),
        Property("chains", "Chains", INTEGER, FOUND, later("Contours"), later("How many there are"), 0, output=True),
        Property("faults", "Faults", INTEGER, FOUND, later("Faults"),
                 later("How many gaps, doubles, crossings and other faults were found"), 0, output=True),
        Property("kerf_mm", "SharedKerf", DISTANCE, FOUND, later("Kerf of shared cuts"),
                 later("The kerf for which neighbours on a nested sheet share cuts; 0: none do"), 0.0, output=True),
        Property("state", "FileState", TEXT, FOUND, later("State"),
                 later("Whether the file is as it was read"), UNREAD, output=True),
        Property("read_with", READ, TEXT, FOUND, later("Read"), later("How it was read last"), "", output=True),
        Property("report", "Report", TEXT, FOUND, later("Report"), later("What was found in it"), "", output=True),
    )  # fmt: skip

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and show what counts."""
        super().add_properties(obj)
        for name in ("Kind", READ, "Report"):
            obj.setEditorMode(name, HIDDEN)
        self.show_what_counts(obj)

    def counts(self, entry: Property, found: dict[str, Any]) -> bool:
        """Return whether an option counts with the others, by key."""
        if not entry.only:
            return True
        return found[entry.only[0]] in entry.only[1] and self.counts(entry_of(self, entry.only[0]), found)

    def show_what_counts(self, obj: Any) -> None:
        """Hide the options that files of this kind do not have."""
        found = {**values(obj), "kind": obj.Kind}
        for entry in self.PROPERTIES:
            if entry.only:
                obj.setEditorMode(entry.name, 0 if self.counts(entry, found) else HIDDEN)

    def onChanged(self, obj: Any, name: str) -> None:
        """Know the kind of another file; FreeCAD calls this at every change."""
        if "Report" not in obj.PropertiesList or "Restore" in obj.State:
            return
        if name == "File":
            obj.Kind = KINDS.get(Path(obj.File).suffix.casefold(), "drawing")
        if name in ("File", "Section"):
            self.show_what_counts(obj)

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the form of the drawing among an object's values; what is 0 is found from the file."""
        from CNCStepper.workbench.features.cycle_operation import in_tables

        left_out = {"split", "cut_at", "mending"}
        content = in_tables({key: value for key, value in found.items() if key not in left_out}, TABLES)
        content["trace"] = {
            key: value or (False if key == "invert" else None) for key, value in content["trace"].items()
        }
        content["trace"]["blur_px"] = content["trace"]["blur_px"] or 0.0
        content["unit_mm"] = content["unit_mm"] or None
        content["height_mm"] = content["height_mm"] if found["cut_at"] == SECTION else None
        return content

    def make(self, obj: Any) -> None:
        """Say what is wrong with the file; the objects stay as they were read."""
        place = Place(obj.File)
        if obj.FileState == MISSING:
            what, advice = "the file of the drawing is not there any more", "bring it back, or choose another file"
            raise JobError("drawing-missing", what, advice=advice, place=place)
        if obj.FileState == CHANGED:
            what, advice = "the file of the drawing has changed", "reload it"
            raise JobError("drawing-changed", what, advice=advice, place=place)


def path_of(obj: Any) -> Path:
    """Return the file of a drawing: where it was, or beside the document, when both have moved together."""
    path = Path(obj.File)
    beside = Path(obj.Document.FileName).parent / path.name if obj.Document.FileName else path
    return beside if beside.exists() and not path.exists() else path


def form_of(obj: Any) -> tuple[DrawingForm, RepairLimits]:
    """Return how a drawing is to be read, and the limits of its repair; raises JobError for a bad value."""
    packages.require()
    from CNCStepper.job.shape_forms.drawing_form import DrawingForm
    from CNCStepper.machine.profile import validated

    form: DrawingForm = validated(DrawingForm, obj.Proxy.given(values(obj)), obj.Label)
    limits = form.mend
    assert limits is not None
    return form if obj.Mend else form.model_copy(update={"mend": None}), limits


def question_of(obj: Any) -> dict[str, Any]:
    """Return what the process that reads drawings is asked; raises JobError for a bad value."""
    form, limits = form_of(obj)
    return {
        "drawing": {
            "file": str(path_of(obj)),
            "form": form.model_dump(mode="json"),
            "limits": limits.model_dump(mode="json"),
        }
    }


def read_key(obj: Any) -> str:
    """Return a text that is the same for options which give the same objects of an unchanged file."""
    form, limits = form_of(obj)
    content = {"split": obj.Split, "form": form.model_dump(mode="json"), "limits": limits.model_dump(mode="json")}
    return json.dumps(content, sort_keys=True)


def is_stale(obj: Any) -> bool:
    """Return whether options have changed since the objects were read; raises JobError for a bad value."""
    return not obj.ReadWith or json.loads(obj.ReadWith)["key"] != read_key(obj)


def state_of(obj: Any) -> FileState | None:
    """Return the state of the file as it was read, None where nothing was."""
    from CNCStepper.job.drawings.linked_file import FileState

    return FileState(**json.loads(obj.ReadWith)["state"]) if obj.ReadWith else None


def set_state(obj: Any, state: str) -> None:
    """Say at the object, its icon and its tooltip whether its file is as it was read."""
    if obj.FileState != state:
        obj.FileState = state
        obj.Proxy.execute(obj)


def applied(obj: Any, imported: ImportedDrawing) -> Iterator[None]:
    """Put what was read into the group, a little at a time, so that a window can see to its events.

    The document changes when all shapes are made. An object of before that goes on keeps its name, label and place;
    what the file does not hold any more is deleted.
    """
    from CNCStepper.workbench.features.drawings.imported_parts import (
        best_split,
        in_one_group,
        matched,
        new_object,
        parts_of_chains,
        set_part,
        shape_steps,
    )

    split = best_split(imported.chains) if obj.Split == "automatic" else obj.Split
    parts = parts_of_chains(imported.chains, split)
    shapes: list[Any] = []
    for part in parts:
        yield from shape_steps(part, shapes)
    before = [each for each in obj.Group if hasattr(each, "Fingerprint")]
    others = [each for each in obj.Group if each not in before]
    obj.Split = split
    kept = matched(parts, before)
    group = []
    for part, shape, old in zip(parts, shapes, kept, strict=True):
        target = old or new_object(obj.Document, part)
        if old is None or old.Fingerprint != part.fingerprint:
            set_part(target, part, shape)
        group.append(target)
        yield
    if list(obj.Group) != (members := [*group, *others]):
        with in_one_group([*before, *others]):
            for gone in [each for each in before if each not in group]:
                obj.Document.removeObject(gone.Name)
            obj.Group = members
    obj.Chains, obj.Faults = len(imported.chains), imported.problems.count
    obj.SharedKerf = imported.kerf_mm or 0.0
    obj.ReadWith = json.dumps({"key": read_key(obj), "state": asdict(imported.state)})
    obj.Report = text_json.dumps(_report(imported))
    set_state(obj, CURRENT)


def _report(imported: ImportedDrawing) -> dict[str, Any]:
    """Return what a person is told of the drawing, as plain data: counts, and rows with their places."""
    from CNCStepper.drawing.chain_list import drawing_box_mm

    return {
        "box_mm": list(drawing_box_mm(imported.chains)),
        "unit_mm": imported.unit_mm,
        "layers": len({chain.attributes.layer for chain in imported.chains}),
        "open": sum(not chain.curve.closed for chain in imported.chains),
        "problems": [imported.problems.count, [astuple(row) for row in imported.problems.rows]],
        "changes": [imported.changes.count, [astuple(row) for row in imported.changes.rows]],
        "skipped": [imported.skipped.count, [[row.kind, row.layer, row.why] for row in imported.skipped.rows]],
        "warnings": list(imported.warnings),
    }
