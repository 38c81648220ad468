# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job files among the examples; those of a lathe have a model of their own (`job/turning`)."""

from __future__ import annotations

from pathlib import Path

from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.processes import is_turning

EXAMPLES = Path(__file__).parents[3] / "examples" / "jobs"
_ALL = sorted(EXAMPLES.rglob("*.toml"))
LATHE_JOBS = tuple(path for path in _ALL if is_turning(read_toml(path)))
TABLE_JOBS = tuple(path for path in _ALL if path not in LATHE_JOBS)
