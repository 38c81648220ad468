# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the workbench's window works in this FreeCAD."""

from __future__ import annotations

import unittest
from pathlib import Path

import FreeCAD
import FreeCADGui

from CNCStepper.workbench import api, packages
from CNCStepper.workbench.panels import open_panel

ICONS = packages.ROOT / "resources" / "icons"


class TestWorkbench(unittest.TestCase):
    """Commands and panels of the workbench."""

    @classmethod
    def setUpClass(cls) -> None:
        """Open the workbench, which registers its commands."""
        FreeCADGui.activateWorkbench("CNCStepperWorkbench")

    def test_every_command_has_text_and_icon(self) -> None:
        """FreeCAD shows no empty button."""
        ours = [name for name in FreeCADGui.listCommands() if name.startswith("CNCStepper_")]
        self.assertTrue(ours)
        for name in ours:
            told = FreeCADGui.Command.get(name).getInfo()
            self.assertTrue(told["menuText"] and told["toolTip"], name)
            self.assertTrue(Path(told["pixmap"]).is_file(), name)

    def test_panel_of_a_new_job_opens(self) -> None:
        """A job, its tool and its panel can be made."""
        document = FreeCAD.newDocument("CNCStepperTest")
        try:
            job = api.new_job(document, machine="table-a", stock_size_mm=(100, 70, 20))
            document.recompute()
            open_panel(job)
            self.assertTrue(FreeCADGui.Control.activeDialog())
        finally:
            FreeCADGui.Control.closeDialog()
            document.abortTransaction()
            FreeCAD.closeDocument(document.Name)
