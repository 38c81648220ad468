# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job as the text of a job file, which gives the same job when it is read.

    Job ──► operations whose curves have become names ──► TOML
            [[shape]] tables, each with its curve

Numbers are written with all their digits, so that the program of the job that is read back is the same byte for byte.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place
from CNCStepper.job.model import Job, save_job
from CNCStepper.job.shapes import SHAPE_KEYS, ShapeKey
from CNCStepper.machine.files.toml_reader import MOST_BYTES
from CNCStepper.machine.files.toml_text import key_text, value_text
from CNCStepper.output_files import MADE_BY
from CNCStepper.quantities import MOST_ITEMS

Content = dict[str, Any]


def write_job_file(job: Job) -> str:
    """Return the job as the text of a job file, its curves within it."""
    return content_text(job_content(job), f"a job, {MADE_BY}")


def save_job_file(job: Job, path: Path) -> None:
    """Write the job into a file, as TOML, or as JSON where the name ends so.

    Raises JobError for a job whose TOML would be too long to be read.
    """
    if path.suffix.casefold() == ".json":
        save_job(job, path)
        return
    data = write_job_file(job).encode("utf-8")
    if len(data) > MOST_BYTES:
        value, limit = f"{len(data) / 1e6:.3g} MB", f"{MOST_BYTES / 1e6:.3g} MB"
        what, advice = "the job is too long for a file that people read", "end the name in .json"
        raise JobError("job-large", what, value=value, limit=limit, advice=advice, place=Place(str(path)))
    write_whole(path, data)


def content_text(content: Mapping[str, Any], title: str) -> str:
    """Return the content of a job file as TOML: keys, then tables, then lists of tables; None is left out."""
    tables = {key: one for key, one in content.items() if isinstance(one, Mapping)}
    lists = {key: one for key, one in content.items() if _is_list_of_tables(one)}
    plain = {key: one for key, one in content.items() if key not in tables | lists}
    sections = [*_table([f"# {title}"], plain)]
    for key, table in tables.items():
        sections += ["", *_table([f"[{key_text(key)}]"], table)]
    for key, rows in lists.items():
        for row in rows:
            sections += ["", *_table([f"[[{key_text(key)}]]"], row)]
    return "\n".join(sections) + "\n"


def _is_list_of_tables(value: Any) -> bool:
    return isinstance(value, list | tuple) and bool(value) and all(isinstance(one, Mapping) for one in value)


def _table(head: list[str], table: Mapping[str, Any]) -> Iterator[str]:
    yield from head
    for key, value in table.items():
        if value is not None:
            yield f"{key_text(key)} = {value_text(value)}"


def job_content(job: Job) -> Content:
    """Return the job as tables: what has its default is left out, curves are shapes with names."""
    apart = {"operation", "tool", "cut_data", "stock", "clamp"}
    content = job.model_dump(mode="json", exclude_defaults=True, exclude=apart)
    content["stock"] = job.stock.model_dump(mode="json", exclude_none=True)
    if job.cut_data is not None:
        content["cut_data"] = job.cut_data.model_dump(mode="json", exclude_none=True)
    content["clamp"] = [clamp.model_dump(mode="json") for clamp in job.clamp] or None
    content["tool"] = [tool.model_dump(mode="json", exclude_defaults=True) for tool in job.tool]
    shapes: list[Content] = []
    operations = [_operation(operation, shapes) for operation in job.operation]
    content["shape"] = shapes if len(shapes) <= MOST_ITEMS["shapes"] else None
    if content["shape"] is None:  # too many names: the curves stay in their operations
        operations = [operation.model_dump(mode="json", exclude_none=True) for operation in job.operation]
    return content | {"shape": content["shape"] or None, "operation": operations}


def _operation(operation: Any, shapes: list[Content]) -> Content:
    content: Content = {"cycle": operation.cycle, "tool": operation.tool}
    content |= operation.model_dump(mode="json", exclude_none=True)
    for key in SHAPE_KEYS.get(operation.cycle, ()):
        _name_curves(content, key, shapes)
    return content


def _name_curves(content: Content, key: ShapeKey, shapes: list[Content]) -> None:
    """Move the curves of one field into shapes, and let the operation name these."""
    *tables, field = key.field.split(".")
    for table in tables:
        if not isinstance(content.get(table), dict):
            return
        content = content[table]
    curves = content.get(field)
    if key.says != key.field or not curves or isinstance(curves[0], str):
        return
    names = [f"{field}-{len(shapes) + number}" for number in range(1, len(curves) + 1)]
    shapes += [{"name": name, "curve": curve} for name, curve in zip(names, curves, strict=True)]
    content[field] = names
