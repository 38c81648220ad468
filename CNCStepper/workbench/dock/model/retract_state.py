# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state of a retract in the dock: last request, its result, possible requests; no Qt."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from CNCStepper.control.session.status import SenderStatus
from CNCStepper.workbench.dock.model.button_states import RULES, STANDING, ControllerSnapshot, why_not
from CNCStepper.workbench.services.translation import later

FIND, RESUME = "find", "resume"
BACK, LINE, ENTRY, FORWARD, ASIDE = (
    "back_mm",
    "line",
    "entry",
    "forward_mm",
    "aside",
)  # as `workers/path_retract.py` says
Request = tuple[str, float | bool]  # one of these, and how far
THERE_MM = 0.001  # no further behind is where the cut has come to
RULE_OF = {BACK: "back", LINE: "back", ENTRY: "back", FORWARD: "forward", ASIDE: "aside", RESUME: "resume"}
DOES = {
    BACK: RULES["back"].does,
    LINE: later("Go back to where this line of the program begins, its last run before here."),
    ENTRY: later("Go back to where the tool last began to go down into the work."),
    FORWARD: RULES["forward"].does,
    ASIDE: RULES["aside"].does,
}
UNDER_WAY = later("The retract along the cut is being calculated: wait, hold or stop.")
NOTHING_AHEAD = later("The tool is at the end of the cut.")
FINDING = later("The place on the cut is being looked for…")
PROVING = later("The retract along the cut is being checked…")
GOING = later("The tool moves along the cut.")
UNKNOWN = later("The tool can retract along exactly the path by which it came.")


def request_of(status: SenderStatus | None) -> Request | None:
    """Return the request of the machine's buttons, from its session's status."""
    if status is None or (status.wanted_back_mm is None and not status.wanted_rest):
        return None
    return (RESUME, True) if status.wanted_back_mm is None else (BACK, status.wanted_back_mm)


@dataclass
class RetractFlow:
    """The retract in progress, and the tool's place on its cut.

    line: of the program, 0 where it is not known. behind_mm: how far the tool is behind where the cut has come to.
    trouble: why the last request was refused.
    """

    line: int = 0
    behind_mm: float = 0.0
    trouble: str = ""
    _pending: list[str] = field(default_factory=list)  # asked, and answered in this order
    _phase: str = ""
    _request: Request | None = None  # of the machine's buttons, as it was last
    _due: Request | None = None  # of theirs, what was not asked for yet

    @property
    def asked(self) -> str:
        """What was asked last and is not answered yet, "" for nothing."""
        return self._pending[-1] if self._pending else ""

    def ask(self, kind: str) -> None:
        """Note that something was asked."""
        self._pending.append(kind)
        self.trouble = ""

    def answer(self, answer: Mapping[str, Any]) -> None:
        """Take an answer of the worker, unless it is a refusal."""
        del self._pending[:1]
        self.line, self.behind_mm = answer.get("line", 0), answer.get("behind_mm", 0.0)

    def refuse(self, trouble: str) -> str:
        """Take why nothing came of what was asked first, as people's words; return what that was."""
        self.trouble = trouble
        return self._pending.pop(0) if self._pending else ""

    def forget(self) -> None:
        """Drop the pending answer and the known place."""
        self._pending.clear()
        self.line, self.behind_mm, self.trouble, self._due = 0, 0.0, "", None

    def follow(self, moment: ControllerSnapshot) -> bool:
        """Follow the machine; return whether its place on the cut is to be looked for now: it was just held."""
        entered, self._phase = moment.phase != self._phase, moment.phase
        if moment.phase not in (*STANDING, "holding") and not self.asked:
            self.forget()
        return entered and moment.phase == "held" and moment.job_runs and not self.asked

    def request_of_machine(self, request: Request | None, moment: ControllerSnapshot) -> Request | None:
        """Return what to do now for the buttons of the machine, once for each time that one is pressed.

        A request leaves the status as soon as anybody asks for the place; pressed on the way, it is done after that.
        """
        before, self._request = self._request, request
        if request is not None and request != before:
            self._due = _added(self._due, before, request)
        if self._due is None or why_not_back(self._due[0], self, moment):
            return None
        due, self._due = self._due, None
        return due


def _added(due: Request | None, before: Request | None, request: Request) -> Request:
    """Return what is due after another press: lengths in the status, and those that wait here, add up."""
    if request[0] != BACK:
        return request
    seen_mm = before[1] if before and before[0] == BACK and before[1] < request[1] else 0.0
    waiting_mm = due[1] if due and due[0] == BACK else 0.0
    return BACK, waiting_mm + request[1] - seen_mm


def why_not_back(kind: str, flow: RetractFlow, moment: ControllerSnapshot) -> str:
    """Return why a way cannot be asked for now, "" when it can."""
    if moment.connected and not moment.job_runs:
        return later("No job runs: there is no cut to go back along.")
    if why := why_not(RULE_OF[kind], moment):
        return why
    if flow.asked and flow.asked != FIND:
        return UNDER_WAY
    return NOTHING_AHEAD if kind == FORWARD and flow.line and flow.behind_mm < THERE_MM else ""


def state_text(flow: RetractFlow, moment: ControllerSnapshot) -> str:
    """Return the text of the retract, still to be translated; {0} is a line, {1} a length."""
    if flow.asked == FIND:
        return FINDING
    if flow.asked:
        return GOING if moment.phase in ("running", "finishing") else PROVING
    if not flow.line:
        return UNKNOWN
    if flow.behind_mm < THERE_MM:
        return later("The tool is on line {0}, at the end of the cut.")
    return later("The tool is on line {0}, {1} behind the end of the cut.")
