# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks a second: our interpreter beside LinuxCNC's `rs274 -g`, on the same program in the same run."""

from __future__ import annotations

import math
import subprocess
import tempfile
import time
from pathlib import Path

BLOCKS = 200_000


def program() -> str:
    """Return a spiral of short lines, words only."""
    lines = ["G21 G90 G17", "G0 Z2", "G1 Z-1 F600"]
    for n in range(BLOCKS):
        radius, angle = 5 + n * 2e-4, n * 0.01
        lines.append(f"G1 X{radius * math.cos(angle):.3f} Y{radius * math.sin(angle):.3f}")
    return "\n".join([*lines, "M2", ""])


def ours(text: str) -> float:
    """Return the seconds that our interpreter takes."""
    from CNCStepper.gcode.interpret import interpret
    from CNCStepper.state import Start

    begun = time.perf_counter()
    interpret(text, Start.at_zero(), "linuxcnc")
    return time.perf_counter() - begun


def theirs(text: str) -> float:
    """Return the seconds that rs274 takes, its start included."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "spiral.ngc"
        path.write_text(text, encoding="ascii")
        begun = time.perf_counter()
        subprocess.run(["rs274", "-g", str(path), "/dev/null"], check=True, stdout=subprocess.DEVNULL)
        return time.perf_counter() - begun


def main() -> None:
    """Print both sides and their ratio."""
    text = program()
    first, ours_s, rs274_s = ours(text), ours(text), theirs(text)
    print(f"interpreter: {BLOCKS} blocks: ours {BLOCKS / ours_s:,.0f}/s (first call {BLOCKS / first:,.0f}/s), ", end="")
    print(f"rs274 {BLOCKS / rs274_s:,.0f}/s, ratio {rs274_s / ours_s:.2f}")


if __name__ == "__main__":
    main()
