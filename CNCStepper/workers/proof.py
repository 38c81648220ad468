# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that proves: `python -m CNCStepper.workers.proof FOLDER NAME`, the folder as in `proof_folder`,
with what `restart_proof_folder` adds where the restart of a program is proven.

It prints the stage that begins, one a line, and `part` once the cut part is in the folder.
When its standard input is closed nobody waits for the answer any more: it takes the folder away and ends. NAME is the
program's in findings. Its exit status is 0 when an answer stands in the folder, else 1: then `error.json` says why.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import sys
import threading
import traceback
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.errors import CNCStepperError, JobError, MissingPackage, Text

if TYPE_CHECKING:
    from CNCStepper.simulation.removal.heightmap import HeightMap


def main(arguments: list[str]) -> int:
    """Prove the program of the folder `arguments[0]`, named `arguments[1]`; return the exit status."""
    folder, name = Path(arguments[0]), arguments[1]
    threading.Thread(target=_end_when_left, args=(folder,), daemon=True).start()
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
    write_turned_answer(folder, proven.proof, proven.verdict, proven.on_part, certificate_of(proven.proof))


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


def _end_when_left(folder: Path) -> None:
    """End this process when nobody holds the other end of standard input any more."""
    with contextlib.suppress(OSError):
        while os.read(0, 1):  # not sys.stdin: its lock would be held when the interpreter ends
            pass
    shutil.rmtree(folder, ignore_errors=True)
    os._exit(1)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
