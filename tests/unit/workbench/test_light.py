# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening the workbench and showing the tree load nothing heavy, and neither needs Qt to be imported."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
WORKBENCH = ROOT / "CNCStepper" / "workbench"
HEAVY = {"numpy", "numba", "shapely", "matplotlib", "pydantic", "scipy", "serial", "PySide", "PySide2", "PySide6"}
LOAD = """
import importlib, sys
for module in sys.argv[1:]:
    importlib.import_module(module)
print(*sys.modules, sep="\\n")
"""


def modules_of(folder: str) -> list[str]:
    names = [path.stem for path in (WORKBENCH / folder).glob("*.py") if path.stem != "__init__"]
    return [f"CNCStepper.workbench.{folder}.{name}" for name in names]


@pytest.mark.parametrize(
    "modules",
    [
        [*modules_of("commands"), "CNCStepper.workbench.opening", "CNCStepper.workbench.services.missing_packages"],
        [
            *modules_of("viewproviders"),
            "CNCStepper.workbench.panels",
            "CNCStepper.workbench.proving.prove_program",
        ],
    ],
    ids=["commands", "tree"],
)
def test_nothing_heavy_is_loaded(modules: list[str]) -> None:
    result = subprocess.run(
        [sys.executable, "-c", LOAD, *modules], capture_output=True, text=True, cwd=ROOT, timeout=60
    )
    assert result.returncode == 0, result.stderr
    loaded = {line.partition(".")[0] for line in result.stdout.splitlines()}
    assert not loaded & HEAVY
    assert set(modules) <= set(result.stdout.splitlines())
