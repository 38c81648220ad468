# SPDX-License-Identifier: LGPL-2.1-or-later
"""These tests run inside FreeCAD (see run.py); tests/test_in_freecad.py starts them there."""

from __future__ import annotations

import importlib.util
import locale

INSIDE = importlib.util.find_spec("FreeCAD") is not None
collect_ignore_glob = [] if INSIDE else ["test_*.py"]

if INSIDE:
    from collections.abc import Iterator
    from typing import Any

    import FreeCAD
    import pytest

    @pytest.fixture
    def document() -> Iterator[Any]:
        """A new document; all that are open are closed afterwards."""
        locale.setlocale(locale.LC_NUMERIC, "C")  # as FreeCAD keeps it; Qt's application of another test sets it anew
        yield FreeCAD.newDocument("Test")
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
