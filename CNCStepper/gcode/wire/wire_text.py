# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text: the lines sent, their lines in the file, and the limits of a line."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.wire.wire_lines import WireLines

REALTIME = frozenset(b"!?~\x18") | frozenset(range(0x80, 0x100))  # bytes that grbl acts upon wherever they stand


@dataclass(frozen=True)
class WireText:
    """lines: without their newline. file_lines: int32[len(lines)], the file's line of each, from 1.

    messages: index in `lines` -> what to tell the operator before that line runs. leads: bool[len(lines)], whether
    a line stands for the same line of the program as the next one, to which it leads; None for none
    (`backlash_compensation.py`).
    """

    lines: WireLines
    file_lines: np.ndarray
    messages: Mapping[int, str] = field(default_factory=dict)
    leads: np.ndarray | None = None

    @property
    def text(self) -> str:
        """The lines as they are sent, each with its newline."""
        return self.lines.data.decode("ascii")

    @property
    def sha256(self) -> str:
        """The fingerprint that a certificate names."""
        return hashlib.sha256(self.lines.data).hexdigest()


def check_wire_line(line: str, dialect: str | Dialect = "grbl", place: Place | None = None) -> None:
    """Raise ProgramError where a line (without newline) may not be sent: too long, or with bytes that act."""
    language = dialect_named(dialect)
    if language.line_limit and len(line) >= language.line_limit:
        limit = f"{language.line_limit - 1} characters"
        value = f"{len(line)} characters"
        what: str = Text("the line does not fit the buffer of {language}", language=language.title)
        raise ProgramError("line-too-long", what, value=value, limit=limit, advice="write it as two", place=place)
    acting = sorted(REALTIME.intersection(line.encode("utf-8")))
    if acting or not line.isprintable():
        value = f"0x{acting[0]:02X}" if acting else repr(line)
        what = "the line holds a byte that the controller acts upon wherever it stands"
        raise ProgramError("realtime-byte", what, value=value, advice="take it out", place=place)
