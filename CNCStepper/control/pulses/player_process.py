# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player's process for its parent: its start, its output lines, and its clean-up after a kill.

Where it was killed, its parent leaves the port idle; the places in a board's sequences are kept from job to job.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.atomic_file import write_whole
from CNCStepper.control.pulses.output_ports import RECORD, SOCKET, open_output
from CNCStepper.control.pulses.pacing import ZERO_AGAIN
from CNCStepper.control.pulses.pulse_ring import BEGIN_NS, PLACES
from CNCStepper.control.session.files import session_folder
from CNCStepper.control.session.status import error_from_json
from CNCStepper.control.transport.port_identity import identify
from CNCStepper.errors import LinkError, Text
from CNCStepper.machine.controller_family import family_of
from CNCStepper.machine.profile import Machine
from CNCStepper.motion.signals.parallel_port_registers import RegisterWriter, idle_registers
from CNCStepper.motion.signals.port_bytes import BoardWriter

MOST_LOOK_S = 0.1


class StallWatch:
    """Tells a process that gets no time any more (stopped, or starved) by its counter of looks.

    limit_s: for so long it may stand. Only the time between two close looks of ours counts: where both processes
    stood, as in a computer that slept, it goes on counting first.
    """

    def __init__(self, limit_s: float):
        self.limit_s = limit_s
        self._beat, self._looked_s, self._still_s = -1, 0.0, 0.0

    def still_s(self, beat: int, now_s: float) -> float:
        """Return for how long the counter has been the same."""
        if beat != self._beat:
            self._beat, self._still_s = beat, 0.0
        else:
            self._still_s += min(now_s - self._looked_s, MOST_LOOK_S)
        self._looked_s = now_s
        return self._still_s


def is_board(machine: Machine) -> bool:
    """Return whether a machine's pulses go out as a board's bytes, not as a parallel port's registers."""
    return family_of(machine) == "board"


def leave_port_idle(port: str, machine: Machine, places: Path | None, words: np.ndarray) -> None:
    """Do the clean-up of a killed worker: write registers without an active line, or a board's positions."""
    if is_board(machine):
        if places:
            kept = words[PLACES : PLACES + len(machine.signals.motors) + 1].tolist()
            with suppress(OSError):
                write_whole(places, json.dumps({"places": kept}).encode("ascii"))
        return
    with suppress(LinkError, OSError):  # the port itself may be what was lost
        opened = open_output(port, False, int(words[BEGIN_NS]), again=True)
        opened.write(*idle_registers(machine.signals))
        opened.close()


def writer_of(machine: Machine) -> RegisterWriter | BoardWriter:
    """Return what makes a machine's writes of its pulses; raises MachineRefusal where a motor has no pin."""
    signals = machine.signals
    if is_board(machine):
        return BoardWriter(signals.motors, signals.null_motor)
    return RegisterWriter(signals, len(machine.axes))


def places_file(port: str) -> Path | None:
    """Return where a board's places in its motors' sequences are kept from job to job; None for a virtual one."""
    if port.startswith((RECORD, SOCKET)) or os.path.realpath(port).startswith("/dev/pts/"):
        return None
    digest = hashlib.sha256(identify(port).key.encode("utf-8")).hexdigest()[:16]
    return session_folder() / f"{digest}.places"


def line_of(worker: subprocess.Popen) -> bytes:
    """Return the next line of its output, b"" at its end."""
    assert worker.stdout
    line: bytes = worker.stdout.readline()
    return line


def answer(line: bytes, wanted: str) -> dict[str, Any]:
    """Return the worker's answer; raises its error, or LinkError where it ended without one."""
    said = json.loads(line) if line.endswith(b"\n") else {}
    if "error" in said:
        raise error_from_json(said["error"])
    if wanted not in said:
        raise gone()
    content: dict[str, Any] = said[wanted]
    return content


def stands(still_s: float, limit_s: float) -> LinkError:
    """Return the error of a process that was stopped, or that gets no time."""
    return LinkError(
        "pulse-worker",
        "the process that plays the pulses was stopped or got no processor time; all outputs are off, and steps "
        "may be lost",
        value=Text("{still_s:.1f} s", still_s=still_s),
        limit=Text("{limit_s:g} s", limit_s=limit_s),
        advice=ZERO_AGAIN,
    )


def gone() -> LinkError:
    """Return the error of a process that has ended without a word."""
    return LinkError(
        "pulse-worker", "the process that plays the pulses has ended; steps may be lost", advice=ZERO_AGAIN
    )
