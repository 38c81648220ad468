# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job's material gives feeds and speeds to tools that have none, and warns of those that do not fit it."""

from __future__ import annotations

from typing import Any

import pytest

from CNCStepper.machine.feeds_and_speeds import feeds_of
from CNCStepper.machine.materials import material, material_names
from CNCStepper.workbench import api
from CNCStepper.workbench.document.core_job import machine_of
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.features.tool import model_of
from CNCStepper.workbench.services.choice_labels import WORDS

NOTHING = {"feed_mm_min": 0, "plunge_mm_min": 0, "spindle_rpm": 0}


@pytest.fixture
def job(document: Any) -> Any:
    job = api.new_job(document)
    api.add_tool(job, diameter_mm=6, **NOTHING)
    api.add_operation(job, "circular_pocket", radius_mm=15, depth_mm=2)
    return job


def test_every_material_has_words() -> None:
    assert set(material_names()) <= set(WORDS)


def test_without_a_material_a_tool_without_a_feed_is_refused(document: Any, job: Any) -> None:
    document.recompute()
    assert "feed_mm_min" in problem_of(job.Operations[0])


def test_the_material_gives_what_the_tool_has_not(document: Any, job: Any) -> None:
    api.edit(job, material="plywood")
    document.recompute()
    found = feeds_of(model_of(job.Tools[0]), material("plywood"), machine_of(job))
    text = api.program_text(job)
    assert f"S{found.spindle_rpm:g}" in text and f"F{found.feed_mm_min:g}" in text
    tool = job.Tools[0]
    assert (float(tool.FeedUsed) * 60, tool.SpindleUsed) == pytest.approx((found.feed_mm_min, found.spindle_rpm))
    api.edit(job, material="aluminium-6061")
    document.recompute()
    assert api.program_text(job) != text


def test_what_the_tool_has_stays_and_is_judged(document: Any, job: Any) -> None:
    api.edit(job, material="aluminium-6061")
    api.edit(job.Tools[0], feed_mm_min=3000, plunge_mm_min=100, spindle_rpm=8000, flutes=2)
    document.recompute()
    assert problem_of(job) == ""
    assert "F3000" in api.program_text(job)
    assert any("too thick a chip" in warning for warning in job.Operations[0].Proxy.warnings)


def test_a_material_that_there_is_not_is_refused(document: Any, job: Any) -> None:
    api.edit(job, material="unobtainium")
    document.recompute()
    assert "unobtainium" in problem_of(job)
