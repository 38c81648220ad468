# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the reference pages that follow from the code: `python tools/reference.py`.

The tables of docs/reference/job-file.md, between two comments, are what the cycles declare; docs/reference/cli.md is
what the commands declare. tests/unit/job/test_jobs_page.py and tests/unit/cli/test_cli_page.py fail when a page is
behind the code.
"""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, get_args, get_origin

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))

import click  # noqa: E402
from pydantic import BaseModel  # noqa: E402

from CNCStepper.cli.main import FAMILIES, OTHER_NAMES, group  # noqa: E402
from CNCStepper.cycles.catalogue import CYCLES  # noqa: E402
from CNCStepper.cycles.holes.hole_parameters import PATTERNS  # noqa: E402
from CNCStepper.cycles.parameter import Declared, Parameters, declared  # noqa: E402
from CNCStepper.job.shapes import SHAPE_KEYS  # noqa: E402

PAGE = ROOT / "docs" / "reference" / "job-file.md"
BEGIN, END = "<!-- written by tools/reference.py -->\n", "<!-- end of what tools/reference.py writes -->\n"
CLI_PAGE = PAGE.with_name("cli.md")
CLI_HEAD = """# Command line

Every command and its options, as `cncstepper COMMAND --help` prints them. `python tools/reference.py` writes this page
from the code. [The user guide](../user-guide/command-line.md) shows the commands at work.
"""
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


def cli_page() -> str:
    """Return the reference of the command line in Markdown, a section a family of commands."""
    context = click.Context(group, info_name="cncstepper")
    parts = [CLI_HEAD]
    for title, verbs in FAMILIES.values():
        parts.append(f"## {title}\n")
        for verb in verbs:
            if other := OTHER_NAMES.get(verb):
                parts.append(f"### `cncstepper {verb}`\n\nAnother name of [`{other}`](#cncstepper-{other}).\n")
                continue
            command = group.get_command(context, verb)
            assert command is not None
            parts += command_parts(command, click.Context(command, info_name=verb, parent=context))
    return "\n".join(parts)


def command_parts(command: click.Command, context: click.Context) -> Iterator[str]:
    """Yield the parts of a command: usage, help text and table of options; then those of its sub-commands."""
    level = "#" * (2 + context.command_path.count(" "))
    yield f"{level} `{context.command_path}`\n"
    pieces = [argument(param) for param in command.params if isinstance(param, click.Argument)]
    pieces = ["COMMAND"] if isinstance(command, click.Group) else pieces
    yield f"```\n{' '.join([context.command_path, '[OPTIONS]', *pieces])}\n```\n"
    yield from map(paragraph, inspect.cleandoc(command.help or "").split("\n\n"))
    options = [param for param in command.params if isinstance(param, click.Option) and not param.hidden]
    if options:
        yield "\n".join(["| option | value | |", "|---|---|---|", *map(option_row, options), ""])
    if isinstance(command, click.Group):
        for name in command.list_commands(context):
            below = command.get_command(context, name)
            assert below is not None
            yield from command_parts(below, click.Context(below, info_name=name, parent=context))


def argument(param: click.Argument) -> str:
    """Return an argument as a usage line has it."""
    name = param.human_readable_name.upper() + ("..." if param.nargs != 1 else "")
    return name if param.required else f"[{name}]"


def paragraph(text: str) -> str:
    """Return a paragraph of a help text; one whose lines click keeps as they are becomes a block of code."""
    if text.startswith("\b"):
        lines = text.removeprefix("\b").strip("\n")
        return f"```\n{lines}\n```\n"
    return f"{escaped(text)}\n"


def option_row(option: click.Option) -> str:
    """Return the row of an option: its names, the value that it takes, its help and its default."""
    names = ", ".join(f"`{name}`" for name in [*option.opts, *option.secondary_opts])
    repeats = "may be given more than once"
    more = ["required"] * option.required + [repeats] * (option.multiple and repeats not in (option.help or ""))
    if option.show_default and option.default not in (None, False):
        more.append(f"default: {option.default}")
    notes = f" [{'; '.join(more)}]" if more else ""
    return f"| {names} | {option_value(option)} | {escaped(option.help or '')}{escaped(notes)} |"


def option_value(option: click.Option) -> str:
    """Return what an option takes, "" for one that is given without a value."""
    if option.is_flag or option.count:
        return ""
    kind = option.type
    if isinstance(kind, click.Choice):
        return ", ".join(f"`{choice}`" for choice in kind.choices)
    if isinstance(kind, click.IntRange | click.FloatRange):
        number = "integer" if isinstance(kind, click.IntRange) else "number"
        least = "" if kind.min is None else f" {'above' if kind.min_open else 'from'} {kind.min:g}"
        most = "" if kind.max is None else f" to {kind.max:g}"
        return f"{number}{least}{most}"
    return escaped(option.metavar or kind.name.upper())


def escaped(text: str) -> str:
    """Return a text in which Markdown reads no table, no tag and no emphasis."""
    for sign in "|<*":
        text = text.replace(sign, f"\\{sign}")
    return text


if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text("utf-8")), "utf-8", newline="\n")
    CLI_PAGE.write_text(cli_page(), "utf-8", newline="\n")
