# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a question is JSON of the same data, with large parts written once; its name is that of its data."""

from __future__ import annotations

import json
from typing import Any

import pytest

from CNCStepper.job.request_digest import Content, digest_of, key_of, text_of

LINES = {"points": [[0.1, 2.0], [1e-9, -3.5]], "label": 'Peça "nº 1"\n'}
QUESTIONS: list[dict[str, Any]] = [
    {},
    {"mark": 3, "parts": {}, "compiled": True, "none": None},
    {"tools": {1: "flat", 2: Content(LINES)}, "by": {None: 1, True: 2}},
    {
        "cut": {"operation": [Content(LINES), Content(LINES)], "stock": {"size_mm": [1, 2, 3]}},
        "machine": Content(LINES),
    },
    {"parts": {"é": {"program": Content({}), "list": [], "dict": {"inner": [[1], {"a": "ç"}]}}}},
]


@pytest.mark.parametrize("question", QUESTIONS)
def test_the_text_is_json_of_the_same_data(question: dict[str, Any]) -> None:
    assert json.loads(text_of(question)) == json.loads(json.dumps(question))
    assert text_of(question).isascii() and "\n" not in text_of(question)


def test_a_part_of_many_questions_is_written_once(monkeypatch: pytest.MonkeyPatch) -> None:
    part = Content(LINES)
    first = text_of({"cut": part}), key_of({"cut": part})
    monkeypatch.setattr(part, "values", None)  # what looks at it again fails
    monkeypatch.setattr(part, "items", None)
    assert (text_of({"cut": part}), key_of({"cut": part})) == first


def test_the_name_of_a_part_is_that_of_its_data() -> None:
    assert Content(LINES).digest == digest_of(dict(reversed(LINES.items())))
    assert Content(LINES).digest != Content({**LINES, "label": ""}).digest
