# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files that a task takes along, so that a worker on another computer needs no folder of ours.

    {"/home/ana/gasket.dxf": bytes, ...}  ──►  TEMPORARY/home/ana/gasket.dxf     the same folders below another root

Relative paths between the files stay what they are, so a job file that is made there is right here too.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from CNCStepper import text_json
from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.input_file import read_input
from CNCStepper.job.templates.drawing_job import FILES
from CNCStepper.job.templates.template import Template
from CNCStepper.machine.files.profile_files import own_path
from CNCStepper.machine.profile import profile_names

MOST_BYTES = 256_000_000


@lru_cache(maxsize=64)
def file_bytes(path: Path) -> bytes:
    """Return the bytes of an input; an order reads its templates and drawings many times."""
    return read_input(path, MOST_BYTES)


def whole(path: Path) -> str:
    """Return the name under which a file travels."""
    return str(path.absolute())


def below(root: Path, name: str) -> Path:
    """Return where a file that travels under `name` lies below another root."""
    path = Path(name)
    return root / path.relative_to(path.anchor)


def unpack(files: Mapping[str, bytes], root: Path) -> None:
    """Write files below a root."""
    for name, data in files.items():
        path = below(root, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def template_files(template: Template) -> dict[str, bytes]:
    """Return the bytes of a template and of the files that it names: machine, chart, tools.

    Raises JobError for one that is not there.
    """
    paths = [template.path, *_named(template)]
    return {whole(path): file_bytes(path) for path in paths}


def _named(template: Template) -> Iterator[Path]:
    for key in FILES:
        value = template.job.get(key)
        name = value.get("file") if isinstance(value, Mapping) else value
        if not isinstance(name, str):
            continue
        if key != "machine" or name not in profile_names():
            yield template.path.parent / name
        elif own := own_path(name):
            yield own


def own_machine(template: Template) -> str:
    """Return under what name the profile of a template's machine travels, "" where it is not one of the user's own."""
    name = template.job.get("machine")
    own = own_path(name) if isinstance(name, str) else None
    return whole(own) if own else ""


def error_below(root: Path, error: CNCStepperError) -> dict[str, Any]:
    """Return an error as plain data, the paths in it without the root."""
    text = text_json.dumps(error_to_json(error))
    content: dict[str, Any] = json.loads(text.replace(json.dumps(str(root))[1:-1], ""))
    return content
