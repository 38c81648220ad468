# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that is being sent to a virtual controller, by a `send` whose terminal is pipes."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import sessions
from helpers.cli.command_line import command, forked

CHECKED = ("--machine", "table-a")
TYPED_AT = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}


@contextmanager
def being_sent(
    folder: Path, text: str, virtual: tuple[str, ...], options: tuple[str, ...] = CHECKED, pipes: dict = TYPED_AT
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Send a program's text to a virtual controller of its own; yield the `send` and the controller's port."""
    program = folder / "a part ç.nc"
    program.write_text(text, "utf-8")
    with subprocess.Popen(
        command(*virtual), stdout=subprocess.PIPE, encoding="utf-8", preexec_fn=forked(*virtual)
    ) as table:
        assert table.stdout
        port = table.stdout.readline().rpartition(" ")[2].strip()
        arguments = ("send", program, "--port", port, *options, "--zero-confirmed")
        with subprocess.Popen(command(*arguments), encoding="utf-8", preexec_fn=forked(*arguments), **pipes) as sender:
            yield sender, port
            sender.kill()
        table.terminate()


def attached(sender: subprocess.Popen[str]) -> SessionClient:
    """Return one more client of what is being sent, as soon as there is a session."""
    while not sessions():
        assert sender.poll() is None
        time.sleep(0.05)
    return SessionClient.attach(sessions()[0])
