# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of a machine of the user's own: found by its name, offered, and followed when its profile changes."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCAD
import pytest

from CNCStepper.machine.files.profile_files import own_folder
from CNCStepper.machine.own_profiles import change, create, label_of, profiles
from CNCStepper.workbench import api
from CNCStepper.workbench.document.machine_of_job import machine_of

STEPS = ("axis", "x", "steps_per_mm")


@pytest.fixture
def job(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    create("shop", "table-a")
    document = FreeCAD.newDocument("OwnMachine")
    yield api.new_job(document, machine="shop")
    FreeCAD.closeDocument(document.Name)


def test_a_job_follows_the_profile_that_it_names(job: Any) -> None:
    assert machine_of(job).axis["x"].steps_per_mm == 80
    change("shop", {STEPS: 81.5})
    job.touch()
    job.Document.recompute()
    assert machine_of(job).axis["x"].steps_per_mm == 81.5


def test_a_changed_copy_takes_the_place_of_a_shipped_profile(job: Any) -> None:
    job.Machine = "table-b"
    before = machine_of(job).axis["x"].steps_per_mm
    change("table-b", {STEPS: before + 1})
    assert machine_of(job).axis["x"].steps_per_mm == before + 1


def test_a_profile_that_cannot_be_read_is_offered_by_its_name(job: Any) -> None:
    (own_folder() / "broken.toml").write_text("name = 1\n", "utf-8")
    labels = [label_of(profile.name) for profile in profiles()]
    assert "broken" in labels and "shop (shop)" in labels
