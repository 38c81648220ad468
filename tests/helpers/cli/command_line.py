# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line, as a process of its own, as one forked from this one, or in this one."""

from __future__ import annotations

import gc
import io
import os
import signal
import subprocess
import sys
import traceback
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import pytest

from CNCStepper.cli.main import main


def command(*arguments: str | Path) -> list[str]:
    return [sys.executable, "-m", "CNCStepper.cli", *map(str, arguments)]


def forked(*arguments: str | Path) -> Callable[[], None] | None:
    """Return what lets Popen(command(...), preexec_fn=forked(...)) fork this process and start no second Python.

    The child finds loaded what this process has loaded, the kernels too: for tests whose subject is not how the
    process starts. It has its own memory, pipes and signals. None where a fork is not safe: then Python starts.
    """
    return (lambda: _run_forked(arguments)) if sys.platform == "linux" else None


def _run_forked(arguments: tuple[str | Path, ...]) -> None:
    """Run the command line in a forked process, and end it: what would start another program is never reached."""
    gc.freeze()  # what the parent holds must not be closed here
    os.closerange(3, os.sysconf("SC_OPEN_MAX"))
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)  # as Python does at its start
    sys.stdin, sys.stdout, sys.stderr = (os.fdopen(number, mode, encoding="utf-8") for number, mode in enumerate("rww"))
    sys.argv = ["cncstepper", *map(str, arguments)]
    status = 1
    try:
        main()
    except SystemExit as end:
        status = int(end.code or 0)
    except BaseException:
        traceback.print_exc()
    finally:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        os._exit(status)


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
