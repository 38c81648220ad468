# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of `job/proof_folder.py` where the program of a lathe is proven.

    turning.json  machine.json  program.nc            the request; turning.json is the job as plain data
    result.json  moves.npz  lines.npz  send.zip       the answer, or error.json
    faces.bin  faces.json                             the part as it is drawn, the finished one at first

A drawn part is groups of strips of triangles. Their names: "raw" and "cut-N" (the surface that tool N has cut),
"section", "chuck", "jaws", "tailstock", "tool-N", "holder-N". Reading takes numpy only.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper import text_json
from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.proof_folder import ERROR, LINE_COLUMNS, LINES, MACHINE, MOVES, PROGRAM, RESULT, SEND
from CNCStepper.simulation.finding import Finding, refused
from CNCStepper.simulation.tip_track import TipTrack
from CNCStepper.simulation.views.path_lines import Lines

if TYPE_CHECKING:
    from CNCStepper.control.program.certificate import Certificate
    from CNCStepper.job.turning.prove_turning import TurnedProof
    from CNCStepper.job.turning.turning_job import TurningJob
    from CNCStepper.machine.profile import Machine
    from CNCStepper.simulation.meshes.revolved_section import Strips
    from CNCStepper.simulation.turning.swept_outline import Moves

JOB, FACES, GROUPS = "turning.json", "faces.bin", "faces.json"
Groups = dict[str, tuple[np.ndarray, np.ndarray, np.ndarray]]  # points, normals, counts of strips by name


@dataclass(frozen=True)
class TurnedAnswer:
    """What a proof answered. operations_s: when each operation ends."""

    findings: list[Finding]
    report: dict[str, Any]
    moves: TipTrack
    rapids: Lines
    feeds: Lines
    groups: Groups
    operations_s: list[float]
    send_file: Path

    @property
    def refused(self) -> bool:
        """Whether a finding forbids sending the program."""
        return refused(self.findings)


def write_turned_question(folder: Path, program: str, job: TurningJob, machine: Machine) -> None:
    """Write the request."""
    (folder / PROGRAM).write_bytes(program.encode("utf-8"))
    (folder / MACHINE).write_text(machine.model_dump_json(), encoding="utf-8")
    (folder / JOB).write_text(json.dumps(job.model_dump(mode="json", exclude_none=True)), encoding="utf-8")


def is_turned(folder: Path) -> bool:
    """Return whether the request is that of a lathe."""
    return (folder / JOB).exists()


def read_turned_question(folder: Path) -> tuple[str, TurningJob, Machine]:
    """Return program, job and machine; raises JobError for files that were written otherwise."""
    from CNCStepper.job.turning.turning_job import turning_job_of
    from CNCStepper.machine.profile import Machine, validated

    content, machine = (json.loads((folder / name).read_text("utf-8")) for name in (JOB, MACHINE))
    text = (folder / PROGRAM).read_bytes().decode("utf-8")
    return text, turning_job_of(content, folder / JOB), validated(Machine, machine, str(folder / MACHINE))


def write_turned_answer(
    folder: Path, proven: TurnedProof, track: TipTrack, groups: dict[str, Strips], certificate: Certificate
) -> None:
    """Write the answer; the result comes last and marks it complete."""
    track.save(folder / MOVES)
    moves = proven.verdict.part.moves
    own = moves[moves.row >= proven.first_row]
    columns = [array for lines in (_lines(own[own.rapid]), _lines(own[~own.rapid])) for array in lines]
    named: dict[str, Any] = dict(zip(LINE_COLUMNS, columns, strict=True))
    np.savez(folder / LINES, **named)
    (folder / GROUPS).write_text(json.dumps(write_groups(folder, groups)), encoding="ascii")
    certificate.write(folder / SEND)
    spans = [span for span in proven.proof.toolpath.spans if span.kind == "operation"]
    ends_s = [float(proven.proof.times_s[span.last - 1]) for span in spans if span.last > span.first]
    report = {**proven.proof.report, "operation_ends_s": ends_s}
    (folder / RESULT).write_text(text_json.dumps(report, allow_nan=False), encoding="utf-8")


def _lines(moves: Moves) -> tuple[np.ndarray, np.ndarray]:
    """Return moves as lines of two points in the plane of X and Z: points float32[2n, 3], counts int32[n]."""
    ends = np.stack([moves.begin, moves.end], axis=1).reshape(-1, 2)
    points = np.column_stack([ends[:, 1], np.zeros(len(ends)), ends[:, 0]])
    return points.astype(np.float32), np.full(len(moves), 2, np.int32)


def write_groups(folder: Path, groups: dict[str, Strips]) -> list[list[Any]]:
    """Write what is drawn; return name, points and strips of each group, as `read_groups` takes them."""
    with (folder / FACES).open("wb") as file:
        for strips in groups.values():
            for array in (strips.points, strips.normals, strips.counts):
                file.write(np.ascontiguousarray(array).tobytes())
    return [[name, len(strips.points), len(strips.counts)] for name, strips in groups.items()]


def read_groups(folder: Path, sizes: list[list[Any]]) -> Groups:
    """Return what is drawn, of groups of these names and sizes."""
    return dict(_read((folder / FACES).read_bytes(), sizes))


def _read(data: bytes, sizes: list[list[Any]]) -> Iterator[tuple[str, tuple[np.ndarray, np.ndarray, np.ndarray]]]:
    place = 0
    for name, points, strips in sizes:
        arrays = []
        for kind, count in ((np.float32, 3 * points), (np.float32, 3 * points), (np.int32, strips)):
            arrays.append(np.frombuffer(data, kind, count, place))
            place += arrays[-1].nbytes
        yield name, (arrays[0].reshape(-1, 3), arrays[1].reshape(-1, 3), arrays[2])


def read_turned_answer(folder: Path) -> TurnedAnswer:
    """Return the answer; raises the error that was written instead, or CNCStepperError when there is neither."""
    if (folder / ERROR).exists():
        raise error_from_json(json.loads((folder / ERROR).read_text("utf-8")))
    if not (folder / RESULT).exists():
        raise CNCStepperError(
            "proof-lost", "the process that proves the program ended without an answer", advice="try again"
        )
    report = text_json.loads((folder / RESULT).read_text("utf-8"))
    with np.load(folder / LINES, allow_pickle=False) as arrays:
        columns = [arrays[name] for name in LINE_COLUMNS]
    return TurnedAnswer(
        [Finding.from_dict(content) for content in report["findings"]],
        report,
        TipTrack.load(folder / MOVES),
        Lines(*columns[:2]),
        Lines(*columns[2:]),
        read_groups(folder, json.loads((folder / GROUPS).read_text("ascii"))),
        report["operation_ends_s"],
        folder / SEND,
    )
