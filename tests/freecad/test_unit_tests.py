# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own test framework knows our tests, and they pass."""

from __future__ import annotations

import io
import unittest

import FreeCAD

APP = "CNCStepper.workbench.unit_tests.test_app"


def test_freecads_test_framework_runs_our_tests() -> None:
    assert APP in FreeCAD.__unit_test__
    said = io.StringIO()
    result = unittest.TextTestRunner(stream=said).run(unittest.defaultTestLoader.loadTestsFromName(APP))
    assert result.testsRun >= 5
    assert result.wasSuccessful(), said.getvalue()
