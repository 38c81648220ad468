# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python's garbage collector does not look again at all that FreeCAD and its workbenches have loaded.

A full collection looks at every container of the process, some 300 000 in FreeCAD's window, which takes longer than a
key may. What is there when our first panel opens stays for the whole session, nearly all of it: modules, classes,
functions. It is collected once more and then left alone; what is made later is collected as always.
"""

from __future__ import annotations

import gc

_done: list[bool] = []


def leave_what_is_loaded() -> None:
    """Let collections be about what is made from now on; again changes nothing."""
    if not _done:
        _done.append(True)
        gc.collect()
        gc.freeze()
