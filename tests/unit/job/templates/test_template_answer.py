# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window is told of a template and a drawing: the contours of each rule, and the job in place."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.cut_transfer import job_from_content
from CNCStepper.job.drawings.packed_curves import unpacked_curves
from CNCStepper.job.templates.drawing_job import job_of_drawing
from CNCStepper.job.templates.template import read_template
from CNCStepper.job.templates.template_answer import template_answer
from CNCStepper.machine.files.toml_reader import read_toml

EXAMPLES = Path(__file__).parents[4] / "examples"
SIGN, TEMPLATE = EXAMPLES / "drawings" / "sign.svg", EXAMPLES / "templates" / "sign.toml"


def asked(make: bool, **changes: Any) -> dict[str, Any]:
    content = read_toml(TEMPLATE) | changes
    return {"file": str(SIGN), "path": str(TEMPLATE), "content": content, "make": make}


def test_each_rule_has_its_contours_and_what_none_takes_is_told() -> None:
    answer = template_answer(asked(False))
    counts = [taken["count"] for taken in answer["rules"]]
    assert [len(unpacked_curves(taken["curves"])) for taken in answer["rules"]] == counts
    without = template_answer(asked(False, rule=read_toml(TEMPLATE)["rule"][1:]))
    assert without["untaken"]["count"] + sum(taken["count"] for taken in without["rules"]) == sum(counts)
    assert [row[1] for row in without["untaken"]["rows"]] in (["#0000ff"], [])


def test_the_job_of_an_answer_is_the_job_file_s_but_for_its_place(tmp_path: Path) -> None:
    answer = template_answer(asked(True))
    ours = job_from_content(answer["job"])
    theirs = job_of_drawing(read_template(TEMPLATE), SIGN, tmp_path / "sign.toml").job
    assert (ours.stock, ours.tool, ours.machine, ours.material) == (
        theirs.stock,
        theirs.tool,
        theirs.machine,
        theirs.material,
    )
    assert answer["titles"] == ["letters", "pocket", "outline"]
    keys = {"outlines", "islands", "curves"}
    for one, other in zip(ours.operation, theirs.operation, strict=True):
        for key in keys:
            moved = [curve.moved(*answer["offset_mm"]) for curve in getattr(one, key, ())]
            assert moved == list(getattr(other, key, ()))
        assert one.model_dump(exclude=keys) == other.model_dump(exclude=keys)


def test_a_rule_that_does_nothing_is_refused() -> None:
    with pytest.raises(JobError, match="a rule has one of"):
        template_answer(asked(False, rule=[{"layer": "x"}]))
