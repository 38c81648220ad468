# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a program's file writes its text, so that a changed one is written in the same way."""

from __future__ import annotations

from dataclasses import dataclass

BOM = b"\xef\xbb\xbf"


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
