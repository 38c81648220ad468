# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that are run one after the other on one stock, as one table of moves.

rows      before  (lines are 0: no line of the later program)  |  after
events    ...                                     tool_change  |  ...
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from CNCStepper.toolpath import Event, Toolpath


def followed(before: Toolpath, after: Toolpath) -> Toolpath:
    """Return the moves of two programs, the tool changed between them; only those of the later one have lines."""
    rows, states = len(before), len(before.states)
    first = [replace(chunk, line=np.zeros_like(chunk.line)) for chunk in before.chunks]
    second = [
        replace(chunk, first=chunk.first + rows, state=(chunk.state + states).astype(np.int32))
        for chunk in after.chunks
    ]
    events = [replace(event, line=0) for event in before.events]
    change = Event(rows, "tool_change", state=states - 1)
    events += [change, *(replace(e, index=e.index + rows, state=e.state + states) for e in after.events)]
    spans = [*before.spans, *(replace(span, first=span.first + rows, last=span.last + rows) for span in after.spans)]
    return Toolpath(before.start, first + second, [*before.states, *after.states], events, spans)
