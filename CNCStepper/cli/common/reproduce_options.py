# SPDX-License-Identifier: LGPL-2.1-or-later
"""With which options a job was made: its journal keeps them, so that its restart can be offered whole.

{"options": {"--machine": ["table-a"], "--job": ["/home/ana/part.toml"]},      as `cncstepper restart` takes them
 "files": {"/home/ana/part.toml": "9f86d0..."}}                                their fingerprints as they were
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from CNCStepper.cli.common.path_types import as_typed
from CNCStepper.machine.profile import profile_names

KEPT = {
    *("machine", "dialect", "job_path", "part", "stock", "origin", "tool"),
    *("work_zero", "position", "parameters", "tool_table", "search", "overlap", "height"),
}
OF_STOCK = ("--stock", "--origin", "--tool")
OF_JOB = ("--job", "--part")
ReproduceOptions = Mapping[str, Any]


def reproduce_options() -> ReproduceOptions:
    """Return those of the options of the command that runs now which a restart takes too."""
    context = click.get_current_context()
    given = (
        param
        for param in context.command.params
        if param.name in KEPT and context.get_parameter_source(param.name) is ParameterSource.COMMANDLINE
    )
    return plain_options({param.opts[0]: _values(param, context) for param in given})


def plain_options(options: Mapping[str, Iterable[Any]]) -> ReproduceOptions:
    """Return options with their values as plain data; paths are made whole, their files fingerprinted."""
    values = [value for several in options.values() for value in several]
    files = [value.resolve() for value in values if isinstance(value, Path) and value.is_file()]
    return {
        "options": {name: [_text(value) for value in several] for name, several in options.items()},
        "files": {str(file): digest_of_file(file) for file in files},
    }


def merged(proven: ReproduceOptions, own: ReproduceOptions) -> ReproduceOptions:
    """Return with what a job was made whose proof tells the one, and its own command line the other, which wins."""
    if not proven:
        return own
    said = own["options"]
    instead = OF_STOCK if "--job" in said else OF_JOB if "--stock" in said else ()
    options = {name: values for name, values in proven["options"].items() if name not in instead} | said
    return {"options": options, "files": proven["files"] | own["files"]}


def digest_of_file(file: Path) -> str:
    """Return the SHA-256 of a file's bytes."""
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _values(param: click.Parameter, context: click.Context) -> Iterable[Any]:
    assert param.name
    value = context.meta.get(as_typed(param), context.params[param.name])
    if param.name == "machine" and value not in profile_names():
        value = Path(value)
    if param.name == "search":
        return [Path(folder) for folder in value]
    return [value]


def _text(value: Any) -> str:
    if isinstance(value, Path):
        return str(value.resolve())
    if isinstance(value, tuple):
        return ",".join(map(_text, value))
    return f"{value:.10g}" if isinstance(value, float) else str(value)
