# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings that packages of others carry: each is read, or refused with a reason, in bounded time."""

from __future__ import annotations

import os
import random
import sysconfig
import time
from collections.abc import Sequence
from pathlib import Path

import pytest

from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError
from helpers.drawing.debian_packages import unpacked

MATPLOTLIB = Path(sysconfig.get_path("purelib")) / "matplotlib"
FREECAD = Path("/usr/share/freecad")
LIMIT_S = 10.0  # of processor time; the largest takes half a second
REASONS = {"svg-empty", "svg-file", "dxf-empty", "dxf-file"}
HOSTILE = {"svg-entity", "svg-large", "fit-budget", "quantity"}  # librsvg's own tests of crashes are among its files
PICKED = 150  # of a package that is fetched; CNCSTEPPER_FOREIGN=all reads every one
ICONS = {"icons", "adwaita", "cursors"}  # 2500 that are much alike: a quarter of those picked


def drawings(folder: Path) -> list[Path]:
    """Return the drawings below a folder."""
    return sorted(
        each for each in folder.rglob("*") if each.suffix.casefold() in (".svg", ".svgz", ".dxf") and each.is_file()
    )


def picked(paths: Sequence[Path], count: int, seed: int) -> list[Path]:
    """Return some drawings at random, most of them no icons."""
    icons = [path for path in paths if ICONS & set(path.parts)]
    others = [path for path in paths if not ICONS & set(path.parts)]
    dice = random.Random(seed)
    chosen = dice.sample(others, min(len(others), count * 3 // 4))
    return chosen + dice.sample(icons, min(len(icons), count - len(chosen)))


def judged(paths: Sequence[Path]) -> tuple[list[Path], dict[Path, str]]:
    """Return the drawings that were read, and the codes of those that were refused."""
    read, refused = [], {}
    for path in paths:
        code, took_s = outcome(path)
        if took_s >= LIMIT_S:
            code, took_s = outcome(path)  # kernels that the first reading needed were compiled then
        assert took_s < LIMIT_S, path
        if code:
            refused[path] = code
        else:
            read.append(path)
    return read, refused


def outcome(path: Path) -> tuple[str, float]:
    """Read a drawing; return the code of its refusal, "" where it has chains, and the processor time."""
    before_s = time.process_time()
    try:
        drawing = read_drawing(path, ReadOptions())
    except JobError as error:
        assert error.place and error.what, path
        return error.code, time.process_time() - before_s
    assert drawing.chains, path
    return "", time.process_time() - before_s


def test_the_drawings_of_matplotlib_are_all_read() -> None:
    read, refused = judged(drawings(MATPLOTLIB))
    assert len(read) >= 19 and not refused


@pytest.mark.slow
@pytest.mark.freecad
def test_the_drawings_of_freecad_are_read_or_refused_with_a_reason() -> None:
    read, refused = judged(drawings(FREECAD))
    assert len(read) >= 250 and len(refused) <= len(read) / 4
    assert set(refused.values()) <= REASONS


@pytest.mark.slow
@pytest.mark.parametrize(("package", "least"), [("inkscape", 2000), ("librsvg2-tests", 800)])
def test_the_drawings_of_packages_that_are_only_fetched_are_read_or_refused(package: str, least: int) -> None:
    folder = unpacked(package)
    if isinstance(folder, str):
        pytest.skip(folder)
    paths = drawings(folder)
    assert len(paths) >= least
    seed = 0 if "CI" in os.environ else random.randrange(1 << 16)
    if os.environ.get("CNCSTEPPER_FOREIGN") != "all":
        paths = picked(paths, PICKED, seed)
    read, refused = judged(paths)
    print(f"{package}, seed {seed}: {len(read)} read, refused {sorted(refused.items())}")
    assert len(read) >= len(paths) / 2
    assert set(refused.values()) <= REASONS | HOSTILE
