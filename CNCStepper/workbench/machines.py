# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine that a job object names, and the stock that it says lies on it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.machine.profile import Machine, load_machine, profile_names


def machine_of(obj: Any) -> Machine:
    """Return the machine of a job object; a profile's file is looked for beside the document, its dialect set."""
    name = obj.Machine
    if name not in profile_names() and obj.Document.FileName:
        name = str(Path(obj.Document.FileName).parent / name)
    machine = load_machine(name)
    return machine.model_copy(update={"controller": obj.Dialect}) if obj.Dialect else machine
