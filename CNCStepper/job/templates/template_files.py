# SPDX-License-Identifier: LGPL-2.1-or-later
"""The templates of a shop as files: where they lie, and how one is written.

CONFIG/cncstepper/templates/NAME.toml       CONFIG as in machine/files/profile_files.py
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, MissingPackage, Place, Text
from CNCStepper.job.files.job_text import content_text
from CNCStepper.job.templates.drawing_job import FILES
from CNCStepper.job.templates.template import template_of
from CNCStepper.machine.files.profile_files import SUFFIX, config_folder
from CNCStepper.machine.profile import profile_names
from CNCStepper.output_files import MADE_BY
from CNCStepper.safe_text import printable

LONGEST = 60  # letters of a name
NOT_IN_NAMES = set('<>:"/\\|?*')  # that file systems refuse in the name of a file
RESERVED = {"con", "prn", "aux", "nul", *(f"{port}{number}" for port in ("com", "lpt") for number in range(1, 10))}


def template_folder() -> Path:
    """Return the folder of the shop's templates, which need not be there; raises MissingPackage."""
    return config_folder() / "templates"


def template_paths() -> list[Path]:
    """Return the files of the shop's templates."""
    try:
        return sorted(template_folder().glob(f"*{SUFFIX}"))
    except (OSError, MissingPackage):
        return []


def named_template(name: str) -> Path:
    """Return the file of the shop's template of a name that a person types; raises JobError for one that cannot be."""
    name = name.strip()
    bad = NOT_IN_NAMES & set(name) or name[:1] == "." or name[-1:] == "." or not name.isprintable()
    if not name or len(name) > LONGEST or bad or name.partition(".")[0].casefold() in RESERVED:
        what = Text("a template cannot be named '{name}'", name=printable(name, LONGEST))
        raise JobError("template-name", what, advice='give it a short name without < > : " / \\ | ? *')
    return template_folder() / f"{name}{SUFFIX}"


def with_whole_paths(content: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """Return the content of a template of a folder with the files that it names by their whole paths."""
    return {key: _whole(key, value, folder) if key in FILES else value for key, value in content.items()}


def _whole(key: str, value: Any, folder: Path) -> Any:
    if isinstance(value, Mapping):
        return {name: _whole(name, one, folder) if name == "file" else one for name, one in value.items()}
    if not isinstance(value, str) or (key == "machine" and value in profile_names()):
        return value
    return (folder / value).resolve().as_posix()


def write_template(content: Mapping[str, Any], path: Path) -> None:
    """Write a template into a file, its folder too; raises JobError for what is none, or cannot be written."""
    template_of(dict(content), path)
    write_checked(content, path)


def write_checked(content: Mapping[str, Any], path: Path) -> None:
    """Write the content of a template that is known to be one; raises JobError where it cannot be written."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, content_text(content, f"a template, {MADE_BY}").encode("utf-8"))
    except OSError as error:
        what = Text("the template cannot be written: {error}", error=error.strerror or error)
        advice = "choose a folder that exists and that you may write to"
        raise JobError("template-unwritable", what, advice=advice, place=Place(str(path))) from error
