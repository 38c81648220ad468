# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads whole texts through `compiled_reader.CompiledReader`, where that pays."""

from __future__ import annotations

from collections.abc import Generator
from typing import TYPE_CHECKING

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.fast_path.policy import PIECE, as_bytes, pays
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter

if TYPE_CHECKING:
    from CNCStepper.gcode.interpreter.fast_path.compiled_reader import CompiledReader


def compiled_reader(interpreter: Interpreter, size: int) -> CompiledReader | None:
    """Return a reader that compiles runs of lines, None where a text of `size` characters is read sooner without."""
    if not pays(size):
        return None
    from CNCStepper.gcode.interpreter.fast_path.compiled_reader import CompiledReader  # loads the kernels

    return CompiledReader(interpreter)


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
    """Read as `read_runs` does; yield the errors of refused lines, which change nothing, and continue after them."""
    reader = compiled_reader(interpreter, len(text))
    return reader is not None and (yield from reader.refused(as_bytes(text)))
