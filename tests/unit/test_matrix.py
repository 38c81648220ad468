# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of `make matrix`: their order, side by side, and a table in which nothing that failed is left out."""

from __future__ import annotations

import json
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from helpers.tools import load
from window_helpers import window_kinds

ROOT = Path(__file__).parents[2]
WAITS_S = 20.0


@pytest.fixture
def matrix() -> Any:
    return load("matrix")


def let_all_pass(matrix: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(matrix, "LOGS", tmp_path / "logs")
    monkeypatch.setattr(matrix, "system_version", lambda: "0.20.2")
    monkeypatch.setattr(matrix, "made", lambda version: True)
    monkeypatch.setattr(matrix, "told_version", lambda where: f"{where} ['…']")
    monkeypatch.setattr(matrix, "headless", lambda where, environment, log: True)
    monkeypatch.setattr(matrix, "installed", lambda where, log: True)
    monkeypatch.setattr(matrix, "window", lambda where, kind, environment, log, tests=(): True)
    monkeypatch.setattr(matrix.touches, "PICTURES", tmp_path)
    note_touches(tmp_path, "host", seen=["button"], touched=["button"])


def note_touches(folder: Path, run: str, seen: list[str], touched: list[str]) -> None:
    (folder / run).mkdir(exist_ok=True)
    (folder / run / "touches.json").write_text(json.dumps({"seen": seen, "touched": touched}), "utf-8")


def test_what_no_test_has_clicked_is_named(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    let_all_pass(matrix, monkeypatch, tmp_path)
    note_touches(tmp_path, "host-scaled", seen=["CNCStepper_Dock_lost"], touched=[])
    note_touches(tmp_path, "host-monkey", seen=[], touched=["CNCStepper_Dock_lost"])  # at random: does not count
    assert matrix.main([]) == 1
    assert "without a click of a test =====\nCNCStepper_Dock_lost\n" in capsys.readouterr().out
    note_touches(tmp_path, "host-portuguese", seen=[], touched=["CNCStepper_Dock_lost"])
    assert matrix.main([]) == 0
    assert "without a click of a test =====\nnothing\n" in capsys.readouterr().out
    assert matrix.main(["1.1.3"]) == 0
    assert "without a click" not in capsys.readouterr().out


def test_what_cannot_be_set_up_has_failed_and_the_rest_still_runs(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    def window(where: str, kind: str, environment: dict[str, str], log: Any, tests: Any) -> bool:
        log.write(f"the words of {where} {kind}\n")
        return where != "host" or kind != "scaled"

    let_all_pass(matrix, monkeypatch, tmp_path)
    monkeypatch.setattr(matrix, "made", lambda version: version == "1.1.3")
    monkeypatch.setattr(matrix, "window", window)
    assert matrix.main([]) == 1
    said = capsys.readouterr().out
    lines = {line.split()[0]: line for line in said.splitlines() if line[:1].isdigit()}
    assert lines["1.0.0"].count("NOT SET UP") == 8
    assert lines["0.20.2"].count("passed") == 9 and lines["0.20.2"].count("FAILED") == 1
    assert lines["1.1.3"].count("passed") == 9
    assert "0.20.2: scaled FAILED =====\nthe words of host scaled\n" in said
    assert "without a click of a test =====\n(scaled failed: clicks may be missing)\nnothing\n" in said
    assert matrix.main(["1.1.3"]) == 0


def test_a_freecad_that_does_not_tell_its_version_has_failed(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    let_all_pass(matrix, monkeypatch, tmp_path)
    monkeypatch.setattr(matrix, "told_version", lambda where: "" if where == "1.0.0" else "told")
    assert matrix.main([]) == 1
    assert matrix.main(["0.20.2", "1.1.3"]) == 0


def test_a_freecad_gets_the_documents_of_all_older_ones(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    given: dict[tuple[str, str], str] = {}

    def headless(where: str, environment: dict[str, str], log: Any) -> bool:
        if "CNCSTEPPER_OLDER" in environment:
            assert environment["CNCSTEPPER_PYTEST"] == matrix.DOCUMENT_TESTS
            given[where, "documents"] = environment["CNCSTEPPER_OLDER"]
        return True

    def window(where: str, kind: str, environment: dict[str, str], log: Any, tests: Any) -> bool:
        given[where, kind] = environment["CNCSTEPPER_OLDER"]
        return True

    let_all_pass(matrix, monkeypatch, tmp_path)
    monkeypatch.setattr(matrix, "headless", headless)
    monkeypatch.setattr(matrix, "window", window)
    assert matrix.main([]) == 0
    for kind in ("documents", "timed"):
        assert [given[where, kind] for where in ("host", "1.0.0", "1.1.3")] == ["", "0.20.2", "0.20.2 1.0.0"]


def test_the_systems_freecad_runs_whichever_it_is(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    let_all_pass(matrix, monkeypatch, tmp_path)
    monkeypatch.setattr(matrix, "system_version", lambda: "0.21.2")
    assert matrix.main([]) == 0
    lines = [line.split()[0] for line in capsys.readouterr().out.splitlines() if line[:1].isdigit()]
    assert lines == ["0.20.2", "0.21.2", "1.0.0", "1.1.3"]


def test_what_waits_for_another_run_begins_after_its_end(matrix: Any) -> None:
    runs = matrix.follows(list(matrix.VERSIONS))
    begun: list[Any] = []
    ended: list[Any] = []

    def run(key: Any) -> None:
        begun.append(key)
        assert set(runs[key]) <= set(ended)
        ended.append(key)

    matrix.run_in_lanes(runs, run, lanes=2)
    assert sorted(begun) == sorted(runs) and len(begun) == 3 * (1 + len(matrix.NAMES)) - 3
    assert ("1.0.0", "timed") in runs["1.1.3", "timed"] and ("0.20.2", "documents") in runs["1.0.0", "documents"]
    assert runs["1.1.3", "headless"] == (("1.1.3", "set up"),)


def test_so_many_runs_at_a_time_as_there_are_lanes_and_the_longest_first(matrix: Any) -> None:
    both = threading.Barrier(2, timeout=WAITS_S)
    begun: list[Any] = []

    def run(key: Any) -> None:
        begun.append(key)
        both.wait()

    runs = {("1", "bare"): (), ("1", "plain"): (), ("1", "timed"): (), ("1", "scaled"): ()}
    matrix.run_in_lanes(runs, run, lanes=2)
    assert set(begun[:2]) == {("1", "plain"), ("1", "scaled")}


def test_every_kind_of_window_has_its_run(matrix: Any) -> None:
    assert list(window_kinds.KINDS) == [*matrix.KINDS, *window_kinds.ON_DEMAND]


SUMMARY = """
FAILED tests/window/test_panels.py::test_bad_values[5 kg] - AssertionError: assert False
 +  where False = main()
ERROR tests/window/test_road.py::test_a_road
2 failed, 205 passed in 879.60s
"""


def window_that_fails(again: bool, words: str, asked: list[tuple[str, ...]]) -> Any:
    """Return a window whose plain tests fail in 1.1.3, and once more, named, where that is wanted."""

    def window(where: str, kind: str, environment: dict[str, str], log: Any, tests: Sequence[str]) -> bool:
        if (where, kind) != ("1.1.3", "plain"):
            return True
        asked.append(tuple(tests))
        log.write(words)
        return "::" in tests[0] and not again

    return window


def test_the_road_and_the_rest_are_all_files_and_the_freecad_between_runs_the_road(matrix: Any) -> None:
    road, rest = matrix.chosen_files("plain"), matrix.chosen_files("rest")
    every = [f"tests/window/{path.name}" for path in (ROOT / "tests" / "window").glob("test_*.py")]
    assert road and sorted([*road, *rest]) == sorted(every) and not matrix.chosen_files("bare")
    assert ("1.0.0", "plain") in matrix.follows(list(matrix.VERSIONS))
    follows = matrix.follows(list(matrix.VERSIONS))
    assert ("1.0.0", "rest") not in follows and [key for key in follows if "monkey" in key] == [("0.20.2", "monkey")]


def test_what_would_not_end_in_time_is_left_out_and_named(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    let_all_pass(matrix, monkeypatch, tmp_path)
    monkeypatch.setattr(matrix, "UNTIL_S", 0.0)
    assert matrix.main([]) == 0
    said = capsys.readouterr().out
    lines = {line.split()[0]: line for line in said.splitlines() if line[:1].isdigit()}
    assert lines["0.20.2"].count("LEFT OUT") == 6 and lines["0.20.2"].count("passed") == 4
    assert lines["1.0.0"].count("LEFT OUT") == 5 and "FreeCAD 1.1.3: rest is left out" in said
    assert "without a click" not in said


def test_how_long_a_run_takes_is_estimated_from_those_that_have_ended(matrix: Any) -> None:
    row = matrix.Row("0.20.2")
    assert row.lasts_s("rest") == matrix.SECONDS["rest"]
    row.results = {"documents": (True, 10.0), "headless": (True, 330.0), "plain": (True, 980.0)}  # about thrice as long
    assert row.lasts_s("rest") == pytest.approx(3 * matrix.SECONDS["rest"], rel=0.2)


@pytest.mark.parametrize("again", [False, True])
def test_what_failed_beside_another_window_runs_once_more_alone(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, again: bool
) -> None:
    asked: list[tuple[str, ...]] = []
    let_all_pass(matrix, monkeypatch, tmp_path)
    monkeypatch.setattr(matrix, "window", window_that_fails(again, SUMMARY, asked))
    assert matrix.main([]) == int(again)
    named = ("tests/window/test_panels.py::test_bad_values[5 kg]", "tests/window/test_road.py::test_a_road")
    assert asked == [tuple(matrix.chosen_files("plain")), named]


def test_a_freecad_that_crashed_has_failed_for_good(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    asked: list[tuple[str, ...]] = []
    let_all_pass(matrix, monkeypatch, tmp_path)
    words = f"{SUMMARY}window: FreeCAD ended with exit status -11\n"
    monkeypatch.setattr(matrix, "window", window_that_fails(False, words, asked))
    assert matrix.main([]) == 1
    assert asked == [tuple(matrix.chosen_files("plain"))]
