# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program that a verb is given, of which no more is held than is asked for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from CNCStepper.cli.common.options import read_program


@dataclass(frozen=True)
class ProgramFile:
    """The program of a file; `text` holds it whole, from the first time that it is asked for."""

    path: Path

    @cached_property
    def text(self) -> str:
        """Its text."""
        return read_program(self.path)

    @cached_property
    def sha256(self) -> str:
        """The fingerprint by which a certificate knows it."""
        from CNCStepper.control.program.certificate import digest_of_pieces

        return digest_of_pieces(self._pieces())

    def is_expanded(self, dialect: str) -> bool:
        """Whether its lines are written out before they are sent, perhaps with those of other files."""
        from CNCStepper.gcode.dialects import dialect_named
        from CNCStepper.gcode.wire.expansion import is_expanded

        return any(is_expanded(piece, dialect_named(dialect)) for piece in self._pieces())

    def _pieces(self) -> Iterable[str]:
        from CNCStepper.gcode.interpreter.file_chunks import text_pieces

        if "text" in vars(self) or not self.path.is_file():  # a pipe can be read only once
            return [self.text]
        return text_pieces(self.path)
