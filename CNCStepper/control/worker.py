# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender's process: `python -m CNCStepper.control.worker SESSION_FILE`, the job as JSON on standard input.

It lives as long as the job: a window that dies does not stop the cut, SIGTERM stops it safely (hold,
standstill, reset). Its exit status is 0 when the machine is idle at the job's end.
"""

from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path

from CNCStepper.control.outcome import FAILED, Outcome
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.sender import LOST, Sender
from CNCStepper.control.session_file import OUTCOME, write_private
from CNCStepper.control.session_server import SessionServer
from CNCStepper.errors import CNCStepperError

SWITCH_S = 0.0005  # a command must not wait for the sender's turn of 5 ms


def main(arguments: list[str]) -> int:
    """Run the job of standard input as the session whose file is `arguments[0]`; return the exit status."""
    sys.setswitchinterval(SWITCH_S)
    session = Path(arguments[0])
    job = SendJob.from_json(sys.stdin.buffer.read().decode("utf-8"))
    server = SessionServer()
    sender = Sender(job, tell=server.tell)
    _stop_on_signals(sender)
    server.start(sender)
    write_private(session, _address(server, job))
    outcome = _fault(sender)
    try:
        outcome = sender.run()
    finally:
        write_private(session.with_suffix(OUTCOME), outcome.to_json())
        session.unlink(missing_ok=True)
        server.finish(outcome)
    return 0 if outcome.done else 1


def _address(server: SessionServer, job: SendJob) -> dict[str, object]:
    return {
        "host": "127.0.0.1",
        "port": server.port,
        "token": server.token,
        "process": os.getpid(),
        "machine_port": job.port,
        "file": job.file,
        "begin": time.strftime("%Y-%m-%d %H:%M:%S"),
    }


def _fault(sender: Sender) -> Outcome:
    """Return the outcome that stands unless the sender gives its own: a fault of this program."""
    error = CNCStepperError("sender-fault", "the sender failed by a fault of its own", advice="see its log, report it")
    return Outcome(FAILED, f"{error}. Now {LOST}", False, sender.status(), error)


def _stop_on_signals(sender: Sender) -> None:
    """Let every polite signal end the job safely; a closed terminal is no reason to end it."""
    for name in ("SIGTERM", "SIGINT", "SIGBREAK"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), lambda *_: sender.stop())
    if hasattr(signal, "SIGHUP"):
        signal.signal(signal.SIGHUP, signal.SIG_IGN)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
