# SPDX-License-Identifier: LGPL-2.1-or-later
"""A client that jogs a held job: the controller gives its lines up first, and the job's next way leads back to the cut.

At a pause, or while the tool is changed, nothing is given up, and the zero can be set.

held ---a leg that goes nowhere---> retreated, idle ---jogs---> beside the cut ---back, forward, rest---> ...
"""

from __future__ import annotations

import time

from CNCStepper.control.protocol.grbl.firmware import TOOL
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.path_retract import STANDS
from CNCStepper.errors import MachineRefusal, Text
from CNCStepper.recovery.retract.client import RetractClient

LOOK_EVERY_S = 0.05
AT_REST = ("Idle", TOOL)
BEGUN_S = 0.5  # within which a jog shows in the status


def step_aside(client: SessionClient) -> None:
    """Make a held machine idle, where it is not; raises MachineRefusal for one that moves, JobError, ProgramError."""
    status = client.status()
    if status.phase not in STANDS:
        what = "a job runs, and the machine does not stand"
        raise MachineRefusal("not-held", what, value=status.phase, advice="hold it first: Ctrl-C at `cncstepper send`")
    if status.machine_state.startswith("Hold"):
        back = RetractClient(client)
        back.go(back.held().aside())
        back.wait_for_leg()


def jog(client: SessionClient, way: dict[str, float]) -> SenderStatus:
    """Jog a machine that is idle, or waits for a new tool, and return its status then; raises what is refused.

    way: x_mm, y_mm, z_mm and feed_mm_min.
    """
    client.ask("jog", **way)
    begin_s, state = time.monotonic(), ""
    while (time.monotonic() - begin_s < BEGUN_S or state not in AT_REST) and client.outcome is None:
        for event in client.poll(LOOK_EVERY_S):
            if event["event"] == "refused" and event.get("command") == "jog":
                raise event["error"]
            if event["event"] == "status":
                state = event["status"]["machine_state"]
    return client.status()


def set_zero(client: SessionClient, axes: str) -> SenderStatus:
    """Set the zero of axes at a machine paused between two lines; raises refusals."""
    client.status()  # past the events of before
    client.ask("set_zero", axes=axes)
    while client.outcome is None:
        for event in client.poll(LOOK_EVERY_S):
            if event["event"] == "refused" and event.get("command") == "set_zero":
                raise event["error"]
            if event["event"] == "message" and event["text"].startswith("zero of"):
                return client.status()
    what = Text("the job has ended: {outcome}", outcome=client.outcome.text)
    raise MachineRefusal("session-ended", what, advice="set the zero again")
