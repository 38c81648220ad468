# SPDX-License-Identifier: LGPL-2.1-or-later
"""The question at a pause of a job, and the message without a terminal to ask."""

from __future__ import annotations

from CNCStepper.control.session.status import SenderStatus


def why(status: SenderStatus) -> str:
    """Return why the machine stands."""
    return status.message or ("The program pauses" if status.phase == "paused" else "The machine holds")


def question(status: SenderStatus) -> str:
    """Return what is asked about a stand: why it is, and what may be answered."""
    touches = ", zero z touches off" if status.phase == "paused" else ""
    jogs = f", z-0.1 jogs{touches} ({_work_place(status)})" if status.machine_state in ("Idle", "Tool") else ""
    back = "; `cncstepper back` goes back" if status.phase != "door" and status.machine_state != "Tool" else ""
    return f"{why(status)}. Enter goes on, s stops{jogs}, ? says more{back}"


def unasked(status: SenderStatus) -> str:
    """Return what to say of a stand where standard input has ended and is no terminal."""
    go = "cncstepper go --pause" if status.phase == "paused" else "cncstepper go"
    return (
        f"{why(status)}. Nobody can answer here, so the machine waits. In any terminal `{go}` goes on, "
        "`cncstepper back` goes back, `cncstepper stop` stops; so does Ctrl-C here"
    )


def reminder(status: SenderStatus, waits: bool) -> str:
    """Return what to say while the question about a stand is open that is over; waits: somebody is asked again."""
    if waits:
        return f"Meanwhile: {why(status)}. Press Enter to be asked about that"
    return f"Meanwhile the job has gone on ({status.phase}). Press Enter to see it"


def _work_place(status: SenderStatus) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZ", status.wpos_mm or (), strict=False))
