# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads a solid: the Python of CadQuery or FreeCAD's own, with limits of time, memory and output.

    Python with OCP (CadQuery)   drawing/solids/occ_edges.py          STEP, BREP, scripts
    freecadcmd                   workbench/drawings/solid_edges.py    STEP, BREP, FCStd

The process limits itself (`drawing/solids/process_limits.py`), on Windows a job object does. Here it is ended, with all
that it has started, when it takes longer, takes more memory where the system limits none, or writes more than an answer
may have.
"""

from __future__ import annotations

import contextlib
import functools
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import CNCStepper
from CNCStepper.cancellation import checkpoint
from CNCStepper.control.processes.python_finder import environment
from CNCStepper.drawing.read_drawing import SCRIPT
from CNCStepper.drawing.solids.process_limits import ANSWER, MEMORY_BYTES
from CNCStepper.errors import JobError, MissingPackage, Place, Text, joined
from CNCStepper.job.drawings.windows_job_object import JobObject
from CNCStepper.safe_text import printable

CADQUERY_VARIABLE = "CNCSTEPPER_CADQUERY"  # a Python that has CadQuery; "none": do not use one
FREECAD_VARIABLE = "CNCSTEPPER_FREECADCMD"  # FreeCAD's command; "none": do not use it
NONE = "none"
DOCUMENT = ".fcstd"
FREECAD_NAMES = ("freecadcmd", "FreeCADCmd", "freecad.cmd")
QUESTION = "CNCSTEPPER_SOLID"
LIMIT_S = 60.0
CHECK_LIMIT_S = 30.0
LOOK_EVERY_S = 0.05
MOST_OUTPUT_BYTES = 200_000_000
MOST_WORDS = 400
FOLDER = Path(CNCStepper.__file__).absolute().parent
WITH_OCP = FOLDER / "drawing" / "solids" / "occ_edges.py"
WITH_FREECAD = FOLDER / "workbench" / "drawings" / "solid_edges.py"


@dataclass(frozen=True)
class Engine:
    """A program that reads solids, and whether it is FreeCAD."""

    program: str
    is_freecad: bool

    def starts(self, question: tuple[str, str, str]) -> tuple[list[str], dict[str, str]]:
        """Return the words that start it and its variables; question: file, height, tolerance."""
        variables = {**environment(), "PYTHONDONTWRITEBYTECODE": "1", "QT_QPA_PLATFORM": "offscreen"}
        if self.is_freecad:
            words = [self.program, str(WITH_FREECAD), "-P", str(FOLDER.parent)]  # FreeCAD 1 does not read PYTHONPATH
            return words, {**os.environ, **_own(variables), QUESTION: json.dumps(question)}
        return [self.program, "-P", "-B", "-X", "utf8", str(WITH_OCP), *question], variables


def _own(variables: dict[str, str]) -> dict[str, str]:
    return {name: variables[name] for name in ("PYTHONPATH", "PYTHONDONTWRITEBYTECODE", "QT_QPA_PLATFORM")}


@functools.cache
def cadquery_python(asked: str) -> str:
    """Return a Python that can import OCP, which CadQuery and build123d bring, or "" where there is none.

    asked: the only one to try; "": this Python, and where that is FreeCAD none.
    """
    program = asked or (sys.executable if Path(sys.executable or "").stem.lower().startswith("python") else "")
    if asked == NONE or not program:
        return ""
    check = "import importlib.util, sys; sys.exit(importlib.util.find_spec('OCP') is None)"
    try:
        found = subprocess.run([program, "-c", check], capture_output=True, timeout=CHECK_LIMIT_S, check=False)
    except (OSError, ValueError, subprocess.TimeoutExpired):
        return ""
    return program if found.returncode == 0 else ""


def engines(suffix: str) -> Iterator[Engine]:
    """Yield the programs on this machine that read a file of a suffix, the first choice first."""
    if suffix != DOCUMENT and (python := cadquery_python(os.environ.get(CADQUERY_VARIABLE, ""))):
        yield Engine(python, is_freecad=False)
    if suffix != SCRIPT and (command := _freecad_command()):
        yield Engine(command, is_freecad=True)


def _freecad_command() -> str:
    asked = os.environ.get(FREECAD_VARIABLE, "")
    if asked == NONE:
        return ""
    return shutil.which(asked) or "" if asked else next(filter(None, map(shutil.which, FREECAD_NAMES)), "")


def read_solid(path: Path, height: str, tolerance_mm: float, limit_s: float = LIMIT_S) -> dict[str, Any]:
    """Return what the process found in a file at a height in mm, or as "outline"; see `edge_curves.py`.

    Raises MissingPackage where no program reads such files, JobError for a refusal and for a limit that was reached.
    """
    suffix = path.suffix.casefold()
    engine = next(engines(suffix), None)
    if engine is None:
        raise _missing(suffix, Place(str(path)))
    started = engine.starts((str(path.absolute()), height, repr(tolerance_mm)))
    output, status = _Run(*started, Place(str(path))).output(limit_s)
    found = [line[len(ANSWER) :] for line in output.splitlines() if line.startswith(ANSWER.encode("ascii"))]
    if not found:
        raise _ended(status, suffix, Place(str(path)))
    answer: dict[str, Any] = json.loads(found[-1])
    if "refused" in answer:
        code, why = map(str, answer["refused"])
        what = Text("the solid cannot be read: {why}", why=printable(why, MOST_WORDS))
        raise JobError(code, what, advice=_remedy(suffix), place=Place(str(path)))
    return answer


class _Run:
    """One process from its start to its end, in a folder of its own."""

    def __init__(self, words: list[str], variables: dict[str, str], place: Place):
        self._words, self._variables, self._place = words, variables, place
        self._output = bytearray()
        self._too_much = threading.Event()

    def output(self, limit_s: float) -> tuple[bytes, int]:
        """Return what it wrote to standard output, and its exit status; it has ended then."""
        with tempfile.TemporaryDirectory(prefix="cncstepper-solid-", ignore_cleanup_errors=True) as folder:
            process = subprocess.Popen(
                self._words,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env={**self._variables, "FREECAD_USER_HOME": folder},
                cwd=folder,
                start_new_session=True,
            )
            assert process.stdout is not None
            with process.stdout as stream, _limited_memory(process):
                reader = threading.Thread(target=self._read, args=(stream,), daemon=True)
                reader.start()
                try:
                    self._wait(process, limit_s)
                finally:
                    _end(process)
                    reader.join(CHECK_LIMIT_S)
            return bytes(self._output), process.returncode

    def _read(self, stream: IO[bytes]) -> None:
        while piece := os.read(stream.fileno(), 1 << 16):
            if len(self._output) + len(piece) > MOST_OUTPUT_BYTES:
                self._too_much.set()
                return
            self._output += piece

    def _wait(self, process: subprocess.Popen[bytes], limit_s: float) -> None:
        end_s = time.monotonic() + limit_s
        while process.poll() is None:
            checkpoint()
            if time.monotonic() > end_s:
                raise self._limited("solid-time", "reading the solid takes too long", f"{limit_s:g} s")
            if self._too_much.is_set():
                most = f"{MOST_OUTPUT_BYTES / 1e6:g} MB"
                raise self._limited("solid-large", "the solid has too many edges or triangles", most)
            if memory_bytes(process.pid) > MEMORY_BYTES:
                raise self._limited("solid-memory", "reading the solid takes too much memory", _gigabytes(MEMORY_BYTES))
            time.sleep(LOOK_EVERY_S)

    def _limited(self, code: str, what: str, limit: str) -> JobError:
        return JobError(
            code, what, limit=limit, advice="simplify the solid, or end the script's loop", place=self._place
        )


@contextlib.contextmanager
def _limited_memory(process: subprocess.Popen[bytes]) -> Iterator[None]:
    """Limit the memory of a process on Windows, where it cannot limit itself; `_Run._wait` looks at it too."""
    if sys.platform != "win32":
        yield
        return
    with JobObject(int(process._handle), MEMORY_BYTES):  # type: ignore[attr-defined,unused-ignore]
        yield


def memory_bytes(pid: int) -> int:
    """Return the memory that a process occupies; 0 where the system does not tell."""
    try:
        if sys.platform == "linux":
            pages = int(Path(f"/proc/{pid}/statm").read_text("ascii").split()[1])
            return pages * os.sysconf("SC_PAGE_SIZE")
        if sys.platform == "win32":
            listed = ["tasklist", "/FI", f"PID eq {pid}", "/FO", "CSV", "/NH"]
            row = subprocess.run(listed, capture_output=True, timeout=CHECK_LIMIT_S, check=False).stdout
            digits = bytes(byte for byte in row.rpartition(b',"')[2] if byte in b"0123456789")
            return int(digits or 0) * 1000
        asked = subprocess.run(["ps", "-o", "rss=", "-p", str(pid)], capture_output=True, timeout=CHECK_LIMIT_S)
        return int(asked.stdout or 0) * 1024
    except (OSError, ValueError, IndexError, subprocess.TimeoutExpired):  # it has ended meanwhile
        return 0


def _end(process: subprocess.Popen[bytes]) -> None:
    """End a process and all that it has started."""
    if os.name == "posix":
        with contextlib.suppress(ProcessLookupError, PermissionError):  # it has ended
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()


def _gigabytes(count: int) -> str:
    return f"{count / 1e9:g} GB"


def _remedy(suffix: str) -> str:
    """Return what a person does about a file that gives no solid."""
    return "correct the script" if suffix == SCRIPT else "correct the file, or export it as STEP"


def _ended(status: int, suffix: str, place: Place) -> JobError:
    """Return why a process gave no answer: which limit of the system ended it, or that it failed."""
    limits = {"SIGXFSZ": "it writes a file", "SIGXCPU": "it takes too long"}
    by_signal = {-int(getattr(signal, name)): why for name, why in limits.items() if hasattr(signal, name)}
    why = by_signal.get(status)
    if why is None:
        what = Text("the program that reads the solid ended without an answer (status {status})", status=status)
        return JobError("solid-ended", what, advice=_remedy(suffix), place=place)
    what = Text("the solid cannot be read: {why}", why=why)
    return JobError("solid-script", what, advice=_remedy(suffix), place=place)


def _missing(suffix: str, place: Place) -> MissingPackage:
    programs = {SCRIPT: "CadQuery or build123d", DOCUMENT: "FreeCAD"}.get(suffix, "CadQuery or FreeCAD")
    cadquery = Text("set {cadquery} to a Python that has CadQuery", cadquery=CADQUERY_VARIABLE)
    freecad = Text("set {freecad} to FreeCAD's command", freecad=FREECAD_VARIABLE)
    return MissingPackage(
        "solid-program",
        Text("reading '{suffix}' files needs {programs}, which is not installed", suffix=suffix, programs=programs),
        advice={SCRIPT: cadquery, DOCUMENT: freecad}.get(suffix, joined("; ", (cadquery, freecad))),
        place=place,
    )
