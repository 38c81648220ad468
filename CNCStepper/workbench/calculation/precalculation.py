# SPDX-License-Identifier: LGPL-2.1-or-later
"""Requests to the cut process for changed objects, before anything in the document changes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, field
from typing import Any

from CNCStepper.errors import CNCStepperError, JobError
from CNCStepper.job import request_digest
from CNCStepper.job.deferred_fitting import Unfitted, on_trial, only_looking
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.calculation.cut_process import Parts, process
from CNCStepper.workbench.document.operation_order import active_operations
from CNCStepper.workbench.features.base import FAILED, edit, entry_of, is_job, named, proxy_type


@dataclass
class Look:
    """unknown: what is still to be asked. refusals: why objects cannot be made, by their names."""

    unknown: Parts = field(default_factory=dict)
    refusals: dict[str, CNCStepperError] = field(default_factory=dict)


def look_at(
    document: Any,
    obj: Any = None,
    changes: dict[str, Any] | None = None,
    while_tried: Callable[[], None] = lambda: None,
) -> Look:
    """Return the cost of making the changed objects of a document and their dependents.

    obj, changes: an object, and new values by key that it would have; the document is left as it was. while_tried:
    called while it has them.
    """
    changed = {obj.Name} if obj is not None else set()
    with _trial(obj, changes) if changes else nullcontext(), nullcontext() if process().unavailable else only_looking():
        while_tried()
        return _look(document, changed)


def _look(document: Any, changed: set[str]) -> Look:
    look = Look()
    for obj in reversed(document.TopologicalSortedObjects):
        touched = "Touched" in obj.State or any(part.Name in changed for part in obj.OutList)
        if proxy_type(obj) and (touched or obj.Name in changed):
            changed.add(obj.Name)
            try:
                _look_for(obj, look)
            except CNCStepperError as error:
                look.refusals[obj.Name] = error
    return look


def _look_for(obj: Any, look: Look) -> None:
    """Add what making one object calculates; raises the CNCStepperError that refuses it."""
    if is_job(obj):
        for operation in active_operations(obj):
            if error := look.refusals.get(operation.Name):
                raise JobError(FAILED, named(operation, error.sentence))
    try:
        question = obj.Proxy.question(obj)
    except Unfitted as unfitted:  # once they are fitted it is asked for the cut
        question = unfitted.question
    if question is None or process().unavailable:
        return
    key = request_digest.key_of(question)
    if result_cache.may_ask(key):
        look.unknown[key] = question
    elif isinstance(answer := result_cache.known(key), CNCStepperError):
        raise answer.with_traceback(None)


@contextmanager
def _trial(obj: Any, changes: dict[str, Any]) -> Iterator[None]:
    """Let `obj` have other values within; then all is as it was, nor out of date by that."""
    ours = [other for other in obj.Document.Objects if proxy_type(other)]
    current = {other.Name for other in ours if "Touched" not in other.State}
    keys = list(dict.fromkeys([*changes, *getattr(obj.Proxy, "SHAPE", ())]))
    names = [entry_of(obj.Proxy, key).name for key in keys]
    before = {name: getattr(obj, name) for name in names}
    deleted, unused = getattr(obj, "DeletedDrawing", ""), getattr(obj.Proxy, "unused", ())
    with on_trial():
        try:
            edit(obj, **changes)
            yield
        finally:
            for name, value in before.items():
                setattr(obj, name, value)
            if deleted:
                obj.DeletedDrawing = deleted
            if unused:
                obj.Proxy.unused = unused
            for other in ours:
                if other.Name in current:
                    other.purgeTouched()
