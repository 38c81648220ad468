# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_LatheJob: bar, chuck, machine and operations of a lathe; it holds the program that they make."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.machine.processes import TURNING
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    BOOL,
    DISTANCE,
    ENUMERATION,
    FLOAT,
    HIDDEN,
    IDENTITY,
    LATHE_JOB,
    TEXT,
    Property,
    entry_of,
)
from CNCStepper.workbench.features.cycle_operation import in_tables
from CNCStepper.workbench.features.program_job import (
    CONTENTS,
    MACHINE,
    MADE,
    PROGRAM,
    PROGRAM_FORM,
    PROGRAM_PARTS,
    STOCK,
    ProgramJob,
    machine_property,
)
from CNCStepper.workbench.features.turning.turning_tool import TurningTool
from CNCStepper.workbench.services.translation import later

START, CHUCK, TAILSTOCK = later("Start position"), later("Chuck"), later("Tailstock")
TABLES = ("stock", "chuck", "tailstock")
PLAIN = ("units", "machine", "process", "x_is", "distance", "canned", "material", "coolant", "work_offset",
         "arc_tolerance_mm")  # fmt: skip
TUBE = ("stock_form", ("tube",))
OWN_START = ("start_by", ("given",))
YES = ("tailstock_by", ("given",))
SETUP = {  # the names of properties on which the cut of an operation depends
    "Machine", "Dialect", "XIs", "StockForm", "Diameter", "Bore", "FaceStock", "Length", "StartBy", "StartX", "StartZ",
    "Operations",
}  # fmt: skip


class LatheJob(ProgramJob):
    """The proxy of a lathe's job; its keys are those of a job file, tables before their keys ("stock_bore_mm")."""

    Type = "CNCStepper_LatheJob"
    TOOL = TurningTool.Type
    JOB_TYPE = LATHE_JOB
    PROPERTIES = (
        machine_property("mini-lathe"),
        Property("process", "Process", ENUMERATION, MACHINE, later("Process"),
                 later("How it is cut; the machine must be able to"), TURNING, choices=(TURNING,)),
        *PROGRAM_FORM,
        Property("x_is", "XIs", ENUMERATION, PROGRAM, later("X is"), later("What the program's X is"), "diameter",
                 choices=("diameter", "radius")),
        Property("distance", "DistanceMode", ENUMERATION, PROGRAM, later("Distances"),
                 later("From the work zero (G90), or from the point before (G91)"), "absolute",
                 choices=("absolute", "incremental")),
        Property("canned", "Canned", BOOL, PROGRAM, later("Canned cycles"),
                 later("Whether threads are written as G76, where the controller has it"), False),
        Property("arc_tolerance_mm", "ArcTolerance", DISTANCE, PROGRAM, later("Arc tolerance"),
                 later("How far chords may leave an arc, where the controller has no arcs"), 0.002),
        *PROGRAM_PARTS,
        Property("material", "Material", TEXT, STOCK, later("Material"),
                 later("For the forces; empty: they are not figured"), ""),
        Property("stock_form", "StockForm", ENUMERATION, STOCK, later("Form"), later("Shape of the raw material"),
                 "bar", choices=("bar", "tube")),
        Property("stock_diameter_mm", "Diameter", DISTANCE, STOCK, later("Diameter"),
                 later("The diameter of the raw bar"), 50.0),
        Property("stock_bore_mm", "Bore", DISTANCE, STOCK, later("Bore"), later("The inner diameter of a tube"), 20.0,
                 only=TUBE),
        Property("stock_face_mm", "FaceStock", DISTANCE, STOCK, later("Before zero"),
                 later("How far the raw end lies before the finished end face, where Z is 0"), 1.0),
        Property("stock_length_mm", "Length", DISTANCE, STOCK, later("Bar length"),
                 later("From the chuck's face to the finished end face"), 100.0),
        Property("chuck_diameter_mm", "ChuckDiameter", DISTANCE, CHUCK, later("Diameter"),
                 later("The diameter of the chuck"), 100.0),
        Property("chuck_jaw_diameter_mm", "JawDiameter", DISTANCE, CHUCK, later("Jaw diameter"),
                 later("Around the jaws; 0: no jaws stand out"), 0.0),
        Property("chuck_jaw_mm", "Jaws", DISTANCE, CHUCK, later("Jaws"),
                 later("How far the jaws stand out of the chuck's face"), 0.0),
        Property("chuck_grip_n", "Grip", FLOAT, CHUCK, later("Grip"),
                 later("The force of all jaws, in newtons; 0: not known"), 0.0),
        Property("tailstock_by", "TailstockBy", ENUMERATION, TAILSTOCK, later("Tailstock"),
                 later("Whether a centre holds the raw end"), "none", choices=("none", "given")),
        Property("tailstock_diameter_mm", "CentreDiameter", DISTANCE, TAILSTOCK, later("Diameter"),
                 later("The diameter of the tailstock's centre"), 20.0, only=YES),
        Property("tailstock_angle_deg", "CentreAngle", "App::PropertyAngle", TAILSTOCK, later("Angle"),
                 later("Of its tip"), 60.0, only=YES),
        Property("tailstock_hole_mm", "CentreHole", DISTANCE, TAILSTOCK, later("Hole"),
                 later("The diameter of the centre hole; 0: not given"), 0.0, only=YES),
        Property("start_by", "StartBy", ENUMERATION, START, later("Start position"),
                 later("Where the tool is when the program begins: clear of the raw end, or given"), "automatic",
                 choices=("automatic", "given")),
        Property("start_x_mm", "StartX", DISTANCE, START, later("Start X"),
                 later("The tool's X when the program begins, as radius or diameter"), 60.0, only=OWN_START),
        Property("start_z_mm", "StartZ", DISTANCE, START, later("Start Z"),
                 later("The tool's Z when the program begins"), 6.0, only=OWN_START),
        *CONTENTS,
        *MADE,
    )  # fmt: skip

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and show those that count."""
        super().add_properties(obj)
        obj.setEditorMode("Process", HIDDEN)
        self.show_what_counts(obj)

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return what a job file holds besides tools, profiles and operations, in its tables."""
        counting = {key: value for key, value in found.items() if self.counts(entry_of(self, key), found)}
        tables = in_tables({key: counting[key] for key in counting if key.startswith(TABLES)}, TABLES)
        has_tailstock = tables["tailstock"].pop("by") == "given"
        content: dict[str, Any] = {key: found[key] for key in PLAIN}
        content |= tables | {"tailstock": tables["tailstock"] if has_tailstock else None}
        own_start = found["start_by"] == "given"
        return content | {"start": (found["start_x_mm"], found["start_z_mm"]) if own_start else None}

    def check(self, obj: Any) -> None:
        """Raise JobError for a machine that is no lathe, or a stock, chuck or start that cannot be."""
        packages.require()
        from CNCStepper.workbench.document.turning.core_turning_job import check_setup

        check_setup(obj)

    def origin_mm(self, obj: Any) -> tuple[float, float, float]:
        """Return the document's own zero: there X is the radius and Z = 0 the finished end face."""
        return (0.0, 0.0, 0.0)

    def program_question(self, obj: Any) -> dict[str, Any]:
        """Return what the cut process is asked for the programs; raises JobError for a bad job."""
        from CNCStepper.workbench.document.turning.core_turning_job import program_question

        return program_question(obj)

    def programs(self, obj: Any) -> list[tuple[str, str]]:
        """Return the names and texts of the programs; raises what the core raises."""
        from CNCStepper.workbench.document.turning.core_turning_job import programs

        return programs(obj)

    def proof_question(self, obj: Any, program: Any) -> Callable[[Path, str], None]:
        """Return what writes the request for a proof into a folder, with the program's text; raises JobError."""
        from CNCStepper.workbench.document.turning.core_turning_job import proof_question

        return proof_question(obj, program)

    def read_back(self, obj: Any, text: str) -> Any:
        """Return the table of moves of a program's text, X the radius and Z the part's; raises ProgramError."""
        from CNCStepper.workbench.document.turning.core_turning_job import read_back

        return read_back(obj, text)

    def onChanged(self, obj: Any, name: str) -> None:
        """Let operations be figured again when what they need changes; FreeCAD calls this at every change."""
        if "Restore" in obj.State or IDENTITY.name not in obj.PropertiesList:
            return
        if name in ("StockForm", "TailstockBy", "StartBy"):
            self.show_what_counts(obj)
        if name in SETUP:
            for operation in obj.Operations:
                operation.touch()
