# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job object that limits memory on Windows, on a kernel32 that writes down what it is asked."""

from __future__ import annotations

import ctypes
from typing import Any

import pytest

from CNCStepper.job.drawings.windows_job_object import (
    EXTENDED_LIMITS,
    KILL_ON_CLOSE,
    LIMIT_JOB_MEMORY,
    LIMIT_PROCESS_MEMORY,
    ExtendedLimits,
    JobObject,
)

JOB, PROCESS, LIMIT_BYTES = 0x1234_5678_9ABC, 77, 4_000_000_000


class Kernel32:
    """Takes the calls of a JobObject; one of them may be refused."""

    def __init__(self, refused: str = ""):
        self.refused = refused
        self.calls: list[tuple[Any, ...]] = []

    def CreateJobObjectW(self, *arguments: object) -> int:
        """Return the handle of a job."""
        self.calls.append(("create", *arguments))
        return 0 if self.refused == "create" else JOB

    def SetInformationJobObject(self, job: int, kind: int, limits: Any, size: int) -> bool:
        """Note the limits."""
        told = ctypes.cast(limits, ctypes.POINTER(ExtendedLimits)).contents
        assert size == ctypes.sizeof(ExtendedLimits)
        self.calls.append(("limits", job, kind, told.Basic.LimitFlags, told.ProcessMemoryLimit, told.JobMemoryLimit))
        return self.refused != "limits"

    def AssignProcessToJobObject(self, job: int, process: int) -> bool:
        """Note the process."""
        self.calls.append(("assign", job, process))
        return self.refused != "assign"

    def CloseHandle(self, job: int) -> bool:
        """Note that the job is closed."""
        self.calls.append(("close", job))
        return True


def test_a_process_is_put_into_a_job_of_so_much_memory_which_ends_with_it() -> None:
    kernel = Kernel32()
    with JobObject(PROCESS, LIMIT_BYTES, kernel):
        assert kernel.calls[-1] == ("assign", JOB, PROCESS)
    flags = LIMIT_PROCESS_MEMORY | LIMIT_JOB_MEMORY | KILL_ON_CLOSE
    assert kernel.calls == [
        ("create", None, None),
        ("limits", JOB, EXTENDED_LIMITS, flags, LIMIT_BYTES, LIMIT_BYTES),
        ("assign", JOB, PROCESS),
        ("close", JOB),
    ]


@pytest.mark.parametrize("call", ["create", "limits", "assign"])
def test_a_refused_job_is_closed_and_raised(call: str) -> None:
    kernel = Kernel32(refused=call)
    with pytest.raises(OSError, match="JobObject"):
        JobObject(PROCESS, LIMIT_BYTES, kernel)
    assert (("close", JOB) in kernel.calls) == (call != "create")


def test_the_structure_is_as_large_as_that_of_windows_on_64_bits() -> None:
    assert ctypes.sizeof(ExtendedLimits) == 144
