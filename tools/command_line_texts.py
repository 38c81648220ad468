# SPDX-License-Identifier: LGPL-2.1-or-later
"""The texts of the command line, and the catalogue in which Python's gettext finds their translations.

CNCStepper/cli/common/language.py looks them up: the help that the commands declare, the `Text("…")` of the verbs, and
what click itself says. They are in the same .ts as those of the window; the catalogue for gettext is derived from it.
"""

from __future__ import annotations

import ast
import re
import struct
import sys
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import click

ROOT = Path(__file__).resolve().parents[1]
VERBS = ROOT / "CNCStepper" / "cli"
CATALOGUE = ROOT / "CNCStepper" / "locale" / "pt" / "LC_MESSAGES" / "cncstepper.mo"
HEADER = "Content-Type: text/plain; charset=UTF-8\nLanguage: pt_BR\nPlural-Forms: nplurals=2; plural=(n > 1);\n"
SAID_BY = ("Text", "look_up", "show_text")
REFUSING = {"UsageError", "BadParameter", "ClickException", "fail"}
SHOWING = {"echo", "secho", "confirm", "prompt", "pause"}  # of click
DATA = {"virtual {0} at {1}"}  # lines that a program reads: the window that started a virtual machine
NO_WORDS = re.compile(r"\{[^{}]*\}|^cncstepper:")
WORD = re.compile(r"[^\W\d_]{3,}")
OF_CLICK = (
    "Aborted!",
    "Argument {name!r} takes {nargs} values.",
    "Choose from:\n\t{choices}",
    "Commands",
    "Could not open file {filename!r}: {message}",
    "Do you want to continue?",
    "Error: invalid input",
    "Error: {message}",
    "Invalid value for {param_hint}: {message}",
    "Invalid value: {message}",
    "Missing argument",
    "Missing command.",
    "Missing option",
    "Missing parameter",
    "Missing parameter: {param_name}",
    "No such command {name!r}.",
    "No such option {name!r}.",
    "Option {name!r} does not take a value.",
    "Options",
    "Positional arguments",
    "Show the version and exit.",
    "Show this message and exit.",
    "Try '{command} {option}' for help.",
    "Usage:",
    "default: {default}",
    "directory",
    "file",
    "path",
    "required",
    "unknown error",
    "{name} {filename!r} does not exist.",
    "{name} {filename!r} is a directory.",
    "{name} {filename!r} is a file.",
    "{name} {filename!r} is not readable.",
    "{name} {filename!r} is not writable.",
    "{value!r} is not a valid boolean. Recognized values: {states}",
    "{value!r} is not a valid {number_type}.",
    "{value} is not in the range {range}.",
)
PLURALS_OF_CLICK = {
    "(Did you mean one of: {possibilities}?)": "Did you mean {possibility}?",
    "Got unexpected extra arguments ({args})": "Got unexpected extra argument ({args})",
    "Option {name!r} requires {nargs} arguments.": "Option {name!r} requires an argument.",
    "Takes {nargs} values but {len} were given.": "Takes {nargs} values but 1 was given.",
    "{value!r} is not one of {choices}.": "{value!r} is not {choice}.",
}


def texts_of_command_line() -> Iterator[tuple[str, str]]:
    """Yield every text that the command line shows in the language of the locale, and the place of it."""
    for text in (*OF_CLICK, *PLURALS_OF_CLICK, *PLURALS_OF_CLICK.values()):
        yield text, "click"
    for text in help_texts():
        yield text, "the help of the command line"
    for path in sorted(VERBS.rglob("*.py")):
        for text, line in texts_said(path.read_text("utf-8")):
            yield text, f"{path.relative_to(ROOT).as_posix()}:{line}"


def help_texts() -> Iterator[str]:
    """Yield every text of every command's --help as the catalogue holds it."""
    sys.path.append(str(ROOT))
    from CNCStepper.cli.common.language import catalogued
    from CNCStepper.cli.main import FAMILIES, group

    for command in commands_of(group):
        for text in helps_of(command):
            yield from catalogued(text)
    for title, verbs in FAMILIES.values():
        yield from (title, *verbs.values())


def commands_of(command: click.Command) -> Iterator[click.Command]:
    """Yield a command and all commands below it."""
    import click

    yield command
    if isinstance(command, click.Group):
        context = click.Context(command)
        for name in command.list_commands(context):
            if member := command.get_command(context, name):
                yield from commands_of(member)


def helps_of(command: click.Command) -> list[str]:
    """Return the help texts of a command and its parameters, as they are declared."""
    texts = (command.help, command.short_help, *(getattr(param, "help", None) for param in command.params))
    return [text for text in texts if text]


def texts_said(source: str) -> Iterator[tuple[str, int]]:
    """Yield the texts that a module of a verb marks, and their lines."""
    for node in calls(source):
        if called(node) in SAID_BY and node.args and isinstance(node.args[0], ast.Constant):
            text = str(node.args[0].value)
            if WORD.search(NO_WORDS.sub("", text)):
                yield text, node.lineno


def unmarked(source: str) -> Iterator[tuple[int, str]]:
    """Yield lines at which a verb refuses, prints or asks with words that no catalogue can hold, and the words."""
    for node in calls(source):
        if called(node) in REFUSING:
            yield from ((node.lineno, ast.unparse(each)) for each in node.args[:1] if is_string(each))
        elif called(node) in SHOWING:
            yield from ((node.lineno, words) for each in node.args[:1] for words in plain_words(each))


def is_string(node: ast.expr) -> bool:
    """Return whether a string stands there, with values or without."""
    return isinstance(node, ast.JoinedStr | ast.Constant)


def plain_words(node: ast.expr) -> Iterator[str]:
    """Yield the strings with words in what is printed; the arguments of calls in it are looked at by themselves."""
    if is_string(node):
        if WORD.search(NO_WORDS.sub("", words := template(node))) and words not in DATA:
            yield words
    elif not isinstance(node, ast.Call | ast.Subscript):
        for part in ast.iter_child_nodes(node):
            if isinstance(part, ast.expr):
                yield from plain_words(part)


def template(node: ast.expr) -> str:
    """Return a string of the source, {0} and so on for its values."""
    numbers = iter(range(len(ast.unparse(node))))
    parts = node.values if isinstance(node, ast.JoinedStr) else [node]
    return "".join(str(part.value) if isinstance(part, ast.Constant) else f"{{{next(numbers)}}}" for part in parts)


def calls(source: str) -> Iterator[ast.Call]:
    """Yield the calls of a module."""
    yield from (node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call))


def called(node: ast.Call) -> str:
    """Return the last name of what is called."""
    return ast.unparse(node.func).rpartition(".")[2]


def catalogue_bytes(translations: Mapping[str, str]) -> bytes:
    """Return the catalogue that gettext reads (.mo) of texts and their translations."""
    plurals = {
        f"{one}\0{many}": f"{translations[one]}\0{translations[many]}"
        for many, one in PLURALS_OF_CLICK.items()
        if translations.get(one) and translations.get(many)
    }
    entries = {text: said for text, said in translations.items() if text and said} | plurals | {"": HEADER}
    pairs = sorted((text.encode("utf-8"), said.encode("utf-8")) for text, said in entries.items())
    texts, said = zip(*pairs, strict=True)
    begin = 28 + 16 * len(pairs)
    head = struct.pack("<7I", 0x950412DE, 0, len(pairs), 28, 28 + 8 * len(pairs), 0, begin)
    tables = _table(texts, begin) + _table(said, begin + sum(len(text) + 1 for text in texts))
    return head + tables + b"".join(part + b"\0" for part in (*texts, *said))


def _table(parts: Iterable[bytes], begin: int) -> bytes:
    """Return lengths and places of texts that follow each other from `begin`."""
    table = b""
    for part in parts:
        table += struct.pack("<2I", len(part), begin)
        begin += len(part) + 1
    return table
