# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the tables of docs/reference/job-file.md from what the cycles declare: `python tools/reference.py`.

They stand between two comments; tests/unit/job/test_jobs_page.py fails when they are behind the code.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, get_args, get_origin

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))

from pydantic import BaseModel  # noqa: E402

from CNCStepper.cycles.catalogue import CYCLES  # noqa: E402
from CNCStepper.cycles.holes.hole_parameters import PATTERNS  # noqa: E402
from CNCStepper.cycles.parameter import Declared, Parameters, declared  # noqa: E402
from CNCStepper.job.shapes import SHAPE_KEYS  # noqa: E402

PAGE = ROOT / "docs" / "reference" / "job-file.md"
BEGIN, END = "<!-- written by tools/reference.py -->\n", "<!-- end of what tools/reference.py writes -->\n"
HEAD = ["| key | value | default | |", "|---|---|---|---|"]
MODEL = "pocket"  # whose keys others have too, beside their own


def tables() -> str:
    """Return the reference of all cycles and patterns in Markdown."""
    known = list(rows_of_cycle(MODEL))
    parts = [cycle_part(name, known if name != MODEL else []) for name in CYCLES]
    return "\n".join([*parts, *map(pattern_part, PATTERNS)])


def cycle_part(name: str, known: list[str]) -> str:
    """Return heading and table of a cycle; `known` are rows that need not stand here when it has nearly all of them."""
    rows = list(rows_of_cycle(name))
    own = [row for row in rows if row not in known]
    few = len(known) and len(rows) - len(own) > len(known) - 2
    shapes = ", ".join(f"`{key.says}`" for key in SHAPE_KEYS.get(name, ()))
    lines = [f"### `{name}`", "", *([f"Shapes: {shapes}", ""] if shapes else []), *HEAD, *(own if few else rows)]
    return "\n".join([*lines, *(["", f"The other keys are those of `{MODEL}`."] if few else []), ""])


def rows_of_cycle(name: str) -> Iterator[str]:
    """Yield the rows of a cycle's table."""
    model = CYCLES[name]
    parameters = next(
        base for base in model.__mro__ if issubclass(base, Parameters) and not issubclass(base, BaseModel)
    )
    for field in declared(parameters):
        if field.table:
            yield from rows(declared(field.table.parameters), f"{field.key}.")
        elif field.shown:
            default = model.model_fields[field.key].get_default()
            yield row(field, field.key, default if not model.model_fields[field.key].is_required() else None)


def pattern_part(parameters: type) -> str:
    """Return heading and table of a pattern of holes."""
    kind, *fields = declared(parameters)
    return "\n".join([f'### `pattern.kind = "{kind.choices[0]}"`', "", *HEAD, *rows(fields, "pattern."), ""])


def rows(fields: Iterable[Declared], table: str) -> Iterator[str]:
    """Yield the rows of fields in a table."""
    for field in fields:
        if field.table:  # several values in a list
            explained = "; ".join(each.shown.help for each in field.rows if each.shown)
            yield f"| `{table}{field.key}` | [{', '.join(each.key for each in field.rows)}] | | {explained} |"
        elif field.shown:
            yield row(field, table + field.key, field.default)


def row(field: Declared, key: str, default: Any) -> str:
    """Return the row of a field; a default of None: the job file must give one."""
    assert field.shown is not None
    only = field.shown.only
    chooser = f"{key.rpartition('.')[0]}.{only[0]}".lstrip(".") if only and only[0] != "by" else ""
    when = f" (with `{chooser}` {' or '.join(map(toml, only[1]))})" if chooser and only else ""
    return f"| `{key}` | {value(field)} | {'' if default is None else toml(default)} | {field.shown.help}{when} |"


def value(field: Declared) -> str:
    """Return what a field takes, in words."""
    if field.choices:
        return ", ".join(map(toml, field.choices))
    if get_origin(field.type) is tuple:
        return "[[x, y], …]" if ... in get_args(field.type) else "[x, y], mm"
    return field.bounds.words if field.bounds else "true, false"


def toml(found: Any) -> str:
    """Return a value as a job file has it."""
    if isinstance(found, bool | str):
        return f"`{str(found).lower()}`" if isinstance(found, bool) else f'`"{found}"`'
    return f"`{list(found) if isinstance(found, tuple) else f'{found:g}'}`"


def page(text: str) -> str:
    """Return the page with the tables as they are to be."""
    above, _, rest = text.partition(BEGIN)
    return f"{above}{BEGIN}\n{tables()}\n{END}{rest.partition(END)[2]}"


if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text("utf-8")), "utf-8", newline="\n")
