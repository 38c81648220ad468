# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's presets of operations, CONFIG/cncstepper/presets.toml: values by key, under the cycle and a name.

[pocket."Plywood, fast"]
stepdown_mm = 3.0
entry = "ramp"
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import is_there
from CNCStepper.machine.files.profile_files import config_folder
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.files.toml_text import document_text

Value = str | float | int | bool
Values = dict[str, Value]
TITLE = "Presets of operations: values by key, under the cycle and a name"
LONGEST = 60  # letters of a name


def presets_path() -> Path:
    """Return the file of the user's presets, which need not be there; raises MissingPackage without platformdirs."""
    return config_folder() / "presets.toml"


def presets_of(cycle: str) -> dict[str, Values]:
    """Return the presets of a cycle by name, in the order of the alphabet; raises JobError for a bad file."""
    return dict(sorted(_read().get(cycle, {}).items(), key=lambda item: item[0].casefold()))


def save_preset(cycle: str, name: str, values: Mapping[str, Value]) -> str:
    """Write values under a name, in place of those that it had, and return the name without blanks around it.

    Raises JobError for a name that cannot be, and for a bad file, which then stays as it is.
    """
    name = name.strip()
    if not name or len(name) > LONGEST or not name.isprintable():
        what = Text("a preset cannot be named '{name}'", name=name[:LONGEST])
        raise JobError("preset-name", what, limit=f"1 to {LONGEST}", advice="give it a short name on one line")
    content = _read()
    content.setdefault(cycle, {})[name] = dict(values)
    _write(content)
    return name


def delete_preset(cycle: str, name: str) -> None:
    """Delete a preset; one that is not there is no error. Raises JobError for a bad file."""
    content = _read()
    if content.get(cycle, {}).pop(name, None) is not None:
        _write(content)


def _read() -> dict[str, dict[str, Values]]:
    path = presets_path()
    content = read_toml(path) if is_there(path) else {}
    for cycle, presets in content.items():
        for name, values in presets.items() if isinstance(presets, dict) else [("", None)]:
            if not isinstance(values, dict) or not all(isinstance(one, Value) for one in values.values()):
                what = Text("the preset {cycle}.{name} is no table of values", cycle=cycle, name=name)
                raise JobError("preset-file", what, advice="correct or delete that entry", place=Place(str(path)))
    return content


def _write(content: dict[str, dict[str, Values]]) -> None:
    path = presets_path()
    path.parent.mkdir(parents=True, exist_ok=True)
    kept = {cycle: presets for cycle, presets in content.items() if presets}
    write_whole(path, document_text(kept, TITLE).encode("utf-8"))
