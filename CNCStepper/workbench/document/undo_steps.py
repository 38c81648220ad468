# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo steps: all that a person does is one of FreeCAD's transactions, and one piece of a recorded macro."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


def begin(document: Any, name: str) -> None:
    """Open a transaction of that name; its commit writes it into a macro that is being recorded."""
    import FreeCAD

    document.openTransaction(name)
    if FreeCAD.GuiUp:
        from CNCStepper.workbench.document import macro_recorder  # not loaded at FreeCAD's start

        macro_recorder.follow(document, name)


@contextmanager
def undo_step(document: Any, name: str) -> Iterator[None]:
    """Make one undo step of what happens inside; an error takes it back."""
    begin(document, name)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
