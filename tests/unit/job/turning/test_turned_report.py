# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict on a turned part against its job: profile, dimensions, pieces, findings, picture."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.image import imread

from CNCStepper.job.turning.report import TurnedVerdict, judge_turning, setup_of
from CNCStepper.job.turning.turning_job import turning_job_of
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.simulation.views.picture_style import COLOURS
from helpers.simulation.lathe_moves import lathe_path

TOOLS = [
    {"number": 1, "insert": "CNMG 120408", "ap_max_mm": 4},
    {"number": 2, "kind": "parting", "width_mm": 3, "reach_mm": 30},
    {"number": 3, "kind": "drill", "diameter_mm": 10},
]
ROUGH = {"cycle": "turn_rough", "tool": 1, "profile": "shaft", "ap_mm": 2, "stock_to_leave_mm": 0.5}
FINISH = {"cycle": "turn_finish", "tool": 1, "profile": "shaft"}
FACE = {"cycle": "turn_face", "tool": 1}
PART = {"cycle": "turn_part", "tool": 2, "z_mm": -40}
DRILL = {"cycle": "turn_drill", "tool": 3, "depth_mm": 20}
FACING = [("rapid", 0, 30), ("feed", 0, -0.8), ("feed", 2, -0.8), ("rapid", 2, 30)]
TURNING = [("rapid", 2, 18), ("feed", -30, 18), ("feed", -30, 22), ("rapid", 2, 22)]


def job(*operations: dict[str, Any], **more: Any) -> Any:
    content = {
        "machine": "mini-lathe",
        "process": "turning",
        "x_is": "diameter",
        "stock": {"diameter_mm": 40, "face_mm": 1, "length_mm": 80},
        "chuck": {"diameter_mm": 100, "jaw_diameter_mm": 80, "jaw_mm": 15},
        "tool": TOOLS,
        "profile": [{"name": "shaft", "points": [[36, 0], [36, -30], [40, -30]]}],
        "operation": list(operations),
    }
    return turning_job_of(content | more, Path("job.toml"))


def verdict(moves: list[tuple], *operations: dict[str, Any], tool: int = 1) -> TurnedVerdict:
    return judge_turning(moves_of(lathe_path(moves, tool)), setup_of(job(*operations), "p.nc"), "diameter")


def test_the_report_has_profile_and_dimensions() -> None:
    found = verdict(FACING + TURNING, FACE, FINISH)
    assert [one.code for one in found.findings] == []
    report = json.loads(json.dumps(found.report(), allow_nan=False))
    fillet = 0.64 * (1 - np.pi / 4) * 2 * np.pi * 18.18
    assert report["x_is"] == "diameter"
    assert report["profile"][0] == [-80, 40]
    assert report["profile"][-1] == [0, 36]
    assert report["bore_profile"] == []
    assert found.dimension_at(-15) == (pytest.approx(36), 0)
    assert found.dimension_at(0.5) == (0, 0)
    assert report["removed_volume_mm3"] == pytest.approx(np.pi * (400 + 76 * 30) - fillet, rel=1e-4)
    assert (report["gouge_mm"], report["left_over_mm"]) == (0, 0)
    assert report["cut_length_mm"] == pytest.approx(30.8 + 32 + 4)  # whole moves that cut
    assert report["deepest_cut_mm"] == pytest.approx(2.0)


def test_stock_to_leave_and_steps_follow_from_the_last_operation() -> None:
    rough = [("rapid", 2, 19.4), ("feed", -29.5, 19.4), ("feed", -29.5, 22)]
    assert {one.code for one in verdict(rough, ROUGH).findings} == set()
    assert {one.code for one in verdict(rough, ROUGH, FINISH).findings} == {"left-over"}
    along = ROUGH | {"along": "profile"}
    assert {one.code for one in verdict(rough, along).findings} == {"left-over"}  # 0.9 mm on a side, 0.5 mm allowed


def test_what_operations_without_a_profile_cut_is_no_gouge() -> None:
    drilling = [("rapid", 5, 0), ("feed", -20, 0), ("rapid", 5, 0)]
    with_profile = job(DRILL, FINISH)
    setup = setup_of(with_profile, "p.nc")
    drilled = judge_turning(moves_of(lathe_path(drilling, 3)), setup, "diameter")
    assert "gouge" not in {one.code for one in drilled.findings}
    deeper = [("rapid", 5, 0), ("feed", -20.5, 0), ("rapid", 5, 0)]
    assert "gouge" in {one.code for one in judge_turning(moves_of(lathe_path(deeper, 3)), setup, "diameter").findings}


def test_a_parted_piece_is_told_with_its_size() -> None:
    found = verdict([("rapid", -43, 30), ("feed", -43, 0)], PART, tool=2)
    (piece,) = found.report()["pieces"]
    assert (piece["z_min_mm"], piece["z_max_mm"], piece["diameter_mm"]) == pytest.approx((-40, 1, 40))
    assert piece["falls_at_line"] == 2
    assert [(one.code, one.severity) for one in found.findings] == [("parted-off", "info")]


def test_jaws_lie_before_the_chuck() -> None:
    found = verdict([("rapid", 2, 18), ("feed", -66, 18)], FINISH)
    assert "jaws" in {one.code: one.text for one in found.findings}["collision"]


def test_the_picture_shows_stock_part_chuck_and_tool(tmp_path: Path) -> None:
    found = verdict(FACING + TURNING, FACE, FINISH)
    found.draw(tmp_path / "part.png", "shaft", "1 min", row=5)
    picture = np.rint(imread(tmp_path / "part.png")[..., :3] * 255)
    assert picture.shape[1] == 1600
    shares = {
        name: (np.abs(picture - np.array(to_rgb(COLOURS[name])) * 255).max(axis=2) <= 3).mean()
        for name in ("part", "raw", "chuck", "wanted")
    }
    assert shares["part"] > 0.2
    assert min(shares.values()) > 0.0005
    found.draw(tmp_path / "part.svg")
    assert (tmp_path / "part.svg").read_bytes().startswith(b"<?xml")
