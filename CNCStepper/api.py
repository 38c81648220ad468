# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the Python interface that joins several packages: make a job's program, prove it, send it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from CNCStepper.machine.controller_family import BAUD

if TYPE_CHECKING:
    from CNCStepper.control.session.status import Outcome
    from CNCStepper.job.make import Made
    from CNCStepper.job.model import Job
    from CNCStepper.job.prove import Proof
    from CNCStepper.machine.profile import Machine


def make(job: Job, machine: Machine | None = None, title: str = "") -> Made:
    """Return the program of a job (`.program` is its text) for a machine, its own unless another is given.

    Raises CycleError, JobError or ProgramError, and makes nothing.
    """
    from CNCStepper.job.make import make_program
    from CNCStepper.machine.profile import load_machine

    return make_program(job, machine or load_machine(job.machine), title)


def prove(program: str, machine: Machine, job: Job | None = None, **given: Any) -> Proof:
    """Return the proof of a program text: read back, timed, and with stock and tools cut and checked.

    job: gives stock, tools, clamps and the shapes wanted. Without one, `given` are the arguments of
    `CNCStepper.job.prove.prove`: stock, tools, start, file, dialect and more. Raises ProgramError for a text that
    cannot be read.
    """
    from CNCStepper.job import prove as proofs

    return proofs.prove_job(job, machine, program, **given) if job else proofs.prove(program, machine, **given)


def send(proof: Proof, port: str, *, zero_confirmed: bool = False, baud: int = BAUD, **more: Any) -> Outcome:
    """Send a proven program in a process of its own and return how it ended, when the machine is idle again.

    zero_confirmed: the work zero is set on the stock and the way is free. more: other fields of a `SendJob`, such as
    home_first. Raises JobError "certificate-errors" for a proof with errors; an Outcome tells every other end.
    """
    from CNCStepper.control.session.client import SessionClient
    from CNCStepper.job.make_certificate import certificate_of

    certificate = certificate_of(proof)
    certificate.check_clean()
    job = certificate.send_job(port=port, baud=baud, zero_confirmed=zero_confirmed, **more)
    return SessionClient.start(job).wait()
