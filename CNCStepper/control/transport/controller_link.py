# SPDX-License-Identifier: LGPL-2.1-or-later
"""A CNCStepper controller as a port: it runs in a process of its own, and its pipes are the serial line.

    Link ──write──► standard input ──► workers/controller.py
    Link ◄─select── socket pair ◄── thread ◄── standard output

A pipe cannot be waited on everywhere, a socket can: so a thread carries what comes from the one to the other. The end
of the process closes the socket; reading then raises OSError, which is a lost link.
"""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
import threading
from contextlib import suppress
from typing import Any

from CNCStepper.control.processes.python_finder import command, environment, find_python
from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import LinkError, Text

MODULE = "CNCStepper.workers.controller"
NEEDS = ("numpy", "pydantic")
READ_BYTES = 4096
CLOSE_S = 35.0  # a ramp and the port's rest; then the process is ended by force
LINE_BAUD = 10_000_000  # of the pipes, which hold nothing back
WHY_S = 1.0  # how long an ended process may take to say so


class ControllerPort:
    """The process of a controller, with the words of a pyserial port opened with timeout 0."""

    def __init__(self, process: subprocess.Popen[bytes]):
        assert process.stdin and process.stdout
        self._process = process
        self._input, self._output = process.stdin, process.stdout
        self._heard, self._carried = socket.socketpair()
        self._heard.setblocking(False)
        threading.Thread(target=self._carry, name="controller", daemon=True).start()

    def fileno(self) -> int:
        """Return what `select` can wait on."""
        return self._heard.fileno()

    def read(self, most: int) -> bytes:
        """Return what has come, b"" where nothing has; raises OSError once the process has ended."""
        try:
            data = self._heard.recv(most)
        except BlockingIOError:
            return b""
        if not data:
            raise OSError(Text("its controller's process has ended ({status})", status=self._status()))
        return data

    def write(self, data: bytes) -> int:
        """Give the process bytes; raises OSError once it has ended."""
        self._input.write(data)
        self._input.flush()
        return len(data)

    @property
    def out_waiting(self) -> int:
        """The bytes that wait: none, a pipe hands them on at once."""
        return 0

    def close(self) -> None:
        """Let the machine come to rest and the process end."""
        with suppress(OSError):
            self._input.close()
        try:
            self._process.wait(CLOSE_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._heard.close()
        self._output.close()

    def _carry(self) -> None:
        descriptor = self._output.fileno()
        with suppress(OSError, ValueError):
            while data := os.read(descriptor, READ_BYTES):
                self._carried.sendall(data)
        self._carried.close()

    def _status(self) -> str:
        with suppress(subprocess.TimeoutExpired):
            return str(self._process.wait(WHY_S))
        return "?"


def has_no_controller(machine: str) -> bool:
    """Return whether a CNCStepper process is that profile's controller; raises JobError for an invalid profile."""
    from CNCStepper.machine.controller_family import OWN, family_of  # grbl's ports need no profile, nor what reads one
    from CNCStepper.machine.profile import load_machine

    return family_of(load_machine(machine)) in OWN


def open_controller(name: str, machine: str) -> ControllerPort:
    """Start the controller of a machine profile at a port and return it once the machine can move.

    Raises what the process refuses with: LinkError where the port cannot be had, MachineRefusal, JobError of the
    profile; MissingPackage where no Python can run it.
    """
    process = subprocess.Popen(
        command(find_python(NEEDS), MODULE, machine, name),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        bufsize=0,
        env=environment(),
        **_apart(),
    )
    assert process.stdout
    told = _told(_first_line(process.stdout.fileno()))
    if "ready" in told:
        return ControllerPort(process)
    process.communicate()
    if "error" in told:
        raise error_from_json(told["error"])
    raise LinkError(
        "controller-start",
        Text("the controller of {machine} ended at its start", machine=machine),
        advice="read its output, and report it",
    )


def _apart() -> dict[str, Any]:
    """Return what keeps the signals of our terminal from it: it is to brake, and not to be cut off."""
    if sys.platform == "win32":
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW}
    return {"start_new_session": True}


def _first_line(descriptor: int) -> bytes:
    """Return the first line, and not a byte more: what follows is the controller's."""
    line = bytearray()
    while not line.endswith(b"\n") and (byte := os.read(descriptor, 1)):
        line += byte
    return bytes(line)


def _told(line: bytes) -> dict[str, Any]:
    try:
        told = json.loads(line)
    except ValueError:
        return {}
    return told if isinstance(told, dict) else {}
