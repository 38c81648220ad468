# SPDX-License-Identifier: LGPL-2.1-or-later
"""The death of one of our processes must not end FreeCAD."""

from __future__ import annotations

import signal


def raise_on_broken_pipe() -> None:
    """Let writing to a process that has died be an error (BrokenPipeError), as in any Python.

    FreeCAD 1.0 and 1.1 start their Python without that, so the system would end FreeCAD, and the drawing with it.
    """
    if hasattr(signal, "SIGPIPE") and signal.getsignal(signal.SIGPIPE) == signal.SIG_DFL:
        signal.signal(signal.SIGPIPE, signal.SIG_IGN)
