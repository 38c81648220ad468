# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening the workbench: toolbar and menu the first time, missing packages every time."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import commands, dock, first_run, preferences
from CNCStepper.workbench.calculation import freecad_modules
from CNCStepper.workbench.installation import open_installation
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.messages import NAME, guarded
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP
from CNCStepper.workbench.viewproviders import tree_tooltips

LATHE = QT_TRANSLATE_NOOP("Workbench", "Lathe")  # FreeCAD translates names of toolbars and menus itself


@guarded
def first(workbench: Any) -> None:
    """Fill the workbench's toolbar and menu; what they make needs some of FreeCAD's own modules."""
    loading = freecad_modules.begin()
    toolbar, menu, turning = commands.register()
    workbench.appendToolbar(NAME, toolbar)
    workbench.appendToolbar(LATHE, turning)
    workbench.appendMenu(NAME, menu)
    workbench.appendMenu([NAME, LATHE], turning)
    preferences.register()
    tree_tooltips.install()
    freecad_modules.end(loading)


@guarded
def every() -> None:
    """Report missing packages the first time; attach to a machine that an earlier window left connected.

    What a first cut needs is compiled, where it is not.
    """
    missing_packages.look_again()
    missing_packages.report_once(open_installation)
    if not missing_packages.why_not():
        _warm_up()
        first_run.show_once()
    dock.open_if_connected()


def _warm_up() -> None:
    """Let kernels be compiled where they are not, and load what the first panels need beside the window."""
    from PySide import QtCore

    from CNCStepper.workbench.calculation import import_warmup, kernel_warmup

    if compiling := kernel_warmup.begin():
        compiling.ended.connect(import_warmup.begin_in_window)  # a kernel that is called before would be compiled here
    else:
        QtCore.QTimer.singleShot(import_warmup.AFTER_MS, import_warmup.begin_in_window)
