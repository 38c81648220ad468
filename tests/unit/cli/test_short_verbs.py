# SPDX-License-Identifier: LGPL-2.1-or-later
"""A verb that has little to do is done before numba would be loaded; one with more loads it, and says the same."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = """
import sys
from CNCStepper.cli import main
sys.argv[0] = "cncstepper"
try:
    main.main()
finally:
    from CNCStepper import kernels
    heavy = {"shapely", "numpy.ma", "CNCStepper.job.model", "CNCStepper.cycles.cycle"} & set(sys.modules)
    print("numba" in sys.modules, kernels.COMPILED, *([] if "numba" in sys.modules else sorted(heavy)), file=sys.stderr)
"""
LESS_PAYS = """
from CNCStepper.gcode.interpreter.fast_path import policy
policy.PAYS_WITH_LOADING = 20_000
"""
THREE = "G21 G90\nG1 X10 F300\nG0 X0\n"


def said(verb: str, program: Path, variables: dict[str, str] | None = None, begin: str = "") -> tuple[str, str]:
    """Return what a verb prints, and whether numba was loaded and is there; if not, which other large modules were."""
    words = [sys.executable, "-c", begin + SCRIPT, verb, str(program), "--machine", "table-a"]
    environment = {**os.environ, **(variables or {})}
    result = subprocess.run(words, capture_output=True, text=True, env=environment)
    assert result.returncode == 0, result.stderr
    return result.stdout, result.stderr.splitlines()[-1]


@pytest.mark.parametrize("verb", ["time", "check"])
def test_three_lines_load_no_numba(tmp_path: Path, verb: str) -> None:
    program = tmp_path / "three.nc"
    program.write_text(THREE, encoding="ascii")
    printed, loaded = said(verb, program)
    assert loaded == "False True"
    assert (printed, "False False") == said(verb, program, {"NUMBA_DISABLE_JIT": "1"})


@pytest.mark.slow
@pytest.mark.parametrize("verb", ["time", "check"])
def test_more_work_loads_it_in_the_middle(tmp_path: Path, verb: str) -> None:
    program = tmp_path / "many.nc"
    moves = (f"G1 X{index % 7} Y{index % 5} F{100 + index % 50}\n" for index in range(120))
    program.write_text("G21 G90\nG0 Z5\nG0 X0 Y0\nM3 S9000\nG4 P3\n" + "".join(moves), encoding="ascii")
    printed, loaded = said(verb, program)
    assert loaded == "True True"
    assert (printed, "False False") == said(verb, program, {"NUMBA_DISABLE_JIT": "1"})


@pytest.mark.slow
def test_a_text_for_which_it_is_loaded_is_read_by_compiled_kernels(tmp_path: Path) -> None:
    program = tmp_path / "long.nc"
    moves = (f"G1 X{123.456 + index % 7:.3f} Y{index % 5} F{1000 + index % 50}" for index in range(200))
    program.write_text("G21 G90\n" + "".join(f"{move:<200}\n" for move in moves), encoding="ascii")
    printed, loaded = said("time", program, begin=LESS_PAYS)
    assert loaded == "True True"
    assert (printed, "False False") == said("time", program, {"NUMBA_DISABLE_JIT": "1"})
