# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operations of a lathe: a tool, a cycle's parameters, and the half profile that some of them follow."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.turning.turning_parameters import (
    TurnDrillParameters,
    TurnFaceParameters,
    TurnFinishParameters,
    TurnGrooveParameters,
    TurnPartParameters,
    TurnRoughParameters,
    TurnTaperParameters,
    TurnThreadParameters,
)
from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.processes import TURNING
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import FLOAT, LATHE_JOB, Property, show
from CNCStepper.workbench.features.cycle_operation import (
    OPERATION,
    CycleOperation,
    drawings_of,
    drawn,
    jobs_of,
    refuse_what_it_stands_on,
    tool_of,
)
from CNCStepper.workbench.features.parameters import properties_of
from CNCStepper.workbench.services.translation import later

PROFILE_GROUP, IN_PROGRAM = later("Profile"), later("In the program")
FOLLOWED = drawn(PROFILE_GROUP, later("The half profile that it turns: a sketch, edges, a solid or points"))
THREADED = drawn(PROFILE_GROUP, later("The half profile whose diameter the thread has; without it the usual fit"))
USED = (
    Property("used_rpm", "SpindleUsed", FLOAT, IN_PROGRAM, later("Spindle"),
             later("The spindle's speed in the program"), 0.0, output=True),
    Property("used_feed_mm_rev", "FeedUsed", FLOAT, IN_PROGRAM, later("Feed per turn"),
             later("The feed of the program, in millimetres a turn"), 0.0, output=True),
)  # fmt: skip


class TurningOperation(CycleOperation):
    """The proxy of an operation of a lathe. FOLLOWS: whether it needs a profile."""

    JOB_TYPE = LATHE_JOB
    BY = (TURNING,)
    FOLLOWS = False
    ONE_DRAWING = True
    PICKS_LINES = True
    TAKES_SOLIDS = True

    @classmethod
    def look(cls, drawing: Any, picked: tuple[str, ...]) -> None:
        """Raise GeometryError for what gives no half profile."""
        from CNCStepper.workbench.document.turning.profile_of_operation import look_at_profile

        look_at_profile(drawing, picked)

    def operation(self, obj: Any, profile: str) -> Any:
        """Return the core's operation of `obj`, checked; profile: the name of its profile. Raises CycleError."""
        packages.require()
        from CNCStepper.cycles.turning.turning_operation import turning_operation_class
        from CNCStepper.machine.profile import validated

        content = {"cycle": self.CYCLE, "tool": tool_of(obj).Number, **self.given(self.known(obj))}
        if profile:
            content["profile"] = profile
        return validated(turning_operation_class(self.CYCLE), content, obj.Label)

    def question(self, obj: Any) -> dict[str, Any] | None:
        """Return what the cut process is asked for its figures; None while it belongs to no job."""
        self._require_what_it_needs(obj)
        jobs = jobs_of(obj)
        if not jobs:
            return None
        from CNCStepper.workbench.document.turning.core_turning_job import cut_question

        return cut_question(jobs[0], obj)

    def make(self, obj: Any) -> None:
        """Cut it for trial, as its job would, and show the figures."""
        self.warnings = ()
        self._require_what_it_needs(obj)
        jobs = jobs_of(obj)
        if not jobs:
            return
        from CNCStepper.workbench.document.turning.core_turning_job import cut_for_trial

        figures, self.warnings = cut_for_trial(jobs[0], obj)
        show(obj, {"used_rpm": figures["rpm"], "used_feed_mm_rev": figures["feed_mm_rev"]})

    def _require_what_it_needs(self, obj: Any) -> None:
        if self.FOLLOWS and not drawings_of(obj) and not obj.DeletedDrawing:
            raise CycleError(
                "profile-missing",
                Text("{obj} has no profile", obj=obj.Label),
                advice="choose a sketch, edges, a solid of revolution or points for it",
            )
        if "DeletedDrawing" in obj.PropertiesList:
            refuse_what_it_stands_on(obj)
        tool_of(obj)


class TurnFace(TurningOperation):
    """The proxy of facing."""

    Type = "CNCStepper_TurnFace"
    CYCLE = "turn_face"
    PROPERTIES = (*OPERATION, *properties_of(TurnFaceParameters), *USED)


class TurnRough(TurningOperation):
    """The proxy of roughing outside."""

    Type = "CNCStepper_TurnRough"
    CYCLE = "turn_rough"
    FOLLOWS = True
    PROPERTIES = (*OPERATION, *FOLLOWED, *properties_of(TurnRoughParameters), *USED)


class TurnFinish(TurningOperation):
    """The proxy of finishing."""

    Type = "CNCStepper_TurnFinish"
    CYCLE = "turn_finish"
    FOLLOWS = True
    PROPERTIES = (*OPERATION, *FOLLOWED, *properties_of(TurnFinishParameters), *USED)


class TurnGroove(TurningOperation):
    """The proxy of a groove."""

    Type = "CNCStepper_TurnGroove"
    CYCLE = "turn_groove"
    PROPERTIES = (*OPERATION, *properties_of(TurnGrooveParameters), *USED)


class TurnPart(TurningOperation):
    """The proxy of parting off."""

    Type = "CNCStepper_TurnPart"
    CYCLE = "turn_part"
    PROPERTIES = (*OPERATION, *properties_of(TurnPartParameters), *USED)


class TurnDrill(TurningOperation):
    """The proxy of drilling on the axis."""

    Type = "CNCStepper_TurnDrill"
    CYCLE = "turn_drill"
    PROPERTIES = (*OPERATION, *properties_of(TurnDrillParameters), *USED)

    def onChanged(self, obj: Any, name: str) -> None:
        """Let what goes into the hole be figured again; FreeCAD calls this at every change."""
        super().onChanged(obj, name)
        if name in ("Active", "Tool") and "Restore" not in obj.State:
            renew_what_follows(obj)


class TurnBore(TurningOperation):
    """The proxy of roughing in a bore."""

    Type = "CNCStepper_TurnBore"
    CYCLE = "turn_bore"
    FOLLOWS = True
    PROPERTIES = (*OPERATION, *FOLLOWED, *properties_of(TurnRoughParameters), *USED)


class TurnTaper(TurningOperation):
    """The proxy of a cone."""

    Type = "CNCStepper_TurnTaper"
    CYCLE = "turn_taper"
    PROPERTIES = (*OPERATION, *properties_of(TurnTaperParameters), *USED)


class TurnThread(TurningOperation):
    """The proxy of a thread."""

    Type = "CNCStepper_TurnThread"
    CYCLE = "turn_thread"
    PROPERTIES = (*OPERATION, *THREADED, *properties_of(TurnThreadParameters), *USED)


def renew_what_follows(obj: Any) -> None:
    """Let the operations of a job behind one of its drillings be figured again."""
    for job in jobs_of(obj):
        operations = list(job.Operations)
        for each in operations[operations.index(obj) + 1 :] if obj in operations else ():
            each.touch()


TURNING_KINDS: tuple[type[TurningOperation], ...] = (
    TurnFace,
    TurnRough,
    TurnFinish,
    TurnTaper,
    TurnGroove,
    TurnPart,
    TurnDrill,
    TurnBore,
    TurnThread,
)
TURNING_OPERATIONS = {kind.CYCLE: kind for kind in TURNING_KINDS}
