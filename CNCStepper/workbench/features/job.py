# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Job: stock, work zero, machine and operations; it holds the program that they make."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.processes import MILLING, PROCESSES
from CNCStepper.workbench import packages
from CNCStepper.workbench.document import clamps
from CNCStepper.workbench.document.input_limits import require_within_reach
from CNCStepper.workbench.document.stock_of_job import FORMS, stock_content, stock_of
from CNCStepper.workbench.features.base import (
    CONTAINERS,
    DISTANCE,
    ENUMERATION,
    HIDDEN,
    IDENTITY,
    POINTS,
    POSITION,
    TEXT,
    Property,
    require_parts,
    values,
)
from CNCStepper.workbench.features.cut_values import CHART, CUT_KEYS, CUT_VALUES, HEIGHT_KEYS
from CNCStepper.workbench.features.program_job import (
    CONTENTS,
    JOB_GROUP,
    MACHINE,
    MADE,
    PROGRAM_FORM,
    PROGRAM_PARTS,
    STOCK,
    ProgramJob,
    machine_property,
)
from CNCStepper.workbench.services.translation import later

HEIGHTS = later("Heights")
SOLIDS = CONTAINERS  # a clamp may lie inside a part, the job outside
ORIGINS = ("top-centre", "top-left-front")


FROM_CHART = {"Consumable", "Chart", "StockSize", *(each.name for each in CUT_VALUES)}  # and what else with a chart
FED_BY = {"Machine", "Material", "Process"}  # what the tools' feeds depend on, whatever the process
STOCK_SHAPE = {"StockForm", "StockSize", "StockOrigin"}
SETUP = {"Process", "Clearance", "Retract", "WorkOrigin", "Operations", *STOCK_SHAPE}  # the same of operations
NOT_OF_MILLING = {"consumable", "chart", *CUT_KEYS}
OF_SOME = {"coolant", *HEIGHT_KEYS, *NOT_OF_MILLING}  # keys that not every process or machine has


class Job(ProgramJob):
    """The proxy of a milling or sheet cutting job; heights are above the top of the stock."""

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and hide what its process does not have."""
        super().add_properties(obj)
        self.show_what_counts(obj)

    Type = "CNCStepper_Job"
    TOOL = "CNCStepper_Tool"
    PROPERTIES = (
        machine_property("table-a"),
        Property("process", "Process", ENUMERATION, MACHINE, later("Process"),
                 later("How it is cut; the machine must be able to"), MILLING.name, choices=tuple(PROCESSES)),
        *PROGRAM_FORM,
        Property("material", "Material", TEXT, STOCK, later("Material"),
                 later("Tools without feeds or speed use its table"), ""),
        Property("stock_form", "StockForm", ENUMERATION, STOCK, later("Form"),
                 later("Shape of the raw material"), "box", choices=FORMS),
        Property("stock_size_mm", "StockSize", POSITION, STOCK, later("Size"),
                 later("Length, width and height; for an upright cylinder the length is its diameter"),
                 (100.0, 70.0, 20.0)),
        Property("stock_origin", "StockOrigin", ENUMERATION, STOCK, later("Work zero"),
                 later("The place of the work zero on the stock"), "top-centre", choices=ORIGINS),
        Property("work_origin_mm", "WorkOrigin", POSITION, STOCK, later("Zero's place"),
                 later("The place of the work zero in this document"), (0.0, 0.0, 0.0)),
        Property("edge_mm", "EdgeMargin", DISTANCE, STOCK, later("Edge margin"),
                 later("How far from the stock's edge cuts must stay; 0: the edge does not matter"), 0.0),
        Property("consumable", "Consumable", TEXT, CHART, later("Consumable"),
                 later("Nozzle, lens, wire or blade; empty: the first of the chart for this thickness"), ""),
        Property("chart", "Chart", TEXT, CHART, later("Chart"),
                 later("The file of a cut chart of your own; empty: the chart that ships"), ""),
        *CUT_VALUES,
        *PROGRAM_PARTS,
        Property("clearance_mm", "Clearance", DISTANCE, HEIGHTS, later("Clearance"),
                 later("Where rapids travel across the work"), 10.0),
        Property("retract_mm", "Retract", DISTANCE, HEIGHTS, later("Retract"),
                 later("From here down the tool feeds"), 2.0),
        *CONTENTS,
        Property("clamps", "Clamps", SOLIDS, JOB_GROUP, later("Clamps"),
                 later("Solids that hold the work down, which the tool must not touch"), ()),
        Property("clamp_containers", "ClampContainers", CONTAINERS, JOB_GROUP, later("Containers of the clamps"),
                 later("The parts and bodies that the clamps move with"), (), output=True),
        Property("clamp_outlines", "ClampOutlines", POINTS, JOB_GROUP, later("Outlines of the clamps"),
                 later("The clamps seen from above, at the height of their tops"), (), output=True),
        *MADE,
    )  # fmt: skip

    def check(self, obj: Any) -> None:
        """Raise JobError for a machine that there is not, a stock that none can be, or heights beyond both."""
        packages.require()
        from CNCStepper.workbench.document.machine_of_job import machine_of

        machine_of(obj)
        stock_of(obj)
        stock_content(obj)
        machine_of(obj).process(obj.Process)
        require_within_reach(obj, {key: value for key, value in values(obj).items() if key in HEIGHT_KEYS})

    def make_surroundings(self, obj: Any) -> None:
        """Look where the clamps are."""
        require_parts(obj.Clamps)
        obj.ClampOutlines = clamps.outlines_of(obj.Clamps)

    def program_question(self, obj: Any) -> dict[str, Any]:
        """Return what the cut process is asked for the programs; raises JobError for a bad job."""
        from CNCStepper.workbench.document.core_job import program_question

        return program_question(obj)

    def programs(self, obj: Any) -> list[tuple[str, str]]:
        """Return the names and texts of the programs; raises what the core raises."""
        from CNCStepper.workbench.document.core_job import programs

        return programs(obj)

    def proof_question(self, obj: Any, program: Any) -> Callable[[Path, str], None]:
        """Return what writes the request for a proof into a folder, with the program's text; raises JobError."""
        from CNCStepper.job.proof_folder import write_question
        from CNCStepper.workbench.document.core_job import language_of, machine_of, proven_with

        job, machine, language = proven_with(program), machine_of(obj), language_of(program)
        return lambda folder, text: write_question(folder, text, job, machine, language)

    def read_back(self, obj: Any, text: str) -> Any:
        """Return the table of moves of a program's text, in work coordinates; raises ProgramError."""
        from CNCStepper.workbench.document.core_job import read_back

        return read_back(obj, text)

    def show_what_counts(self, obj: Any) -> None:
        """Hide the properties that the job's process or machine does not have."""
        if obj.Process == MILLING.name:
            hidden = NOT_OF_MILLING
        else:
            try:
                packages.require()
                from CNCStepper.workbench.document.cut_chart_of_job import keys_that_count

                hidden = OF_SOME - keys_that_count(obj)
            except CNCStepperError:  # what is wrong with the machine is said at the job
                return
        for entry in self.PROPERTIES:
            if entry.key in OF_SOME:
                obj.setEditorMode(entry.name, HIDDEN if entry.key in hidden else 0)

    def onChanged(self, obj: Any, name: str) -> None:
        """Stand on what the clamps move with, and let operations be figured again when what they need changes."""
        if "Restore" in obj.State:
            return
        if name == "Clamps" and "ClampContainers" in obj.PropertiesList:
            obj.ClampContainers = clamps.containers(obj.Clamps)
        if name in ("Process", "Machine") and IDENTITY.name in obj.PropertiesList:
            self.show_what_counts(obj)
        is_feeding = name in FED_BY or (name in FROM_CHART and obj.Process != MILLING.name)
        if is_feeding and "Tools" in obj.PropertiesList:
            for tool in obj.Tools:
                tool.touch()
        if name in SETUP and "Operations" in obj.PropertiesList:
            for operation in obj.Operations:
                operation.touch()
