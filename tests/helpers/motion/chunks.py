# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same toolpath in chunks of another size."""

from __future__ import annotations

from CNCStepper.toolpath import Chunk, Toolpath

COLUMNS = ("kind", "end", "centre", "plane", "turns", "feed", "state", "line")


def in_chunks(toolpath, rows):
    whole = toolpath.table()
    pieces = [
        Chunk(first, *(getattr(whole, name)[first : first + rows] for name in COLUMNS))
        for first in range(0, len(whole), rows)
    ]
    return Toolpath(toolpath.start, pieces, toolpath.states, toolpath.events)
