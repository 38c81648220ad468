# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a job's spool in a process of its own, a block at a time, while the connection service goes on.

python -m CNCStepper.control.service.spool_process FILE SPOOL     standard input:  values for some fields of the job,
as JSON
                                                    standard output: {"job": without its lines} or {"error": ...}
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.control.program.certificate import sendable
from CNCStepper.control.program.long_json import read_long
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.spool import read_spool, write_spool
from CNCStepper.control.session.status import error_from_json, error_to_json
from CNCStepper.errors import CNCStepperError, JobError

SPOOLER = "CNCStepper.control.service.spool_process"
NO_WINDOW = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # Windows opens one for the child of a process that has none


def spooled(file: Path, spool: Path, **instead: Any) -> SendJob:
    """Return the job of a file as `sendable` has it, its lines read from `spool` when they are asked for.

    What was in that spool is replaced; a job that is refused leaves it. Raises JobError, and ProgramError for a line
    that holds the end of one.
    """
    draft = spool.with_suffix(".new" + spool.suffix)
    try:
        job = SendJob.from_content(_told(file, draft, instead))
        os.replace(draft, spool)
    except OSError as error:
        raise _unread(error) from error
    finally:
        draft.unlink(missing_ok=True)
    return read_spool(spool, job)


def main(arguments: list[str]) -> int:
    """Write the spool of a file and report its job, or the error; return the exit status."""
    file, spool = map(Path, arguments)
    try:
        answer = {"job": _written(file, spool, json.load(sys.stdin)).to_content()}
    except CNCStepperError as error:
        answer = {"error": error_to_json(error)}
    print(json.dumps(answer))
    return 0


def _written(file: Path, spool: Path, instead: dict[str, Any]) -> SendJob:
    spool.unlink(missing_ok=True)  # of a spooler that was killed
    try:
        with open(file, "rb") as certificate:
            return write_spool(spool, sendable(read_long(certificate), **instead))
    except CNCStepperError:
        raise
    except (OSError, ValueError, TypeError) as error:
        raise _unread(error) from error


def _told(file: Path, spool: Path, instead: dict[str, Any]) -> dict[str, Any]:
    """Return what a spooler's process says of a job; raises what it says instead."""
    words = command(sys.executable, SPOOLER, str(file), str(spool))
    told = json.dumps(instead).encode("ascii")
    process = subprocess.run(words, input=told, capture_output=True, env=environment(), creationflags=NO_WINDOW)
    try:
        answer = json.loads(process.stdout)
    except ValueError as error:
        raise _unread(process.stderr.decode("utf-8", "replace").strip()[-200:]) from error
    if "error" in answer:
        raise error_from_json(answer["error"])
    return answer["job"]


def _unread(why: object) -> JobError:
    return JobError("send-job", f"the job cannot be read: {why}", advice="make it again")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
