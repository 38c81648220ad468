# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of the window in docs/pictures anew: `make pictures`, then look at them.

They are what tests/window/test_road.py sees on its way: in a plain window, in one of twice the pixels (-2x), and in a
Portuguese one, whose pictures the pages in Portuguese show (.pt-BR).
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
TAKEN = ROOT / "build" / "window"
KEPT = ROOT / "docs" / "pictures"
WIDEST = 1600  # pixels
COLOURS = 256  # of a palette: a window has few, and the file is a third as large
NEARER = 1  # colours of the palette move to the means of what they stand for: icons keep theirs
SUFFIX = {"plain": "", "scaled": "-2x", "portuguese": ".pt-BR"}


def keep(kind: str) -> None:
    """Go the road in a window of that kind and keep what was seen."""
    command = [str(ROOT / "tools" / "window.sh"), "0.20.2", kind, "tests/window/test_road.py"]
    subprocess.run(command, check=True, env={**os.environ, "CNCSTEPPER_WINDOW_AS_A_PERSON": "1"})
    folder = TAKEN / ("0.20.2" if kind == "plain" else f"0.20.2-{kind}")
    for taken in sorted(folder.glob("road-*.png")):
        with Image.open(taken) as picture:
            kept(picture).save(KEPT / f"{taken.stem}{SUFFIX[kind]}.png", optimize=True)


def kept(picture: Image.Image, widest: int = WIDEST, colours: int = COLOURS) -> Image.Image:
    """Return a picture as it is kept: at most that many pixels wide, in a palette of its own."""
    small = picture.convert("RGB")
    small.thumbnail((widest, widest), Image.Resampling.LANCZOS)
    return small.quantize(colours, Image.Quantize.MEDIANCUT, kmeans=NEARER)


if __name__ == "__main__":
    for chosen in sys.argv[1:] or SUFFIX:
        keep(chosen)
