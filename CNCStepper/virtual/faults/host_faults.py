# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of the sender's computer, as a virtual controller of its own process can cause them: its end, by force."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.virtual.faults.plan import SERVER_KINDS, Fault, FaultPlan, read_plan

KILL = getattr(signal, "SIGKILL", signal.SIGTERM)  # on Windows SIGTERM ends a process as hard


def plan_for_server(path: Path, kinds: Sequence[str] = SERVER_KINDS) -> FaultPlan:
    """Return the plan of a file; raises JobError when it holds what this virtual machine cannot do."""
    plan = read_plan(path)
    for fault in plan.fault:
        if fault.kind == "disk":
            raise _refusal(path, "the sender's disk cannot be filled from here", "take the fault 'disk' out")
        if fault.kind not in kinds:
            raise _refusal(
                path,
                Text("this machine has no fault '{kind}'", kind=fault.kind),
                Text("there are {kinds}", kinds=", ".join(kinds)),
            )
        if fault.kind == "kill" and not fault.pid_file:
            raise _refusal(path, "the fault 'kill' does not say whom", "add pid_file = a session file of the sender")
    return plan


def kill_sender(fault: Fault) -> None:
    """Kill the process whose number stands in the fault's `pid_file`; one that has ended already is no error."""
    if fault.kind == "kill":
        with suppress(ProcessLookupError):
            os.kill(_process(Path(fault.pid_file)), KILL)


def _process(path: Path) -> int:
    """Return the number in a file, alone or as the "process" of a session file."""
    try:
        content = json.loads(path.read_text("utf-8"))
        return int(content["process"] if isinstance(content, dict) else content)
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise _refusal(path, "it holds no process to kill", "give a session file of the sender") from error


def _refusal(path: Path, what: str, advice: str) -> JobError:
    return JobError("faults-file", what, advice=advice, place=Place(str(path)))
