# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editing verbs as an editor asks for them: by name, with their values; what they would spoil is refused."""

from __future__ import annotations

import inspect
from pathlib import Path

import pytest
from test_program_editor import TEXT, Here

from CNCStepper.errors import CNCStepperError, ProgramError
from CNCStepper.job.editing.edit_verbs import CONVERT, VERBS, edited
from CNCStepper.machine.profile import load_machine

GOOD = TEXT.replace("G2 X60 Y20 J20", "G2 X60 Y20 I0 J20").replace("G1 X\n", "G1 Y20\n")


def test_every_verb_is_asked_by_its_name() -> None:
    needed = {"scale": {"x": 2.0}, "rotate": {"angle_deg": 90.0}, "mirror": {"axis": "x"}, "units": {"units": "inch"}}
    needed |= {"feeds": {"factor": 0.5}, "compact": {"tolerance_mm": 0.01}, "offset": {"x_mm": 5.0}}
    for verb, function in VERBS.items():
        values = needed.get(verb, {})
        inspect.signature(function).bind(GOOD, **values)
        try:
            result = edited(GOOD, verb, values)
        except ProgramError as error:
            assert verb == "reverse", (verb, error)  # this one has a contour that cannot be cut the other way
        else:
            assert result.before == GOOD and (result.changes or verb in ("compact", "without_numbers", CONVERT))


def test_an_edit_that_would_leave_the_machine_is_refused() -> None:
    machine = load_machine("table-a")
    with pytest.raises(ProgramError):
        edited(GOOD, "scale", {"x": 50.0}, machine.controller, machine=machine)
    assert edited(GOOD, "offset", {"x_mm": 1.0}, machine.controller, machine=machine).changes


def test_an_unknown_verb_is_refused() -> None:
    with pytest.raises(CNCStepperError, match="no such verb"):
        edited(GOOD, "bake", {})


def test_the_worker_answers_with_the_difference_and_the_new_text(tmp_path: Path) -> None:
    here = Here(tmp_path, GOOD)
    here.on_message(3)
    here.put({"edit": {"verb": "offset", "values": {"x_mm": 5.0}}})
    (told,) = here.on_message()
    assert told["edited"] == 1 and told["changes"] > 0 and told["more"] == 0
    assert "-G1 X40" in told["diff"] and "+G1 X45" in told["diff"]
    assert "G1 X45\n" in (tmp_path / told["text"]).read_text("utf-8")
    here.put({"edit": {"verb": "scale", "values": {"x": 2.0, "y": 1.0}}})
    (refused,) = here.on_message()
    assert refused["error_of_edit"]["code"] and here.answers._text.lines == GOOD.splitlines()
