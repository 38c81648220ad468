# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job object of Windows: a process in it, with all that it starts, gets a limit of memory, and ends with it.

    CreateJobObjectW ──► SetInformationJobObject: limits ──► AssignProcessToJobObject ──► CloseHandle ends what is left

Source: Microsoft's reference of job objects, JOBOBJECT_EXTENDED_LIMIT_INFORMATION.
"""

from __future__ import annotations

import ctypes
from typing import Any

EXTENDED_LIMITS = 9  # JobObjectExtendedLimitInformation
LIMIT_PROCESS_MEMORY, LIMIT_JOB_MEMORY, KILL_ON_CLOSE = 0x100, 0x200, 0x2000


class _BasicLimits(ctypes.Structure):
    _fields_ = (
        ("PerProcessUserTimeLimit", ctypes.c_int64),
        ("PerJobUserTimeLimit", ctypes.c_int64),
        ("LimitFlags", ctypes.c_uint32),
        ("MinimumWorkingSetSize", ctypes.c_size_t),
        ("MaximumWorkingSetSize", ctypes.c_size_t),
        ("ActiveProcessLimit", ctypes.c_uint32),
        ("Affinity", ctypes.c_size_t),
        ("PriorityClass", ctypes.c_uint32),
        ("SchedulingClass", ctypes.c_uint32),
    )


class _Counters(ctypes.Structure):
    _fields_ = tuple((name, ctypes.c_uint64) for name in ("Reads", "Writes", "Others", "Read", "Written", "Other"))


class ExtendedLimits(ctypes.Structure):
    """JOBOBJECT_EXTENDED_LIMIT_INFORMATION."""

    _fields_ = (
        ("Basic", _BasicLimits),
        ("Io", _Counters),
        ("ProcessMemoryLimit", ctypes.c_size_t),
        ("JobMemoryLimit", ctypes.c_size_t),
        ("PeakProcessMemoryUsed", ctypes.c_size_t),
        ("PeakJobMemoryUsed", ctypes.c_size_t),
    )


class JobObject:
    """Limits the memory of a process by its handle until `with` ends; raises OSError where Windows refuses it."""

    def __init__(self, process_handle: int, memory_bytes: int, kernel: Any = None):
        self._kernel = _kernel32() if kernel is None else kernel
        self._job = self._kernel.CreateJobObjectW(None, None)
        if not self._job:
            raise _refused("CreateJobObjectW")
        limits = ExtendedLimits()
        limits.Basic.LimitFlags = LIMIT_PROCESS_MEMORY | LIMIT_JOB_MEMORY | KILL_ON_CLOSE
        limits.ProcessMemoryLimit = limits.JobMemoryLimit = memory_bytes
        set_limits = self._kernel.SetInformationJobObject
        if not set_limits(self._job, EXTENDED_LIMITS, ctypes.byref(limits), ctypes.sizeof(limits)):
            self._give_up("SetInformationJobObject")
        if not self._kernel.AssignProcessToJobObject(self._job, process_handle):
            self._give_up("AssignProcessToJobObject")

    def __enter__(self) -> JobObject:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End every process that is left in it."""
        if self._job:
            self._kernel.CloseHandle(self._job)
            self._job = None

    def _give_up(self, call: str) -> None:
        error = _refused(call)
        self.close()
        raise error


def _kernel32() -> Any:
    """Return kernel32 with the types that keep a handle whole on 64 bits."""
    from ctypes import wintypes

    kernel = ctypes.WinDLL("kernel32", use_last_error=True)  # type: ignore[attr-defined]
    kernel.CreateJobObjectW.restype = wintypes.HANDLE
    kernel.CreateJobObjectW.argtypes = (ctypes.c_void_p, wintypes.LPCWSTR)
    kernel.SetInformationJobObject.argtypes = (wintypes.HANDLE, ctypes.c_int, ctypes.c_void_p, wintypes.DWORD)
    kernel.AssignProcessToJobObject.argtypes = (wintypes.HANDLE, wintypes.HANDLE)
    kernel.CloseHandle.argtypes = (wintypes.HANDLE,)
    return kernel


def _refused(call: str) -> OSError:
    number = getattr(ctypes, "get_last_error", int)()  # Windows alone has one
    return OSError(number, f"{call} is refused")
