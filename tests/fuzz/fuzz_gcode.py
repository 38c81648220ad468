# SPDX-License-Identifier: LGPL-2.1-or-later
"""A coverage-guided fuzz target: atheris changes programs byte by byte and keeps those that reach new code.

`make fuzz` runs it for FUZZ_S seconds, from the programs in tests/bad and tests/data/ngc. By hand:

    .venv/bin/python tests/fuzz/fuzz_gcode.py -max_total_time=600 build/fuzz tests/bad tests/data/ngc
"""

from __future__ import annotations

import sys
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["CNCStepper.gcode"]):
    sys.path.insert(0, str(Path(__file__).parents[1]))
    from helpers.gcode.hostile_programs import check, read

DIALECTS = ("linuxcnc", "linuxcnc", "linuxcnc", "grbl", "mach", "iso", "thesis-a", "mini-lathe", "marlin")


def one_input(data: bytes) -> None:
    """Read a program whose last byte chooses the dialect; anything but a table or a refusal is a finding."""
    text = data[:-1].decode("latin-1")
    check(read(text, DIALECTS[data[-1] % len(DIALECTS) if data else 0]), text)


if __name__ == "__main__":
    atheris.Setup(sys.argv, one_input)
    atheris.Fuzz()
