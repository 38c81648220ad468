# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads a drawing of any format that is known by the suffix of its file.

A format is a row of READERS: its suffixes and the module that reads it, imported when a file of it comes.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from CNCStepper.drawing.drawing import Drawing, Share
from CNCStepper.drawing.trace.options import TraceOptions
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.garbage import collection_paused
from CNCStepper.geometry.chain_joining import NEAR_MM
from CNCStepper.tolerances import JOINED_ENDS_MM

AS_FOUND = TraceOptions()
SCRIPT = ".py"  # no reader below reads it: a script runs only where a person names it


@dataclass(frozen=True)
class ReadOptions:
    """How a drawing is read.

    Curves that are no arcs become arcs within `tolerance_mm`. `unit_mm` is the length of the file's unit where the file
    does not say it or is wrong. Ends within `same_mm` are joined, with `by_colour` only of lines of one colour; gaps up
    to `near_mm` are reported. `trace` is how a picture becomes contours. Of a solid, `height_mm` chooses the level
    faces or the section there, None its whole outline seen from above.
    """

    tolerance_mm: float = 0.005
    unit_mm: float | None = None
    same_mm: float = JOINED_ENDS_MM
    near_mm: float = NEAR_MM
    by_colour: bool = False
    height_mm: float | None = None
    trace: TraceOptions = AS_FOUND


Reader = Callable[[Path, ReadOptions, Share], Drawing]
READERS = {  # suffix: the module whose function `read` is the reader
    ".dxf": "CNCStepper.drawing.dxf.reader",
    ".stl": "CNCStepper.drawing.solids.stl",
    ".jpeg": "CNCStepper.drawing.trace.picture_tracer",
    ".jpg": "CNCStepper.drawing.trace.picture_tracer",
    ".png": "CNCStepper.drawing.trace.picture_tracer",
    ".svg": "CNCStepper.drawing.svg.svg_reader",
    ".svgz": "CNCStepper.drawing.svg.svg_reader",
}


def read_drawing(
    path: Path, options: ReadOptions, share: Share = lambda share: None, readers: Mapping[str, str] = READERS
) -> Drawing:
    """Return the drawing in a file, read by the row of `readers` for its suffix; `share` is called with what is done.

    Raises JobError for a suffix that is not known, a file that cannot be read, and one that holds no curve.
    """
    module = readers.get(path.suffix.casefold())
    if module is None:
        raise JobError(
            "drawing-format",
            Text("drawings with the suffix '{suffix}' cannot be read", suffix=path.suffix),
            advice=Text("save it as one of {known}", known=", ".join(sorted(readers))),
            place=Place(str(path)),
        )
    reader: Reader = importlib.import_module(module).read
    with collection_paused():  # no reader makes cycles
        return reader(path, options, share)
