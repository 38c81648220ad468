# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON with the lists of a long program in it, read and written a block at a time: no such list is ever held whole.

{"format": ..., "send": {"file": ..., "lines": ["G21", "G1X10", ...], "file_lines": [1, 2, ...]}}
                                               ^ a LongList: where it begins in the file, and its length
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, islice
from typing import Any, BinaryIO, TypeVar, overload

from CNCStepper.errors import Text

LONG = ("lines", "file_lines")  # the keys of long lists, which hold texts and numbers only
OF = ((), ("send",), ("certificate", "send"))  # the keys before them: of a job, of its certificate, of a way back
BLOCK_BYTES = 262_144
BLOCK_ITEMS = 10_000
BYTES = "latin-1"  # a character a byte: what the marks of JSON are found in, whatever stands in its texts

Item = TypeVar("Item")

_BLANKS = re.compile(r"[ \t\r\n]*")
_END = re.compile(r"[ \t\r\n,:\]}]")  # of a value
_ITEM = r'[ \t\r\n]*(?:"[^"\\]*(?:\\.[^"\\]*)*"|-?\d[\d.eE+-]*)[ \t\r\n]*'
_ITEMS = re.compile(rf"(?:{_ITEM},)*", re.DOTALL)
_LAST_ITEM = re.compile(rf"{_ITEM}\]", re.DOTALL)


def read_long(file: BinaryIO) -> Any:
    """Return the content of a JSON file, its long lists as `LongList`; raises OSError, and ValueError as `json` does.

    The file must stay open as long as these lists are wanted.
    """
    text = _Text(file, 0)
    content = _value(text, ())
    if text.mark():
        raise text.fault()
    return content


def pieces(content: Any, encoder: json.JSONEncoder) -> Iterator[str]:
    """Yield the JSON text of plain data, in which a sequence that is neither list nor tuple counts as long."""
    if _is_long(content):
        yield from _list_pieces(content, encoder)
    elif isinstance(content, Mapping) and any(map(_holds_long, content.values())):
        before = "{"
        for key in sorted(content) if encoder.sort_keys else content:
            yield f"{before}{encoder.encode(key)}{encoder.key_separator}"
            yield from pieces(content[key], encoder)
            before = encoder.item_separator
        yield "}"
    else:
        yield encoder.encode(content)


def blocks_of(items: Iterable[Item]) -> Iterator[list[Item]]:
    """Yield the items a block at a time, none empty."""
    rest = iter(items)
    while block := list(islice(rest, BLOCK_ITEMS)):
        yield block


class LongList(Sequence[Any]):
    """A list in an open JSON file: its items are read from `offset`, behind its bracket, each time they are wanted."""

    def __init__(self, file: BinaryIO, offset: int, count: int):
        self._file, self._offset, self._count = file, offset, count

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Any]:
        return chain.from_iterable(_Text(self._file, self._offset).blocks())

    @overload
    def __getitem__(self, index: int) -> Any: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[Any]: ...

    def __getitem__(self, index: int | slice) -> Any:
        """Return an item or some of them, after a walk along all before."""
        places = range(self._count)[index]
        if isinstance(places, int):
            return next(islice(self, places, None))
        return [self[place] for place in places]


class _Text:
    """The text of a file from `offset` on, of which a block or a value is held; others may read the file meanwhile."""

    def __init__(self, file: BinaryIO, offset: int):
        self.file = file
        self._next = offset  # to be read
        self._held = ""
        self._at = 0  # in what is held

    @property
    def offset(self) -> int:
        """Where the next character stands in the file."""
        return self._next - len(self._held) + self._at

    def mark(self) -> str:
        """Return the next character that is no blank, "" at the end."""
        while True:
            blanks = _BLANKS.match(self._held, self._at)
            assert blanks  # the pattern matches nothing, too
            self._at = blanks.end()
            if self._at < len(self._held) or not self._read_on():
                return self._held[self._at : self._at + 1]

    def take(self, marks: str) -> str:
        """Return the next character that is no blank, which must be one of these; raises ValueError."""
        mark = self.mark()
        if not mark or mark not in marks:
            raise self.fault()
        self._at += 1
        return mark

    def value(self) -> Any:
        """Return the value that begins here; raises ValueError."""
        self.mark()
        while True:
            try:
                _, end = json.JSONDecoder().raw_decode(self._held, self._at)
            except ValueError:
                if not self._read_on():
                    raise self.fault() from None
            else:
                if _END.match(self._held, end) or not self._read_on():  # a number may go on
                    break
        begin, self._at = self._at, end
        return json.loads(self._held[begin:end].encode(BYTES))

    def blocks(self) -> Iterator[list[Any]]:
        """Yield the items of a long list, behind its bracket, a block at a time; raises ValueError."""
        if self.mark() == "]":
            self._at += 1
            return
        while not (last := _LAST_ITEM.match(self._held, self._at)):
            items = _ITEMS.match(self._held, self._at)
            if items and items[0]:
                self._at = items.end()
                yield json.loads(f"[{items[0][:-1]}]".encode(BYTES))
            elif not self._read_on():
                raise self.fault()
        self._at = last.end()
        yield json.loads(f"[{last[0]}".encode(BYTES))

    def fault(self) -> ValueError:
        """Return that this is no JSON from here on."""
        return ValueError(Text("no JSON at byte {offset}", offset=self.offset))

    def _read_on(self) -> bool:
        """Hold more, twice as much where a value is longer than a block; return whether there was more."""
        self._held = self._held[self._at :]
        self._at = 0
        self.file.seek(self._next)
        data = self.file.read(max(BLOCK_BYTES, len(self._held)))
        self._next += len(data)
        self._held += data.decode(BYTES)
        return bool(data)


def _value(text: _Text, path: tuple[str, ...]) -> Any:
    """Return the value that begins here; path: the keys that lead to it."""
    mark = text.mark()
    if mark == "{":
        return _object(text, path)
    if mark == "[" and _leads_to_long(path):
        text.take("[")
        offset = text.offset
        return LongList(text.file, offset, sum(map(len, text.blocks())))
    return text.value()


def _leads_to_long(path: tuple[str, ...]) -> bool:
    return path != () and path[-1] in LONG and path[:-1] in OF


def _object(text: _Text, path: tuple[str, ...]) -> dict[str, Any]:
    content: dict[str, Any] = {}
    text.take("{")
    if text.mark() == "}":
        text.take("}")
        return content
    mark = ","
    while mark == ",":
        if text.mark() != '"':
            raise text.fault()
        key = text.value()
        text.take(":")
        content[key] = _value(text, (*path, key))
        mark = text.take(",}")
    return content


def _is_long(content: Any) -> bool:
    return isinstance(content, Sequence) and not isinstance(content, (list, tuple, str))


def _holds_long(content: Any) -> bool:
    return _is_long(content) or (isinstance(content, Mapping) and any(map(_holds_long, content.values())))


def _list_pieces(items: Sequence[Any], encoder: json.JSONEncoder) -> Iterator[str]:
    """Yield the text of a list, a block of its items at a time."""
    before = "["
    for block in blocks_of(items):
        yield before + encoder.encode(block)[1:-1]
        before = encoder.item_separator
    yield "]" if len(items) else "[]"
