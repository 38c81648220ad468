# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the owner of a machine's port: a running or paused job, or a connection service of this user.

A service without a job is shared by all. A second opening would get nothing from a serial port, and from a network
port a connection that breaks at once: both look as if the cable were at fault.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from CNCStepper.control.processes.process_file import is_alive
from CNCStepper.control.service.connection_client import check_no_job, check_over, port_held_by_job
from CNCStepper.control.service.connection_session import ConnectionSession
from CNCStepper.control.session.files import closed_files, service_at, service_near
from CNCStepper.control.session.unreachable import closed
from CNCStepper.errors import LinkError, MachineRefusal, Text


def check_free(port: str, folder: Path | None = None) -> None:
    """Raise MachineRefusal when a job of this user holds the port, or a connection service that may be at its host.

    A service at this port that runs no job is no owner: a job goes through it.
    """
    check_no_job(port, folder)
    if service := service_near(port, folder):
        _check_service(service, port, is_there=service == service_at(port, folder))


def warn_of_closed(tell: Callable[[str], None], folder: Path | None = None) -> None:
    """Tell of each session that lives and cannot be read: it may have the port that is opened now, and keeps none."""
    for path in filter(is_alive, closed_files(folder)):
        tell(str(closed(path)))


def _check_service(service: Path, port: str, is_there: bool) -> None:
    try:
        with ConnectionSession.attach(service) as client:
            status = client.status()
    except LinkError as error:  # it has ended meanwhile, or it does not answer
        check_over(service, port, error)
        return
    if status.total:
        raise port_held_by_job(service, port, status)
    if not is_there:
        raise MachineRefusal(
            "port-held",
            Text("{port} may be held by another connection of yours", port=port),
            advice="close it first: cncstepper disconnect",
        )
