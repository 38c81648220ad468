# SPDX-License-Identifier: LGPL-2.1-or-later
"""TOML written: single values, whole documents, and keys changed in a text whose comments stay.

    [axis.x]                              axis.x.steps_per_mm = 80
    steps_per_mm = 40      # measured     ───────────────────────►   steps_per_mm = 80      # measured

A text is changed line by line, read again, and compared with what it should hold. Where the two differ (a text that is
laid out in a way which the line editor does not know) the whole content is written anew, without the comments.
"""

from __future__ import annotations

import copy
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_HEADER = re.compile(r"\s*\[.*\]\s*(#.*)?")
_KEY = re.compile(r"""\s*((?:[A-Za-z0-9_.\s-]|"[^"]*"|'[^']*')+?)\s*=""")
COLUMNS = 100  # of a list on one line

Path = tuple[str, ...]


class Changed(NamedTuple):
    """A text with its new values, and whether its comments are still there."""

    text: str
    comments_kept: bool


def value_text(value: Any) -> str:
    """Return a value as TOML: numbers, booleans, strings, and lists and tables of them on one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        entries = ", ".join(f"{key_text(key)} = {value_text(one)}" for key, one in value.items() if one is not None)
        return f"{{ {entries} }}" if entries else "{}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(value_text(one) for one in value) + "]"
    if not isinstance(value, str):
        return repr(value)
    escaped = value.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(one if one.isprintable() else _escaped(one) for one in escaped) + '"'


def key_text(*path: str) -> str:
    """Return a dotted key; parts that are no bare keys are quoted."""
    return ".".join(part if _BARE.fullmatch(part) else value_text(part) for part in path)


def document_text(content: Mapping[str, Any], title: str = "") -> str:
    """Return a whole document: plain keys first, then its tables, each under its header; None is left out.

    title: a comment for its first line.
    """
    lines = [f"# {title}", ""] if title else []
    lines += _table_lines((), content)
    return "\n".join(lines).strip("\n") + "\n"


def changed_text(text: str, changes: Mapping[Path, Any]) -> Changed:
    """Return a document's text with other values at some keys; None takes a key or table out.

    Raises ValueError (of tomllib) where the text is no TOML, and KeyError with the path where a key leads into what is
    no table.
    """
    wanted = copy.deepcopy(tomllib.loads(text))
    edited = text
    for path, value in changes.items():
        put(wanted, path, value)
        edited = _edited(edited, path, wanted)
    if _reads_as(edited, wanted):
        return Changed(edited, True)
    return Changed(document_text(wanted), False)


def put(content: dict[str, Any], path: Path, value: Any) -> None:
    """Set a key of nested tables, or take it out where the value is None; raises KeyError where a part is no table."""
    table = content
    for part in path[:-1]:
        if part not in table and value is None:
            return
        table = table.setdefault(part, {})
        if not isinstance(table, dict):
            raise KeyError(path)
    if value is None:
        table.pop(path[-1], None)
    else:
        table[path[-1]] = copy.deepcopy(value)


# --- a document from its content -----------------------------------------------------------------


def _table_lines(path: Path, content: Mapping[str, Any]) -> Iterator[str]:
    plain = {key: one for key, one in content.items() if one is not None and not isinstance(one, Mapping)}
    tables = {key: one for key, one in content.items() if isinstance(one, Mapping)}
    if path and (plain or not tables):
        yield f"[{key_text(*path)}]"
    for key, value in plain.items():
        yield from _entry_lines(key, value)
    if plain or (path and not tables):
        yield ""
    for key, table in tables.items():
        yield from _table_lines((*path, key), table)


def _entry_lines(key: str, value: Any) -> list[str]:
    """Return the lines of one key; a long list has one value a line."""
    line = f"{key_text(key)} = {value_text(value)}"
    if not isinstance(value, (list, tuple)) or (len(line) <= COLUMNS and not _holds_tables(value)):
        return [line]
    return [f"{key_text(key)} = [", *(f"    {value_text(one)}," for one in value), "]"]


def _holds_tables(values: Sequence[Any]) -> bool:
    return any(isinstance(one, Mapping) for one in values)


def _escaped(character: str) -> str:
    code = ord(character)
    return f"\\u{code:04X}" if code <= 0xFFFF else f"\\U{code:08X}"


# --- a text changed line by line -----------------------------------------------------------------


class _Entry(NamedTuple):
    """A key's lines, from `begin` to before `end`."""

    path: Path
    begin: int
    end: int


class _Section(NamedTuple):
    """A table's header line (-1 for the top), and the end of its lines."""

    path: Path
    begin: int
    end: int
    entries: tuple[_Entry, ...]

    @property
    def last(self) -> int:
        """The line behind its last key."""
        return self.entries[-1].end if self.entries else self.begin + 1


def _edited(text: str, path: Path, wanted: Mapping[str, Any]) -> str:
    """Return the text with the value at `path` as it is in `wanted`, as far as that can be done line by line."""
    lines = text.splitlines()
    sections = list(_sections(lines))
    holder = _holder(sections, path)
    if holder:
        value = _value_at(wanted, holder.path)
        lines[holder.begin : holder.end] = [] if value is None else _replaced(lines, holder, value)
        return "\n".join(lines) + "\n"
    value = _value_at(wanted, path)
    for section in reversed([one for one in sections if one.path[: len(path)] == path]):
        del lines[section.begin : section.end]
    if value is None:
        return "\n".join(lines) + "\n"
    return "\n".join(_added(lines, path, value)) + "\n"


def _holder(sections: Sequence[_Section], path: Path) -> _Entry | None:
    """Return the entry that gives the value at `path`, or the inline table that it lies in."""
    entries = [entry for section in sections for entry in section.entries]
    found = [entry for entry in entries if entry.path == path[: len(entry.path)]]
    return max(found, key=lambda entry: len(entry.path), default=None)


def _replaced(lines: Sequence[str], entry: _Entry, value: Any) -> list[str]:
    """Return the lines of an entry with another value; the comment behind it stays in its column."""
    head, _, rest = lines[entry.begin].partition("=")
    new = f"{head.rstrip()} = "
    if isinstance(value, list) and _holds_tables(value):
        return _entry_lines(head.strip(), value)
    comment = _comment_of(rest) if entry.end == entry.begin + 1 else ""
    new += value_text(value)
    column = len(lines[entry.begin]) - len(comment)
    return [f"{new.ljust(column - 1)} {comment}".rstrip() if comment else new]


def _comment_of(rest: str) -> str:
    for place, character in enumerate(rest):
        if character == "#" and _parses(f"v = {rest[:place]}"):
            return rest[place:]
    return ""


def _added(lines: list[str], path: Path, value: Any) -> list[str]:
    """Return the lines with a key that was not there, behind the last one of its table."""
    section = next((one for one in _sections(lines) if one.path == path[:-1]), None)
    if isinstance(value, dict) and value:
        return [*lines, "", *_trimmed(_table_lines(path, value))]
    if section is None:
        return [*lines, "", f"[{key_text(*path[:-1])}]", *_entry_lines(path[-1], value)]
    return [*lines[: section.last], *_entry_lines(path[-1], value), *lines[section.last :]]


def _trimmed(lines: Iterator[str]) -> list[str]:
    found = list(lines)
    while found and not found[-1]:
        found.pop()
    return found


def _sections(lines: Sequence[str]) -> Iterator[_Section]:
    """Yield the top and the tables of a text, each with its keys."""
    path: Path = ()
    begin, place = -1, 0
    entries: list[_Entry] = []
    while place < len(lines):
        if _HEADER.fullmatch(lines[place]) and (header := _path_of(lines[place])):
            yield _Section(path, begin, place, tuple(entries))
            path, begin, entries = header, place, []
        elif found := _entry(lines, place, path):
            entries.append(found)
            place = found.end - 1
        place += 1
    yield _Section(path, begin, len(lines), tuple(entries))


def _entry(lines: Sequence[str], place: int, table: Path) -> _Entry | None:
    """Return the key that begins in a line; its value may take several."""
    key = _KEY.match(lines[place])
    own = _path_of(f"{key[1]} = 0") if key else ()
    if not own:
        return None
    for end in range(place + 1, len(lines) + 1):
        if _parses("\n".join(lines[place:end])):
            return _Entry((*table, *own), place, end)
    return None


def _path_of(line: str) -> Path:
    """Return the path of a header or key, () for another line."""
    try:
        content: Any = tomllib.loads(line)
    except ValueError:
        return ()
    path: Path = ()
    while isinstance(content, (dict, list)) and content:
        if isinstance(content, list):
            content = content[0]
            continue
        key = next(iter(content))
        path, content = (*path, key), content[key]
    return path


def _value_at(content: Mapping[str, Any], path: Path) -> Any:
    found: Any = content
    for part in path:
        if not isinstance(found, Mapping) or part not in found:
            return None
        found = found[part]
    return found


def _parses(text: str) -> bool:
    try:
        tomllib.loads(text)
    except ValueError:
        return False
    return True


def _reads_as(text: str, wanted: Mapping[str, Any]) -> bool:
    try:
        return tomllib.loads(text) == wanted
    except ValueError:
        return False
