# SPDX-License-Identifier: LGPL-2.1-or-later
"""A restart, proven: the program from a place on, against the stock that the moves before it have cut.

moves before the place + a lift  |  entry + the program's own lines      cut one after the other, judged together
          taken as done          |  checked line by line
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isnan
from pathlib import Path
from typing import Any, Unpack

from CNCStepper.control.journal.replay import FirstProgram, pairs_of
from CNCStepper.control.program.certificate import Certificate, digest_of_text
from CNCStepper.cycles.cycle import Answer, Removal
from CNCStepper.errors import Place
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.model import Job
from CNCStepper.job.prove import (
    PriorPrograms,
    Proof,
    ProofOptions,
    answers_of,
    operations_before,
    prove,
    prove_operations,
    removals_of,
    with_findings,
)
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.recovery.restart.approach import Options
from CNCStepper.recovery.restart.description import height_mm
from CNCStepper.recovery.restart.interrupted_program import read_on_machine
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.recovery.restart.restart_program import Restart, restart_of
from CNCStepper.simulation.checks.stock_checks import JUDGE_ERROR_MM
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.prior_programs import followed
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start


@dataclass(frozen=True)
class EntryOptions:
    """How a person wants the path entered; see `Options`. height_mm: None is as the program's own rapids go."""

    overlap_mm: float = 0.0
    height_mm: float | None = None


@dataclass(frozen=True)
class ProvenRestart:
    """A restart program and its proof; `certificate_of_restart` makes the certificate for a sender."""

    restart: Restart
    proof: Proof


def restart_program(
    text: str,
    machine: Machine,
    where: RequestedPlace,
    entering: EntryOptions | None = None,
    *,
    file: str = "",
    start: Start | None = None,
    stock: Stock | None = None,
    tools: dict[int, Tool] | Tool | None = None,
    **options: Unpack[ProofOptions],
) -> ProvenRestart:
    """Return the restart of a program at a place, proven as `prove` does; raises ProgramError where it cannot be."""
    program = read_on_machine(text, machine, options.get("dialect", ""), start, file)
    made = restart_of(program, where, _options(machine, tools, entering))
    options["dialect"] = program.dialect.name
    before = PriorPrograms(made.cut, (digest_of_text(text),))
    proof = prove(
        made.text,
        machine,
        file=restart_name(file),
        start=made.start,
        stock=stock,
        tools=tools,
        before=before,
        **options,
    )
    return ProvenRestart(made, proof)


def restart_job(
    job: Job,
    machine: Machine,
    text: str,
    where: RequestedPlace,
    entering: EntryOptions | None = None,
    *,
    file: str = "",
    start: Start | None = None,
    earlier: Sequence[Proof] = (),
    **options: Unpack[ProofOptions],
) -> ProvenRestart:
    """Return the restart of a job's program at a place, judged against the whole shapes that the job wants removed.

    earlier: the proofs of the programs that the job was split into and that were run before this one
    (`prior_proofs`). Raises ProgramError where it cannot be restarted there.
    """
    program = read_on_machine(text, machine, options.get("dialect", ""), job.started(start, machine), file)
    made = restart_of(program, where, _options(machine, job.on(machine).tools, entering))
    options["dialect"] = program.dialect.name
    done = sum(span.last <= made.entrance.row for span in made.program.operations)

    def wanted() -> tuple[Sequence[Answer], Sequence[Removal]]:
        answers = answers_of(job, machine, len(earlier))
        return answers[done:], removals_of(answers, earlier)

    proof = prove_operations(
        job,
        machine,
        made.text,
        wanted,
        first=operations_before(job, len(earlier)) + done,
        before=_before(made, text, earlier),
        file=restart_name(file),
        start=made.start,
        **options,
    )
    return ProvenRestart(made, with_findings(proof, _incomplete(proof)))


def certificate_of_restart(proven: ProvenRestart) -> Certificate:
    """Return the certificate of a restart; it names the first program, which a restart of the restart begins from."""
    made = proven.restart
    file = Path(made.program.file)
    first = FirstProgram(
        str(file.resolve()) if file.is_file() else str(made.program.file),
        proven.proof.given.before[-1],
        tuple(pairs_of(made.file_lines.tolist())),
    )
    return certificate_of(proven.proof).sending(restart_of=first.to_content(), lift=_lift(made))


def _lift(made: Restart) -> dict[str, Any]:
    """Return to where the restart goes first, as a `SendJob` has it; the G92 in force is set only after it."""
    approach, state = made.approach, made.approach.state
    if isnan(approach.safe_mm):
        return {}
    system_mm = state.offset_mm[2] - state.g92_mm[2] - state.tool_length_mm
    return {"system": state.work_system, "z_mm": approach.safe_mm - system_mm, "height_mm": height_mm(made)}


def restart_name(file: str) -> str:
    """Return the name of a program's restart: "part.nc" gives "part-restart.nc"."""
    name, dot, suffix = file.rpartition(".")
    return f"{name}-restart.{suffix}" if dot else f"{file}-restart"


def _options(machine: Machine, tools: dict[int, Tool] | Tool | None, entering: EntryOptions | None) -> Options:
    entering = entering or EntryOptions()
    spindle = machine.spindle
    is_wire = set(machine.processes) == {"hot-wire"}
    own = (entering.overlap_mm, entering.height_mm, spindle.spin_up_s, spindle.laser, tools)
    return Options(*own, machine.run_up_mm, is_wire)


def _before(made: Restart, text: str, earlier: Sequence[Proof]) -> PriorPrograms:
    """Return all that has cut the stock: the programs before this one, and this one up to the entrance."""
    before, digest = PriorPrograms.of(earlier), digest_of_text(text)
    if before is None:
        return PriorPrograms(made.cut, (digest,))
    return PriorPrograms(followed(before.toolpath, made.cut), (*before.sha256, digest))


def _incomplete(proof: Proof) -> list[Finding]:
    """Return that the whole part is not as it is wanted, where the worst place lies in what was cut before.

    The checks report only the program's own lines; a restart must also show whether the part will be good.
    """
    allowed_mm = max((removal.tolerance_mm for removal in proof.given.removals), default=0.0) + JUDGE_ERROR_MM
    found = []
    for code, text in (
        ("gouge", "the moves before the restart cut into the wanted part"),
        ("left_over", "the moves before the restart leave material that should be removed"),
    ):
        value_mm = proof.report[f"{code}_mm"]
        told = any(finding.code == code.replace("_", "-") for finding in proof.findings)
        if value_mm is not None and value_mm > allowed_mm and not told:
            numbers = {"value": value_mm, "limit": allowed_mm, "unit": "mm"}
            place = Place(proof.report["program"], 1, 1)
            advice = "restart earlier, or make a new part"
            found.append(Finding("error", "restart-incomplete", place, text, advice, **numbers))  # type: ignore[arg-type]
    return found
