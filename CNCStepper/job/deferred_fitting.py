# SPDX-License-Identifier: LGPL-2.1-or-later
"""While a window only collects the work of making objects, it calculates nothing that takes long.

What is missing is raised as `Unfitted`, with the question that the cut process is asked for it. Nothing changes in the
document meanwhile: what all operations of a job need of it is worked out `once`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

from CNCStepper.errors import GeometryError

_only_looking = False
_on_trial = False
_worked_out: dict[tuple[str, str, str], Any] = {}  # while a window only looks
Found = TypeVar("Found")


class Unfitted(GeometryError):
    """Lines are not fitted yet; `question` is the request for them to the cut process."""

    def __init__(self, question: dict[str, Any]):
        super().__init__("unfitted", "the lines are being fitted", advice="it resumes without a person")
        self.question = question


@contextmanager
def only_looking() -> Iterator[None]:
    """Calculate nothing within that takes long."""
    global _only_looking
    before, _only_looking = _only_looking, True
    try:
        yield
    finally:
        _only_looking = before
        _worked_out.clear()


def looks_only() -> bool:
    """Return whether what takes long is to be asked of the cut process now."""
    return _only_looking


def once(what: str, obj: Any, work_out: Callable[[], Found]) -> Found:
    """Return the result for an object; while a window only collects work, the first one's result serves all."""
    if not _only_looking:
        return work_out()
    key = what, obj.Document.Name, obj.Name
    if key not in _worked_out:
        _worked_out[key] = work_out()
    return _worked_out[key]  # type: ignore[no-any-return]


@contextmanager
def on_trial() -> Iterator[None]:
    """Let values within be those that an object would have: they are taken back, and nothing is drawn of them."""
    global _on_trial
    _on_trial = True
    try:
        yield
    finally:
        _on_trial = False


def is_on_trial() -> bool:
    """Return whether the values of objects are on trial now."""
    return _on_trial
