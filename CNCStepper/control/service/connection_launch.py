# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts a connection service on a thread: finding a Python and starting it take time."""

from __future__ import annotations

import subprocess
import threading
import time
from concurrent.futures import Future
from pathlib import Path

from CNCStepper.control.processes.python_finder import find_python
from CNCStepper.control.service.port_of_job import check_no_job
from CNCStepper.control.session.detached_process import start
from CNCStepper.control.session.files import DESK, new_session, service_at, session_folder
from CNCStepper.errors import CNCStepperError, LinkError, Text

WORKER = "CNCStepper.workers.connection_service"
YIELD_S = 0.005  # the thread of the window goes on first

Launched = tuple[Path, subprocess.Popen | None]


def launch(port: str, baud: int, folder: Path | None) -> Future[Launched]:
    """Return a future of the service's file at `port` and its process; None when it runs already.

    Its exception is MissingPackage when no Python can be the desk's, MachineRefusal while a job that was sent from a
    command line has the port, or LinkError when it cannot be started.
    """
    answer: Future[Launched] = Future()

    def work() -> None:
        time.sleep(YIELD_S)
        try:
            path, process = _launched(port, baud, folder or session_folder())
        except CNCStepperError as error:
            answer.set_exception(error)
            return
        except Exception as error:  # the disk is full, the folder is gone: the window is to say so
            answer.set_exception(
                LinkError("desk-start", Text("the desk cannot be started: {error}", error=error), advice="try again")
            )
            return
        answer.set_result((path, process))
        if process:
            process.wait()  # so that nothing is left of it when it has ended

    threading.Thread(target=work, name="launch-desk", daemon=True).start()
    return answer


def _launched(port: str, baud: int, folder: Path) -> Launched:
    if there := service_at(port, folder):
        return there, None
    check_no_job(port, folder)
    path = new_session(folder, DESK)
    return path, start(find_python(), WORKER, path, port, str(baud))
