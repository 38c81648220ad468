# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splits a text into runs of plain lines, written at once as they are sent, and the lines between them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.preprocessor import reads_moves_directly
from CNCStepper.gcode.interpreter.fast_path.policy import as_bytes, pays
from CNCStepper.gcode.syntax.words import program_lines

NO_LIMIT = 2**40
_LINE_END = re.compile(rb"\r\n|\r|\n")


class WireRun(NamedTuple):
    """lines: as they are sent, each with its newline. numbers: int32, the line of the text of each, from 1.

    begins: it has words.
    """

    lines: bytes
    numbers: np.ndarray
    begins: bool


def wire_runs(text: str, dialect: Dialect) -> Iterator[WireRun | tuple[int, str]]:
    """Yield the text as runs, where a kernel can write them, and the number and text of every other line."""
    if _are_plain(dialect) and pays(len(text)):
        yield from compiled_runs(as_bytes(text), dialect)
    else:
        yield from enumerate(program_lines(text), 1)


def runs_of_piece(piece: str, first: int, dialect: Dialect) -> Iterator[WireRun | tuple[int, str]]:
    """Yield the same of whole lines of a text, of which the first is line `first`."""
    if _are_plain(dialect) and pays(len(piece)):
        yield from compiled_runs(piece.encode("utf-8", "surrogatepass"), dialect, first)
    else:
        yield from enumerate(program_lines(piece), first)


def _are_plain(dialect: Dialect) -> bool:
    """Whether the kernel may write a language's lines: it reads them as they are, and leaves out N."""
    return reads_moves_directly(dialect) and not dialect.two_block_cycles


def compiled_runs(data: bytes, dialect: Dialect, first: int = 1) -> Iterator[WireRun | tuple[int, str]]:
    """Yield the same of a text's bytes, written by the kernel."""
    from CNCStepper.gcode.syntax.word_kernels import new_roles
    from CNCStepper.gcode.wire.line_kernel import NOW, write_lines

    view, roles, now = np.frombuffer(data, np.uint8), new_roles(), np.zeros(1, NOW).view(np.recarray)[0]
    now.line = first - 1
    out, numbers = np.empty(2 * len(data) + 2, np.uint8), np.empty(len(data) // 2 + 1, np.int32)
    while now.at < len(data):
        now.out = now.lines = now.words = 0
        write_lines(view, now, roles, dialect.line_limit or NO_LIMIT, out, numbers)
        if now.lines or now.words:
            yield WireRun(out[: now.out].tobytes(), numbers[: now.lines], bool(now.words))
        if now.at < len(data):
            at, found = int(now.at), _LINE_END.search(data, int(now.at))
            now.line, now.at = now.line + 1, found.end() if found else len(data)
            yield int(now.line), data[at : found.start() if found else len(data)].decode("utf-8", "surrogatepass")
