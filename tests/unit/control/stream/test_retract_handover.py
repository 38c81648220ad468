# SPDX-License-Identifier: LGPL-2.1-or-later
"""A leg is read from a copy of its file: the job that was proven, and no whole program in memory."""

from __future__ import annotations

import json
import tracemalloc
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from CNCStepper.control.program.bundle import LINE_MAP, WIRE, array_bytes, head_bytes, line_bytes, write_bundle
from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate, digest_of_lines
from CNCStepper.control.program.program_columns import MESSAGE_MAP, MESSAGES
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.stream.retract_handover import LEG, OWN_MAP, REST, PathRetract, read_held
from CNCStepper.errors import JobError, Place
from CNCStepper.state import Start

LINES = ("G21G90G94", "G1X-2F1500", "G1Y-2")
PROGRAM = SendJob("/dev/é", (*LINES, "G1X0"), file="peça.nc", baud=9600, messages={3: "turn it"})


def write_leg(path: Path, lines: Sequence[str], **more: Any) -> Path:
    start = Start.with_work_zero((-10.0, -20.0, -30.0))
    content = {
        "format": FORMAT,
        "version": VERSION,
        "findings": [],
        "wire": {"sha256": digest_of_lines(lines), "dialect": "grbl"},
        "start": {"sha256": start.sha256(), "state": asdict(start) | {"position_mm": [1.0, 2.0, 3.0]}},
        "send": {"expected": {"100": 80.0}},
    }
    leg = {
        "kind": REST,
        "heads": 1,
        "certificate": Certificate(content, lines).head(),
    }
    messages: dict[str, Any] = {MESSAGES: [b'"turn it"\n'], MESSAGE_MAP: array_bytes(more.pop("told_at", [1]))}
    numbers = more.pop("file_lines", [40 + number for number in range(len(lines))])
    members = {LEG: head_bytes(leg | more), WIRE: line_bytes(lines), OWN_MAP: array_bytes([])} | messages
    with path.open("wb") as file:
        write_bundle(file, members | ({} if numbers is None else {LINE_MAP: array_bytes(numbers)}))
    return path


def test_the_job_is_the_proven_one_at_the_programs_lines(tmp_path: Path) -> None:
    retrace = PathRetract(PROGRAM)
    leg = retrace.read(write_leg(tmp_path / "leg ç.zip", LINES), "held")
    job = leg.job
    assert tuple(job.lines) == LINES and job.place(1) == Place("peça.nc", 41) and job.messages == {1: "turn it"}
    assert (job.port, job.baud, job.zero_confirmed, job.expected) == ("/dev/é", 9600, True, {})
    assert job.work_offsets_mm["G54"] == [-10.0, -20.0, -30.0] and job.work_offsets_mm["G92"] == [0.0, 0.0, 0.0]
    assert leg.is_rest and leg.begin_mm == (1.0, 2.0, 3.0)
    retrace.start(leg)
    assert retrace.lines_before == 1


def test_what_is_kept_for_the_next_client_holds_no_lines(tmp_path: Path) -> None:
    kept = PathRetract(PROGRAM).read(write_leg(tmp_path / "leg.zip", LINES, parts=[None]), "held").content
    assert set(kept) == {"kind", "heads", "parts", "certificate"} and set(kept["certificate"]) == {"start"}
    assert json.dumps(kept)


def test_the_lines_of_the_leg_under_way_stay_and_those_before_go(tmp_path: Path) -> None:
    retrace, file = PathRetract(PROGRAM), write_leg(tmp_path / "leg.zip", LINES)
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
        ({"told_at": []}, "retreat-file"),
        ({"told_at": [-1]}, "retreat-file"),
        ({"certificate": 3}, "certificate"),
    ],
)
def test_what_is_no_leg_is_refused(tmp_path: Path, more: dict[str, Any], code: str) -> None:
    with pytest.raises(JobError) as refused:
        PathRetract(PROGRAM).read(write_leg(tmp_path / "leg.zip", LINES, **more), "held")
    assert refused.value.code == code


@pytest.mark.parametrize("data", [b"", b"{}", b"PK\3\4", b"\0" * 1000])
def test_a_file_that_is_no_bundle_is_refused(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "leg.zip").write_bytes(data)
    with pytest.raises(JobError) as refused:
        PathRetract(PROGRAM).read(tmp_path / "leg.zip", "held")
    assert refused.value.code == "retreat-file"


def test_what_is_told_is_read_back(tmp_path: Path) -> None:
    driver = SimpleNamespace(settings={100: 80.0}, mpos_mm=(1.0, 2.0, 3.0))
    PathRetract(PROGRAM).tell(driver, "held", tmp_path / "held.zip", jogged=False)
    told = read_held(tmp_path / "held.zip")
    assert told["program"]["lines"] == list(PROGRAM.lines) and told["leg_lines"] == [] and told["leg"] is None
    assert told["program"]["messages"] == PROGRAM.messages != {}
    assert told["position_mm"] == [1.0, 2.0, 3.0] and told["steps_per_mm"] == [80.0, None, None]
    with pytest.raises(JobError, match="cannot be written"):
        PathRetract(PROGRAM).tell(driver, "held", tmp_path / "nowhere" / "held.zip", jogged=False)


@pytest.mark.slow
def test_memory_does_not_grow_with_the_leg(tmp_path: Path) -> None:
    def most_bytes(count: int) -> int:
        file, retrace = write_leg(tmp_path / f"{count}.zip", ["G1X10.123Y20.456"] * count), PathRetract(PROGRAM)
        tracemalloc.start()
        retrace.read(file, "held")
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return most

    most_bytes(100)  # imports
    few, many = most_bytes(200_000), most_bytes(400_000)
    assert many < few + 8 * 50_000  # a list of a quarter as many more
