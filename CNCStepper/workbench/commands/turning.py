# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the lathe: a job, a profile by points, an operation for each turning cycle, and part records."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands.create_object import Operation, create, labelled
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.document.turning import turning_defaults
from CNCStepper.workbench.features.base import LATHE_JOB, proxy_type
from CNCStepper.workbench.features.cycle_operation import drawings_of
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, later, tr
from CNCStepper.workbench.services.view_fit import look_at_lathe, show_all
from CNCStepper.workbench.templates.around import Around


class NewLatheJob(Command):
    """Makes a lathe's job; also a document, when none is open."""

    name = "CNCStepper_NewLatheJob"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_NewLatheJob", "New lathe job")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_NewLatheJob", "Makes a job of a lathe with a bar in its chuck")

    def why_not(self) -> str:
        """Return why no job can be made."""
        return missing_packages.why_not() or targets.why_no_panel()

    def run(self) -> None:
        """Make the job, open its panel, and look at its bar."""
        import FreeCAD

        document = targets.document() or FreeCAD.newDocument()
        create(document, tr("New lathe job"), lambda: _job(document))
        look_at_lathe()
        show_all()


def _job(document: Any) -> Any:
    from CNCStepper.workbench import api
    from CNCStepper.workbench.viewproviders.job import previews

    job = labelled(api.new_lathe_job(document), tr("Lathe job"))
    job.Proxy.around = Around()
    labelled(api.add_tool(job), tr("Tool"))
    for preview in previews(job):
        labelled(preview, tr("Preview"))
    return job


class TurningProfile(Command):
    """Makes a half profile by its points."""

    name = "CNCStepper_TurningProfile"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurningProfile", "Profile by points")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurningProfile", "Makes a half profile from points, chamfers and arcs")

    def why_not(self) -> str:
        """Return why no profile can be made."""
        reason = missing_packages.why_not() or targets.why_no_panel()
        return reason or ("" if targets.document() is not None else tr("Open or make a document first"))

    def run(self) -> None:
        """Make the profile, as large as the job's bar, and open its panel."""
        document, job = targets.document(), targets.job()
        rows = turning_defaults.profile(job) if proxy_type(job) == LATHE_JOB else turning_defaults.PROFILE
        create(document, tr("Profile by points"), lambda: self.add(document, rows))

    def add(self, document: Any, rows: tuple[str, ...]) -> Any:
        """Return the new profile."""
        from CNCStepper.workbench import api

        return labelled(api.add_profile(document, rows), tr("Profile"))


class TurningOperation(Operation):
    """A command that adds an operation to a lathe's job; nothing selected means the profile of the one before."""

    def add(self, job: Any, pairs: list[Any], is_drawn: bool) -> Any:
        """Return the new operation of the job; raises a CNCStepperError that says why a profile cannot be followed."""
        from CNCStepper.workbench.features.catalogue import operation_class

        if not operation_class(self.cycle).FOLLOWS:  # type: ignore[attr-defined]
            return super().add(job, [], False)
        if not pairs:
            before = [drawings_of(each) for each in job.Operations]
            pairs = list(next(filter(None, reversed(before)), ()))
        return super().add(job, pairs, is_drawn)

    def tool(self, job: Any) -> Any:
        """Return a tool of the kind that the cycle takes: a selected one, the job's last, or a new one."""
        from CNCStepper.workbench import api

        kind = turning_defaults.KIND_OF_TOOL[self.cycle]
        found = [tool for tool in job.Tools if tool.Kind == kind]
        selected = [tool for tool in targets.selected() if tool in job.Tools]
        if found or selected:
            return (selected or found)[-1]
        return labelled(api.add_tool(job, **turning_defaults.tool(kind)), tr("Tool"))

    def values(self, job: Any, tool: Any, is_drawn: bool) -> dict[str, Any]:
        """Return values that fit the bar and the tool."""
        return turning_defaults.operation(self.cycle, float(job.Diameter), float(job.Length), tool)


class TurnFace(TurningOperation):
    """Adds facing to a lathe's job."""

    name = "CNCStepper_TurnFace"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnFace", "Turn face")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnFace", "Turns the raw end flat, down to Z = 0")
    cycle = "turn_face"
    label = later("Facing")


class TurnRough(TurningOperation):
    """Adds roughing to a lathe's job."""

    name = "CNCStepper_TurnRough"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnRough", "Turn roughing")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnRough", "Roughs the selected half profile out of the bar")
    cycle = "turn_rough"
    label = later("Roughing")


class TurnFinish(TurningOperation):
    """Adds finishing to a lathe's job."""

    name = "CNCStepper_TurnFinish"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnFinish", "Turn finishing")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnFinish", "Follows the selected half profile in one pass")
    cycle = "turn_finish"
    label = later("Finishing")


class TurnTaper(TurningOperation):
    """Adds a cone to a lathe's job."""

    name = "CNCStepper_TurnTaper"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnTaper", "Turn cone")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnTaper", "Turns a cone by its diameters or its angle, without a profile")
    cycle = "turn_taper"
    label = later("Cone")


class TurnGroove(TurningOperation):
    """Adds a groove to a lathe's job."""

    name = "CNCStepper_TurnGroove"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnGroove", "Turn groove")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnGroove", "Cuts a groove with parallel walls")
    cycle = "turn_groove"
    label = later("Groove")


class TurnPart(TurningOperation):
    """Adds parting off to a lathe's job."""

    name = "CNCStepper_TurnPart"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnPart", "Part off")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnPart", "Cuts the part off the bar")
    cycle = "turn_part"
    label = later("Parting off")


class TurnDrill(TurningOperation):
    """Adds drilling on the axis to a lathe's job."""

    name = "CNCStepper_TurnDrill"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnDrill", "Drill on the axis")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnDrill", "Drills into the end face on the axis, with pecks")
    cycle = "turn_drill"
    label = later("Drilling")


class TurnBore(TurningOperation):
    """Adds boring to a lathe's job."""

    name = "CNCStepper_TurnBore"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnBore", "Turn bore")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnBore", "Roughs the selected half profile out of a hole")
    cycle = "turn_bore"
    label = later("Boring")


class TurnThread(TurningOperation):
    """Adds a thread to a lathe's job."""

    name = "CNCStepper_TurnThread"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_TurnThread", "Turn thread")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_TurnThread", "Cuts a thread by its designation, outside or inside")
    cycle = "turn_thread"
    label = later("Thread")


class PartRecords(Command):
    """Opens the window of part records."""

    name = "CNCStepper_PartRecords"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_PartRecords", "Part records…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_PartRecords", "Measured parts: height and three diameters, their mean, deviation, ratio, and plots"
    )

    def why_not(self) -> str:
        """Return why no table can be read."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Open the window."""
        from CNCStepper.workbench.part_records import open_part_records

        open_part_records()


COMMANDS = (
    NewLatheJob,
    TurningProfile,
    TurnFace,
    TurnRough,
    TurnFinish,
    TurnTaper,
    TurnGroove,
    TurnPart,
    TurnDrill,
    TurnBore,
    TurnThread,
    PartRecords,
)
