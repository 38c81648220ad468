# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of `make matrix`: a FreeCAD that cannot be set up has failed, it is never left out."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture
def matrix() -> Any:
    spec = importlib.util.spec_from_file_location("matrix_of_freecads", ROOT / "tools" / "matrix.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def test_what_cannot_be_set_up_has_failed_and_the_rest_still_runs(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(matrix, "system_version", lambda: "0.20.2")
    monkeypatch.setattr(matrix, "set_up", lambda version: version == "1.1.3")
    monkeypatch.setattr(matrix, "told_version", lambda where: f"{where} ['…']")
    monkeypatch.setattr(matrix, "headless", lambda where, environment: True)
    monkeypatch.setattr(matrix, "followed", lambda where: True)
    monkeypatch.setattr(matrix, "window", lambda where, kind, environment: where != "host" or kind != "scaled")
    assert matrix.main([]) == 1
    lines = {line.split()[0]: line for line in capsys.readouterr().out.splitlines() if line[:1].isdigit()}
    assert lines["1.0.0"].count("NOT SET UP") == 7
    assert lines["0.20.2"].count("passed") == 6 and lines["0.20.2"].count("FAILED") == 1
    assert lines["1.1.3"].count("passed") == 7
    assert matrix.main(["1.1.3"]) == 0
