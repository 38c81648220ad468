# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window says of a tool in a material is what the job file says."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.workbench.document.cut_chart_of_job import fed
from CNCStepper.workbench.document.machine_of_job import remarks

JOB = SimpleNamespace(Process="milling", Material="fr4", Machine="table-a", Dialect="")


def hss(**feeds: float) -> Tool:
    return Tool(number=1, shape="flat", diameter_mm=3, made_of="hss", **feeds)


def test_a_tool_of_no_use_in_the_material_is_warned_of_where_it_has_its_own_feeds() -> None:
    own = hss(feed_mm_min=300, plunge_mm_min=90, spindle_rpm=9000)
    assert fed(own, JOB) is own
    (told,) = remarks(own, JOB)
    assert "HSS" in told and "; " in told
    with pytest.raises(JobError, match="HSS"):
        fed(hss(), JOB)


def test_without_a_material_and_for_a_beam_there_is_nothing_to_say() -> None:
    own = hss(feed_mm_min=300, plunge_mm_min=90, spindle_rpm=9000)
    assert remarks(own, SimpleNamespace(Process="milling", Material="", Machine="table-a", Dialect="")) == ()
    assert remarks(Tool(number=2, shape="jet", diameter_mm=0.2, feed_mm_min=900), JOB) == ()
