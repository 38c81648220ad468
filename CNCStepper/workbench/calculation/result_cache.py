# SPDX-License-Identifier: LGPL-2.1-or-later
"""Answers of the cut process by their requests, so that a recompute calculates nothing twice.

    a question (plain data) ──► key ──► Cut or Programs, or the error that refuses it

Of programs their paths are kept too, as FreeCAD's Path takes them. The oldest go first. Where the process failed, that
is kept for whoever makes the object now, and asked anew when somebody tries again later.
"""

from __future__ import annotations

import hashlib
import time
from collections import OrderedDict
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.request_digest import key_of

if TYPE_CHECKING:
    from CNCStepper.geometry.curve import Curve

MOST_BYTES = 64_000_000  # of all that is kept
ENTRY_BYTES = 1_000  # of an answer besides its texts
PROCESS_FAILURES = ("cut-lost", "cut-memory", "cut-fault")  # they say nothing of the values that were asked for
RETRY_S = 2.0  # after which such a question is asked anew


@dataclass(frozen=True)
class Cut:
    """The report of an operation's cut: figures by name, and warnings."""

    figures: dict[str, float]
    warnings: tuple[str, ...]


@dataclass(frozen=True)
class Programs:
    """The names and texts of a job's programs, and the path of each."""

    texts: tuple[tuple[str, str], ...]
    paths: tuple[str, ...]

    @property
    def size(self) -> int:
        """How many bytes it takes."""
        return sum(len(text) for _, text in self.texts) + sum(map(len, self.paths))


@dataclass(frozen=True)
class Fits:
    """Lines were fitted; `fitting` keeps what came out."""


@dataclass(frozen=True)
class Planned:
    """The planned time of an operation's own moves."""

    time_s: float


@dataclass(frozen=True)
class Written:
    """A file was written."""

    path: str


@dataclass(frozen=True)
class TextCurves:
    """The curves of a text."""

    curves: tuple[Curve, ...]

    @property
    def size(self) -> int:
        """How many bytes it takes."""
        return sum(curve.xy.nbytes + curve.bulge.nbytes for curve in self.curves)


Answer = Cut | Planned | Programs | Fits | TextCurves | Written | CNCStepperError

_answers: OrderedDict[str, Answer] = OrderedDict()
_paths: dict[str, str] = {}  # by the key of a program's text
_failed_s: dict[str, float] = {}  # when the process failed, by the key of what it was asked
_bytes = 0


def take(key: str, content: dict[str, Any]) -> None:
    """Keep an answer of `cycle_cutting`."""
    keep(key, _answer(content))


def keep(key: str, answer: Answer) -> None:
    """Keep an answer; the oldest go where there are too many."""
    global _bytes
    _drop(key)
    _answers[key] = answer
    _bytes += _size(answer)
    if isinstance(answer, CNCStepperError) and answer.code in PROCESS_FAILURES:
        _failed_s[key] = time.monotonic()
    if isinstance(answer, Programs):
        _paths.update({_text_key(text): path for (_, text), path in zip(answer.texts, answer.paths, strict=True)})
    while _bytes > MOST_BYTES and len(_answers) > 1:
        _drop(next(iter(_answers)))


def known(key: str) -> Answer | None:
    """Return the answer to a question, None where there is none."""
    if key in _answers:
        _answers.move_to_end(key)
    return _answers.get(key)


def may_ask(key: str) -> bool:
    """Return whether a question has no answer, or only that its process failed, some time ago."""
    return key not in _answers or (key in _failed_s and time.monotonic() - _failed_s[key] > RETRY_S)


def answer_to(question: dict[str, Any]) -> Cut | Planned | Programs | Fits | TextCurves | Written | None:
    """Return what is known of a question, None where nothing is; raises the CNCStepperError that refused it."""
    answer = known(key_of(question))
    if isinstance(answer, CNCStepperError):
        raise answer.with_traceback(None)
    return answer


def path_of(text: str) -> str | None:
    """Return the path of a program's text, None where it is not known."""
    return _paths.get(_text_key(text))


def any_known() -> bool:
    """Return whether anything was answered: without a window nothing is, and then no question need be put together."""
    return bool(_answers)


def forget() -> None:
    """Forget all answers."""
    global _bytes
    _answers.clear()
    _paths.clear()
    _failed_s.clear()
    _bytes = 0


def _drop(key: str) -> None:
    global _bytes
    answer = _answers.pop(key, None)
    _failed_s.pop(key, None)
    if answer is not None:
        _bytes -= _size(answer)
    if isinstance(answer, Programs):
        for _, text in answer.texts:
            _paths.pop(_text_key(text), None)


def _size(answer: Answer) -> int:
    return ENTRY_BYTES + (answer.size if isinstance(answer, Programs | TextCurves) else 0)


def _text_key(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def _answer(content: dict[str, Any]) -> Answer:
    if "error" in content:
        return error_from_json(content["error"])
    if "fits" in content:
        from CNCStepper.job import curve_fit_cache

        curve_fit_cache.take(content)
        return Fits()
    if "curves" in content:
        from CNCStepper.job.drawings.packed_curves import unpacked_curves

        return TextCurves(tuple(unpacked_curves(content["curves"])))
    if "texts" in content:
        return Programs(tuple((name, text) for name, text in content["texts"]), tuple(content["paths"]))
    if "written" in content:
        return Written(content["written"])
    if "time_s" in content:
        return Planned(content["time_s"])
    return Cut(dict(content["figures"]), tuple(content["warnings"]))
