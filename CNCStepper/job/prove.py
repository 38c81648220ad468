# SPDX-License-Identifier: LGPL-2.1-or-later
"""Program text to proof: read back from the wire text, timed, judged, checked, reported and drawn.

Nothing here uses the cycles' moves; only the shapes that they want removed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from functools import reduce
from itertools import groupby, islice, takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar, Unpack

import numpy as np

from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.cycles.cycle import Answer, Removal
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.gcode.wire.wire_text import WireText
from CNCStepper.job.findings import findings_of
from CNCStepper.job.make import Part, is_split, make_parts, make_program
from CNCStepper.job.model import Job
from CNCStepper.job.planned_times import milestones
from CNCStepper.job.proof_inputs import Given
from CNCStepper.job.wire_round_trip import wire_round_trip
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import MILLING, Process
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.motion.interpolation.dda_stream import times_and_whole_s
from CNCStepper.motion.planner.plan import begun
from CNCStepper.simulation.check_context import CheckContext, Cutting
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.checks.clamps import Clamp
from CNCStepper.simulation.checks.program_report import report
from CNCStepper.simulation.exact.swept_area import Judgement, judge
from CNCStepper.simulation.finding import Finding, refused, worst_first
from CNCStepper.simulation.first_lines import FirstLines
from CNCStepper.simulation.prior_programs import followed
from CNCStepper.simulation.removal.heightmap import HeightMap, height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath, require_straight_axes

if TYPE_CHECKING:
    from shapely.geometry.base import BaseGeometry

    from CNCStepper.job.prove_file import FileProof
    from CNCStepper.simulation.exact.free_pieces import FreePiece, SheetVerdict
    from CNCStepper.simulation.removal.timeline import TimelinePosition
    from CNCStepper.simulation.views.scene import Scene

STAGES = ("read", "cut", "make", "time", "judge", "check", "report")  # arguments of `tell`, in this order
Tell = Callable[[str], None]
Share = Callable[[float], None]
See = Callable[[HeightMap], None]
AnyProof = TypeVar("AnyProof", "Proof", "FileProof")
Wanted = Callable[[], tuple[Sequence[Answer], Sequence[Removal]]]


class ProofOptions(TypedDict, total=False):
    """What every proof takes, whatever is proven; `prove` has the meanings and the defaults."""

    dialect: str
    tell: Tell
    share: Share
    see: See


@dataclass(frozen=True)
class Proof:
    """What is known of a program text on a machine.

    wire: what would be sent. toolpath: where the tool goes, naming the file's lines. motors: the same rows as the
    motors go them, which differ where play is taken up for a controller that does not. times_s: end of every row.
    part: the stock after the program, or None without stock and tools. report: plain data for JSON.
    given: what it was proven against. pieces: what it cuts free of a sheet, in order.
    """

    wire: WireText
    toolpath: Toolpath
    motors: Toolpath
    times_s: np.ndarray
    findings: list[Finding]
    part: HeightMap | None
    report: dict[str, Any]
    given: Given
    pieces: Sequence[FreePiece] = ()

    @property
    def refused(self) -> bool:
        """Whether a finding forbids sending it."""
        return refused(self.findings)

    @property
    def program_sha256(self) -> str:
        """The fingerprint of the program's text."""
        return digest_of_text(self.given.text)

    @property
    def start(self) -> Start:
        """The start state of the table."""
        return self.toolpath.start

    @property
    def plan(self) -> list[list[float]]:
        """The planned times that a sender is given, as `milestones` has them."""
        return milestones(self.toolpath.table().line, self.times_s)

    @property
    def cell_mm(self) -> tuple[float, float] | None:
        """The sides of a cell of the cut part; None without stock and tools."""
        return None if self.part is None else self.part.cell_mm

    def scene(self, moment: TimelinePosition | None = None, part: HeightMap | None = None) -> Scene:
        """Return the contents of a picture of the program's end, or of a time and the part at that time.

        Raises JobError for a program that was proven without stock and tools.
        """
        from CNCStepper.simulation.views.scene import scene_at

        part = part or self.part
        if part is None or self.given.tools is None:
            raise JobError("picture", "there is no part to draw", advice="give the stock and the tools")
        return scene_at(self.toolpath, self.times_s, part, self.given.tools, moment, self.given.machine, self.pieces)

    def draw(self, path: Path, title: str, tools: str) -> None:
        """Draw the cut part and the tool's paths as PNG or SVG; `tools` names the cutters for people."""
        from CNCStepper.simulation.views.proof_picture import facts_of, save_picture

        scene = self.scene()
        save_picture(path, scene, title, facts_of(scene, tools, self.report["time_s"]))


@dataclass(frozen=True)
class PriorPrograms:
    """What has cut the stock already: the moves, with the fingerprint of each program's text, in their order."""

    toolpath: Toolpath
    sha256: tuple[str, ...]

    @classmethod
    def of(cls, proofs: Sequence[Proof]) -> PriorPrograms | None:
        """Return what programs have cut that were proven one after the other; None for no program."""
        if not proofs:
            return None
        toolpath = reduce(followed, (proof.toolpath for proof in proofs))
        return cls(toolpath, tuple(digest_of_text(proof.given.text) for proof in proofs))


@dataclass(frozen=True)
class CutProgram:
    """A program text read back, and what it cuts.

    language: in which it was read. wire, motors, toolpath, part: as in `Proof`. moves: the tool's after those that have
    cut the stock before.
    """

    language: str
    wire: WireText
    motors: Toolpath
    toolpath: Toolpath
    moves: Toolpath
    part: HeightMap | None


def cut_program(
    text: str,
    machine: Machine,
    *,
    file: str = "",
    dialect: str = "",
    start: Start | None = None,
    stock: Stock | None = None,
    tools: dict[int, Tool] | Tool | None = None,
    before: PriorPrograms | None = None,
    tell: Tell = lambda stage: None,
    share: Share = lambda share: None,
    see: See = lambda part: None,
) -> CutProgram:
    """Read a program text back and cut its part: the first half of `prove`, which has the meanings."""
    language = machine.language(dialect)
    tell("read")
    wire, motors, toolpath = wire_round_trip(text, machine, language, file, start, share)
    require_straight_axes(motors, file)
    tell("cut")
    moves = followed(before.toolpath, toolpath) if before else toolpath
    return CutProgram(language, wire, motors, toolpath, moves, _part(moves, tools, stock, see))


def prove(
    text: str,
    machine: Machine,
    *,
    file: str = "",
    dialect: str = "",
    start: Start | None = None,
    stock: Stock | None = None,
    tools: dict[int, Tool] | Tool | None = None,
    removals: Sequence[Removal] = (),
    keep_out: Sequence[Clamp] = (),
    edge_mm: float | None = None,
    before: PriorPrograms | None = None,
    process: Process = MILLING,
    cut_data: CutData | None = None,
    parts: Sequence[BaseGeometry] = (),
    tell: Tell = lambda stage: None,
    share: Share = lambda share: None,
    see: See = lambda part: None,
    cut: CutProgram | None = None,
) -> Proof:
    """Return the proof of a program text; raises ProgramError for a text that cannot be read.

    start: None is a machine whose position and zero are unknown (its times begin at the work zero). removals: the
    shapes wanted, in work coordinates, by which gouge and left-over are judged. keep_out: the clamps. edge_mm: how far
    from the sheet's edge cuts must stay. before: the programs that have cut this stock; `removals` hold theirs too.
    process, cut_data, parts: how it cuts, the row of the cut chart, and the shapely polygons that are to be left whole.
    tell: called with the stage that begins, one of STAGES. share: called with the share of reading and timing, 0 to 1.
    see: called with the part once it is cut, before judging. cut: the text read and its part cut, where that is done.
    """
    if cut is None:
        options: dict[str, Any] = {"tell": tell, "share": share, "see": see, "before": before}
        cut = cut_program(text, machine, file=file, dialect=dialect, start=start, stock=stock, tools=tools, **options)
    toolpath, moves = cut.toolpath, cut.moves
    tell("time")
    ends_s, whole_s = times_and_whole_s(begun(cut.motors), machine, share)
    tell("judge")
    judgement = judge(moves, tools, list(removals), stock) if tools is not None and removals else None
    tell("check")
    prior = before.sha256 if before else ()
    known = (stock, tools, removals, keep_out, edge_mm, prior, process, cut_data, parts)
    given = Given(text, cut.language, machine, *known)
    sheet = _sheet(given, moves, ends_s)
    findings = _checked(given, toolpath, cut.motors, moves, judgement, sheet, file)
    tell("report")
    facts: dict[str, Any] = {"judgement": judgement, "part": cut.part, "tools": tools}
    free = sheet.told() if sheet else []
    told = report(toolpath, ends_s, whole_s=whole_s, file=file, findings=findings, pieces=free, **facts)
    pieces = _own_pieces(sheet, toolpath, moves)
    return Proof(cut.wire, toolpath, cut.motors, ends_s, findings, cut.part, told, given, pieces)


def _own_pieces(sheet: SheetVerdict | None, toolpath: Toolpath, moves: Toolpath) -> list[FreePiece]:
    """Return what comes free by the rows of the program itself; `moves` are those after the programs before it."""
    return [replace(one, row=one.row + len(toolpath) - len(moves)) for one in (sheet.free if sheet else [])]


def _sheet(given: Given, moves: Toolpath, ends_s: np.ndarray) -> SheetVerdict | None:
    """Return the pieces that the moves cut free of a sheet; ends_s: end of the last move. None for no pieces."""
    cutting = Cutting(given.process, given.cut_data, given.parts)
    if given.tools is None or not cutting.is_through_sheet:
        return None
    from CNCStepper.simulation.exact.free_pieces import sheet_verdict

    known_s = np.concatenate([np.full(len(moves) - len(ends_s), np.nan), ends_s])
    return sheet_verdict(CheckContext.of(moves, given.machine, ""), cutting, given.tools, given.stock, known_s)


def _checked(
    given: Given,
    toolpath: Toolpath,
    motors: Toolpath,
    moves: Toolpath,
    judgement: Judgement | None,
    sheet: SheetVerdict | None,
    file: str,
) -> list[Finding]:
    """Return what all checks find in a toolpath; `moves` are its own after those that have cut the stock before."""
    return check(
        toolpath,
        given.machine,
        file=file,
        stock=given.stock,
        tools=given.tools,
        judgement=judgement,
        keep_out=given.keep_out,
        edge_mm=given.edge_mm,
        cut=moves,
        motors=motors,
        process=given.process,
        cut_data=given.cut_data,
        parts=given.parts,
        sheet=sheet,
    )


def _part(moves: Toolpath, tools: dict[int, Tool] | Tool | None, stock: Stock | None, see: See) -> HeightMap | None:
    """Return the part that the moves cut, shown at once; None where tools or stock are not known."""
    if stock is None or tools is None:
        return None
    part = height_map(moves, tools, stock)
    see(part)
    return part


def prove_job(
    job: Job,
    machine: Machine,
    text: str,
    file: str = "",
    start: Start | None = None,
    *,
    earlier: Sequence[Proof] = (),
    answers: Sequence[Answer] | None = None,
    **options: Unpack[ProofOptions],
) -> Proof:
    """Return the proof of a job's program text, as `prove` does, against the shapes that the job wants removed.

    earlier: the proofs of the programs that the job was split into and that are run before this one, in their order.
    answers: those of the program's own operations, where they were just cut; else they are cut again.
    """

    def wanted() -> tuple[Sequence[Answer], Sequence[Removal]]:
        own = answers_of(job, machine, len(earlier)) if answers is None else answers
        return own, removals_of(own, earlier)

    proof = prove_operations(
        job,
        machine,
        text,
        wanted,
        first=operations_before(job, len(earlier)),
        before=PriorPrograms.of(earlier),
        file=file,
        start=start,
        **options,
    )
    return with_findings(proof, list(_refused(earlier, file)))


def removals_of(answers: Sequence[Answer], earlier: Sequence[Proof]) -> list[Removal]:
    """Return the shapes that operations want removed, with those of the programs before them."""
    own = [removal for answer in answers for removal in answer.removals]
    return own + (list(earlier[-1].given.removals) if earlier else [])


def cut_inputs_of(job: Job, machine: Machine, start: Start | None) -> dict[str, Any]:
    """Return the keyword arguments of `cut_program` that a job gives."""
    return {
        "start": job.started(start, machine),
        "stock": job.stock.stock(),
        "tools": tools_of(job.on(machine)),
    }


def inputs_of(job: Job, machine: Machine, answers: Sequence[Answer], start: Start | None) -> dict[str, Any]:
    """Return the keyword arguments of `prove` and `prove_file` that a job gives."""
    return cut_inputs_of(job, machine, start) | {
        "process": job.cutting,
        "cut_data": job.on(machine).cut_data,
        "parts": [part for answer in answers for part in answer.parts],
        "keep_out": job.clamps,
        "edge_mm": job.stock.edge_mm,
    }


def prove_operations(
    job: Job,
    machine: Machine,
    text: str,
    wanted: Wanted,
    *,
    first: int,
    before: PriorPrograms | None,
    file: str = "",
    start: Start | None = None,
    **options: Unpack[ProofOptions],
) -> Proof:
    """Return the proof of a text that runs some of a job's operations, on the stock that others may have cut before.

    wanted: asked once the part is cut, so that a person sees it sooner: the answers of the operations that it runs, of
    which `first` of the job's come before, and what those before and these want removed together.
    """
    cut = cut_program(text, machine, file=file, before=before, **cut_inputs_of(job, machine, start), **options)
    if tell := options.get("tell"):
        tell("make")
    answers, removals = wanted()
    inputs = inputs_of(job, machine, answers, start)
    proof = prove(text, machine, file=file, removals=removals, before=before, cut=cut, **inputs, **options)
    lines, spans = FirstLines.of(proof.toolpath), proof.toolpath.spans
    own = list(findings_of(job, machine, lines, spans, answers, file, first))
    return with_findings(with_answers(proof, answers), own)


def tools_of(job: Job) -> dict[int, Tool] | Tool:
    """Return a job's tools by number; the one jet or wire of a job is its tool whatever T says, or where none is."""
    tools = list(job.tools.values())
    return tools[0] if job.cutting.cuts_through and len(tools) == 1 else job.tools


def operations_before(job: Job, parts: int) -> int:
    """Return how many operations the first parts hold into which a job is split."""
    stretches = groupby(operation.tool for operation in job.operation)
    return sum(len(list(stretch)) for _, stretch in islice(stretches, parts))


def with_answers(proof: AnyProof, answers: Sequence[Answer]) -> AnyProof:
    """Return a proof whose report has the answers of its job's cycles."""
    told = [
        operation | {"figures": answer.figures, "rest_corners": [asdict(corner) for corner in answer.corners]}
        for operation, answer in zip(proof.report["operations"], answers, strict=False)
    ]
    return replace(proof, report=proof.report | {"operations": told})


def with_findings(proof: AnyProof, more: Sequence[Finding]) -> AnyProof:
    """Return a proof with further findings, in its report too."""
    findings = worst_first([*proof.findings, *more])
    counts = {f"{kind}s": sum(one.severity == kind for one in findings) for kind in ("error", "warning")}
    told = {"findings": [finding.as_dict() for finding in findings]}
    return replace(proof, findings=findings, report=proof.report | counts | told)


def _refused(earlier: Sequence[Proof], file: str) -> Iterator[Finding]:
    """Yield that a program before this one is refused: what it leaves of the stock is not known."""
    for proof in earlier:
        if proof.refused:
            text = Text(
                "{program}, which is to be run before it, is refused",
                program=proof.report["program"] or "the program before it",
            )
            yield Finding("error", "earlier-refused", Place(file, 1, 1), text, "correct that one first")


def prove_parts(
    job: Job, machine: Machine, parts: Sequence[Part], folder: Path, start: Start | None = None
) -> Iterator[Proof]:
    """Yield the proof of each of a job's programs, the later ones against the stock that the earlier ones have cut.

    folder: where their files stand; findings name them.
    """
    proofs: list[Proof] = []
    for part in parts:
        file = str(folder / part.file_name)
        proof = prove_job(job, machine, part.program, file, start, earlier=tuple(proofs), answers=part.answers)
        proofs.append(proof)
        yield proof


def prior_proofs(
    job: Job, machine: Machine, program: str, title: str = "", start: Start | None = None
) -> tuple[Proof, ...]:
    """Return the proofs of the programs that are run before `program`, one of those that a job is split into.

    title: with which they were made. None for a job that is not split. Raises JobError for a text that is none of them:
    which stock it would cut is not known.
    """
    if not is_split(job, machine):
        return ()
    parts = make_parts(job, machine, title)
    before = list(takewhile(lambda part: part.program != program, parts))
    if len(before) == len(parts):
        what = "the program is none of the job's parts"
        raise JobError("not-a-part", what, limit=f"{len(parts)} parts", advice="make the program again")
    return tuple(prove_parts(job, machine, before, Path(), start))


def answers_of(job: Job, machine: Machine, number: int) -> list[Answer]:
    """Return the answers of the operations of the job's program, of part `number` (from 0) of a split one."""
    if is_split(job, machine):
        return make_parts(job, machine)[number].answers
    return make_program(job, machine).answers
