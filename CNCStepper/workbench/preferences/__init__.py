# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's page in FreeCAD's own dialog of preferences."""

from __future__ import annotations

from CNCStepper.workbench import packages
from CNCStepper.workbench.services.messages import NAME


def register() -> None:
    """Add the page to FreeCAD's dialog; its icon is resources/icons/preferences-cncstepper.svg."""
    import FreeCADGui

    from CNCStepper.workbench.preferences.job_preferences import JobPreferences

    FreeCADGui.addIconPath(str(packages.ROOT / "resources" / "icons"))
    FreeCADGui.addPreferencePage(JobPreferences, NAME)
