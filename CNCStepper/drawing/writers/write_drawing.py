# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as the bytes of a file, by the suffix of its name."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.drawing.writers.svg_writer import svg_bytes
from CNCStepper.errors import JobError, Text

WRITERS: dict[str, Callable[[Drawing], bytes]] = {".dxf": dxf_bytes, ".svg": svg_bytes}


def drawing_bytes(drawing: Drawing, suffix: str) -> bytes:
    """Return the content of a drawing's file; raises JobError for a suffix that is not written."""
    writer = WRITERS.get(suffix.casefold())
    if writer is None:
        what = Text("drawings with the suffix '{suffix}' cannot be written", suffix=suffix)
        known = Text("end the name in one of {known}", known=", ".join(sorted(WRITERS)))
        raise JobError("drawing-format", what, advice=known)
    return writer(drawing)
