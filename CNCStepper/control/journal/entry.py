# SPDX-License-Identifier: LGPL-2.1-or-later
"""One entry of a journal: how far a job may have gone, and how far it certainly has."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from CNCStepper.control.protocol.grbl.report import Vector


@dataclass(frozen=True)
class Group:
    """Counts of wire lines from the job's first, and their offsets in the file.

    time_s: since 1970. may_be_sent: no line from here on has gone out. acknowledged: the controller took these.
    finished: these are certainly cut. first_line: the file's line of the first that is not; 0 when all are.
    last_line: the file's line of the last that may be sent; 0 for none. state, mpos_mm, wpos_mm: last reported.
    """

    time_s: float
    may_be_sent: int
    acknowledged: int
    finished: int
    first_line: int
    last_line: int
    state: str = ""
    mpos_mm: Vector | None = None
    wpos_mm: Vector | None = None

    def to_content(self) -> dict[str, Any]:
        """Return it as plain data, short: a long job writes one a second."""
        return {"group": list(asdict(self).values())}

    @classmethod
    def from_content(cls, content: dict[str, Any]) -> Group:
        """Return the group of `to_content`, after its way through JSON."""
        values: list[Any] = content["group"]
        return cls(*values[:-2], *map(_vector, values[-2:]))


def _vector(values: list[float] | None) -> Vector | None:
    return tuple(values) if values else None
