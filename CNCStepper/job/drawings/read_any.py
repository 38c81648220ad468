# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads a drawing of every format: those of `drawing/`, solids that take a process, G-code, point lists.

`drawing/` knows neither the interpreter nor processes, so these formats are rows here.
"""

from __future__ import annotations

from pathlib import Path

from CNCStepper.drawing.drawing import Drawing, Share
from CNCStepper.drawing.read_drawing import READERS, SCRIPT, ReadOptions, read_drawing

ALL_READERS = READERS | {
    ".step": "CNCStepper.job.drawings.solids",
    ".stp": "CNCStepper.job.drawings.solids",
    ".brep": "CNCStepper.job.drawings.solids",
    ".brp": "CNCStepper.job.drawings.solids",
    ".fcstd": "CNCStepper.job.drawings.solids",
    ".nc": "CNCStepper.job.drawings.program_paths",
    ".ngc": "CNCStepper.job.drawings.program_paths",
    ".gcode": "CNCStepper.job.drawings.program_paths",
    ".tap": "CNCStepper.job.drawings.program_paths",
    ".csv": "CNCStepper.job.drawings.point_drawing",
    ".txt": "CNCStepper.job.drawings.point_drawing",
}


def read_named_drawing(path: Path, options: ReadOptions, share: Share = lambda share: None) -> Drawing:
    """Return the drawing in a file that a person names on the command line: of every format, scripts too, which run."""
    if path.suffix.casefold() == SCRIPT:
        from CNCStepper.job.drawings.solids import read_script  # it loads what few drawings need

        return read_script(path, options, share)
    return read_any_drawing(path, options, share)


def read_any_drawing(path: Path, options: ReadOptions, share: Share = lambda share: None) -> Drawing:
    """Return the drawing in a file of any format, as `read_drawing` does; scripts are none (`solids.read_script`)."""
    return read_drawing(path, options, share, ALL_READERS)
