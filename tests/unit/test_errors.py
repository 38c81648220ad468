# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text keeps its template and its values: in an error, in a pickle, and as JSON; errors say what to do."""

from __future__ import annotations

import ast
import copy
import json
import pickle
import re
from collections.abc import Iterable
from typing import Any

import pytest

from CNCStepper.control.session.status import error_from_json, error_to_json
from CNCStepper.cycles.sheet_cutting.lead_room import NoScrap
from CNCStepper.errors import MOST_CHARACTERS, JobError, Place, Text, joined, placed
from CNCStepper.job.deferred_fitting import Unfitted
from CNCStepper.text_json import dumps, loads, restored, with_texts
from helpers.imports import PACKAGE
from helpers.tools import load

refusal_codes = load("refusal_codes")
WITH_ONE_ADVICE = {"NoScrap", "Unfitted"}  # the same wherever they are raised

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


def without_advice(tree: ast.Module, classes: set[str]) -> list[str]:
    """Return the errors that a module makes without an advice; one that carries other words whole is left."""
    calls = [call for call, _ in refusal_codes.calls_in(tree) if refusal_codes.last_name(call) in classes]
    return [ast.unparse(call) for call in calls if not (_gives_advice(call) or _carries_other_words(call))]


def _gives_advice(call: ast.Call) -> bool:
    """Return whether a call names an advice that is never empty; `**` may hold one."""
    given = [keyword.value for keyword in call.keywords if keyword.arg in ("advice", None)]
    choices = list(refusal_codes.translations.alternatives(given))
    return bool(choices) and not any(isinstance(one, ast.Constant) and one.value == "" for one in choices)


def _carries_other_words(call: ast.Call) -> bool:
    """Return whether an error has an object's own problem for its words, or is an answer of emulated firmware."""
    code = ast.unparse(call.args[0]) if call.args else ""
    return code == "FAILED" or code.startswith("f'error:")


def optional_advice(tree: ast.Module) -> list[int]:
    """Return the lines of functions that take an advice and need not be given one."""
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    return [each.lineno for each in functions if re.search(r"\badvice(: \w+)?\s*=\s*''", ast.unparse(each.args))]


def errors_in(sources: Iterable[str]) -> set[str]:
    """Return the names of the classes of our errors, those that are derived from them too."""
    bases = {name: of for source in sources for name, of in re.findall(r"^class (\w+)\((.*)\):", source, re.MULTILINE)}
    found = {"CNCStepperError"}
    while more := {name for name, of in bases.items() if set(re.findall(r"\w+", of)) & found} - found:
        found |= more
    return found


def test_every_error_says_what_to_do() -> None:
    sources = {str(path): path.read_text("utf-8") for path in PACKAGE.rglob("*.py")}
    classes = errors_in(sources.values())
    assert {"JobError", "MissingPackage", *WITH_ONE_ADVICE} <= classes
    made = re.compile(rf"\b({'|'.join(classes)})\(|\badvice\b")
    trees = {path: ast.parse(source) for path, source in sources.items() if made.search(source)}
    silent = {path: without_advice(tree, classes - WITH_ONE_ADVICE) for path, tree in trees.items()}
    assert not {path: calls for path, calls in silent.items() if calls}
    del trees[str(PACKAGE / "errors.py")]
    optional = {path: optional_advice(tree) for path, tree in trees.items()}
    assert not {path: lines for path, lines in optional.items() if lines}


def test_errors_with_one_advice_have_it() -> None:
    assert NoScrap("a", LONG, value=LONG, scrap_mm=1.0).advice and Unfitted({}).advice


@pytest.mark.parametrize(
    "call",
    [
        "JobError('a', 'b')",
        "errors.JobError('a', 'b', value='1 mm')",
        "JobError('a', 'b', advice='')",
        "JobError('a', 'b', advice='drop it' if limit else '')",
        "JobError(f'{a}:error', 'b')",
    ],
)
def test_a_planted_error_without_advice_is_found(call: str) -> None:
    assert without_advice(ast.parse(f"def f():\n    raise {call}"), {"JobError"}) == [call]


@pytest.mark.parametrize(
    "call", ["JobError('a', 'b', advice='drop it')", "JobError('a', 'b', **more)", "JobError(f'error:{a}', 'b')"]
)
def test_an_error_with_advice_is_not_found(call: str) -> None:
    assert without_advice(ast.parse(f"raise {call}"), {"JobError"}) == []


@pytest.mark.parametrize(
    ("arguments", "lines"),
    [("a, advice: str = '', b=0", [1]), ("a, *, advice: str = ''", [1]), ("advice=''", [1]), ("advice: str, b=''", [])],
)
def test_a_planted_optional_advice_is_found(arguments: str, lines: list[int]) -> None:
    assert optional_advice(ast.parse(f"def f({arguments}):\n    pass")) == lines
