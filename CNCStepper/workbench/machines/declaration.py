# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of a machine's page, as the profile's model declares them: kind of value, choices, unit, default; no Qt."""

from __future__ import annotations

import types
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.quantities import Bounds

NUMBER, WHOLE, EITHER, TEXT, CHECK, CHOICE = "number", "whole", "either", "text", "check", "choice"
SET, WORDS, NUMBERS, POINTS = "set", "words", "numbers", "points"  # several choices; words in order; lists
# EITHER is a whole number or a word
Path = tuple[str, ...]
PINS: Path = ("signals", "pins")


@dataclass(frozen=True)
class Row:
    """One value of a profile: its key, its kind, and its default.

    default: None where there is none, or it must be given. unit: "" for bare numbers.
    """

    path: Path
    kind: str
    choices: tuple[str, ...] = ()
    unit: str = ""
    default: Any = None
    required: bool = False


@dataclass(frozen=True)
class Table:
    """A list of tables, such as the inputs: its key, and the columns of each."""

    key: str
    columns: tuple[Row, ...]


def rows(model: type[BaseModel] = Machine, above: Path = ()) -> Iterator[Row]:
    """Yield the rows of a model in the order of their declaration; lists of tables are among `tables`."""
    for key, field in model.model_fields.items():
        path = (*above, key)
        inner = _model_in(field.annotation)
        if path == PINS or _is_table_list(field.annotation):
            continue
        if inner is None:
            yield _row(path, field)
        elif get_origin(_bare(field.annotation)) is dict:
            for name in AXIS_NAMES:
                yield from rows(inner, (*path, name))
        else:
            yield from rows(inner, path)


def key_of_row(path: Path) -> str:
    """Return the key of a row as the help has it, one for all axes: "axis.NAME.steps_per_mm"."""
    axis = len(path) > 1 and path[0] == "axis" and path[1] in AXIS_NAMES
    return ".".join((path[0], "NAME", *path[2:]) if axis else path)


def tables() -> tuple[Table, ...]:
    """Return the lists of tables of a profile."""
    return tuple(
        Table(key, tuple(rows(model)))
        for key, field in Machine.model_fields.items()
        if _is_table_list(field.annotation) and (model := _model_in(field.annotation))
    )


def _row(path: Path, field: FieldInfo) -> Row:
    annotation = _bare(field.annotation)
    parts = list(get_args(annotation)) if get_origin(annotation) in (Union, types.UnionType) else [annotation]
    kinds = {_bare(part) for part in parts} - {type(None)}
    bounds = next((rule for rule in (*field.metadata, *_metadata(field.annotation)) if isinstance(rule, Bounds)), None)
    most = next((rule.max_length for rule in field.metadata if hasattr(rule, "max_length")), 0)
    kind, choices = _kind(kinds, most)
    default = None if field.is_required() or isinstance(field.default, BaseModel) else field.default
    return Row(path, kind, choices, bounds.unit if bounds else "", default, field.is_required())


def _kind(kinds: set[Any], most: int) -> tuple[str, tuple[str, ...]]:
    """Return the kind of values of some types; most: how long a list may be."""
    if len(kinds) > 1:
        return (EITHER if int in kinds else TEXT), ()
    one = next(iter(kinds))
    if get_origin(one) is Literal:
        return CHOICE, tuple(map(str, get_args(one)))
    if get_origin(one) in (tuple, list):
        item = _bare(get_args(one)[0])
        if get_origin(item) is Literal:
            words = tuple(map(str, get_args(item)))
            return (SET if most <= len(words) else WORDS), words
        return (POINTS if get_origin(item) is tuple else NUMBERS), ()
    return {float: NUMBER, int: WHOLE, bool: CHECK}.get(one, TEXT), ()


def _bare(annotation: Any) -> Any:
    """Return a type without what it is annotated with."""
    return _bare(get_args(annotation)[0]) if get_origin(annotation) is Annotated else annotation


def _metadata(annotation: Any) -> Iterator[Any]:
    for part in (annotation, *get_args(annotation)):
        yield from getattr(part, "__metadata__", ())


def _model_in(annotation: Any) -> type[BaseModel] | None:
    """Return the model that an annotation is, or holds."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    if get_origin(annotation) is Literal:
        return None
    return next((found for part in get_args(annotation) if (found := _model_in(part))), None)


def _is_table_list(annotation: Any) -> bool:
    return get_origin(annotation) is tuple and _model_in(annotation) is not None
