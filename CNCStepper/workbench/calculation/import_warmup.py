# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads what the first panels, dialogs and the dock need, soon after the workbench is open.

Loaded with the first panel, it would keep the window from its events for half a second and more.

opening.py ──► after AFTER_MS: begin ──► thread: modules of the core, then one kernel: numba loads as much for it
               begin_in_window ──► when these are loaded: one of the window's own modules in each of its events
                               ──► then: thread: the sentences of messages; all kernels, where they are compiled already
"""

from __future__ import annotations

import contextlib
import importlib
from collections.abc import Iterator
from concurrent.futures import Future
from typing import Any

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.errors import MissingPackage

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
    "CNCStepper.cycles.catalogue",
    "CNCStepper.cycles.facing.face_parameters",
    "CNCStepper.cycles.holes.hole_parameters",
    "CNCStepper.cycles.pockets.pocket_parameters",
    "CNCStepper.machine.libraries.operation_presets",
    "CNCStepper.job.model",
    "CNCStepper.job.templates.begun_job",
    "CNCStepper.job.templates.turning_template",
    "CNCStepper.job.turning.turning_transfer",
    "CNCStepper.job.stock_fit",
    "CNCStepper.job.proof_folder",
    "CNCStepper.job.turning.turning_proof_folder",
    "CNCStepper.job.turning.prove_program",
    "serial.tools.list_ports",
    "CNCStepper.control.service.connection_client",
    "CNCStepper.control.service.work_zero",
    "CNCStepper.control.settings.settings_profile",
    "CNCStepper.control.settings.settings_restore",
    "CNCStepper.control.protocol.grbl.capabilities",
    "CNCStepper.control.program.send_job",
    "CNCStepper.control.journal.replay",
    "CNCStepper.recovery.restart.restart_places",
    "CNCStepper.recovery.restart.restart_proof_folder",
    "CNCStepper.simulation.tip_follower",
    "CNCStepper.simulation.views.depth_colours",
    "CNCStepper.simulation.views.path_lines",
)
WINDOW_MODULES = (  # an import of `api` or of the panels is long as a whole: its parts come first
    "CNCStepper.workbench.document.drawing_files",
    "CNCStepper.workbench.document.macro_recorder",
    "CNCStepper.workbench.calculation.deferred_cuts",
    "CNCStepper.workbench.features.job",
    "CNCStepper.workbench.features.bore",
    "CNCStepper.workbench.features.pocket",
    "CNCStepper.workbench.features.sheet_cut",
    "CNCStepper.workbench.features.catalogue",
    "CNCStepper.workbench.features.drawings.drawing",
    "CNCStepper.workbench.features.drawings.nest",
    "CNCStepper.workbench.features.drawings.slices",
    "CNCStepper.workbench.features.drawings.text",
    "CNCStepper.workbench.features.freehand",
    "CNCStepper.workbench.features.programs.arrangement",
    "CNCStepper.workbench.features.turning.lathe_job",
    "CNCStepper.workbench.features.turning.turning_tool",
    "CNCStepper.workbench.api",
    "CNCStepper.workbench.panels.fields",
    "CNCStepper.workbench.panels.remedies",
    "CNCStepper.workbench.panels.form",
    "CNCStepper.workbench.panels.object_form",
    "CNCStepper.workbench.templates.job_template",
    "CNCStepper.workbench.document.turning.core_turning_job",
    "CNCStepper.workbench.templates.turning_template",
    "CNCStepper.workbench.panels.catalogue",
    "CNCStepper.workbench.panels.job",
    "CNCStepper.workbench.panels.turning",
    "CNCStepper.workbench.panels.placing.nest",
    "CNCStepper.workbench.panels.drawing",
    "CNCStepper.workbench.panels.text",
    "CNCStepper.workbench.editor.view_session",
    "CNCStepper.workbench.simulation.task",
    "CNCStepper.workbench.simulation.turned_task",
    "CNCStepper.workbench.restart.panel",
    "CNCStepper.workbench.restart.task",
    "CNCStepper.workbench.dock.connection",
    "CNCStepper.workbench.dock.controller_panel",
    "CNCStepper.workbench.libraries.dialog",
    "CNCStepper.workbench.machines.dialog",
    "CNCStepper.workbench.assistant.wizard",
)

ended = False  # whether what `begin_in_window` has begun is over


def begin() -> Future[None]:
    """Load all in a thread; what is loaded already costs nothing."""
    return in_background(load)


def load() -> None:
    """Load all: what the window then needs of it is there."""
    for name in MODULES:
        _load(name)
    from CNCStepper.geometry.curve import from_points

    _ = from_points([(0.0, 0.0), (1.0, 0.0)], closed=False).length_mm


def _load(name: str) -> None:
    """Load a module, unless a package that it needs is missing: that is told where a person needs it."""
    with contextlib.suppress(ModuleNotFoundError, MissingPackage):
        importlib.import_module(name)


def begin_in_window() -> None:
    """Load all, and then what belongs to the window's thread, in that thread."""
    from PySide import QtCore

    from CNCStepper.workbench.calculation.preloading import LOOK_EVERY_MS
    from CNCStepper.workbench.services.messages import guarded

    loaded, left = begin(), iter(WINDOW_MODULES)
    timer = QtCore.QTimer(QtCore.QCoreApplication.instance())
    timer.timeout.connect(guarded(lambda: _load_next(loaded, left, timer)))
    timer.start(LOOK_EVERY_MS)


def _load_next(loaded: Future[None], left: Iterator[str], timer: Any) -> None:
    if not loaded.done():
        return
    if (name := next(left, "")) and loaded.exception() is None:
        _load(name)
        return
    timer.stop()
    timer.deleteLater()
    loaded.result()
    in_background(_load_the_rest)


def _load_the_rest() -> None:
    """Read the sentences of messages, and the machine code of what is cut in the window: a tenth of a second each."""
    from CNCStepper.workbench.calculation.kernel_warmup import are_compiled
    from CNCStepper.workbench.services import message_translation

    global ended
    try:
        message_translation.load_catalogue()
        if are_compiled():
            from CNCStepper.workers.kernel_warm_up import cut_each_kind

            cut_each_kind()
    finally:
        ended = True
