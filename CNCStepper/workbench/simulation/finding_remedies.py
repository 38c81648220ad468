# SPDX-License-Identifier: LGPL-2.1-or-later
"""What mends the findings of a proof at one click: for each finding the button below it in the list, if any.

    finding ──► the rule of its code ──► a change of one object, where it surely helps ──► a button

A press makes one undo step and the program anew; a change that an operation or the job then refuses is taken back.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.processes import MILLING
from CNCStepper.workbench import api
from CNCStepper.workbench.document.undo_steps import undo_step
from CNCStepper.workbench.features.base import FAILED, JOB, STALE, edit, proxy_type
from CNCStepper.workbench.services.jit_guard import LONG, WAITS
from CNCStepper.workbench.services.remedy_bar import Remedy
from CNCStepper.workbench.simulation import operation_remedies, tool_remedies
from CNCStepper.workbench.simulation.proven_job import Change, ProvenJob

if TYPE_CHECKING:
    from CNCStepper.simulation.finding import Finding

RULES: dict[str, Callable[[ProvenJob, Finding], Change | None]] = {
    "spindle-speed": tool_remedies.spindle_speed,
    "feed-above-rate": tool_remedies.feed_above_rate,
    "chip-load": tool_remedies.chip_load,
    "feeds": tool_remedies.feeds,
    "flute-length": operation_remedies.flute_length,
    "below-stock": operation_remedies.below_stock,
    "beside-stock": operation_remedies.beside_stock,
    "not-exact": operation_remedies.tabs,
    "piece-loose": operation_remedies.piece_loose,
    "coolant": operation_remedies.coolant,
    "clamp": operation_remedies.clamp,
}  # by the code of the finding


def of_proof(job: Any, result: Any, mended: Callable[[], None]) -> list[Remedy | None]:
    """Return the remedy of each finding of a proof; the same one is offered once.

    job: what was proven; only a milling job's own program has remedies. mended: is called when one was applied.
    """
    if not _is_proven(job, result):
        return [None] * len(result.findings)
    proven, texts = ProvenJob(job, result), set[str]()
    found: list[Remedy | None] = []
    for finding in result.findings:
        change = change_for(proven, finding)
        is_new = change is not None and change.text not in texts
        found.append(_remedy(job, finding.code, change, mended) if change and is_new else None)
        texts |= {change.text} if change else set()
    return found


def _is_proven(job: Any, result: Any) -> bool:
    """Return whether an object is a milling job whose program is still the proven one."""
    if proxy_type(job) != JOB or job.Process != MILLING.name:
        return False
    try:
        return bool(api.program_text(job).splitlines() == result.program_lines)
    except CNCStepperError:
        return False


def change_for(proven: ProvenJob, finding: Finding) -> Change | None:
    """Return what surely mends a finding, None where nothing does or the document cannot be read now."""
    rule = RULES.get(finding.code)
    if rule is None or finding.severity == "info":
        return None
    try:
        return rule(proven, finding)
    except CNCStepperError:  # a tool, machine or drawing with a problem says it itself
        return None


def _remedy(job: Any, code: str, change: Change, mended: Callable[[], None]) -> Remedy:
    def act() -> None:
        apply(job, change)
        mended()

    return Remedy(code, change.text, act)


def apply(job: Any, change: Change) -> None:
    """Make a change and the program, in one undo step; raises the refusal of what it would spoil, and takes it back."""
    try:
        with undo_step(job.Document, change.text):
            edit(change.obj, **change.values)
            job.Document.recompute()
            for refusal in _refusals([job, *job.Operations, *job.Tools]):
                raise refusal
    except CNCStepperError:
        job.Document.recompute()
        raise


def _refusals(objects: Sequence[Any]) -> list[CNCStepperError]:
    """Return why objects cannot be made; what only waits for a cut is none, nor what another object has caused."""
    refusals = [each.Proxy.refusal for each in objects]
    return [each for each in refusals if each is not None and each.code not in (FAILED, STALE, WAITS, LONG)]
