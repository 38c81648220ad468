# SPDX-License-Identifier: LGPL-2.1-or-later
"""A leg is read from its file into a spool: the job that was proven, and no whole program in memory."""

from __future__ import annotations

import json
import tracemalloc
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest

from CNCStepper.control.program import long_json
from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate, digest_of_lines
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.stream.path_retract import REST, PathRetract
from CNCStepper.errors import CNCStepperError, JobError, Place
from CNCStepper.state import Start

LINES = ("G21G90G94", "G1X-2F1500", "G1Y-2")
PROGRAM = SendJob("/dev/é", (*LINES, "G1X0"), file="peça.nc", baud=9600)


def write_leg(path: Path, lines: Sequence[str], **more: Any) -> Path:
    start = Start.with_work_zero((-10.0, -20.0, -30.0))
    content = {
        "format": FORMAT,
        "version": VERSION,
        "findings": [],
        "wire": {"sha256": digest_of_lines(lines), "dialect": "grbl"},
        "start": {"sha256": start.sha256(), "state": asdict(start) | {"position_mm": [1.0, 2.0, 3.0]}},
        "send": {"lines": list(lines), "expected": {"100": 80.0}},
    }
    leg = {
        "kind": REST,
        "heads": 1,
        "certificate": json.loads(Certificate(content).to_json()),
        "file_lines": [40 + number for number in range(len(lines))],
        "messages": {"1": "turn it"},
    }
    path.write_text(json.dumps(leg | more), encoding="utf-8")
    return path


def test_the_job_is_the_proven_one_at_the_programs_lines(tmp_path: Path) -> None:
    retrace = PathRetract(PROGRAM)
    leg = retrace.read(write_leg(tmp_path / "leg ç.json", LINES), "held")
    job = leg.job
    assert tuple(job.lines) == LINES and job.place(1) == Place("peça.nc", 41) and job.messages == {1: "turn it"}
    assert (job.port, job.baud, job.zero_confirmed, job.expected) == ("/dev/é", 9600, True, {})
    assert job.work_offsets_mm["G54"] == [-10.0, -20.0, -30.0] and job.work_offsets_mm["G92"] == [0.0, 0.0, 0.0]
    assert leg.is_rest and leg.begin_mm == (1.0, 2.0, 3.0)
    retrace.start(leg)
    assert retrace.lines_before == 1


def test_what_is_kept_for_the_next_client_holds_no_lines(tmp_path: Path) -> None:
    kept = PathRetract(PROGRAM).read(write_leg(tmp_path / "leg.json", LINES, parts=[None]), "held").content
    assert set(kept) == {"kind", "heads", "parts", "certificate"} and set(kept["certificate"]) == {"start"}
    assert json.dumps(kept)


def test_the_lines_of_the_leg_under_way_stay_and_those_before_go(tmp_path: Path) -> None:
    retrace, file = PathRetract(PROGRAM), write_leg(tmp_path / "leg.json", LINES)
    refused, under_way = (retrace.read(file, "held") for _ in range(2))
    retrace.start(under_way)
    coming = retrace.read(write_leg(file, LINES[:1]), "held")
    assert tuple(under_way.job.lines) == LINES and tuple(coming.job.lines) == LINES[:1]
    assert [leg.wire.exists() for leg in (refused, under_way, coming)] == [False, True, True]
    folder = coming.wire.parent
    del retrace
    assert not folder.exists()


@pytest.mark.parametrize(
    ("more", "code"),
    [
        ({"certificate": {}}, "certificate"),
        ({"file_lines": [1]}, "line-map"),
        ({"messages": []}, "retreat-file"),
        ({"file_lines": None}, "retreat-file"),
    ],
)
def test_what_is_no_leg_is_refused(tmp_path: Path, more: dict[str, Any], code: str) -> None:
    with pytest.raises(JobError) as refused:
        PathRetract(PROGRAM).read(write_leg(tmp_path / "leg.json", LINES, **more), "held")
    assert refused.value.code == code


def test_a_line_that_holds_the_end_of_one_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CNCStepperError) as refused:
        PathRetract(PROGRAM).read(write_leg(tmp_path / "leg.json", ["G1X1", "G1X2\nM3"]), "held")
    assert refused.value.code == "acting-byte"


def test_memory_does_not_grow_with_the_leg(tmp_path: Path) -> None:
    def most_bytes(count: int) -> int:
        file, retrace = write_leg(tmp_path / f"{count}.json", ["G1X10.123Y20.456"] * count), PathRetract(PROGRAM)
        tracemalloc.start()
        retrace.read(file, "held")
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return most

    with patch.multiple(long_json, BLOCK_BYTES=5000, BLOCK_ITEMS=250):
        few, many = most_bytes(2000), most_bytes(12_000)
    assert many < few + 8 * 10_000  # a list of as many more
