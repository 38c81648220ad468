# SPDX-License-Identifier: LGPL-2.1-or-later
"""After the warm-up the first nest loads no heavy module, and no kernel, on the window's thread."""

from __future__ import annotations

import json
import subprocess
import sys

MOST_MS = 50.0  # of processor time of one call on the window's thread
FIRST_NEST = """
import json, sys, time
from CNCStepper.workbench.calculation import import_warmup
import_warmup.begin().result() if {warm} else None
before, begun_s = set(sys.modules), time.thread_time()
from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.geometry.curve import from_points
from CNCStepper.job.curve_fit_cache import require
from CNCStepper.job.nesting.nest_data import packed_chains
from CNCStepper.job.nesting.nest_form import NestForm
from CNCStepper.machine.profile import validated
from CNCStepper.nesting.manual_nesting import ManualNest
square = from_points([(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)], closed=True)
assert square.length_mm == 36.0
packed_chains([Chain(square.moved(1.0, 2.0), Attributes(layer="CUT"))])
ms = 1e3 * (time.thread_time() - begun_s)
print(json.dumps([ms, len([name for name in sys.modules if name not in before])]))
"""


def first_nest(warm: bool) -> tuple[float, int]:
    """Return the milliseconds that the calls of a first nest take on their thread, and the modules that they load."""
    run = subprocess.run(
        [sys.executable, "-c", FIRST_NEST.format(warm=warm)], capture_output=True, text=True, timeout=120, check=True
    )
    ms, loaded = json.loads(run.stdout)
    return ms, loaded


def test_what_a_first_nest_needs_is_loaded_beside_the_window() -> None:
    ms, loaded = first_nest(warm=True)
    cold_ms, cold_loaded = first_nest(warm=False)
    print(f"{ms:.1f} ms and {loaded} modules after the warm-up, {cold_ms:.0f} ms and {cold_loaded} without")
    assert (ms < MOST_MS, loaded) == (True, 0)
    assert cold_ms > MOST_MS and cold_loaded > 100, "without the warm-up the test must see the load"
