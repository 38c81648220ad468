# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads and joins drawings of 100 000 things, beside ezdxf and fonttools, which only parse the same files.

Each side has a process of its own for each run: start and imports are in the figures, and the memory is its own.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import ezdxf

from CNCStepper.drawing.dxf.limits import MOST_ENTITIES

SIDES = 4
COLUMNS = 160
PITCH_MM, WIDE_MM = 10.0, 8.0
AROUND = 500  # entities that the count takes beside those drawn: layers, styles, dictionaries
ELEMENTS = 100_000
RUNS = 3
OURS = """
import sys
from pathlib import Path
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
print(len(read_drawing(Path(sys.argv[1]), ReadOptions()).chains), "chains")
"""
EZDXF = "import sys, ezdxf; print(len(ezdxf.readfile(sys.argv[1]).modelspace()), 'entities')"
FONTTOOLS = """
import sys
from fontTools.pens.recordingPen import RecordingPen
from fontTools.svgLib.path import SVGPath
pen = RecordingPen()
SVGPath(sys.argv[1]).draw(pen)
print(len(pen.value), "segments")
"""


@dataclass(frozen=True)
class Figures:
    """What a process takes: its processor time, s, its most memory, MB, and what it printed."""

    processor_s: float
    memory_mb: float
    words: str


def squares(path: Path) -> int:
    """Write a DXF of squares of single lines, as many as a drawing may have; return how many lines."""
    document = ezdxf.new("R2010")
    document.units = 4
    space, count = document.modelspace(), (MOST_ENTITIES - AROUND) // SIDES
    for number in range(count):
        x, y = _place(number)
        corners = [(x, y), (x + WIDE_MM, y), (x + WIDE_MM, y + WIDE_MM), (x, y + WIDE_MM)]
        for side in range(SIDES):
            space.add_line(corners[side], corners[(side + 1) % SIDES], {"layer": f"L{number % 5}"})
    document.saveas(path)
    return SIDES * count


def elements(path: Path) -> int:
    """Write an SVG of rectangles, circles, polygons and Bezier paths in turn; return how many."""
    kinds = (
        '<rect id="r{n}" x="{x}" y="{y}" width="8" height="8" style="fill:none;stroke:#ff0000"/>',
        '<circle id="c{n}" cx="{x}" cy="{y}" r="4" fill="#00ff00"/>',
        '<path id="p{n}" d="M{x} {y}h8v8l-4 -4z" fill="none" stroke="blue"/>',
        '<path id="b{n}" d="M{x} {y}c3 0 6 2 8 5s0 3 -4 3s-6 -4 -4 -8z" fill="none" stroke="black"/>',
    )
    rows = []
    for number in range(ELEMENTS):
        x, y = _place(number)
        rows.append(kinds[number % len(kinds)].format(n=number, x=x, y=y))
    head = '<svg xmlns="http://www.w3.org/2000/svg" width="1700mm" height="7000mm" viewBox="0 0 1700 7000"><g id="cut">'
    path.write_text(head + "\n".join(rows) + "</g></svg>", "utf-8")
    return ELEMENTS


def _place(number: int) -> tuple[float, float]:
    return PITCH_MM * (number % COLUMNS), PITCH_MM * (number // COLUMNS)


def figures(code: str, path: Path) -> Figures:
    """Run Python code on a file in a process of its own, RUNS times; return the best figures."""
    found = []
    for _ in range(RUNS):
        process = subprocess.Popen([sys.executable, "-c", code, str(path)], stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        words = process.stdout.read().strip()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            raise RuntimeError(f"it ends with status {process.returncode}")
        found.append(Figures(usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, words))
    return min(found, key=lambda each: each.processor_s)


def compare(title: str, path: Path, theirs: str, code: str) -> float:
    """Print the figures of both sides; return how many times as fast as the parser alone we are."""
    print(f"{title}, {path.stat().st_size / 1e6:.1f} MB: processor time with start and imports, the best of {RUNS}")
    ours, other = figures(OURS, path), figures(code, path)
    for name, own in (("read and joined", ours), (f"{theirs} alone, parsed only", other)):
        print(f"  {name:28} {own.processor_s:6.2f} s  {own.memory_mb:5.0f} MB  {own.words}")
    print(f"  ratio {ours.processor_s / other.processor_s:.2f}, memory {ours.memory_mb / other.memory_mb:.2f}")
    return other.processor_s / ours.processor_s


def guarded() -> dict[str, float]:
    """Print the figures of both kinds of drawing; return the ratios that `make bench-guard` compares."""
    with tempfile.TemporaryDirectory() as folder:
        lines, shapes = Path(folder) / "squares.dxf", Path(folder) / "elements.svg"
        return {
            "drawings, DXF": compare(f"DXF of {squares(lines)} lines", lines, "ezdxf", EZDXF),
            "drawings, SVG": compare(f"SVG of {elements(shapes)} elements", shapes, "fonttools", FONTTOOLS),
        }


if __name__ == "__main__":
    guarded()
