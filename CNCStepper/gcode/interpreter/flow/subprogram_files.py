# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subroutines in files of their own: `o<name> call` reads `name.ngc` beside the program or in a search path."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.syntax.text_format import decoded
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.input_file import read_input
from CNCStepper.state import Start

SUFFIXES = (".ngc", ".nc")
LARGEST_BYTES = 16_000_000
_FORBIDDEN = set('/\\:*?"|\0')


@dataclass
class Source:
    """A text that is being run: `file` as errors name it."""

    file: str
    lines: Sequence[str]


@dataclass
class Library:
    """Finds the files of subroutines: in `folders`, in their order, each file read once."""

    folders: tuple[Path, ...] = ()
    largest_bytes: int = LARGEST_BYTES
    _read: dict[Path, Source] = field(default_factory=dict)

    @property
    def sources(self) -> list[Source]:
        """The files that were read, in their order."""
        return list(self._read.values())

    def find(self, name: str) -> Source | None:
        """Return the file of a subroutine, None when there is none; raises ProgramError when it cannot be read."""
        if not name or name.startswith(".") or _FORBIDDEN & set(name) or len(name) > 100:
            return None
        for folder in self.folders:
            for suffix in SUFFIXES:
                path = folder / (name + suffix)
                if path.is_file():
                    return self._source(path)
        return None

    def _source(self, path: Path) -> Source:
        if path not in self._read:
            self._read[path] = Source(str(path), program_lines(self._text(path)))
        return self._read[path]

    def _text(self, path: Path) -> str:
        return decoded(read_input(path, self.largest_bytes, refusal=ProgramError))[0]


def library_of(file: str, start: Start | None = None) -> Library:
    """Return the library of a program's file: its own folder, where it has a file, then those that the start names."""
    beside = (Path(file).parent,) if file else ()
    return Library((*beside, *map(Path, start.search if start else ())))
