# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual grbl as a background process, which ends when its client disconnects."""

from __future__ import annotations

import os
import re
import secrets
import subprocess
from pathlib import Path
from typing import Any

from CNCStepper.control.processes.python_finder import PROOF, command, environment, find_python_in_background
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.files import LOG, session_folder
from CNCStepper.control.stream.position_trust import LOST
from CNCStepper.dependencies import MACHINE, modules
from CNCStepper.errors import LinkError, Text

NEEDS = (*PROOF, *modules(MACHINE))  # of it, and of the service that comes after it
ADDRESS = re.compile(r"^virtual grbl at (\S+)\s*$", re.MULTILINE)


class VirtualMachine:
    """One start of the virtual grbl, `speed` times as fast as real; ask `address` from a timer."""

    def __init__(self, speed: float):
        self._speed = speed
        self._python = find_python_in_background(NEEDS)
        self._process: subprocess.Popen | None = None
        self._told = session_folder() / f"virtual-{secrets.token_hex(4)}{LOG}"

    def address(self) -> str:
        """Return where it listens, "" while it is being started; never waits.

        Raises MissingPackage when no Python can run it, LinkError when it ended at once.
        """
        if self._process is None:
            if self._python.done():
                self._process = _started(self._python.result(), self._speed, self._told)
            return ""
        found = ADDRESS.search(self._told.read_text("utf-8", "replace"))
        if found:
            PositionTrustFile.of_port(session_folder(), found[1]).keep(
                LOST
            )  # as of any machine that was just switched on
            return found[1]
        if self._process.poll() is not None:
            raise LinkError("virtual-start", "the virtual grbl ended at once", advice=Text("see {log}", log=self._told))
        return ""

    def give_up(self) -> None:
        """End it before any client has connected."""
        if self._process and self._process.poll() is None:
            self._process.terminate()


def _started(python: str, speed: float, told: Path) -> subprocess.Popen:
    """Start it apart from FreeCAD, so that a window that dies does not take the machine with it."""
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--until-left", "--speed", f"{speed:g}")
    apart: dict[str, Any] = {"start_new_session": True}
    if os.name == "nt":
        flags = ("DETACHED_PROCESS", "CREATE_NEW_PROCESS_GROUP")
        apart = {"creationflags": sum(getattr(subprocess, flag) for flag in flags)}
    with told.open("wb") as log:
        return subprocess.Popen(
            command(python, "CNCStepper.cli.main", *words),
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            env=environment(),
            **apart,
        )
