# SPDX-License-Identifier: LGPL-2.1-or-later
"""Presets of operations: kept under a cycle and a name, given back as they were, and a bad file stays as it is."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.libraries.operation_presets import delete_preset, presets_of, presets_path, save_preset

FAST = {"stepdown_mm": 3.0, "entry": "ramp", "passes": 2, "climb": True}


@pytest.fixture(autouse=True)
def config(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("CNCStepper.machine.libraries.operation_presets.config_folder", lambda: tmp_path / "own")


def test_a_preset_comes_back_by_its_name_and_only_for_its_cycle() -> None:
    assert presets_of("pocket") == {}
    assert save_preset("pocket", '  Compensado "12 mm", rápido ', FAST) == 'Compensado "12 mm", rápido'
    save_preset("pocket", "aluminium", {"stepdown_mm": 0.5})
    save_preset("pocket", "aluminium", {"stepdown_mm": 0.4})
    save_preset("face", "aluminium", {"stepover_mm": 5.0})
    assert presets_of("pocket") == {"aluminium": {"stepdown_mm": 0.4}, 'Compensado "12 mm", rápido': FAST}
    delete_preset("pocket", "aluminium")
    delete_preset("pocket", "never kept")
    assert list(presets_of("pocket")) == ['Compensado "12 mm", rápido'] and list(presets_of("face")) == ["aluminium"]


@pytest.mark.parametrize("name", ["", "  ", "two\nlines", "x" * 61])
def test_a_name_that_cannot_be_is_refused_and_nothing_is_written(name: str) -> None:
    with pytest.raises(JobError, match="cannot be named"):
        save_preset("pocket", name, FAST)
    assert not presets_path().exists()


@pytest.mark.parametrize("text", ["pocket = 3", "[pocket]\nfast = 3", "[pocket.fast]\nstepdown_mm = [1, 2]", "[[["])
def test_a_bad_file_is_refused_and_stays_as_it_is(text: str) -> None:
    presets_path().parent.mkdir()
    presets_path().write_text(text, "utf-8")
    for act in (lambda: presets_of("pocket"), lambda: save_preset("pocket", "fast", FAST)):
        with pytest.raises(JobError) as refused:
            act()
        assert refused.value.place.file == str(presets_path())
    assert presets_path().read_text("utf-8") == text
