# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests that a person runs in FreeCAD's Test workbench, or by `freecad -t CNCStepper.workbench.unit_tests.test_app`.

They say whether this installation works. `Init.py` and `InitGui.py` register them.
"""
