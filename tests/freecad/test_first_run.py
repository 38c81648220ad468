# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every example of the first steps becomes objects with a program; the window tests open them by clicks."""

from __future__ import annotations

from typing import Any

import pytest

from CNCStepper.workbench import api
from CNCStepper.workbench.document.job_files import open_job
from CNCStepper.workbench.first_run.examples import EXAMPLES, Example


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.path.stem)
def test_an_example_opens_with_its_program(example: Example, document: Any) -> None:
    job, notes = open_job(document, example.path)
    document.recompute()
    assert len(api.program_text(job).splitlines()) > 20
    assert not notes
