# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings that packages of others carry: each is read, or refused with a reason, in bounded time."""

from __future__ import annotations

import sysconfig
import time
from pathlib import Path

import pytest

from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError

MATPLOTLIB = Path(sysconfig.get_path("purelib")) / "matplotlib"
FREECAD = Path("/usr/share/freecad")
LIMIT_S = 10.0  # of processor time; the largest takes half a second
REASONS = {"svg-empty", "svg-file", "dxf-empty", "dxf-file"}


def judged(folder: Path) -> tuple[list[Path], dict[Path, str]]:
    """Return the drawings below a folder that were read, and the codes of those that were refused."""
    read, refused = [], {}
    for path in sorted(each for each in folder.rglob("*") if each.suffix.casefold() in (".svg", ".svgz", ".dxf")):
        before = time.process_time()
        try:
            drawing = read_drawing(path, ReadOptions())
        except JobError as error:
            assert error.place and error.what, path
            refused[path] = error.code
        else:
            assert drawing.chains, path
            read.append(path)
        assert time.process_time() - before < LIMIT_S, path
    return read, refused


def test_the_drawings_of_matplotlib_are_all_read() -> None:
    read, refused = judged(MATPLOTLIB)
    assert len(read) >= 19 and not refused


@pytest.mark.slow
@pytest.mark.freecad
def test_the_drawings_of_freecad_are_read_or_refused_with_a_reason() -> None:
    read, refused = judged(FREECAD)
    assert len(read) >= 250 and len(refused) <= len(read) / 4
    assert set(refused.values()) <= REASONS
