# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe's proof in its folder: where the program lies on the part, and where the machine's reports lie there."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from CNCStepper.cycles.turning.turned_coordinates import Placement
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.job.start_state_file import write_start
from CNCStepper.job.turning.make_turning import make_turning, points_in_part
from CNCStepper.job.turning.prove_program import TurnedBar
from CNCStepper.job.turning.turning_job import TurningJob, turning_job_of
from CNCStepper.job.turning.turning_proof_folder import (
    TurnedAnswer,
    read_turned_answer,
    write_file_question,
    write_job_question,
)
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.simulation.tip_follower import TipFollower
from CNCStepper.simulation.tip_track import TipTrack
from CNCStepper.workers.proof import answer as answer_question
from CNCStepper.workers.turned_timeline import Answers
from helpers.controllers.lathe_judge import LatheBench

START_X_MM, START_Z_MM = 5.3, 7.2  # the radius
AUTOMATIC_X_MM, AUTOMATIC_Z_MM = 4.3 + 5.0, 0.1 + 5.0  # clear of the bar, and of its raw end
CONE: dict[str, Any] = {
    "machine": "mini-lathe",
    "process": "turning",
    "x_is": "radius",
    "stock": {"diameter_mm": 8.6, "length_mm": 20.0, "face_mm": 0.1},
    "tool": [{"number": 1, "insert": "CNMG 120408", "shank_mm": 20.0, "feed_mm_rev": 0.1, "spindle_rpm": 1000.0}],
    "profile": [{"name": "cone", "points": [[3.0, 0.0], [4.0, -2.0]]}],
    "operation": [
        {"cycle": "turn_rough", "tool": 1, "profile": "cone", "ap_mm": 0.5, "stock_to_leave_mm": 0.2},
        {"cycle": "turn_finish", "tool": 1, "profile": "cone"},
    ],
}
AWAY_MM = 0.02  # of a step of 0.0125 mm in X and in Z
REPORT_S = 0.2
NEAR_S = 0.05  # of the end: the earliest of several places as near counts


def cone(**more: Any) -> TurningJob:
    return turning_job_of({**CONE, **more}, Path("cone.toml"))


def proven(folder: Path, job: TurningJob, machine: Machine) -> tuple[str, TurnedAnswer]:
    """The job's program and the answer to the request for its proof."""
    program = make_turning(job, machine, "cone")[0].program
    write_job_question(folder, program, job, machine, 1, "cone")
    write_start(folder, None)
    answer_question(folder, "cone")
    return program, read_turned_answer(folder)


def reports(program: str) -> list[tuple[int, int, np.ndarray]]:
    """What a mini-lathe reports that was jogged before its zero was set: file lines done and sent, work position."""
    wire, bench = prepare(program, "mini-lathe"), LatheBench()
    for jog in ("$J=G91X-3F1000", "$J=G91Z2F1000"):
        bench.send(f"{jog}\n", 5.0)
    assert "error" not in bench.send("G10L20P1X0Z0\n") and max(map(abs, bench.board.places_mm)) > 1
    told, waiting, sent = [], list(wire.lines), 0
    while bench.board.state != "Idle" or waiting:
        while waiting and bench.board.program.has_room:
            bench.send(f"{waiting.pop(0)}\n", 0.0)
            sent += 1
        bench.wait(REPORT_S, 0.01)
        status = bench.status()
        machine, zero = (np.array(status[name].split(","), float) for name in ("MPos", "WCO"))
        lines = [0, *wire.file_lines]
        told.append((int(lines[sent - int(status["Queue"])]), int(lines[sent]), machine - zero))
    assert bench.judge.faults == []
    return told


def away_mm(moves: TipTrack, place_mm: np.ndarray) -> float:
    """How far a place is from the nearest move, all of which are straight."""
    way = moves.end - moves.begin
    share = np.einsum("ij,ij->i", place_mm - moves.begin, way) / np.maximum(np.einsum("ij,ij->i", way, way), 1e-12)
    nearest = moves.begin + np.clip(share, 0.0, 1.0)[:, None] * way
    return float(np.linalg.norm(nearest - place_mm, axis=1).min())


@pytest.mark.parametrize("distance", ["absolute", "incremental"])
@pytest.mark.parametrize("start", [None, [START_X_MM, START_Z_MM]], ids=["automatic", "given"])
def test_reports_of_the_mini_lathe_lie_on_the_path_and_the_part_follows_them(
    tmp_path: Path, start: list[float] | None, distance: str
) -> None:
    program, answer = proven(tmp_path, cone(start=start, distance=distance), load_machine("mini-lathe"))
    x_mm, z_mm = start or (AUTOMATIC_X_MM, AUTOMATIC_Z_MM)
    told = reports(program)
    tips_mm = points_in_part(np.array([work_mm for *_, work_mm in told]), answer.placement)
    wanted_mm = [(x_mm + work_mm[0], 0.0, z_mm - work_mm[2]) for *_, work_mm in told]
    assert tips_mm == pytest.approx(np.array(wanted_mm), abs=1e-9)
    assert len(told) > 30 and max(away_mm(answer.moves, tip_mm) for tip_mm in tips_mm) < AWAY_MM
    assert tips_mm[-1] == pytest.approx(answer.moves.end[-1], abs=AWAY_MM)
    follower, timeline = TipFollower(answer.moves), Answers(tmp_path, "cone")._timeline
    times_s = [follower.follow(done, sent, tip) for (done, sent, _), tip in zip(told, tips_mm, strict=True)]
    assert times_s[-1] == pytest.approx(answer.moves.duration_s, abs=NEAR_S)
    volumes = [timeline.at(time_s).section.volume_mm3 for time_s in times_s]
    assert all(after <= before + 1e-6 for before, after in itertools.pairwise(volumes))
    assert volumes[0] > volumes[len(volumes) // 2] > volumes[-1] == timeline.part.section.volume_mm3


def test_a_lathe_whose_programs_count_from_the_end_face_reports_places_of_the_part(tmp_path: Path) -> None:
    machine = load_machine("linuxcnc-lathe")
    _, answer = proven(tmp_path, cone(machine="linuxcnc-lathe", start=[START_X_MM, START_Z_MM]), machine)
    assert answer.placement == Placement()
    assert points_in_part(np.array([[3.0, 0.0, -2.0]]), answer.placement).tolist() == [[3.0, 0.0, -2.0]]


def test_a_file_of_the_mini_lathe_has_its_moves_on_the_part(tmp_path: Path) -> None:
    """Z of the mini-lathe rises towards the chuck, that of the part falls."""
    tool = TurningTool(**CONE["tool"][0])
    text = "N10 G91 # N20 G00 X3. # N30 G01 Z2. F1. # N40 M02 #\n"
    write_file_question(tmp_path, text, TurnedBar(8.6, 20.0), [tool], load_machine("mini-lathe"))
    write_start(tmp_path, None)
    answer_question(tmp_path, "file")
    answer = read_turned_answer(tmp_path)
    assert answer.moves.end[-1].tolist() == [3.0, 0.0, -2.0]
    assert points_in_part(np.array([[3.0, 0.0, 2.0]]), answer.placement).tolist() == [[3.0, 0.0, -2.0]]
