# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this when its window starts: it only makes the workbench known by name and icon.

It runs inside a function of FreeCAD's: a class here does not see this file's own imports.
"""

import FreeCAD
import FreeCADGui


class CNCStepperWorkbench(FreeCADGui.Workbench):
    """The entry in FreeCAD's list of workbenches."""

    from CNCStepper.workbench import packages, viewproviders

    MenuText = "CNCStepper"
    ToolTip = "From a drawing to a cut part on stepper-driven tables"
    Icon = str(packages.ROOT / "resources" / "icons" / "CNCStepper.svg")

    def Initialize(self) -> None:
        """Make toolbar and menu, when the workbench is opened for the first time."""
        from CNCStepper.workbench import opening

        opening.first(self)

    def Activated(self) -> None:
        """Say what is missing, when the workbench is opened."""
        from CNCStepper.workbench import opening

        opening.every()

    def GetClassName(self) -> str:
        """Return FreeCAD's own class for workbenches in Python."""
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(CNCStepperWorkbench())
CNCStepperWorkbench.viewproviders.register()
FreeCADGui.addLanguagePath(str(CNCStepperWorkbench.packages.ROOT / "resources" / "translations"))
FreeCADGui.updateLocale()  # FreeCAD chose its language before it knew this folder
FreeCAD.__unit_test__ += ["CNCStepper.workbench.unit_tests.test_gui"]
