# SPDX-License-Identifier: LGPL-2.1-or-later
"""A module of ours in a Python process of its own, of which the window hears by Qt's signals."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore

from CNCStepper.control.python_finder import environment

KILLED_WITHIN_MS = 2000


def start_worker(
    parent: Any,
    words: list[str],
    heard: Callable[[], None],
    ended: Callable[[], None],
    troubled: Callable[[Any], None],
) -> Any:
    """Start the `words` of `python_finder.command`; returns the QProcess.

    heard: called when it has told something. ended: when it is over. troubled: with a QProcess.ProcessError.
    """
    variables = QtCore.QProcessEnvironment()
    for name, value in environment().items():
        variables.insert(name, value)
    process = QtCore.QProcess(parent)
    process.setProcessEnvironment(variables)
    process.readyReadStandardOutput.connect(heard)
    process.finished.connect(ended)
    process.errorOccurred.connect(troubled)
    process.start(words[0], words[1:])
    return process


def kill(process: Any) -> None:
    """End such a process, whatever it does; nothing is heard of it any more."""
    process.blockSignals(True)
    process.kill()
    process.waitForFinished(KILLED_WITHIN_MS)
    process.deleteLater()
