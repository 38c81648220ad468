# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a job's program, made by a process of its own while the window goes on.

    run = ProofRun(job, parent)
    run.part.connect(show_part)     # Part and work zero, while the rest is still to come
    run.finished.connect(show)      # ProofResult
    run.failed.connect(tell)        # CNCStepperError
    run.start()

What is proven is the program text that stands in the document, a job's own or an edited one; one that is missing or out
of date is refused.
A program that was proven last, from the same start state, is not proven again. With a place in the program its restart
there is proven instead.
"""

from __future__ import annotations

import hashlib
import tempfile
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.control.python_finder import PROOF, command, seek_python
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import api, packages
from CNCStepper.workbench.features.program import job_behind
from CNCStepper.workbench.words import later, tr
from CNCStepper.workbench.worker import kill, start_worker

if TYPE_CHECKING:
    import numpy as np

    from CNCStepper.job.proof_files import Part
    from CNCStepper.job.restart_files import RestartPlace
    from CNCStepper.simulation.finding import Finding
    from CNCStepper.simulation.lines import Lines
    from CNCStepper.simulation.tip_track import TipTrack
    from CNCStepper.state import Start

WORKER = "CNCStepper.job.proof_worker"
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
class ProofResult:
    """What is known of a program; its folder goes when the last who holds this object lets go of it.

    program_lines: the text; of a restart its own. findings: in the order of the lines. refused: whether it must not be
    sent. send_file: the certificate. moves: the tip in work coordinates in time. rapids, feeds: as lines.
    part: what is left of the stock. tools: the outlines of cutter and shank by number. report: as `cncstepper run`
    writes it. work_origin_mm: where the work zero lies in the document. begins: the start state that it holds for, None
    where that is not known. words: what a restart does, the core's sentences in its order.
    """

    program_lines: list[str]
    findings: list[Finding]
    refused: bool
    send_file: Path
    time_s: float
    moves: TipTrack
    rapids: Lines
    feeds: Lines
    part: Part
    report: dict[str, Any]
    work_origin_mm: tuple[float, float, float]
    tools: dict[int, tuple[np.ndarray, np.ndarray]]
    folder: tempfile.TemporaryDirectory
    begins: Start | None = None
    words: tuple[str, ...] = ()

    @property
    def end_mm(self) -> np.ndarray:
        """Where the tip stands after every row, float64[n, 3], work coordinates."""
        return self.moves.end


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

    _last: tuple[str, ProofResult] | None = None  # fingerprint of the question, and its answer

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
        self._key = ""
        self._told: tuple[Any, Any] | None = None  # a signal and its value that the next look sends
        self._python: Future[str] | None = None
        self._process: Any = None
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
            self._ask()
        except CNCStepperError as error:
            self._tell_soon(self.failed, error)
        except OSError as error:
            advice = tr("make room in the folder for temporary files")
            self._tell_soon(self.failed, CNCStepperError("proof-folder", str(error), advice=advice))

    def cancel(self) -> None:
        """End the process and take its folder away; nothing is told any more."""
        self._timer.stop()
        process, self._process = self._process, None
        if process is not None:
            kill(process)
        self._drop_folder()

    def _ask(self) -> None:
        packages.require()
        from CNCStepper.job.proof_files import write_question
        from CNCStepper.job.restart_files import write_place
        from CNCStepper.job.start_file import write_start
        from CNCStepper.workbench.making import job_of, machine_of

        self._program = api.program_text(self._job)
        self._folder = tempfile.TemporaryDirectory(prefix="cncstepper-", ignore_cleanup_errors=True)
        path = Path(self._folder.name)
        job = job_behind(self._job)
        write_question(path, self._program, job_of(job), machine_of(job))
        write_start(path, self._begins)
        write_place(path, self._place)
        self._origin_mm = tuple(job.WorkOrigin)
        self._key = _fingerprint(path, self._job.Label, self._origin_mm)
        if ProofRun._last and ProofRun._last[0] == self._key:
            self._drop_folder()
            self._tell_soon(self.finished, ProofRun._last[1])
            return
        self.progress.emit(tr(STAGES["start"]))
        self._python = seek_python(PROOF)
        self._timer.start()

    def _tell_soon(self, signal: Any, value: Any) -> None:
        self._told = (signal, value)
        self._timer.start()

    def _look(self) -> None:
        """Send what waits to be sent, or see whether the Python is found; the process then tells by itself."""
        if self._told:
            self._timer.stop()
            signal, value = self._told
            signal.emit(value)
            return
        if self._python is None or not self._python.done():
            return
        self._timer.stop()
        try:
            self._spawn(self._python.result())
        except CNCStepperError as error:
            self._fail(error)

    def _spawn(self, python: str) -> None:
        assert self._folder is not None
        words = command(python, WORKER, self._folder.name, self._job.Label)
        self._process = start_worker(self, words, self._hear, self._ended, self._not_started)

    def _hear(self) -> None:
        if self._process is None:
            return
        told = bytes(self._process.readAllStandardOutput()).decode("ascii", "replace").split()
        stages = [word for word in told if word in STAGES]
        if stages:
            self.progress.emit(tr(STAGES[stages[-1]]))
        if PART_CUT in told:
            self._hand_out_part()

    def _hand_out_part(self) -> None:
        from CNCStepper.job.proof_files import read_part

        assert self._folder is not None
        self.part.emit(read_part(Path(self._folder.name)), self._origin_mm)

    def _not_started(self, problem: Any) -> None:
        """Tell that the process did not start; every other end of it is told by `_ended`."""
        if problem == QtCore.QProcess.ProcessError.FailedToStart and self._process is not None:
            error = CNCStepperError(
                "proof-start",
                "the process that proves cannot be started",
                value=self._process.errorString(),
                advice="try again",
            )
            self._process = None
            self._fail(error)

    def _ended(self, *_: Any) -> None:
        """Take the answer, or tell why there is none."""
        process, self._process = self._process, None
        if process is None:
            return
        process.deleteLater()
        try:
            result = self._result()
        except CNCStepperError as error:
            self._fail(error)
            return
        ProofRun._last = (self._key, result)
        self.finished.emit(result)

    def _result(self) -> ProofResult:
        from CNCStepper.job.proof_files import read_answer
        from CNCStepper.job.restart_files import read_restart

        folder, self._folder = self._folder, None
        assert folder is not None
        try:
            answer, restart = read_answer(Path(folder.name)), read_restart(Path(folder.name))
        except CNCStepperError:
            folder.cleanup()
            raise
        return ProofResult(
            program_lines=(restart.program if restart else self._program).splitlines(),
            findings=answer.findings,
            refused=answer.refused,
            send_file=answer.send_file,
            time_s=answer.moves.duration_s,
            moves=answer.moves,
            rapids=answer.rapids,
            feeds=answer.feeds,
            part=answer.part,
            report=answer.report,
            work_origin_mm=self._origin_mm,
            tools=answer.tools,
            folder=folder,
            begins=self._begins,
            words=restart.words if restart else (),
        )

    def _fail(self, error: CNCStepperError) -> None:
        self._drop_folder()
        self.failed.emit(error)

    def _drop_folder(self) -> None:
        folder, self._folder = self._folder, None
        if folder is not None:
            folder.cleanup()


def _fingerprint(folder: Path, *more: Any) -> str:
    """Return what names a question: the bytes of its files, and what else the answer says."""
    digest = hashlib.sha256(repr(more).encode("utf-8"))
    for path in sorted(folder.iterdir()):
        digest.update(path.read_bytes())
    return digest.hexdigest()
