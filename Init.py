# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this at every start, with and without a window: nothing heavy may be imported here."""

import FreeCAD

from CNCStepper.workbench import broken_pipes, packages

packages.make_available()
broken_pipes.raise_on_broken_pipe()
FreeCAD.__unit_test__ += ["CNCStepper.workbench.unit_tests.test_app"]
