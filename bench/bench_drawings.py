# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads and joins a DXF file of 100 000 lines, and lets ezdxf alone parse the same file: processor time and memory."""

from __future__ import annotations

import resource
import sys
import tempfile
import time
from pathlib import Path

import ezdxf

from CNCStepper.drawing.dxf.limits import MOST_ENTITIES
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing

SIDES = 4
COLUMNS = 160
PITCH_MM, WIDE_MM = 10.0, 8.0
AROUND = 500  # entities that the count takes beside those drawn: layers, styles, dictionaries
RUNS = 3


def squares(path: Path) -> int:
    """Write squares of single lines, as many as a drawing may have; return how many lines."""
    document = ezdxf.new("R2010")
    document.units = 4
    space, count = document.modelspace(), (MOST_ENTITIES - AROUND) // SIDES
    for number in range(count):
        x, y = PITCH_MM * (number % COLUMNS), PITCH_MM * (number // COLUMNS)
        corners = [(x, y), (x + WIDE_MM, y), (x + WIDE_MM, y + WIDE_MM), (x, y + WIDE_MM)]
        for side in range(SIDES):
            space.add_line(corners[side], corners[(side + 1) % SIDES], {"layer": f"L{number % 5}"})
    document.saveas(path)
    return SIDES * count


def main() -> int:
    """Print both figures from one run, the better of RUNS each."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "squares.dxf"
        lines = squares(path)
        ours, theirs = [], []
        for _ in range(RUNS):
            begun = time.process_time()
            chains = len(read_drawing(path, ReadOptions()).chains)
            ours.append(time.process_time() - begun)
            begun = time.process_time()
            ezdxf.readfile(path)
            theirs.append(time.process_time() - begun)
        most_mb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        print(f"{lines} lines, {path.stat().st_size / 1e6:.1f} MB: processor time, the better of {RUNS}")
        print(f"  read and joined to {chains} chains   {min(ours):6.2f} s")
        print(f"  ezdxf alone, parsed only             {min(theirs):6.2f} s")
        print(f"  most memory of this process          {most_mb:6.0f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
