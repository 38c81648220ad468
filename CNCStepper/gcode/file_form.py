# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a program's file writes its text, so that a changed one is written in the same way, whole or not at all."""

from __future__ import annotations

import errno
import shutil
from dataclasses import dataclass
from pathlib import Path

BOM = b"\xef\xbb\xbf"
WRITABLE = 0o222  # bits of a file's mode


@dataclass(frozen=True)
class FileForm:
    """encoding: UTF-8, or Latin-1. end: of a line. mark: the byte-order mark, if there is one."""

    encoding: str = "utf-8"
    end: str = "\n"
    mark: bytes = b""

    def encoded(self, text: str) -> bytes:
        """Return a text, its lines ended as they are, as bytes; as UTF-8 where its own encoding lacks a letter."""
        try:
            return self.mark + text.encode(self.encoding)
        except UnicodeEncodeError:
            return text.encode("utf-8")

    def bytes_of(self, text: str) -> bytes:
        """Return a text with LF as the file's bytes."""
        return self.encoded(text.replace("\n", self.end))


def decoded(data: bytes) -> tuple[str, FileForm]:
    """Return the text of a file, without its byte-order mark, and how it is written."""
    mark = BOM if data.startswith(BOM) else b""
    body = data[len(mark) :]
    try:
        text, encoding = body.decode("utf-8"), "utf-8"
    except UnicodeDecodeError:
        text, encoding = body.decode("latin-1"), "latin-1"
    end = next((end for end in ("\r\n", "\n", "\r") if end in text), "\n")
    return text, FileForm(encoding, end, mark)


def write_whole(path: Path, data: bytes) -> None:
    """Write a file whole or not at all: a full disk does not cost the old one.

    A link stays one: what it leads to is written. Raises OSError, for a read-only file too.
    """
    path = path.resolve()
    if path.exists() and not path.stat().st_mode & WRITABLE:
        raise PermissionError(errno.EACCES, "the file is read-only", str(path))
    unfinished = path.with_name(f".{path.name}.unfinished")
    try:
        unfinished.write_bytes(data)
        if path.exists():
            shutil.copymode(path, unfinished)
        unfinished.replace(path)
    except BaseException:  # an interrupt too leaves nothing behind
        unfinished.unlink(missing_ok=True)
        raise
