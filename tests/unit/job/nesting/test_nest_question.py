# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window asks about a nest: shown, searched, filled, written; locked parts stay; a stop gives what is found."""

from __future__ import annotations

import time
from pathlib import Path
from threading import Event, Timer
from typing import Any

import pytest

from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import CNCStepperError, GeometryError
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.job.nesting.nest_data import packed_chains, parts_of, unpacked_order
from CNCStepper.job.nesting.nest_question import answer_of

PLATE = [
    Chain(from_points([(0, 0), (60, 0), (60, 40), (0, 40)], closed=True), Attributes(layer="OUT")),
    Chain(circle((30, 20), 12.0), Attributes(layer="OUT")),
    Chain(from_points([(5, 5), (15, 5)], closed=False), Attributes(layer="BEND")),
]


def asked(verb: str, folder: Path, parts: list[list[Any]] | None = None, **more: Any) -> dict[str, Any]:
    order = {
        "kerf_mm": 0.5,
        "gap_mm": 1.5,
        "margin_mm": 4.5,
        "sheet": [{"size_mm": [200.0, 100.0], "count": 2}],
        "part": [
            {"name": "plate", "drawing": "plate", "count": 3, "rotations_deg": [0.0, 90.0]},
            {"name": "dot", "diameter_mm": 8.0, "count": 2},
        ],
    }
    drawings = {"plate": packed_chains(PLATE)}
    return {
        "verb": verb,
        "order": order,
        "drawings": drawings,
        "parts": parts or [],
        "folder": str(folder),
        "time_s": 1.0,
        **more,
    }


def test_a_search_keeps_locked_parts_and_writes_the_sheets(tmp_path: Path) -> None:
    fixed = [0, 0, 100.0, 50.0, 0.0, True]
    answer = answer_of(asked("search", tmp_path, [fixed]))
    assert fixed in answer["parts"] and len(answer["parts"]) == 5 and answer["missing"] == 0
    assert sum(locked for *_, locked in answer["parts"]) == 1
    items, sheets, spacing = unpacked_order(answer["order"])
    assert [item.count for item in items] == [3, 2] and len(sheets) == 2 and spacing.gap_mm == 2.0
    chains = read_drawing(Path(answer["sheets"][0]), ReadOptions()).chains
    assert {"OUT", "BEND", "CUT", "SHEET"} <= {chain.attributes.layer for chain in chains}


def test_filling_adds_parts_and_writing_judges_the_whole(tmp_path: Path) -> None:
    shown = answer_of(asked("show", tmp_path / "no"))
    assert shown["parts"] == [] and not (tmp_path / "no").exists()
    filled = answer_of(asked("fill", tmp_path / "no", [[0, 0, 5.0, 5.0, 0.0, False]], item=1, sheet=0, time_s=60.0))
    assert len(filled["parts"]) > 20 and {row[1] for row in filled["parts"][1:]} == {1}
    written = answer_of(asked("write", tmp_path / "out", filled["parts"]))
    assert written["missing"] == 2 and len(written["sheets"]) == 1 and written["density"] > 0.2
    moved = [list(row) for row in filled["parts"]]
    moved[1][2] += 0.7
    with pytest.raises(GeometryError, match=r"too close|beyond"):
        answer_of(asked("write", tmp_path / "bad", moved))
    assert not (tmp_path / "bad").exists()
    assert written["faults"] == [] and 1 in answer_of(asked("show", tmp_path / "bad", moved))["faults"]


def test_a_stopped_search_gives_what_it_has(tmp_path: Path) -> None:
    stopped, shares = Event(), list[float]()
    Timer(1.0, stopped.set).start()
    begun_s = time.monotonic()
    answer = answer_of(asked("search", tmp_path, time_s=60.0), shares.append, stopped)
    assert time.monotonic() - begun_s < 20.0
    assert len(shares) > 5 and shares == sorted(shares), "whatever it does it reports, and so looks for a stop"
    assert len(parts_of(answer["parts"])) + answer["missing"] == 5


def test_a_drawing_that_is_no_part_is_refused(tmp_path: Path) -> None:
    question = asked("search", tmp_path)
    question["drawings"] = {"plate": packed_chains(PLATE[2:])}
    with pytest.raises(CNCStepperError, match="part 'plate': the drawing has no closed outline"):
        answer_of(question)


def test_common_lines_are_told_and_parts_of_sheets_that_are_gone_are_left_out(tmp_path: Path) -> None:
    question = asked("search", tmp_path, [[7, 0, 0.0, 0.0, 0.0, True]])
    question["order"] |= {"gap_mm": 0.0, "common_lines": True}
    answer = answer_of(question)
    assert len(answer["parts"]) == 5 and {row[0] for row in answer["parts"]} <= {0, 1}
    assert answer["saving"][0].startswith("common lines: ") and answer_of(asked("show", tmp_path))["saving"] == []
    chains = read_drawing(Path(answer["sheets"][0]), ReadOptions()).chains
    assert {"OUT", "BEND", "CUT", "SHEET", "COMMON"} == {chain.attributes.layer for chain in chains}
