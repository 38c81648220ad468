# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a job's program, made by a background process.

    run = ProofRun(job, parent)
    run.part.connect(show_part)     # Part and work zero, while the rest is still to come
    run.finished.connect(show)      # ProofResult
    run.failed.connect(tell)        # CNCStepperError
    run.start()

What is proven is the program text that stands in the document, a job's own, an edited one or a file's; one that is
missing or out of date is refused.
A program that was proven last, from the same start state, is not proven again. With a place in the program its restart
there is proven instead.
"""

from __future__ import annotations

import hashlib
import json
import tempfile
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.control.processes.python_finder import PROOF, command, find_python_in_background
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import api, packages
from CNCStepper.workbench.features.program import job_behind
from CNCStepper.workbench.proving import standby
from CNCStepper.workbench.services import message_translation
from CNCStepper.workbench.services.background_process import Worker
from CNCStepper.workbench.services.translation import later, tr

if TYPE_CHECKING:
    import numpy as np

    from CNCStepper.cycles.turning.turned_coordinates import Placement
    from CNCStepper.job.proof_folder import Part, ProgramAnswer
    from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace
    from CNCStepper.simulation.finding import Finding
    from CNCStepper.simulation.meshes.fallen_faces import FallenFaces
    from CNCStepper.simulation.tip_track import TipTrack
    from CNCStepper.simulation.views.path_lines import Lines
    from CNCStepper.state import Start

LOOK_EVERY_MS = 20
PART_CUT = "part"  # what the process tells when the part can be read
STAGES = {
    "start": later("Looking for a Python…"),
    "make": later("Reading the job…"),
    "read": later("Reading the program back…"),
    "time": later("Timing the moves…"),
    "judge": later("Comparing the cut with the drawing…"),
    "check": later("Checking against the machine…"),
    "cut": later("Cutting the part…"),
    "report": later("Writing the report…"),
}


@dataclass(frozen=True)
class ProvenProgram:
    """The proof of a program; its folder is removed with the last reference to this object.

    program_lines: the text; of a restart its own. findings: the worst first. refused: whether it must not be
    sent. send_file: the certificate. moves: the tip in work coordinates in time. rapids, feeds: as lines.
    report: as `cncstepper run` writes it. work_origin_mm: where the work zero lies in the document. begins: the start
    state that it holds for, None where that is not known. words: what a restart does, the core's sentences.
    """

    program_lines: list[str]
    findings: list[Finding]
    refused: bool
    send_file: Path
    time_s: float
    moves: TipTrack
    rapids: Lines
    feeds: Lines
    report: dict[str, Any]
    work_origin_mm: tuple[float, float, float]
    folder: tempfile.TemporaryDirectory
    begins: Start | None
    words: tuple[str, ...]

    @property
    def end_mm(self) -> np.ndarray:
        """The tip's position after every row, float64[n, 3], work coordinates."""
        return self.moves.end


@dataclass(frozen=True)
class ProofResult(ProvenProgram):
    """The proof of a program for a table, with the part that it leaves.

    part: what is left of the stock. fallen: what it cuts free. tools: the outlines of cutter and shank by number.
    """

    part: Part
    fallen: FallenFaces
    tools: dict[int, tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True)
class TurnedResult(ProvenProgram):
    """The proof of a lathe's program, its moves on the part: X is the radius, Z the part's own.

    rings: of the part in half section, each float64[n, 2] of z and radius. placement: of the program on the part.
    """

    rings: tuple[np.ndarray, ...]
    placement: Placement


class ProofRun(QtCore.QObject):
    """One proof of a job's program; `start` it once, `cancel` it at any time.

    begins: the start state of the machine that it is proven for, None where that is not known. place: where it is to be
    restarted, None for the whole program. part: sent once with
    the Part, as soon as it is cut, and where the work zero lies in the document; not for a proof that is known already.
    """

    part = QtCore.Signal(object, object)
    finished = QtCore.Signal(object)
    failed = QtCore.Signal(object)
    progress = QtCore.Signal(str)

    _last: tuple[str, ProvenProgram] | None = None  # fingerprint of the question, and its answer

    def __init__(
        self,
        job_object: Any,
        parent: Any = None,
        begins: Start | None = None,
        place: RestartPlace | None = None,
    ):
        super().__init__(parent)
        self._job = job_object
        self._begins, self._place = begins, place
        self._folder: tempfile.TemporaryDirectory | None = None
        self._files: Future[Any] | None = None  # what is done to the folder's files
        self._key = ""
        self._awaited: tuple[Future[Any], Callable[[Any], None]] | None = None
        self._process: Worker | None = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK_EVERY_MS)
        self._timer.timeout.connect(self._look)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.cancel)

    @property
    def running(self) -> bool:
        """Whether an answer is still to come."""
        return self._timer.isActive() or self._process is not None

    def start(self) -> None:
        """Begin; `finished` or `failed` follows from the event loop, unless it is cancelled before."""
        try:
            self._files = self._ask()
            self._await(self._files, self._begin)
        except (CNCStepperError, OSError) as error:
            refused: Future[Any] = Future()
            refused.set_exception(error)
            self._await(refused, self._begin)

    def cancel(self) -> None:
        """End the process and remove its folder; no further signals are sent."""
        self._timer.stop()
        self._awaited = None
        process, self._process = self._process, None
        if process is not None:
            process.stop()
        self._drop_folder()

    def _ask(self) -> Future[str]:
        """Read the document, and write the question beside the window: gives its fingerprint."""
        packages.require()
        self._program = api.program_text(self._job)
        asked = job_behind(self._job)
        write_question = asked.Proxy.proof_question(asked, self._job)
        self._origin_mm = asked.Proxy.origin_mm(asked)
        names = (self._job.Label, self._origin_mm)
        self._folder = tempfile.TemporaryDirectory(prefix="cncstepper-", ignore_cleanup_errors=True)
        path = Path(self._folder.name)

        def write() -> str:
            from CNCStepper.job.start_state_file import write_start
            from CNCStepper.recovery.restart.restart_proof_folder import write_place

            write_question(path, self._program)
            write_start(path, self._begins)
            write_place(path, self._place)
            return _fingerprint(path, *names)

        return in_background(write)

    def _begin(self, key: str) -> None:
        """Hand out the answer that is known already, or look for the Python that will find one."""
        self._key = key
        if ProofRun._last and ProofRun._last[0] == key:
            self._drop_folder()
            self.finished.emit(ProofRun._last[1])
            return
        in_background(message_translation.make_ready)  # findings are to be said; read while the process proves
        if (waiting := standby.take(self)) is not None:
            self._ask_process(waiting)
            return
        self.progress.emit(tr(STAGES["start"]))
        self._await(find_python_in_background(PROOF), self._spawn)

    def _await(self, future: Future[Any], then: Callable[[Any], None]) -> None:
        self._awaited = (future, then)
        self._timer.start()

    def _look(self) -> None:
        """Go on as soon as what is awaited is there; what the process tells comes by itself."""
        if self._awaited is None or not self._awaited[0].done():
            return
        self._timer.stop()
        (future, then), self._awaited = self._awaited, None
        try:
            then(future.result())
        except CNCStepperError as error:
            self._fail(error)
        except OSError as error:
            advice = tr("make room in the folder for temporary files")
            self._fail(CNCStepperError("proof-folder", str(error), advice=advice))

    def _spawn(self, python: str) -> None:
        self._ask_process(Worker(command(python, standby.WORKER), self))

    def _ask_process(self, process: Worker) -> None:
        """Hand the question to a process that waits for one."""
        assert self._folder is not None
        self._process = process
        process.told.connect(self._on_message)
        process.ended.connect(self._ended)
        process.write(json.dumps([self._folder.name, self._job.Label]).encode("ascii") + b"\n")

    def _on_message(self) -> None:
        if self._process is None:
            return
        told = [line.decode("ascii", "replace").strip() for line in iter(self._process.line, b"")]
        stages = [word for word in told if word in STAGES]
        if stages:
            self.progress.emit(tr(STAGES[stages[-1]]))
        if PART_CUT in told:
            self._hand_out_part()

    def _hand_out_part(self) -> None:
        from CNCStepper.job.proof_folder import read_part

        assert self._folder is not None
        self.part.emit(read_part(Path(self._folder.name)), self._origin_mm)

    def _ended(self) -> None:
        """Take the answer, or tell why there is none."""
        process, self._process = self._process, None
        if process is None:
            return
        process.deleteLater()
        folder = self._folder
        assert folder is not None
        self._files = in_background(lambda: self._read(folder))
        self._await(self._files, self._answer)

    def _answer(self, result: ProvenProgram) -> None:
        self._folder = self._files = None  # the result keeps the folder
        ProofRun._last = (self._key, result)
        self.finished.emit(result)

    def _read(self, folder: tempfile.TemporaryDirectory) -> ProvenProgram:
        """Read the answer, beside the window; raises the error that was written instead."""
        from CNCStepper.job.proof_folder import read_answer
        from CNCStepper.job.turning.turning_proof_folder import is_turned, read_turned_answer
        from CNCStepper.recovery.restart.restart_proof_folder import read_restart

        path = Path(folder.name)
        if is_turned(path):
            turned = read_turned_answer(path)
            shared = self._shared(turned, folder, None)
            return TurnedResult(**shared, rings=turned.rings, placement=turned.placement)
        answer = read_answer(path)
        shared = self._shared(answer, folder, read_restart(path))
        return ProofResult(**shared, part=answer.part, fallen=answer.fallen, tools=answer.tools)

    def _shared(self, answer: ProgramAnswer, folder: tempfile.TemporaryDirectory, restart: Any) -> dict[str, Any]:
        """Return what every result has, by name."""
        return {
            **answer.shared(),
            "program_lines": (restart.program if restart else self._program).splitlines(),
            "refused": answer.refused,
            "time_s": answer.moves.duration_s,
            "work_origin_mm": self._origin_mm,
            "folder": folder,
            "begins": self._begins,
            "words": restart.words if restart else (),
        }

    def _fail(self, error: CNCStepperError) -> None:
        self._drop_folder()
        self.failed.emit(error)

    def _drop_folder(self) -> None:
        """Take the folder away, as soon as nobody reads or writes there any more."""
        folder, self._folder = self._folder, None
        files, self._files = self._files, None
        if files is not None and folder is not None:
            files.add_done_callback(lambda _: folder.cleanup())


def _fingerprint(folder: Path, *more: Any) -> str:
    """Return what names a question: the bytes of its files, and what else the answer says."""
    digest = hashlib.sha256(repr(more).encode("utf-8"))
    for path in sorted(folder.iterdir()):
        digest.update(path.read_bytes())
    return digest.hexdigest()
