# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guard of the benches: what fell by more than a tenth is named, noise and gains are not."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

BENCH = Path(__file__).parents[2] / "bench"


@pytest.fixture
def guard() -> ModuleType:
    """The script `bench/guard.py` as a module."""
    specification = importlib.util.spec_from_file_location("bench_guard", BENCH / "guard.py")
    assert specification and specification.loader
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_only_what_fell_by_more_than_a_tenth_or_is_gone_is_named(guard: ModuleType) -> None:
    recorded = {"noise": 10.0, "fell": 10.0, "faster": 10.0, "gone": 10.0}
    assert guard.fallen(recorded, {"noise": 9.1, "fell": 8.9, "faster": 30.0, "new": 1.0}) == ["fell", "gone"]


def test_a_fall_counts_when_a_second_run_shows_it_too(
    guard: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    runs = iter([{"once": 5.0, "twice": 5.0}, {"once": 10.0, "twice": 6.0}])
    monkeypatch.setattr(guard, "measured", lambda name: next(runs))
    assert guard.compare({"bench": {"once": 10.0, "twice": 10.0}}) == 1
    said = capsys.readouterr()
    assert "twice fell by more than 10%" in said.err
    assert "once fell" not in said.err


def test_every_guarded_bench_is_there_and_recorded(guard: ModuleType) -> None:
    recorded = guard.json.loads(guard.RECORDED.read_text("utf-8"))
    assert set(recorded) == set(guard.GUARDED)
    for name in guard.GUARDED:
        assert "def guarded() -> dict[str, float]:" in (BENCH / f"bench_{name}.py").read_text("utf-8")
