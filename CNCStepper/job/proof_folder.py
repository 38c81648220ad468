# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder with request and answer of a proof, between a window and the process that proves.

    job.json  machine.json  program.nc  dialect.txt    the request; the machine is that of machine.json
    part.npz                                  the cut stock, as soon as it is known: a first picture
    result.json  moves.npz  lines.npz  fallen.npz  tools.npz  send.zip     the answer; or error.json
    tiles.bin  part.stl                       what `simulation_timeline` answers afterwards

send.zip is the program's certificate. Reading an answer takes numpy only, so that a window does it at once.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper import text_json
from CNCStepper.control.session.status import error_from_json, error_to_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.simulation.finding import Finding, refused
from CNCStepper.simulation.meshes.fallen_faces import FallenFaces
from CNCStepper.simulation.tip_track import TipTrack
from CNCStepper.simulation.views.path_lines import Lines

if TYPE_CHECKING:
    from CNCStepper.control.program.certificate import Certificate
    from CNCStepper.job.model import Job
    from CNCStepper.job.prove import Proof
    from CNCStepper.machine.profile import Machine
    from CNCStepper.simulation.removal.heightmap import HeightMap
    from CNCStepper.toolpath import Toolpath

PROGRAM, JOB, MACHINE, DIALECT = "program.nc", "job.json", "machine.json", "dialect.txt"
RESULT, MOVES, LINES = "result.json", "moves.npz", "lines.npz"
PART, TOOLS, FALLEN = "part.npz", "tools.npz", "fallen.npz"
SEND, ERROR = "send.zip", "error.json"
TILES, MESH = "tiles.bin", "part.stl"
LINE_COLUMNS = ("rapid_points", "rapid_counts", "feed_points", "feed_counts")
MOST_POINTS = 60_000  # of the rapids, and of the feeds, that a 3D view is given to draw


@dataclass(frozen=True)
class Part:
    """The stock after the program, in work coordinates; z = 0 is the stock's top.

    heights_mm: float64[rows, columns], rows along y. x_mm, y_mm: the centres of the cells. low_mm, high_mm: the
    corners of the stock. corners, rgba: its faces, as `coloured_faces.DrawnFaces`.
    """

    heights_mm: np.ndarray
    x_mm: np.ndarray
    y_mm: np.ndarray
    low_mm: np.ndarray
    high_mm: np.ndarray
    corners: np.ndarray
    rgba: np.ndarray


@dataclass(frozen=True)
class ProgramAnswer:
    """What every proof answered: report as in `Proof`, the moves in time and as lines, the certificate."""

    findings: list[Finding]
    report: dict[str, Any]
    moves: TipTrack
    rapids: Lines
    feeds: Lines
    send_file: Path

    @property
    def refused(self) -> bool:
        """Whether a finding forbids sending the program."""
        return refused(self.findings)

    def shared(self) -> dict[str, Any]:
        """Return what every answer has, by name."""
        return {each.name: getattr(self, each.name) for each in fields(ProgramAnswer)}


@dataclass(frozen=True)
class Answer(ProgramAnswer):
    """The answer about a part that lies on a table, and what is left of it.

    tools: the outlines of cutter and shank by number, as `tool_outline.outlines_mm`. fallen: what it cuts free.
    """

    part: Part
    fallen: FallenFaces
    tools: dict[int, tuple[np.ndarray, np.ndarray]]


def write_question(folder: Path, program: str, job: Job, machine: Machine, dialect: str = "") -> None:
    """Write the request; dialect: in which the program is read, "" for the machine's own."""
    from CNCStepper.job.model import save_job

    write_program(folder, program, machine, dialect)
    save_job(job, folder / JOB)


def write_program(folder: Path, program: str, machine: Machine, dialect: str = "") -> None:
    """Write what every request holds."""
    (folder / PROGRAM).write_bytes(program.encode("utf-8"))
    (folder / MACHINE).write_text(machine.model_dump_json(), encoding="utf-8")
    (folder / DIALECT).write_text(dialect, encoding="utf-8")


def read_question(folder: Path) -> tuple[str, Job, Machine]:
    """Return program, job and machine; raises JobError for files that `write_question` has not written so."""
    from CNCStepper.job.model import read_job

    program, machine = read_program(folder)
    return program, read_job(folder / JOB), machine


def read_program(folder: Path) -> tuple[str, Machine]:
    """Return program and machine of a request; raises JobError for files that were not written so."""
    from CNCStepper.machine.profile import Machine, validated

    content = json.loads((folder / MACHINE).read_text("utf-8"))
    text = (folder / PROGRAM).read_bytes().decode("utf-8")
    return text, validated(Machine, content, str(folder / MACHINE))


def read_dialect(folder: Path) -> str:
    """Return the dialect in which the program is read, "" for the machine's own."""
    return (folder / DIALECT).read_text("utf-8")


def proven_file(folder: Path) -> str:
    """Return the path of the proven program's file; subroutines are looked for in its folder."""
    return str(json.loads((folder / RESULT).read_text("utf-8"))["program"])


def write_part(folder: Path, part: HeightMap) -> None:
    """Write the cut stock; the file appears when it is complete."""
    from CNCStepper.simulation.meshes.mesh_faces import faces_of
    from CNCStepper.simulation.views.coloured_faces import drawn, height_range_mm

    faces = drawn(faces_of(part), height_range_mm(part))
    unfinished = folder / f"unfinished-{PART}"
    np.savez(
        unfinished,
        heights_mm=part.heights_mm,
        x_mm=part.x_mm,
        y_mm=part.y_mm,
        low_mm=np.array(part.stock.low_mm),
        high_mm=np.array(part.stock.high_mm),
        corners=faces.corners,
        rgba=faces.rgba,
    )
    unfinished.replace(folder / PART)


def write_answer(folder: Path, proof: Proof, job: Job, certificate: Certificate) -> None:
    """Write the answer except for the part; the result comes last and marks it complete."""
    from CNCStepper.simulation.meshes.fallen_faces import fallen_faces
    from CNCStepper.simulation.meshes.tool_outline import outlines_mm

    stock = job.stock.stock()
    fallen_faces(proof.pieces, stock.top_mm).save(folder / FALLEN)
    height_mm = stock.size_mm[2]
    outlines = {str(tool.number): outlines_mm(tool, height_mm) for tool in job.tool}
    named: dict[str, Any] = {f"{number}-{place}": both[place] for number, both in outlines.items() for place in (0, 1)}
    np.savez(folder / TOOLS, **named)
    write_program_answer(folder, proof.toolpath, proof, certificate)


def write_program_answer(folder: Path, moves: Toolpath, proof: Proof, certificate: Certificate) -> None:
    """Write what every answer holds; the result comes last. moves: the program's, as a view is to show them."""
    from CNCStepper.simulation.views.path_lines import lines_in_space

    TipTrack.of(moves, proof.times_s).save(folder / MOVES)
    rapids, feeds = lines_in_space(moves, MOST_POINTS)
    columns = (rapids.points, rapids.counts, feeds.points, feeds.counts)
    named: dict[str, Any] = dict(zip(LINE_COLUMNS, columns, strict=True))
    np.savez(folder / LINES, **named)
    certificate.write(folder / SEND)
    (folder / RESULT).write_text(text_json.dumps(proof.report, allow_nan=False), encoding="utf-8")


def write_error(folder: Path, error: CNCStepperError) -> None:
    """Write why there is no answer."""
    (folder / ERROR).write_text(json.dumps(error_to_json(error)), encoding="utf-8")


def read_part(folder: Path) -> Part:
    """Return the cut stock, once it is written."""
    with np.load(folder / PART, allow_pickle=False) as arrays:
        return Part(**arrays)


def read_answer(folder: Path) -> Answer:
    """Return the answer about a part on a table; raises what `read_program_answer` raises."""
    common = read_program_answer(folder)
    with np.load(folder / TOOLS, allow_pickle=False) as arrays:
        numbers = sorted({int(name.partition("-")[0]) for name in arrays})
        tools = {number: (arrays[f"{number}-0"], arrays[f"{number}-1"]) for number in numbers}
    fallen = FallenFaces.load(folder / FALLEN)
    return Answer(**common.shared(), part=read_part(folder), fallen=fallen, tools=tools)


def read_program_answer(folder: Path) -> ProgramAnswer:
    """Return what every answer holds; raises the error that was written instead, or CNCStepperError for neither."""
    if (folder / ERROR).exists():
        raise error_from_json(json.loads((folder / ERROR).read_text("utf-8")))
    if not (folder / RESULT).exists():
        raise CNCStepperError(
            "proof-lost",
            "the process that proves the program ended without an answer",
            advice="try again; if it stays so, the program may need more memory than there is",
        )
    report = text_json.loads((folder / RESULT).read_text("utf-8"))
    with np.load(folder / LINES, allow_pickle=False) as arrays:
        columns = [arrays[name] for name in LINE_COLUMNS]
    findings = [Finding.from_dict(content) for content in report["findings"]]
    moves = TipTrack.load(folder / MOVES)
    return ProgramAnswer(findings, report, moves, Lines(*columns[:2]), Lines(*columns[2:]), folder / SEND)
