# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of the window in docs/pictures anew: `make pictures`, then look at them.

They are what tests/window/test_road.py sees on its way, in a plain window and in one of twice the pixels (-2x).
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
TAKEN = ROOT / "build" / "window"
KEPT = ROOT / "docs" / "pictures"
WIDEST = {"plain": 1600, "scaled": 2000}  # pixels
SUFFIX = {"plain": "", "scaled": "-2x"}


def keep(kind: str) -> None:
    """Go the road in a window of that kind and keep what was seen."""
    subprocess.run([str(ROOT / "tools" / "window.sh"), "0.20.2", kind, "tests/window/test_road.py"], check=True)
    folder = TAKEN / ("0.20.2" if kind == "plain" else f"0.20.2-{kind}")
    for taken in sorted(folder.glob("road-*.png")):
        with Image.open(taken) as picture:
            small = picture.convert("RGB")
            small.thumbnail((WIDEST[kind], WIDEST[kind]), Image.Resampling.LANCZOS)
            small.save(KEPT / f"{taken.stem}{SUFFIX[kind]}.png", optimize=True)


if __name__ == "__main__":
    for chosen in sys.argv[1:] or SUFFIX:
        keep(chosen)
