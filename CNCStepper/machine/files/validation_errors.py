# SPDX-License-Identifier: LGPL-2.1-or-later
"""Validation errors of a file: the key, its table, and the remedy."""

from __future__ import annotations

import re
import types
from collections.abc import Iterator, Sequence
from functools import reduce
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from CNCStepper.errors import JobError, Place, Text, joined, one_of
from CNCStepper.quantities import ERROR_TYPE, Bounds, shown, with_unit
from CNCStepper.safe_text import printable

MOST_KEY = 200  # characters of a key's path that are shown
WRONG_TYPES = {  # by pydantic's name of the problem
    "bool_type": Text("must be true or false"),
    "bool_parsing": Text("must be true or false"),
    "int_type": Text("must be a whole number"),
    "int_parsing": Text("must be a whole number"),
    "int_from_float": Text("must be a whole number"),
    "float_type": Text("must be a number"),
    "float_parsing": Text("must be a number"),
    "finite_number": Text("must be a finite number"),
    "none_required": Text("must be left out"),
    "missing": Text("is missing"),
    "extra_forbidden": Text("is no key that is known"),
    "string_type": Text("must be a text in quotes"),
    "string_pattern_mismatch": Text("is not written as it must be"),
    "dict_type": Text("must be a table"),
    "model_type": Text("must be a table"),
    "model_attributes_type": Text("must be a table"),
    "list_type": Text("must be a list"),
    "tuple_type": Text("must be a list"),
}
CHOICES = {"literal_error": "expected", "enum": "expected", "union_tag_invalid": "expected_tags"}  # the key of its ctx
QUOTED = re.compile("'[^']*'")


def refusal_of(model: type[BaseModel], error: ValidationError, file: str) -> JobError:
    """Return the first error; an unknown key comes first, for it may be the missing one."""
    problems = error.errors()
    unknown = [problem for problem in problems if problem["type"] == "extra_forbidden"]
    first = (unknown or problems)[0]
    key, place = printable(".".join(str(part) for part in first["loc"]), MOST_KEY), Place(file)
    owner, table = _owner(model, first["loc"])
    if unknown:
        known = ", ".join(sorted(owner.model_fields))
        advice = Text(
            "correct its spelling or take it out; known {table}are: {known}",
            table=Text("in {table} ", table=table) if table else "",
            known=known,
        )
        return JobError("bad-value", Text("there is no key {key}", key=key), advice=advice, place=place)
    if first["type"] == "missing" and isinstance(first["loc"][-1], int):
        key = ".".join(str(part) for part in first["loc"][:-1])
        return JobError("bad-value", Text("{key} has too few values", key=key), advice="give all of them", place=place)
    if first["type"] == "missing":
        name = str(first["loc"][-1])
        what = Text("the key {name} is missing", name=name)
        what = Text("{problem} in {table}", problem=what, table=table) if table else what
        words = _words(owner.model_fields[name]) if name in owner.model_fields else Text("a value")
        return JobError("bad-value", what, advice=Text("add {name} = {words}", name=name, words=words), place=place)
    if first["type"] == ERROR_TYPE:
        return _out_of_bounds(key, first, place)
    if first["type"] == "too_long":
        return _too_long(key, first, place)
    wrong = message_of(first)
    if not key:
        return JobError("bad-value", wrong, advice="correct that", place=place)
    return JobError(
        "bad-value",
        Text("{key}: {what}", key=key, what=wrong),
        value=shown(first["input"]),
        advice="correct that key",
        place=place,
    )


def message_of(problem: ErrorDetails) -> str:
    """Return the text of an error; a text of a model's own check keeps its values."""
    raised = problem.get("ctx", {}).get("error")
    if isinstance(raised, ValueError) and raised.args and isinstance(raised.args[0], str):
        return raised.args[0]
    if problem["type"] in WRONG_TYPES:
        return WRONG_TYPES[problem["type"]]
    if problem["type"] in CHOICES:
        return Text("must be {choices}", choices=_choices(str(problem["ctx"][CHOICES[problem["type"]]])))
    return _beyond(problem) or printable(problem["msg"].removeprefix("Value error, "))


def _choices(told: str) -> str:
    """Return the quoted choices of pydantic's words as "'a', 'b' or 'c'"."""
    *first, last = (printable(choice, MOST_KEY) for choice in QUOTED.findall(told))
    return Text("{one} or {other}", one=", ".join(first), other=last) if first else last


def _beyond(problem: ErrorDetails) -> str:
    """Return the text of an error that has a limit, "" for any other."""
    match problem.get("ctx", {}):
        case {"min_length": least} if problem["type"] == "string_too_short":
            return Text("must have at least {least} characters", least=least)
        case {"max_length": most} if problem["type"] == "string_too_long":
            return Text("must have at most {most} characters", most=most)
        case {"min_length": least}:
            return Text("must have at least {least} values", least=least)
        case {"max_length": most}:
            return Text("must have at most {most} values", most=most)
        case {"gt": limit}:
            return Text("must be above {limit:g}", limit=limit)
        case {"ge": limit}:
            return Text("must be at least {limit:g}", limit=limit)
        case {"lt": limit}:
            return Text("must be below {limit:g}", limit=limit)
        case {"le": limit}:
            return Text("must be at most {limit:g}", limit=limit)
        case {"discriminator": key} if problem["type"] == "union_tag_not_found":
            return Text("the key {name} is missing", name=str(key).strip("'"))
    return ""


def _out_of_bounds(key: str, problem: ErrorDetails, place: Place) -> JobError:
    """Return the error for a number beyond its bounds, or for another type."""
    given, told = problem["input"], problem["ctx"]
    is_number = isinstance(given, int | float) and not isinstance(given, bool)
    value = with_unit(given, told["unit"]) if is_number else shown(given)
    what = Text("{key} must be {number} within its bounds", key=key, number=told["number"])
    return JobError("bad-value", what, value=value, limit=told["bounds"], advice=told["advice"], place=place)


def _too_long(key: str, problem: ErrorDetails, place: Place) -> JobError:
    most = problem["ctx"]["max_length"]
    value = f"{len(problem['input'])}" if hasattr(problem["input"], "__len__") else ""
    advice = "make the list shorter"
    return JobError(
        "bad-value", Text("{key} is too long", key=key), value=value, limit=f"{most}", advice=advice, place=place
    )


def _owner(model: type[BaseModel], loc: Sequence[int | str]) -> tuple[type[BaseModel], str]:
    """Return the model of the table that holds the last part of `loc`, and how a person finds that table."""
    words: list[str] = []
    choice = [model]
    for part in loc[:-1]:
        model = choice[0]
        if isinstance(part, int):
            words[-1] += f" {part + 1}"
        elif part in model.model_fields:
            words.append(part)
            choice = list(_models_in(model.model_fields[part].annotation)) or choice
        else:  # the kind by which one of several models was chosen
            choice = [one for one in choice if part in _kinds(one)] or choice
    return choice[0], reduce(lambda whole, part: Text("{part} of {whole}", part=part, whole=whole), words or [""])


def _models_in(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for part in get_args(annotation):
        if not isinstance(part, str):
            yield from _models_in(part)


def _kinds(model: type[BaseModel]) -> tuple[str, ...]:
    kind = model.model_fields.get("kind")
    return (model.__name__, *(get_args(kind.annotation) if kind else ()))


def _words(field: FieldInfo) -> Text:
    """Return the accepted values of a key as text: "a number from 0.001 to 10000 mm"."""
    kinds = [rule for rule in (*field.metadata, *_parts(field.annotation)) if isinstance(rule, Bounds)]
    if kinds:
        return Text("{number} from {words}", number=_kind_words(field.annotation), words=kinds[0].words)
    bounds = list(_bounds(field))
    return Text("{kind}{bounds}", kind=_kind_words(field.annotation), bounds=joined("", bounds))


def _bounds(field: FieldInfo) -> Iterator[Text]:
    for rule in field.metadata:
        if (least := getattr(rule, "gt", None)) is not None:
            yield Text(" above {least:g}", least=least)
        if (least := getattr(rule, "ge", None)) is not None:
            yield Text(" of at least {least:g}", least=least)
        if (most := getattr(rule, "lt", None)) is not None:
            yield Text(" below {most:g}", most=most)
        if (most := getattr(rule, "le", None)) is not None:
            yield Text(" of at most {most:g}", most=most)


def _parts(annotation: Any) -> Iterator[Any]:
    """Yield what an optional number is annotated with."""
    for part in get_args(annotation):
        yield from getattr(part, "__metadata__", ())


def _kind_words(annotation: Any) -> str:
    if get_origin(annotation) is Annotated:
        return _kind_words(get_args(annotation)[0])
    if get_origin(annotation) is Literal:
        return one_of(f'"{choice}"' for choice in get_args(annotation))
    if get_origin(annotation) in (Union, types.UnionType):
        return _kind_words(get_args(annotation)[0])
    if annotation in (int, float):
        return Text("a number") if annotation is float else Text("a whole number")
    if annotation is str:
        return Text("a text")
    return Text("a list") if get_origin(annotation) in (tuple, list) else Text("a value")
