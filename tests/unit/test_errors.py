# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text keeps its template and its values: in an error, in a pickle, and as JSON; it reads as plain English."""

from __future__ import annotations

import copy
import json
import pickle
from typing import Any

import pytest

from CNCStepper.control.session.status import error_from_json, error_to_json
from CNCStepper.errors import MOST_CHARACTERS, JobError, Place, Text, joined, placed
from CNCStepper.text_json import dumps, loads, restored, with_texts

LONG = Text("{key} is longer than {most_mm:.2f} mm", key="Slot 1", most_mm=12.345)
ERROR = JobError("too-long", LONG, advice=Text("take {key!r} away", key="x"), limit=Text("at most {n} mm", n=3))


def same(one: Any, other: Any) -> bool:
    """Whether two texts have the same English, template and values."""
    return one == other and (one.template, one.values) == (other.template, other.values)


def test_a_text_reads_as_english_and_keeps_its_values() -> None:
    assert LONG == "Slot 1 is longer than 12.35 mm" and f"{LONG}!" == "Slot 1 is longer than 12.35 mm!"
    assert LONG.template == "{key} is longer than {most_mm:.2f} mm"
    assert LONG.values == {"key": "Slot 1", "most_mm": 12.345}


def test_a_text_survives_pickle_and_copy() -> None:
    assert same(pickle.loads(pickle.dumps(LONG)), LONG) and copy.deepcopy(LONG) is LONG


def test_values_of_other_kinds_become_values_that_json_has() -> None:
    np = pytest.importorskip("numpy")
    text = Text("{count:d} of {place} at {x_mm:g}", count=np.int64(3), place=Place("a.nc", 1), x_mm=np.float64(1.5))
    assert text == "3 of a.nc:1 at 1.5" and json.loads(json.dumps(text.values)) == text.values


def test_an_error_as_a_value_stays_a_text() -> None:
    text = Text("the job has ended: {error}", error=ERROR.at(Place("a.nc", 2)))
    assert text == f"the job has ended: {ERROR.at(Place('a.nc', 2))}"
    assert text.values["error"].values["error"].values["code"] == "too-long"


def test_texts_are_joined_to_one() -> None:
    assert joined("; ", []) == "" and joined("; ", [LONG]) is LONG
    assert joined("; ", [LONG, "drop it"]) == f"{LONG}; drop it"


def test_an_error_keeps_its_texts() -> None:
    for error in (ERROR.at(Place("a.nc")), pickle.loads(pickle.dumps(ERROR)), copy.copy(ERROR)):
        assert same(error.what, LONG) and same(error.limit, ERROR.limit) and same(error.advice, ERROR.advice)
    with pytest.raises(JobError) as caught, placed(Place("b.nc", 7)):
        raise ERROR
    assert same(caught.value.what, LONG) and str(caught.value).startswith("b.nc:7: Slot 1 is longer")
    assert str(ERROR) == "Slot 1 is longer than 12.35 mm (limit at most 3 mm); take 'x' away [too-long]"


def test_an_error_of_the_operating_system_is_quoted_without_its_number() -> None:
    assert Text("it broke: {error}", error=BrokenPipeError(32, "Broken pipe")) == "it broke: Broken pipe"
    assert Text("it broke: {error}", error=OSError("odd")) == "it broke: odd"


def test_values_in_an_error_are_printable_and_bounded() -> None:
    error = JobError("x", Text("no {name} here", name="\x1b[2J\u202e"))
    assert error.what == "no \\x1b[2J\\u202e here" and error.what.template == "no {name} here"  # type: ignore[attr-defined]
    long = JobError("x", Text("no {name} here", name="a" * 2 * MOST_CHARACTERS))
    assert len(long.what) == MOST_CHARACTERS + 1


def test_the_json_of_an_error_keeps_its_texts() -> None:
    error = error_from_json(json.loads(json.dumps(error_to_json(ERROR))))
    assert type(error) is JobError and str(error) == str(ERROR)
    assert same(error.what, LONG) and same(error.advice, ERROR.advice) and same(error.limit, ERROR.limit)


def test_older_json_of_an_error_opens() -> None:
    content = {key: value for key, value in error_to_json(ERROR).items() if key != "templates"}
    assert str(error_from_json(json.loads(json.dumps(content)))) == str(ERROR)


def test_json_keeps_texts_wherever_they_stand() -> None:
    outer = Text("{why}. Now {state}", why=LONG, state="it stands")
    content = {"event": "x", "list": [{"text": outer}, LONG], "plain": "a"}
    again = loads(dumps(content))
    assert again == content
    assert same(again["list"][0]["text"], outer) and same(outer.values["why"], LONG) and same(again["list"][1], LONG)
    assert with_texts({"a": "b"}) == {"a": "b"}


@pytest.mark.parametrize(
    "told",
    [
        None,
        [],
        {"template": "{x"},
        {"template": "{x.__class__}", "values": {"x": "a"}},
        {"template": "{x:999999999}", "values": {"x": "a"}},
        {"template": "{x:d}", "values": {"x": "a"}},
        {"template": "{y}", "values": {"x": "a"}},
        {"template": "another", "values": {}},
        {"template": 7, "values": {}},
        {"template": "{x}", "values": {"x": {"template": "{x}", "values": {"x": []}}}},
    ],
)
def test_templates_that_do_not_give_the_english_are_left(told: Any) -> None:
    assert restored({"a": "hello", "templates": {"hello": told}}) == {"a": "hello"}
    assert type(restored({"a": "hello", "templates": {"hello": told}})["a"]) is str


def test_a_template_that_would_fill_the_memory_is_not_formatted() -> None:
    text, template = "x" * 40, "{a}" * 40
    for _ in range(4):  # 40 ** 4 characters each
        text = {"template": template, "values": {"a": text}}
    assert restored({"templates": {"x": text}, "why": "x"}) == {"why": "x"}
