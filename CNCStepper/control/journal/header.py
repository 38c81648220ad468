# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first record of a journal: the program, its certificate, the machine and its work zero."""

from __future__ import annotations

import operator
import time
from itertools import islice
from pathlib import Path
from typing import Any

from CNCStepper import __version__
from CNCStepper.control.journal.replay import FORMAT, VERSION
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import ControllerInfo, offsets_of
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.stream.status_snapshot import HOMING
from CNCStepper.control.transport.port_identity import identify


def header_of(job: SendJob, driver: Grbl, found: ControllerInfo) -> dict[str, Any]:
    """Return the first record of a job's journal, as plain data; positions and offsets in mm.

    goes_back: some line of the file is sent again after later ones, so that its number alone names no place.
    made_with, profile: the options of the command line, and the machine's profile; empty where they are not known.
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "made_by": f"CNCStepper {__version__}",
        "begin": time.strftime("%Y-%m-%d %H:%M:%S"),
        "file": _where(job.file),
        "program_sha256": job.program_sha256,
        "restart_of": dict(job.restart_of),
        "certificate_sha256": job.certificate_sha256,
        "machine": job.machine,
        "profile": job.retrace.get("machine", {}),
        "made_with": dict(job.made_with),
        "lines": len(job.lines),
        "last_line": job.place(len(job.lines) - 1).line,
        "goes_back": any(map(operator.gt, job.file_lines, islice(job.file_lines, 1, None))),
        "port": job.port,
        "port_identity": identify(job.port).to_json(),
        "baud": job.baud,
        "firmware": found.version,
        "greeted": found.greeted,
        "homing": bool(found.settings.get(HOMING)),
        "modes": found.modes,
        "offsets_mm": offsets_of(driver, found),
        "dialect": job.dialect,
        "controller": found.firmware.key,
        "mpos_mm": driver.mpos_mm,
    }


def _where(file: str) -> str:
    """Return the whole path of a program's file, or its name where it is no file (a program within a document)."""
    return str(Path(file).resolve()) if file and Path(file).is_file() else file
