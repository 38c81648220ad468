# SPDX-License-Identifier: LGPL-2.1-or-later
"""The catalogue of cycles: every name leads to its class, and a job loads no cycle but its own."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from CNCStepper.cycles.catalogue import CYCLES, cycle_class

POCKET = Path(__file__).parents[3] / "examples" / "jobs" / "elliptical-pocket.toml"
LOADED = """import sys
from pathlib import Path
from CNCStepper.cycles.catalogue import CYCLES
from CNCStepper.job.model import load_job
load_job(Path(sys.argv[1]))
print(*(name for name, place in CYCLES.items() if f"CNCStepper.cycles.{place.rpartition('.')[0]}" in sys.modules))
"""


def test_every_name_is_that_of_its_cycle() -> None:
    assert {name: cycle_class(name).model_fields["cycle"].default for name in CYCLES} == {name: name for name in CYCLES}


def test_a_job_loads_the_cycles_that_it_names_alone() -> None:
    run = subprocess.run([sys.executable, "-c", LOADED, str(POCKET)], capture_output=True, encoding="utf-8", check=True)
    assert run.stdout.split() == ["elliptical_pocket"]
