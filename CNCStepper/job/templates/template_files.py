# SPDX-License-Identifier: LGPL-2.1-or-later
"""The templates of a shop as files: where they lie, and how one is written.

CONFIG/cncstepper/templates/NAME.toml       CONFIG as in machine/files/profile_files.py
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import MissingPackage
from CNCStepper.job.files.job_text import content_text
from CNCStepper.job.templates.drawing_job import FILES
from CNCStepper.job.templates.template import template_of
from CNCStepper.machine.files.profile_files import SUFFIX, config_folder
from CNCStepper.machine.profile import profile_names
from CNCStepper.output_files import MADE_BY


def template_folder() -> Path:
    """Return the folder of the shop's templates, which need not be there; raises MissingPackage."""
    return config_folder() / "templates"


def template_paths() -> list[Path]:
    """Return the files of the shop's templates."""
    try:
        return sorted(template_folder().glob(f"*{SUFFIX}"))
    except (OSError, MissingPackage):
        return []


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
    """Write a template into a file, its folder too; raises JobError for what is none."""
    template_of(dict(content), path)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, content_text(content, f"a template, {MADE_BY}").encode("utf-8"))
