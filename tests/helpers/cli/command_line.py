# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line, as a process of its own or in this one."""

from __future__ import annotations

import io
import signal
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import pytest

from CNCStepper.cli.main import main


def command(*arguments: str | Path) -> list[str]:
    return [sys.executable, "-m", "CNCStepper.cli", *map(str, arguments)]


def called(*arguments: str | Path, answer: str = "") -> subprocess.CompletedProcess[str]:
    """Run the command line in this process, which costs no second start of Python."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8") for _ in range(2))
    on_sigterm = signal.getsignal(signal.SIGTERM)
    with pytest.MonkeyPatch.context() as here, redirect_stdout(out), redirect_stderr(err):
        here.setattr(sys, "argv", ["cncstepper", *map(str, arguments)])
        here.setattr(sys, "stdin", io.StringIO(answer))
        with pytest.raises(SystemExit) as end:
            main()
    signal.signal(signal.SIGTERM, on_sigterm)
    for stream in (out, err):
        stream.seek(0)
    return subprocess.CompletedProcess(arguments, int(end.value.code or 0), out.read(), err.read())
