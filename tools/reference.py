# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the reference pages that follow from the code: `python tools/reference.py`.

The tables of docs/reference/job-file.md, between two comments, are what the cycles declare; docs/reference/cli.md is
what the commands declare; docs/reference/shapes.md and its pictures are what the shapes of the library declare.
tests/unit/job/test_jobs_page.py, tests/unit/cli/test_cli_page.py and tests/unit/drawing/test_shapes_page.py fail when a
page is behind the code.
"""

from __future__ import annotations

import inspect
import os
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args, get_origin
from unittest.mock import patch

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))

import click  # noqa: E402
from pydantic import BaseModel  # noqa: E402

from CNCStepper.cli.common.language import OVERRIDE, look_up  # noqa: E402
from CNCStepper.cli.main import FAMILIES, OTHER_NAMES, group  # noqa: E402
from CNCStepper.cycles.catalogue import CYCLES, cycle_class  # noqa: E402
from CNCStepper.cycles.holes.hole_parameters import PATTERNS  # noqa: E402
from CNCStepper.cycles.parameter import Declared, Parameters, declared  # noqa: E402
from CNCStepper.cycles.turning.turning_operation import TURNING_OPERATIONS  # noqa: E402
from CNCStepper.cycles.turning.turning_parameters import TurningParameters  # noqa: E402
from CNCStepper.drawing.shape_library.declaration import LibraryShape  # noqa: E402
from CNCStepper.drawing.shape_library.shape_families import FAMILIES as SHAPE_FAMILIES  # noqa: E402
from CNCStepper.drawing.shape_library.shape_families import shapes_of  # noqa: E402
from CNCStepper.drawing.writers.svg_writer import path_data  # noqa: E402
from CNCStepper.job.shapes import SHAPE_KEYS  # noqa: E402

PAGE = ROOT / "docs" / "reference" / "job-file.md"
BEGIN, END = "<!-- written by tools/reference.py -->\n", "<!-- end of what tools/reference.py writes -->\n"
CLI_PAGE = PAGE.with_name("cli.md")
SHAPES_PAGE, SHAPE_PICTURES = PAGE.with_name("shapes.md"), ROOT / "docs" / "pictures" / "shapes"
PICTURE_PIXELS, PICTURE_MARGIN = 160.0, 0.08
HEAD = ["| key | value | default | |", "|---|---|---|---|"]
MODEL = "pocket"  # whose keys others have too, beside their own
TURNING_HEAD = """## Operations of a lathe

`turn_rough`, `turn_bore` and `turn_finish` have the name of a `profile`, `turn_thread` may. [The guide to
turning](../user-guide/turning.md) has the other tables of a lathe's job. Every operation has a `tool` and may have
"""


@dataclass(frozen=True)
class Words:
    """The words of the pages that no code declares, in a language of the command line."""

    language: str = "en"
    cli_head: str = """# Command line

Every command and its options, as `cncstepper COMMAND --help` prints them. `python tools/reference.py` writes this page
from the code. [The user guide](../user-guide/command-line.md) shows the commands at work.
"""
    shapes_head: str = """# Library of shapes

A job file draws a shape of the library by its kind and its dimensions. Dimensions that are left out have the values in
the table. `python tools/reference.py` writes this page and its pictures from the code.

```
[[shape]]
name = "flange"
library = { kind = "flange", outer_diameter_mm = 90, holes = 8, offset_mm = [60, 60], rotation_deg = 22.5 }
```

`offset_mm` moves the shape's zero, the cross in its picture, after `rotation_deg` has turned it. `part = "outline"` or
`part = "holes"` takes some of its curves: a contour takes all, a drill the holes. Dimensions that do not go together
are refused.
"""
    option_table: str = "| option | value | |"
    key_table: str = "| key | value | default | |"
    other_name: str = "Another name of [`{0}`](#cncstepper-{0})."
    repeats: str = "may be given more than once"
    required: str = "required"
    default: str = "default: {0}"
    integer: str = "integer"
    number: str = "number"
    above: str = "above"
    least: str = "from"
    most: str = "to"


ENGLISH = Words()
PORTUGUESE = Words(
    language="pt",
    cli_head="""# Linha de comando

Todos os comandos e as suas opções, como `cncstepper COMANDO --help` os imprime.
[O guia](../user-guide/command-line.md) mostra os comandos em uso.
""",
    shapes_head="""# Biblioteca de formas

Um arquivo de trabalho desenha uma forma da biblioteca pelo tipo e pelas dimensões. Dimensões que faltam têm os
valores da tabela.

```
[[shape]]
name = "flange"
library = { kind = "flange", outer_diameter_mm = 90, holes = 8, offset_mm = [60, 60], rotation_deg = 22.5 }
```

`offset_mm` move o zero da forma, a cruz na figura, depois que `rotation_deg` a girou. `part = "outline"` ou
`part = "holes"` toma algumas das curvas: um contorno toma todas, uma furação os furos. Dimensões que não combinam
são recusadas.
""",
    option_table="| opção | valor | |",
    key_table="| chave | valor | padrão | |",
    other_name="Outro nome de [`{0}`](#cncstepper-{0}).",
    repeats="pode ser dada mais de uma vez",
    required="obrigatória",
    default="padrão: {0}",
    integer="inteiro",
    number="número",
    above="acima de",
    least="de",
    most="a",
)


def tables() -> str:
    """Return the reference of all cycles and patterns in Markdown, then of the lathe's cycles."""
    known = list(rows_of_cycle(cycle_class(MODEL)))
    parts = [cycle_part(name, known if name != MODEL else []) for name in CYCLES]
    common = list(rows(declared(TurningParameters), ""))
    turning = [TURNING_HEAD, *HEAD, *common, "", *(turning_part(name, common) for name in TURNING_OPERATIONS)]
    return "\n".join([*parts, *map(pattern_part, PATTERNS), *turning])


def turning_part(name: str, common: list[str]) -> str:
    """Return heading and table of a cycle of the lathe, without the rows that all have."""
    own = [row for row in rows_of_cycle(TURNING_OPERATIONS[name]) if row not in common]
    return "\n".join([f"### `{name}`", "", *HEAD, *own, ""])


def cycle_part(name: str, known: list[str]) -> str:
    """Return heading and table of a cycle; `known` are rows that need not stand here when it has nearly all of them."""
    rows = list(rows_of_cycle(cycle_class(name)))
    own = [row for row in rows if row not in known]
    few = len(known) and len(rows) - len(own) > len(known) - 2
    shapes = ", ".join(f"`{key.says}`" for key in SHAPE_KEYS.get(name, ()))
    lines = [f"### `{name}`", "", *([f"Shapes: {shapes}", ""] if shapes else []), *HEAD, *(own if few else rows)]
    return "\n".join([*lines, *(["", f"The other keys are those of `{MODEL}`."] if few else []), ""])


def rows_of_cycle(model: type[BaseModel]) -> Iterator[str]:
    """Yield the rows of a cycle's table."""
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
    if field.type is str:
        return "a text"
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


def cli_page(words: Words = ENGLISH) -> str:
    """Return the reference of the command line in Markdown, a section a family of commands."""
    with patch.dict(os.environ, {OVERRIDE: words.language}):
        return "\n".join(cli_parts(words))


def cli_parts(words: Words) -> Iterator[str]:
    """Yield the parts of the reference, in the language in which this process prints help."""
    context = click.Context(group, info_name="cncstepper")
    yield words.cli_head
    for title, verbs in FAMILIES.values():
        yield f"## {look_up(title)}\n"
        for verb in verbs:
            if other := OTHER_NAMES.get(verb):
                yield f"### `cncstepper {verb}`\n\n{words.other_name.format(other)}\n"
                continue
            command = group.get_command(context, verb)
            assert command is not None
            yield from command_parts(command, click.Context(command, info_name=verb, parent=context), words)


def command_parts(command: click.Command, context: click.Context, words: Words) -> Iterator[str]:
    """Yield the parts of a command: usage, help text and table of options; then those of its sub-commands."""
    level = "#" * (2 + context.command_path.count(" "))
    yield f"{level} `{context.command_path}`\n"
    pieces = [argument(param) for param in command.params if isinstance(param, click.Argument)]
    pieces = ["COMMAND"] if isinstance(command, click.Group) else pieces
    yield f"```\n{' '.join([context.command_path, '[OPTIONS]', *pieces])}\n```\n"
    yield from map(paragraph, inspect.cleandoc(command.help or "").split("\n\n"))
    options = [param for param in command.params if isinstance(param, click.Option) and not param.hidden]
    if options:
        rows = (option_row(option, words) for option in options)
        yield "\n".join([words.option_table, "|---|---|---|", *rows, ""])
    if isinstance(command, click.Group):
        for name in command.list_commands(context):
            below = command.get_command(context, name)
            assert below is not None
            yield from command_parts(below, click.Context(below, info_name=name, parent=context), words)


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


def option_row(option: click.Option, words: Words) -> str:
    """Return the row of an option: its names, the value that it takes, its help and its default."""
    names = ", ".join(f"`{name}`" for name in [*option.opts, *option.secondary_opts])
    says_so = words.repeats in (option.help or "")
    more = [words.required] * option.required + [words.repeats] * (option.multiple and not says_so)
    if option.show_default and option.default not in (None, False):
        more.append(words.default.format(option.default))
    notes = f" [{'; '.join(more)}]" if more else ""
    return f"| {names} | {option_value(option, words)} | {escaped(option.help or '')}{escaped(notes)} |"


def option_value(option: click.Option, words: Words) -> str:
    """Return what an option takes, "" for one that is given without a value."""
    if option.is_flag or option.count:
        return ""
    kind = option.type
    if isinstance(kind, click.Choice):
        return ", ".join(f"`{choice}`" for choice in kind.choices)
    if isinstance(kind, click.IntRange | click.FloatRange):
        number = words.integer if isinstance(kind, click.IntRange) else words.number
        least = "" if kind.min is None else f" {words.above if kind.min_open else words.least} {kind.min:g}"
        most = "" if kind.max is None else f" {words.most} {kind.max:g}"
        return f"{number}{least}{most}"
    return escaped(option.metavar or kind.name.upper())


def shapes_page(words: Words = ENGLISH, tr: Callable[[str], str] = str) -> str:
    """Return the reference of the library in Markdown, a section a family; tr: translates what the shapes declare."""
    parts = [words.shapes_head]
    for title in SHAPE_FAMILIES:
        parts.append(f"## {tr(title)}\n")
        parts += [shape_part(shape, words, tr) for shape in shapes_of(title)]
    return "\n".join(parts)


def shape_part(shape: LibraryShape, words: Words, tr: Callable[[str], str]) -> str:
    """Return heading, picture and table of a shape."""
    rows = [
        f"| `{key}` | {one.bounds.words} | `{one.usual:g}` | {tr(one.title)} |" for key, one in shape.dimensions.items()
    ]
    picture = f"![{tr(shape.title)}](../pictures/shapes/{shape.kind}.svg)"
    head = [words.key_table, HEAD[1]]
    return "\n".join([f"### `{shape.kind}`", "", tr(shape.about), "", picture, "", *head, *rows, ""])


def shape_picture(shape: LibraryShape) -> str:
    """Return a picture of a shape with its usual dimensions as SVG; a cross is its zero."""
    figure = shape.figure({})
    left, low, right, high = figure.outline.box_mm
    left, low, right, high = min(left, 0.0), min(low, 0.0), max(right, 0.0), max(high, 0.0)
    size = max(right - left, high - low)
    margin = PICTURE_MARGIN * size
    box = [left - margin, -margin, right - left + 2.0 * margin, high - low + 2.0 * margin]
    wide, tall = (PICTURE_PIXELS * side / size for side in box[2:])
    line, arm = size / 130.0, size / 25.0
    paths = "".join(path_data(curve, high) for curve in figure.curves)
    cross = f"M{-arm:.4g} {high:.6g}H{arm:.4g}M0 {high - arm:.6g}V{high + arm:.6g}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.0f}" height="{tall:.0f}" '
        f'viewBox="{" ".join(f"{value:.6g}" for value in box)}">\n'
        f'<path fill="#cfd8e6" fill-rule="evenodd" stroke="#1f4e9e" stroke-width="{line:.3g}" d="{paths}"/>\n'
        f'<path fill="none" stroke="#c0267e" stroke-width="{line:.3g}" d="{cross}"/>\n</svg>\n'
    )


def shape_pictures() -> dict[str, str]:
    """Return the pictures of all shapes by the names of their files."""
    return {f"{shape.kind}.svg": shape_picture(shape) for title in SHAPE_FAMILIES for shape in shapes_of(title)}


def escaped(text: str) -> str:
    """Return a text in which Markdown reads no table, no tag and no emphasis."""
    for sign in "|<*":
        text = text.replace(sign, f"\\{sign}")
    return text


if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text("utf-8")), "utf-8", newline="\n")
    CLI_PAGE.write_text(cli_page(), "utf-8", newline="\n")
    SHAPES_PAGE.write_text(shapes_page(), "utf-8", newline="\n")
    SHAPE_PICTURES.mkdir(exist_ok=True)
    for name, picture in shape_pictures().items():
        (SHAPE_PICTURES / name).write_text(picture, "utf-8", newline="\n")
