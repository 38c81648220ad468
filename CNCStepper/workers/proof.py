# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that proves one program: `python -m CNCStepper.workers.proof`.

It loads what a proof needs, prints `ready`, and waits for one line on standard input, in JSON: [FOLDER, NAME]. Where
the line is there already it loads nothing beforehand. FOLDER is as in `proof_folder`, with what `restart_proof_folder`
adds where the restart of a program is proven; NAME is the program's in findings. It prints the stage that begins, one
a line, and `part` once the cut part is in the folder. Its exit status is 0 when an answer stands in the folder, else
1: then `error.json` says why. When standard input is closed nobody waits any more: it takes the folder away and ends.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import shutil
import sys
import tempfile
import threading
import traceback
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError, JobError, MissingPackage, Text

if TYPE_CHECKING:
    from CNCStepper.simulation.removal.heightmap import HeightMap


WARM_UP_JOB = Path(__file__).with_name("kernel_warm_up.toml")
ASKED_WITHIN_S = 0.05  # of the start, by whoever has a question already
Asked = SimpleQueue[tuple[Path, str]]


def main() -> int:
    """Wait for a question, prove its program, and return the exit status."""
    asked: Asked = SimpleQueue()
    threading.Thread(target=_listen, args=(asked,), daemon=True).start()
    folder, name = _question(asked)
    try:
        answer(folder, name)
    except CNCStepperError as error:
        _refuse(folder, error)
        return 1
    except ImportError as error:
        advice = "install it for the Python that proves (python -m pip install NAME)"
        _refuse(folder, MissingPackage("package-missing", f"{sys.executable}: {error}", advice=advice))
        return 1
    except Exception as error:  # a fault of ours still has to reach the person who waits
        traceback.print_exc()
        what = Text("the proof failed by a fault of its own: {kind}: {error}", kind=type(error).__name__, error=error)
        _refuse(folder, CNCStepperError("proof-fault", what, advice="please report it, with the program"))
        return 1
    return 0


def _question(asked: Asked) -> tuple[Path, str]:
    """Return the question, and load what a proof needs while there is none."""
    try:
        return asked.get(timeout=ASKED_WITHIN_S)
    except Empty:
        _warm_up()
        _tell("ready")
        return asked.get()


def answer(folder: Path, name: str) -> None:
    """Read the question, prove, and write the answer; raises what the core raises."""
    from CNCStepper.job.turning.turning_proof_folder import is_turned

    (_answer_turned if is_turned(folder) else _answer_job)(folder, name)


def _answer_turned(folder: Path, name: str) -> None:
    from CNCStepper.job.make_certificate import certificate_of
    from CNCStepper.job.proof_folder import read_program
    from CNCStepper.job.start_state_file import read_start
    from CNCStepper.job.turning.turning_proof_folder import prove_question, write_turned_answer
    from CNCStepper.recovery.restart.restart_proof_folder import read_place

    if read_place(folder) is not None:
        what, advice = "the program of a lathe cannot be restarted in its middle", "turn the part from its beginning"
        raise JobError("restart-turning", what, advice=advice)
    _tell("read")
    program, machine = read_program(folder)
    proven = prove_question(folder, program, machine, name, read_start(folder))
    _tell("report")
    write_turned_answer(folder, proven, certificate_of(proven.proof))


def _answer_job(folder: Path, name: str) -> None:
    from CNCStepper.job.make_certificate import certificate_of
    from CNCStepper.job.proof_folder import read_dialect, read_question, write_answer, write_part
    from CNCStepper.job.prove import prior_proofs, prove_job
    from CNCStepper.job.start_state_file import read_start
    from CNCStepper.recovery.restart.prove_restart import EntryOptions, certificate_of_restart, restart_job
    from CNCStepper.recovery.restart.restart_proof_folder import read_place, write_restart

    program, job, machine = read_question(folder)
    start, place = read_start(folder), read_place(folder)

    def see(part: HeightMap) -> None:
        write_part(folder, part)
        _tell("part")

    earlier = prior_proofs(job, machine, program, name, start)
    more: dict[str, Any] = {"file": name, "start": start, "tell": _tell, "see": see, "earlier": earlier}
    more["dialect"] = read_dialect(folder)
    if place is None:
        proof = prove_job(job, machine, program, **more)
        certificate = certificate_of(proof)
    else:
        entering = EntryOptions(place.overlap_mm, place.height_mm)
        restarted = restart_job(job, machine, program, place.where, entering, **more)
        proof, certificate = restarted.proof, certificate_of_restart(restarted)
        write_restart(folder, restarted.restart)
    write_answer(folder, proof, job, certificate)


def _tell(stage: str) -> None:
    print(stage, flush=True)


def _refuse(folder: Path, error: CNCStepperError) -> None:
    from CNCStepper.job.proof_folder import write_error

    write_error(folder, error)


def _warm_up() -> None:
    """Prove a small job and read a text by kernels, so that all are loaded when the question comes.

    A fault is printed only: the proof that is asked for meets it again and answers with it.
    """
    try:
        with tempfile.TemporaryDirectory(prefix="cncstepper-") as name, contextlib.redirect_stdout(io.StringIO()):
            _write_small_question(Path(name))
            answer(Path(name), "")
            _read_by_kernels()
    except Exception:
        traceback.print_exc()


def _read_by_kernels() -> None:
    """Load the kernels that read and write long texts, where there are any."""
    from CNCStepper.gcode.interpreter.fast_path.policy import PAYS_WITH_LOADING, pays

    if pays(PAYS_WITH_LOADING):
        from CNCStepper.workers.kernel_warm_up import read_all_ways

        read_all_ways()


def _write_small_question(folder: Path) -> None:
    from CNCStepper.job.make import make_program
    from CNCStepper.job.model import load_job
    from CNCStepper.job.proof_folder import write_question

    job, machine = load_job(WARM_UP_JOB)
    small = job.model_copy(update={"operation": job.operation[:1]})
    write_question(folder, make_program(small, machine).program, small, machine)


def _listen(asked: Asked) -> None:
    """Hand on the question; end this process when nobody holds the other end of standard input any more."""
    folder: Path | None = None
    with open(0, "rb", closefd=False) as lines:  # not sys.stdin: its lock would be held when the interpreter ends
        for line in lines:
            path, name = json.loads(line)
            folder = Path(path)
            asked.put((folder, name))
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)
    os._exit(1)


if __name__ == "__main__":
    sys.exit(main())
