# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads what the first panels need in a background thread, soon after the workbench is open.

Loaded by the window's thread, with the first panel, it would keep that from its events for half a second and more.

opening.py ──► after AFTER_MS: begin ──► thread: modules of the core, then one kernel: numba loads as much for it
"""

from __future__ import annotations

import importlib
from concurrent.futures import Future

from CNCStepper.control.processes.background_thread import in_background

AFTER_MS = 500  # the window is painted first
MODULES = (  # of the core alone: modules of FreeCAD and Qt belong to the window's thread
    "CNCStepper.machine.feeds_and_speeds",
    "CNCStepper.cycles.sheet_cutting.sheet_parameters",
    "CNCStepper.cycles.turning.turning_parameters",
    "CNCStepper.cycles.wire_cutting.wire_parameters",
    "CNCStepper.job.shape_forms.text_parameters",
    "CNCStepper.job.curve_fit_cache",
    "CNCStepper.job.nesting.nest_data",
    "CNCStepper.job.nesting.nest_form",
)


def begin() -> Future[None]:
    """Load all in a thread; what is loaded already costs nothing."""
    return in_background(load)


def load() -> None:
    """Load all: what the window then needs of it is there."""
    for name in MODULES:
        importlib.import_module(name)
    from CNCStepper.geometry.curve import from_points

    _ = from_points([(0.0, 0.0), (1.0, 0.0)], closed=False).length_mm
