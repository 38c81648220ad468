# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hostile files: whatever a job, a profile, a tool file or a drawing holds, it is taken or refused by name, in time.

`make fuzz` takes 2000 jobs and profiles and 500 of the others (FILES=n takes n and n / 4); CNCSTEPPER_FILE_FUZZ is that
number. The seed of what fails is in the message: `job_case(SEED)` makes it again.
"""

from __future__ import annotations

import os
import signal
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

import pytest

from CNCStepper.drawing.dxf.reader import read_dxf
from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool_files import read_tools, write_tools
from CNCStepper.motion.planner.machine_limits import Limits
from helpers.job.hostile_files import BITS, BYTES, KIND, MEAN, Case, drawing_case, job_case, profile_case, tool_case

FILES = int(os.environ.get("CNCSTEPPER_FILE_FUZZ", "100"))
MOST_S = 60.0  # processor time of one case; the first ones compile kernels
MOST_BYTES = 1_000_000_000  # of memory, by which the peak may rise in all cases together


class TooLongError(BaseException):
    """No Exception, so that nothing takes it for a refusal."""


@contextmanager
def bounded() -> Iterator[None]:
    """End what takes more than MOST_S of processor time, at once where there are such timers."""
    began_s = time.process_time()

    def end(number: int, frame: FrameType | None) -> None:
        raise TooLongError

    timer = hasattr(signal, "setitimer")
    if timer:
        before = signal.signal(signal.SIGPROF, end)
        signal.setitimer(signal.ITIMER_PROF, MOST_S)
    try:
        yield
    finally:
        if timer:
            signal.setitimer(signal.ITIMER_PROF, 0)
            signal.signal(signal.SIGPROF, before)
    assert time.process_time() - began_s < MOST_S


def memory_bytes() -> int:
    """Return the most memory that this process had so far; 0 where the system does not say."""
    try:
        import resource
    except ImportError:
        return 0
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def outcome(path: Path, take: Callable[[Path], str]) -> str:
    """Return what becomes of a file: "taken", "refused" when it is read, or what `take` says of a later refusal."""
    try:
        with bounded():
            return take(path)
    except CNCStepperError as error:
        assert error.code and error.what and error.place and error.place.file, repr(error)
        assert str(error).isprintable() and len(str(error)) < 10_000, repr(error)
        return "refused"


def run(make: Callable[[int], Case], take: Callable[[Path], str], count: int, folder: Path) -> Counter[str]:
    """Return how often each mutation and each outcome occurred; fails with the seed of the first bad case."""
    met: Counter[str] = Counter()
    before_bytes = memory_bytes()
    for seed in range(count):
        case = make(seed)
        path = folder / f"case{case.ending}"
        path.write_bytes(case.content)
        try:
            met[outcome(path, take)] += 1
        except BaseException as error:
            (folder / f"failed-{seed}{case.ending}").write_bytes(case.content)
            name = f"{make.__name__}({seed}) with {', '.join(case.mutations)}"
            pytest.fail(f"{name}: {type(error).__name__}: {str(error)[:500]}")
        met.update(set(case.mutations))
    assert memory_bytes() - before_bytes < MOST_BYTES
    print(f"{make.__name__}: seeds 0 to {count - 1}: {dict(met)}")
    return met


def names(*mutations: Callable[..., object]) -> set[str]:
    return {mutate.__name__ for mutate in mutations}


def take_job(path: Path) -> str:
    """Load a job, make its program and read that back."""
    job, machine = load_job(path)
    try:
        text = make_program(job, machine).program
    except CNCStepperError as error:
        assert error.code and error.place, repr(error)
        return "not made"
    interpret(text, dialect=machine.controller, file="program.nc")
    return "taken"


def take_profile(path: Path) -> str:
    """Load a profile, and take from it what the planner wants."""
    machine = load_machine(path)
    Limits.of(machine)
    return "taken"


def take_tools(path: Path) -> str:
    """Read a tool file and write what it holds as a table."""
    write_tools(read_tools(path), path.with_name("written.tbl"))
    return "taken"


def take_drawing(path: Path) -> str:
    """Read a drawing; whatever it says can be shown."""
    drawing = read_dxf(path, 0.01)
    words = [drawing.damage, *(layer.name for layer in drawing.layers)]
    words += [f"{each.kind}{each.layer}{each.handle}{each.why}" for each in drawing.skipped]
    assert all(word.isprintable() for word in words), words
    return "taken"


def check(met: Counter[str], count: int, wanted: set[str], readable: int) -> None:
    """Fail where too few of the files were readable, or a mutation never occurred."""
    assert readable > count / 2, met
    assert met["refused"] > count / 50, met
    assert not wanted - set(met), sorted(wanted - set(met))


@pytest.mark.slow
def test_a_mutated_job_makes_a_program_that_is_read_or_is_refused(tmp_path: Path) -> None:
    met = run(job_case, take_job, FILES, tmp_path)
    check(met, FILES, names(*KIND, *MEAN, *BYTES), met["taken"] + met["not made"])
    assert met["taken"] > FILES / 3, met


@pytest.mark.slow
def test_a_mutated_profile_is_taken_or_refused(tmp_path: Path) -> None:
    met = run(profile_case, take_profile, FILES, tmp_path)
    check(met, FILES, names(*KIND), met["taken"])


@pytest.mark.slow
def test_a_mutated_tool_file_is_taken_or_refused(tmp_path: Path) -> None:
    for bit in BITS:
        (tmp_path / bit.name).write_bytes(bit.read_bytes())
    met = run(tool_case, take_tools, FILES // 4, tmp_path)
    check(met, FILES // 4, {".fctb", ".fctl", ".tbl"} | names(*KIND), met["taken"])


@pytest.mark.slow
def test_a_mutated_drawing_is_taken_or_refused(tmp_path: Path) -> None:
    met = run(drawing_case, take_drawing, FILES // 4, tmp_path)
    check(met, FILES // 4, {"group_number", "group_text", "group_gone"}, met["taken"])
