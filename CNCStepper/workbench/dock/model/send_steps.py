# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of sending a job, from the click to the end of the cut: no Qt, no FreeCAD, nothing done here.

    checking --> warned --go on--> connect --> zero --start--> starting --> cutting --> ended
        |                                        ^                 |
        `--> refused, failed                     `--- differs <----'   (send anyway starts it again)

Every step says what is asked, and which answer leads on. At the zero the program is checked again whenever the
machine's zero is no longer the one that it was checked with; that leads to where the first check leads.
"""

from __future__ import annotations

from dataclasses import dataclass

from CNCStepper.workbench.dock.model.button_states import CALM, DANGER, GOING, OFF, WAITING, ControllerSnapshot
from CNCStepper.workbench.services.translation import later


@dataclass(frozen=True)
class Step:
    """One step: its name, text and look, and the labels of its answers ("" for none).

    number: of the four things that a person sees happen, 0 for an end.
    """

    title: str
    text: str = ""
    tone: str = CALM
    confirm_step: str = ""
    away: str = later("Cancel")
    number: int = 0


STEPS = {
    "checking": Step(later("Checking the program"), later("The cut is simulated and checked."), GOING, number=1),
    "refused": Step(
        later("Refused"), later("The checks found errors: nothing is sent. Mend them, then send again."), DANGER,
        away=later("Close"),
    ),
    "failed": Step(later("Not sent"), tone=DANGER, away=later("Close")),
    "warned": Step(
        later("Warnings"), later("Look at the findings, then decide."), WAITING, later("Go on"), number=1
    ),
    "connect": Step(
        later("Connect"), later("Choose above where to cut, then connect."), CALM, later("Connect"), number=2
    ),
    "zero": Step(
        later("Work zero"), later("Is the work zero set on the stock, and is the path free?"), WAITING, later("Start"),
        number=3,
    ),
    "starting": Step(later("Starting"), later("The controller's settings are compared."), GOING, away="", number=4),
    "differs": Step(
        later("Another machine?"), later("The controller is set up differently. Nothing was sent."), WAITING,
        later("Send anyway"), number=4,
    ),
    "cutting": Step(later("Cutting"), tone=GOING, away="", number=4),
    "ended": Step(later("Done"), tone=CALM, away=later("Close")),
}  # fmt: skip
ENDS = frozenset({"refused", "failed", "ended"})
STARTS = frozenset({"zero", "differs"})  # the steps behind which the machine moves
POSITION_UNKNOWN = later(
    "The machine's position is unknown: home it, or move the tool to the work zero and press All = 0."
)
LAST_NUMBER = 4
OUTCOMES = {
    "done": (later("Done"), CALM),
    "stopped": (later("Stopped"), OFF),
    "refused": (later("Refused by the machine"), DANGER),
    "failed": (later("Failed"), DANGER),
}
AWAITED = {  # which happening moves which step to which
    ("checking", "clean"): "connect",
    ("checking", "warnings"): "warned",
    ("checking", "errors"): "refused",
    ("checking", "failure"): "failed",
    ("warned", "onward"): "connect",
    ("connect", "idle"): "zero",
    ("zero", "lost"): "connect",
    ("zero", "warnings"): "warned",
    ("zero", "errors"): "refused",
    ("zero", "failure"): "failed",
    ("zero", "onward"): "starting",
    ("starting", "cutting"): "cutting",
    ("starting", "differences"): "differs",
    ("starting", "outcome"): "ended",
    ("starting", "refusal"): "failed",
    ("starting", "lost"): "failed",
    ("differs", "onward"): "starting",
    ("differs", "lost"): "connect",
    ("differs", "moved"): "zero",
    ("cutting", "outcome"): "ended",
    ("cutting", "lost"): "failed",
}


@dataclass
class Flow:
    """The state of sending one job; `step` is "" when nothing is being sent.

    detail: what is said beside the step's own text, as people's words. anyway: somebody decided to send though the
    controller's settings differ. outcome: the kind of the outcome, at "ended". again: the program is being checked once
    more, with another zero.
    """

    step: str = ""
    label: str = ""
    detail: str = ""
    anyway: bool = False
    outcome: str = ""
    again: bool = False

    def begin(self, label: str) -> None:
        """Begin to send the job with this label; what was sent before is forgotten."""
        self.step, self.label, self.detail, self.outcome = "checking", label, "", ""
        self.anyway = self.again = False

    def happen(self, what: str, detail: str = "") -> bool:
        """Let something happen; return whether it moved the flow. What a step does not wait for changes nothing."""
        step = AWAITED.get((self.step, what))
        if step is None:
            return False
        self.anyway = self.anyway or (self.step == "differs" and what == "onward")
        self.step, self.detail, self.again = step, detail, False
        return True

    def end(self, kind: str, text: str) -> None:
        """Take the outcome of the cut."""
        if self.happen("outcome", text):
            self.outcome = kind

    def leave(self) -> None:
        """Give up, or close what has ended."""
        self.step, self.again = "", False

    @property
    def active(self) -> bool:
        """Whether a job is on its way to the machine."""
        return bool(self.step) and self.step not in ENDS

    @property
    def awaits_answer(self) -> bool:
        """Whether it waits for the user's answer."""
        return bool(self.step) and bool(STEPS[self.step].confirm_step)

    @property
    def shown(self) -> Step:
        """What to show now, the outcome's own name and colour at the end; not for an empty flow."""
        step = STEPS[self.step]
        if self.step != "ended":
            return step
        title, tone = OUTCOMES.get(self.outcome, OUTCOMES["failed"])
        return Step(title, step.text, tone, step.confirm_step, step.away)


def why_not_confirm(flow: Flow, moment: ControllerSnapshot) -> str:
    """Return why the question of this step cannot be answered with yes now, "" when it can."""
    if flow.again:
        return later("The program is being checked with this work zero.")
    if flow.step in STARTS and moment.phase != "idle":
        return later("The machine must be idle: wait, or home or unlock it first.")
    if flow.step in STARTS and moment.position_known is False:
        return POSITION_UNKNOWN
    if flow.step == "connect" and moment.busy:
        return later("The connection is being made.")
    return ""
