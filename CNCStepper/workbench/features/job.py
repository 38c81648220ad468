# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Job: stock, work zero, machine and operations; it holds the program that they make."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.state import WORK_SYSTEMS
from CNCStepper.workbench import packages
from CNCStepper.workbench.document import clamps, program_file
from CNCStepper.workbench.document.input_limits import require_within_reach
from CNCStepper.workbench.document.operation_order import active_operations
from CNCStepper.workbench.document.stock_of_job import FORMS, stock_content, stock_of
from CNCStepper.workbench.document.undo_observer import follow
from CNCStepper.workbench.features.base import (
    CONTAINERS,
    DISTANCE,
    ENUMERATION,
    HIDDEN,
    INTEGER,
    POINTS,
    POSITION,
    TEXT,
    Feature,
    Property,
    proxy_type,
    require_parts,
    values,
)
from CNCStepper.workbench.services.translation import later

MACHINE, STOCK, HEIGHTS, PROGRAM = later("Machine"), later("Stock"), later("Heights"), later("Program")
JOB_GROUP = later("Job")
LINKS = "App::PropertyLinkList"
SOLIDS = CONTAINERS  # a clamp may lie inside a part, the job outside
ORIGINS = ("top-centre", "top-left-front")
HEIGHT_KEYS = ("clearance_mm", "retract_mm")
FED_BY = {"Machine", "Material"}  # what the tools' feeds depend on
STOCK_SHAPE = {"StockForm", "StockSize", "StockOrigin"}
SETUP = {"Clearance", "Retract", "WorkOrigin", "Operations", *STOCK_SHAPE}  # what an operation's figures depend on


class Job(Feature):
    """The proxy of a job; `Operations` are cut in their order, heights are above the top of the stock."""

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and see that its program follows every undo."""
        super().add_properties(obj)
        follow()

    Type = "CNCStepper_Job"
    PROPERTIES = (
        Property("machine", "Machine", TEXT, MACHINE, later("Profile"),
                 later("A shipped profile's name, or a profile's file"), "table-a"),
        Property("dialect", "Dialect", TEXT, PROGRAM, later("Dialect"),
                 later("The program's dialect; empty: the machine's own"), ""),
        Property("units", "Units", ENUMERATION, PROGRAM, later("Units"), later("Of the written program"),
                 "mm", choices=("mm", "inch")),
        Property("work_offset", "WorkOffset", ENUMERATION, PROGRAM, later("Work offset"),
                 later("The work coordinate system"), "G54", choices=WORK_SYSTEMS),
        Property("coolant", "Coolant", ENUMERATION, PROGRAM, later("Coolant"),
                 later("What is switched on while cutting"), "none", choices=("none", "mist", "flood")),
        Property("material", "Material", TEXT, STOCK, later("Material"),
                 later("Tools without feeds or speed take theirs from its table"), ""),
        Property("stock_form", "StockForm", ENUMERATION, STOCK, later("Form"),
                 later("What the raw material looks like"), "box", choices=FORMS),
        Property("stock_size_mm", "StockSize", POSITION, STOCK, later("Size"),
                 later("Length, width and height; of a cylinder, which stands, the length is its diameter"),
                 (100.0, 70.0, 20.0)),
        Property("stock_origin", "StockOrigin", ENUMERATION, STOCK, later("Work zero"),
                 later("Where on the stock the work zero lies"), "top-centre", choices=ORIGINS),
        Property("work_origin_mm", "WorkOrigin", POSITION, STOCK, later("Zero's place"),
                 later("Where the work zero lies in this document"), (0.0, 0.0, 0.0)),
        Property("edge_mm", "EdgeMargin", DISTANCE, STOCK, later("Edge margin"),
                 later("How far from the stock's edge cuts must stay; 0: the edge does not matter"), 0.0),
        Property("part", "ProgramPart", INTEGER, PROGRAM, later("Program number"),
                 later("Which one is shown, checked and sent, where the machine wants one a tool"), 1),
        Property("parts", "ProgramParts", INTEGER, PROGRAM, later("Programs"),
                 later("How many there are: one, or one a tool in turn"), 0, output=True),
        Property("clearance_mm", "Clearance", DISTANCE, HEIGHTS, later("Clearance"),
                 later("Where rapids travel across the work"), 10.0),
        Property("retract_mm", "Retract", DISTANCE, HEIGHTS, later("Retract"),
                 later("From here down the tool feeds"), 2.0),
        Property("operations", "Operations", LINKS, JOB_GROUP, later("Operations"),
                 later("What is cut, in this order"), ()),
        Property("tools", "Tools", LINKS, JOB_GROUP, later("Tools"),
                 later("The tools that operations may choose from"), ()),
        Property("clamps", "Clamps", SOLIDS, JOB_GROUP, later("Clamps"),
                 later("Solids that hold the work down, which the tool must not touch"), ()),
        Property("clamp_containers", "ClampContainers", CONTAINERS, JOB_GROUP, later("Containers of the clamps"),
                 later("The parts and bodies that the clamps move with"), (), output=True),
        Property("clamp_outlines", "ClampOutlines", POINTS, JOB_GROUP, later("Outlines of the clamps"),
                 later("The clamps seen from above, at the height of their tops"), (), output=True),
        Property("program", "Program", "App::PropertyFileIncluded", JOB_GROUP, later("Program"),
                 later("The program, kept in this document"), output=True),
        Property("message", "Message", TEXT, JOB_GROUP, later("Message"), later("Why there is no program"), "",
                 output=True),
    )  # fmt: skip

    def check(self, obj: Any) -> None:
        """Raise JobError for a machine that there is not, a stock that none can be, or heights beyond both."""
        packages.require()
        from CNCStepper.workbench.document.machine_of_job import machine_of

        machine_of(obj)
        stock_of(obj)
        stock_content(obj)
        require_within_reach(obj, {key: value for key, value in values(obj).items() if key in HEIGHT_KEYS})

    def question(self, obj: Any) -> dict[str, Any] | None:
        """Return what the cut process is asked for the programs; None while there are no operations."""
        self.check(obj)
        if not active_operations(obj):
            return None
        from CNCStepper.workbench.document.core_job import program_question

        return program_question(obj)

    def make(self, obj: Any) -> None:
        """Make the program from all active operations."""
        self.check(obj)
        require_parts(obj.Clamps)
        obj.ClampOutlines = clamps.outlines_of(obj.Clamps)
        require_parts(active_operations(obj))
        if not active_operations(obj):
            self.invalidate(obj, "the job has no operations")
            return
        from CNCStepper.workbench.document.core_job import programs

        texts = [text for _, text in programs(obj)]
        obj.ProgramParts = len(texts)
        obj.setEditorMode("ProgramPart", 0 if len(texts) > 1 else HIDDEN)
        program_file.store(obj, texts[_part(obj, len(texts)) - 1])
        obj.Message = ""

    def invalidate(self, obj: Any, why: str) -> None:
        """Remove the program and its picture, so that an outdated one is never cut."""
        program_file.store(obj, "")
        obj.Message = why
        for preview in obj.InList:
            if proxy_type(preview) == "CNCStepper_Preview":
                preview.Proxy.clear(preview)

    def onChanged(self, obj: Any, name: str) -> None:
        """Stand on what the clamps move with, and let operations be figured again when what they need changes."""
        if "Restore" in obj.State:
            return
        if name == "Clamps" and "ClampContainers" in obj.PropertiesList:
            obj.ClampContainers = clamps.containers(obj.Clamps)
        if name in FED_BY and "Tools" in obj.PropertiesList:
            for tool in obj.Tools:
                tool.touch()
        if name in SETUP and "Operations" in obj.PropertiesList:
            for operation in obj.Operations:
                operation.touch()


def _part(obj: Any, parts: int) -> int:
    """Return which of its programs a job object holds, from 1; raises JobError for one that there is not."""
    if parts == 1:
        return 1
    if not 1 <= obj.ProgramPart <= parts:
        raise JobError(
            "part-missing",
            "there is no such part of the program",
            value=f"{obj.ProgramPart}",
            limit=f"1 to {parts}",
            advice="choose one of them",
        )
    return int(obj.ProgramPart)
