# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job of a machine whose controller is a process of this computer: by which profile that process drives it.

The profile is the one that the command line names. A job or a certificate without --machine has the profile in it: a
copy of that is written beside the sessions, under the name of its content.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.path_types import TYPED
from CNCStepper.machine.controller_family import FAMILIES, OWN
from CNCStepper.machine.profile import profile_names

if TYPE_CHECKING:
    from CNCStepper.control.program.send_job import SendJob


def typed_machine() -> str:
    """Return the profile of the command line by its name or its whole path; "" where it names none."""
    typed = click.get_current_context().meta.get(f"{TYPED}machine") or ""
    return typed if not typed or typed in profile_names() else str(Path(typed).resolve())


def driven_by(job: SendJob, content: Mapping[str, Any], profile: str) -> SendJob:
    """Return the job with the profile that drives its machine, where no controller of its own is at the port.

    content: of the machine's profile. profile: as the command line names it. Raises OSError where a copy of the content
    cannot be written.
    """
    if FAMILIES.get(str(content.get("controller", "")), "") not in OWN:
        return job
    return replace(job, profile=profile or str(_copy_of(content)))


def _copy_of(content: Mapping[str, Any]) -> Path:
    from CNCStepper.control.program.certificate import digest_of
    from CNCStepper.control.session.files import session_folder, write_private

    path = session_folder() / f"machine-{digest_of(content)[:16]}.json"
    write_private(path, content)
    return path


def with_rate(job: SendJob) -> SendJob:
    """Return the job with its fastest rate of pulses, where its controller is to try that."""
    from CNCStepper.job.make_certificate import peak_rate

    return job if job.pulses_per_s else replace(job, pulses_per_s=peak_rate(job))
