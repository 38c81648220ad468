# SPDX-License-Identifier: LGPL-2.1-or-later
"""Without a window nothing of the window is loaded or missed, and what it would say is printed."""

from __future__ import annotations

import sys
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.services import messages


def test_objects_are_made_without_views(document: Any) -> None:
    job = api.new_job(document)
    api.add_tool(job)
    api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    assert api.program_text(job)
    assert all(obj.ViewObject is None for obj in document.Objects)
    assert not {name for name in sys.modules if name.startswith("CNCStepper.workbench.viewproviders")}


def test_what_is_told_is_printed(monkeypatch: pytest.MonkeyPatch) -> None:
    printed: list[str] = []
    monkeypatch.setattr(FreeCAD.Console, "PrintMessage", printed.append)
    messages.error(JobError("bad", "the job is bad", value="3 mm", advice="mend it"))
    messages.note("saved")
    assert printed == ["CNCStepper: the job is bad (3 mm); mend it\n", "CNCStepper: saved\n"]


def test_a_fault_is_printed_with_its_place(capfd: pytest.CaptureFixture[str]) -> None:
    def fail() -> None:
        raise ValueError("broken")

    messages.guarded(fail)()
    out, err = capfd.readouterr()
    assert "ValueError: broken" in out + err
    assert "test_without_window.py" in out + err
