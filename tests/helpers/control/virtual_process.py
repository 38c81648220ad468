# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual grbl in a process of its own, also one that kills the sender."""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from helpers.cli.command_line import command, forked

PLAN = '[[fault]]\nkind = "kill"\nat_byte = {}\npid_file = "{}"\n'
AT_ANY_PORT = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "10")


@contextmanager
def virtual_grbl(kind: str = "tcp", where: object = "127.0.0.1:0", speed: float = 50.0, homing: bool = False):
    """Run a virtual grbl and yield its address."""
    words = ("virtual", "grbl", f"--{kind}", str(where), "--speed", str(speed), *["--homing"] * homing)
    with subprocess.Popen(command(*words), stdout=subprocess.PIPE, text=True, preexec_fn=forked(*words)) as process:
        assert process.stdout
        try:
            yield process.stdout.readline().split()[-1]
        finally:
            process.terminate()


@contextmanager
def machine_that_kills(
    folder: Path, at_byte: int = 3000, more: tuple[str, ...] = ()
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A virtual machine that kills whose number is in the folder's "pid", and its address; it writes trace.csv."""
    plan = folder / "plan.toml"
    plan.write_text(PLAN.format(at_byte, (folder / "pid").as_posix()), "utf-8")
    words = (*AT_ANY_PORT, "--faults", str(plan), "--trace", str(folder / "trace.csv"), *more)
    with subprocess.Popen(command(*words), stdout=subprocess.PIPE, text=True) as machine:
        try:
            yield machine, machine.stdout.readline().split()[-1]
        finally:
            machine.terminate()
