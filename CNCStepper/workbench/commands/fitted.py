# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved lines of the selected drawings are fitted beside the window before a new operation is made of them.

click ──► what of the drawings is not fitted? ── nothing ──► make it
                  ▲            │
                  └── answer ◄─┴─► the cut process (`cut_process.py`)
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from CNCStepper.job import question_key
from CNCStepper.job.deferred_fitting import Unfitted, only_looking
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.document.selection import Pair, selected_drawings
from CNCStepper.workbench.features.operation import Operation
from CNCStepper.workbench.services.messages import guarded, note
from CNCStepper.workbench.services.translation import tr

WHO = object()  # one asks at a time: a newer click takes the place of the one before


def when_fitted(kind: type[Operation], job: Any, pairs: Sequence[Pair], go_on: Callable[[], None]) -> None:
    """Call `go_on` when what an operation of a kind is to follow is fitted, which may be now.

    It is not called any more when the job or a drawing is gone by then, or another panel is open. Where the process
    could not fit something, `go_on` is called all the same.
    """
    from CNCStepper.workbench.calculation.cut_process import CutRequest, process

    parts = {} if process().unavailable else _unknown(kind, pairs)
    if not parts:
        go_on()
        return
    there = _present(job, pairs)

    def answered() -> None:
        if there() and not targets.why_no_panel():
            when_fitted(kind, job, pairs, go_on)

    process().ask(WHO, CutRequest(parts, lambda words: note(tr(words)), guarded(answered)))


def _unknown(kind: type[Operation], pairs: Sequence[Pair]) -> dict[str, dict[str, Any]]:
    """Return what the cut process is to be asked, by its keys."""
    with only_looking():
        refusals = selected_drawings(kind, pairs).refusals
    questions = [error.question for error in refusals if isinstance(error, Unfitted)]
    asked = {question_key.key_of(question): question for question in questions}
    return {key: question for key, question in asked.items() if result_cache.may_ask(key)}


def _present(job: Any, pairs: Sequence[Pair]) -> Callable[[], bool]:
    """Return a function that tells whether the job and the drawings are still in their documents."""
    names = [(obj.Document.Name, obj.Name) for obj in (job, *(drawing for drawing, _ in pairs))]

    def there() -> bool:
        import FreeCAD

        documents = FreeCAD.listDocuments()
        return all(document in documents and documents[document].getObject(name) for document, name in names)

    return there
