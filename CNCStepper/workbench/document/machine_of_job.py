# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine of a job object, and the values of its tools that are outside the range for its material."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

from CNCStepper.errors import Text
from CNCStepper.job.deferred_fitting import once
from CNCStepper.machine.feeds_and_speeds import remarks_on
from CNCStepper.machine.files.profile_files import own_path
from CNCStepper.machine.materials import material
from CNCStepper.machine.processes import MILLING
from CNCStepper.machine.profile import Machine, load_machine, profile_names
from CNCStepper.machine.tools.tool import Tool


def machine_of(obj: Any) -> Machine:
    """Return the machine of a job object; its profile is looked for in the document's folder, its dialect set."""
    return once("machine", obj, lambda: _machine_named(obj))


def _machine_named(obj: Any) -> Machine:
    return machine_named(obj.Machine, obj)


def machine_named(name: str, obj: Any) -> Machine:
    """Return the machine of a name as a job object would have it; raises JobError where there is none."""
    name = profile_of(name, obj)
    return _machine(name, obj.Dialect, file_stamp(str(own_path(name) or name)))


def profile_of(name: str, obj: Any) -> str:
    """Return a profile's name as it is, or its file from the folder of a job object's document."""
    is_file = name not in profile_names() and obj.Document.FileName
    return str(Path(obj.Document.FileName).parent / name) if is_file else name


@functools.lru_cache(maxsize=16)
def _machine(name: str, dialect: str, stamp: tuple[int, ...]) -> Machine:
    machine = load_machine(name)
    return machine.model_copy(update={"controller": dialect}) if dialect else machine


def file_stamp(name: str) -> tuple[int, ...]:
    """Return what changes with the content of a file, () where there is none."""
    try:
        found = Path(name).stat()
    except (OSError, ValueError):
        return ()
    return found.st_mtime_ns, found.st_ctime_ns, found.st_size, found.st_ino


def remarks(tool: Tool, job: Any) -> tuple[str, ...]:
    """Return what of a tool's feeds and speed is out of the range of the job's material, as sentences."""
    is_milled = job.Material and job.Process == MILLING.name
    found = remarks_on(tool, material(job.Material), machine_of(job)) if is_milled else ()
    return tuple(
        Text("{remark}; {advice}", remark=remark.text, advice=remark.advice)
        for remark in found
        if remark.severity == "warning"
    )
