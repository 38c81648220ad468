# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's machine profiles: listed, made from another one, and changed key by key.

A profile is checked whole before it is written, and written whole or not at all. A shipped one is never written: its
first change goes into a copy of the same name in the user's folder, which takes its place from then on.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import BaseModel

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import CNCStepperError, JobError, Text
from CNCStepper.input_file import is_there, read_input
from CNCStepper.machine.files.profile_files import NAME, own_folder, own_names, own_path, shipped_file, shipped_names
from CNCStepper.machine.files.toml_reader import MOST_BYTES, read_json, read_toml
from CNCStepper.machine.files.toml_text import changed_text, document_text, value_text
from CNCStepper.machine.profile import Machine, load_machine, profile_names, validated
from CNCStepper.safe_text import printable

TITLE = "Machine profile, made by CNCStepper"
KeyPath = tuple[str, ...]


class Profile(NamedTuple):
    """A profile that can be named: whether it ships, and whether the user has one of that name."""

    name: str
    is_shipped: bool
    is_own: bool


class Written(NamedTuple):
    """What a change has written: the file, the shipped profile that it was copied from ("" for none), its comments."""

    path: Path
    copied_from: str
    comments_kept: bool
    machine: Machine


def profiles() -> list[Profile]:
    """Return all profiles by name."""
    own, shipped = own_names(), shipped_names()
    return [Profile(name, name in shipped, name in own) for name in profile_names()]


def label_of(name: str, words: Callable[[str], str] = str) -> str:
    """Return how a profile is offered: "Cutting table A (table-a)"; one that cannot be read by its name alone.

    words: gives the machine's name in the person's language.
    """
    try:
        return f"{words(load_machine(name).name)} ({name})"
    except CNCStepperError:
        return name


def profile_text(name_or_path: str) -> str:
    """Return the TOML text of a profile, of a JSON file its content as TOML; raises JobError where there is none."""
    own = own_path(name_or_path)
    if own is None and name_or_path in shipped_names():
        return shipped_file(name_or_path).read_text("utf-8")
    path = own or Path(name_or_path)
    if not is_there(path):
        load_machine(name_or_path)  # which says what there is
    if path.suffix.lower() == ".json":
        return document_text(read_json(path))
    read_toml(path)  # in bounded time, and with its line where it is none
    return read_input(path, MOST_BYTES).decode("utf-8-sig").replace("\r\n", "\n")


def profile_content(name_or_path: str) -> dict[str, Any]:
    """Return the content of a profile, without defaults."""
    return tomllib.loads(profile_text(name_or_path))


def create(name: str, source: str) -> Written:
    """Make a profile of the user's from another one, whose comments it keeps; raises JobError for a name in use."""
    path = _place_of(name)
    if name in profile_names():
        raise JobError(
            "profile-exists",
            Text("there is a machine profile '{name}' already", name=name),
            advice="give it another name, or change that one with: cncstepper machine set",
        )
    load_machine(source)
    return _write(path, profile_text(source), {("name",): name}, "")


def change(name_or_path: str, changes: Mapping[KeyPath, Any]) -> Written:
    """Change keys of a profile, by their paths; None takes a key or table out.

    Raises JobError that names the key, and writes nothing, where the whole would not be a machine.
    """
    text = profile_text(name_or_path)
    own = own_path(name_or_path)
    is_shipped = own is None and name_or_path in shipped_names()
    path = own or (_place_of(name_or_path) if is_shipped else _toml_file(Path(name_or_path)))
    return _write(path, text, changes, name_or_path if is_shipped else "")


def save(name: str, content: Mapping[str, Any]) -> Written:
    """Write this content to a user's profile; in an existing one only values that differ are changed."""
    if name not in profile_names():
        return _write(_place_of(name), document_text(content, TITLE), {}, "")
    return change(name, dict(differences(profile_content(name), content)))


def differences(
    before: Mapping[str, Any], after: Mapping[str, Any], table: KeyPath = ()
) -> Iterator[tuple[KeyPath, Any]]:
    """Yield the paths of the keys whose values differ, with the new value, None for a removed key."""
    for key in {**before, **after}:
        old, new = before.get(key), after.get(key)
        if isinstance(old, Mapping) and isinstance(new, Mapping):
            yield from differences(old, new, (*table, key))
        elif old != new or isinstance(old, bool) != isinstance(new, bool):
            yield (*table, key), new


def read_change(word: str) -> tuple[KeyPath, Any]:
    """Return the path and value of "axis.x.steps_per_mm=80"; an empty value is None, a value that is no TOML a text.

    Raises JobError for what has no key.
    """
    key, sign, text = word.partition("=")
    path = tuple(part.strip() for part in key.split("."))
    if not sign or not all(path):
        raise JobError(
            "bad-value",
            Text("'{word}' changes no key", word=printable(word, 100)),
            advice="write KEY=VALUE, for example axis.x.steps_per_mm=80",
        )
    if not text.strip():
        return path, None
    try:
        return path, tomllib.loads(f"value = {text}")["value"]
    except (ValueError, KeyError, RecursionError):
        return path, text.strip()


def values_of(machine: Machine, path: Sequence[str] = ()) -> list[str]:
    """Return the values in force, defaults too, as "axis.x.steps_per_mm = 80"; all at or below a path.

    Raises JobError where nothing is there.
    """
    found = [(key, value) for key, value in _leaves(machine) if key[: len(path)] == tuple(path)]
    if not found:
        raise JobError(
            "bad-value",
            Text("the profile has no key {key}", key=printable(".".join(path), 100)),
            advice=Text("there are: {keys}", keys=", ".join(Machine.model_fields)),
        )
    return [f"{'.'.join(key)} = {value_text(value)}" for key, value in found]


def _leaves(model: BaseModel, table: KeyPath = ()) -> Iterator[tuple[KeyPath, Any]]:
    for key in type(model).model_fields:
        value = getattr(model, key)
        if isinstance(value, BaseModel):
            yield from _leaves(value, (*table, key))
        elif isinstance(value, dict) and any(isinstance(one, BaseModel) for one in value.values()):
            for name, one in value.items():
                yield from _leaves(one, (*table, key, name))
        elif value is not None:
            yield (*table, key), _plain(value)


def _plain(value: Any) -> Any:
    if isinstance(value, BaseModel):
        return value.model_dump(mode="json", exclude_none=True)
    return [_plain(one) for one in value] if isinstance(value, (list, tuple)) else value


def _write(path: Path, text: str, changes: Mapping[KeyPath, Any], copied_from: str) -> Written:
    try:
        changed = changed_text(text, changes)
    except KeyError as error:
        raise JobError(
            "bad-value",
            Text("{key} leads into a value that is no table", key=printable(".".join(error.args[0]), 100)),
            advice="give the whole list or table, for example outputs.coolant=['mist']",
        ) from error
    machine = validated(Machine, tomllib.loads(changed.text), str(path))
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, changed.text.encode("utf-8"))
    return Written(path, copied_from, changed.comments_kept, machine)


def _place_of(name: str) -> Path:
    """Return the path of the user's profile of a name; raises JobError for an invalid name."""
    if not NAME.fullmatch(name):
        raise JobError(
            "profile-name",
            Text("'{name}' is no name for a machine profile", name=printable(name, 100)),
            advice="take up to 60 letters of a to z, digits, - and _, a letter or digit first",
        )
    return own_folder() / f"{name}.toml"


def _toml_file(path: Path) -> Path:
    if path.suffix.lower() == ".json":
        raise JobError(
            "profile-json",
            Text("{path} is JSON: only TOML profiles are changed", path=printable(str(path), 200)),
            advice="make a profile of your own from it: cncstepper machine new NAME --from FILE",
        )
    return path
