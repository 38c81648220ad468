# SPDX-License-Identifier: LGPL-2.1-or-later
"""A milling job in the state that was proven, and a change of one of its objects that mends a finding."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from CNCStepper.workbench.document.operation_order import active_operations
from CNCStepper.workbench.features.base import entry_of, value_of
from CNCStepper.workbench.panels.unit_values import text_of
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.machine.profile import Machine
    from CNCStepper.workbench.proving.proof_process import ProofResult

NO_BREAK_SPACE = "\u00a0"


@dataclass(frozen=True)
class Change:
    """New values of one object, by key, and what a button says of them in the person's language."""

    obj: Any
    values: dict[str, Any]
    text: str


@dataclass(frozen=True)
class ProvenJob:
    """A job object and the proof of its program, for the rules that look for a remedy."""

    job: Any
    result: ProofResult

    @functools.cached_property
    def operations(self) -> list[Any]:
        """The operations that the program holds, in order."""
        return active_operations(self.job)

    @functools.cached_property
    def tools(self) -> list[Any]:
        """The tools of these operations, each once."""
        return list({operation.Tool.Name: operation.Tool for operation in self.operations}.values())

    @functools.cached_property
    def machine(self) -> Machine:
        """The machine of the job; raises JobError."""
        from CNCStepper.workbench.document.machine_of_job import machine_of

        return machine_of(self.job)

    @functools.cached_property
    def model(self) -> Job:
        """The job as the core's model; raises JobError."""
        from CNCStepper.workbench.document.core_job import proven_with

        return proven_with(self.job)

    def operations_of(self, tool: Any) -> list[Any]:
        """Return the operations that a tool cuts."""
        return [operation for operation in self.operations if operation.Tool is tool]


def value(obj: Any, key: str) -> Any:
    """Return a value of an object, in the unit of its key."""
    return value_of(obj, entry_of(obj.Proxy, key))


def has(obj: Any, key: str) -> bool:
    """Return whether an object has a property of that key."""
    return any(entry.key == key for entry in obj.Proxy.PROPERTIES)


def change_of(obj: Any, key: str, new: Any) -> Change:
    """Return the change of one value, said with the object's name and the label of the value.

    A button may break that text into lines, but not between a number and its unit.
    """
    entry = entry_of(obj.Proxy, key)
    words = words_of(new, key) if isinstance(new, str) else text_of(new, entry).replace(" ", NO_BREAK_SPACE)
    return Change(obj, {key: new}, tr("{0}, {1}: {2}").format(obj.Label, tr(entry.label), words))
