# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every example of the first steps opens as a document with a program, as one undo step."""

from __future__ import annotations

from typing import Any

import FreeCAD
import pytest

from CNCStepper.workbench import api
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.first_run.examples import EXAMPLES, Example, open_example


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.path.stem)
def test_an_example_opens_with_its_program(example: Example, document: Any) -> None:
    opened = open_example(example)
    try:
        assert FreeCAD.ActiveDocument.Name == opened.Name != document.Name
        (job,) = targets.jobs()
        assert len(api.program_text(job).splitlines()) > 20
        assert opened.UndoCount <= 1
    finally:
        FreeCAD.closeDocument(opened.Name)
