# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where compiled reading pays: whole texts go through `compiled_reader.PlainReader` then, and line by line
otherwise."""

from __future__ import annotations

import sys
from collections.abc import Generator
from typing import TYPE_CHECKING

from CNCStepper.errors import ProgramError

if TYPE_CHECKING:
    from CNCStepper.gcode.interpreter.fast_path.compiled_reader import PlainReader
    from CNCStepper.gcode.interpreter.interpret import Interpreter

BYTE_ORDER_MARK = "\ufeff"
PIECE = 1 << 21  # bytes read at once
PAYS = 16_384  # characters from which on the kernel is faster
PAYS_WITH_LOADING = 1_000_000  # and with loading it first, which takes half a second


def pays(size: int) -> bool:
    """Whether a text of so many characters is read sooner by kernels, and they are there."""
    if size < (PAYS if "numba" in sys.modules else PAYS_WITH_LOADING):
        return False
    from CNCStepper import kernels

    return kernels.compiles()


def compiled_reader(interpreter: Interpreter, size: int) -> PlainReader | None:
    """Return a reader that compiles runs of lines, None where a text of `size` characters is read sooner without."""
    if interpreter.canon is not None or not pays(size):
        return None
    from CNCStepper.gcode.interpreter.fast_path.compiled_reader import PlainReader

    return PlainReader(interpreter)


def read_runs(interpreter: Interpreter, text: str) -> Generator[None, None, bool]:
    """Read a text compiled, where that pays, up to the first line that leads elsewhere; return whether that was all.

    Yields now and then; its line number says how far the interpreter has come. Raises ProgramError at the line that is
    refused.
    """
    reader = compiled_reader(interpreter, len(text))
    if reader is None:
        return False
    data, first = as_bytes(text), 0
    while first < len(data):
        last = data.find(b"\n", first + PIECE) + 1 or len(data)
        if not reader.read(data[first:last]):
            return False
        first = last
        yield
    return True


def refused_runs(interpreter: Interpreter, text: str) -> Generator[ProgramError, None, bool]:
    """Read as `read_runs` does; yield why lines are refused, which change nothing, and go on after them."""
    reader = compiled_reader(interpreter, len(text))
    return reader is not None and (yield from reader.refused(as_bytes(text)))


def as_bytes(text: str) -> bytes:
    """Return a text as the compiled reader takes it."""
    return text.removeprefix(BYTE_ORDER_MARK).encode("utf-8", "surrogatepass")
