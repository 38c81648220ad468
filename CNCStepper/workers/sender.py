# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender's process: `python -m CNCStepper.workers.sender SESSION_FILE`, the job in the bundle beside the
session file.

It lives as long as the job: a window that dies does not stop the cut, SIGTERM stops it safely (hold,
standstill, reset). Its exit status is 0 when the machine is idle at the job's end.
"""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path

from CNCStepper.control.journal.writer import Journal
from CNCStepper.control.processes.process_file import ProcessFile, unlink_with_retries
from CNCStepper.control.processes.sleep_inhibitor import inhibit_sleep
from CNCStepper.control.processes.thread_priority import go_first
from CNCStepper.control.program.send_job import read_job
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.detached_process import stop_on_signals
from CNCStepper.control.session.files import OUTCOME, WIRE, write_private
from CNCStepper.control.session.server import SessionServer
from CNCStepper.control.session.status import FAILED, Outcome
from CNCStepper.control.stream.job_run import LOST
from CNCStepper.control.transport.port_identity import identify
from CNCStepper.errors import CNCStepperError, Text

SWITCH_S = 0.0005  # a command must not wait for the sender's turn of 5 ms


def main(arguments: list[str]) -> int:
    """Run the job of the session whose file is `arguments[0]`; return the exit status."""
    sys.setswitchinterval(SWITCH_S)
    go_first()
    session = Path(arguments[0])
    wire = session.with_suffix(WIRE)
    job = read_job(wire)
    own_file = ProcessFile(session)
    server = SessionServer(session, each_turn=own_file.keep)
    identity = {"port_identity": identify(job.port).to_json()}  # whatever its name will mean while the job runs
    kept = PositionTrustFile.of_port(session.parent, job.port)
    sender = Sender(job, tell=server.tell, refuse=server.refuse, journal=Journal(session.parent), kept=kept)
    stop_on_signals(sender.stop)
    server.start(sender)
    own_file.write(server.address(job.port, job.file) | identity)
    outcome = _fault(sender)
    try:
        with inhibit_sleep(partial(server.tell, "warning")):
            outcome = sender.run()
    finally:
        try:
            write_private(session.with_suffix(OUTCOME), outcome.to_json())
        finally:  # who listens gets it, also where the disk takes nothing any more
            own_file.remove()
            unlink_with_retries(wire)
            server.notify_outcome(outcome)
            server.finish()
    return 0 if outcome.done else 1


def _fault(sender: Sender) -> Outcome:
    """Return the outcome where the sender gives none of its own: a fault of this program."""
    error = CNCStepperError("sender-fault", "the sender failed by a fault of its own", advice="see its log, report it")
    return Outcome(FAILED, Text("{error}. Now {state}", error=error, state=LOST), False, sender.status(), error)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
