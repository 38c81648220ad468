# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the folder of a proof holds besides where a restart is proven.

    place.json       where the program is to be restarted; not there where the whole program is proven
    restart.json     the answer: the restart program, and its description

Asking and reading the answer is light enough for a window.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from CNCStepper.recovery.restart.restart_places import RequestedPlace

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.restart_program import Restart

PLACE, RESTART = "place.json", "restart.json"


@dataclass(frozen=True)
class RestartPlace:
    """Where a program is to be restarted, and how many mm before that on the same cut.

    height_mm: of the work's Z, to which the tool goes up first; None is as the program's own rapids go.
    """

    where: RequestedPlace
    overlap_mm: float = 0.0
    height_mm: float | None = None


@dataclass(frozen=True)
class RestartText:
    """The result: the text of the restart, and sentences that describe its steps in order."""

    program: str
    words: tuple[str, ...]


def write_place(folder: Path, place: RestartPlace | None) -> None:
    """Write where the program is to be restarted; None is the whole program."""
    if place is not None:
        (folder / PLACE).write_text(json.dumps(asdict(place)), encoding="utf-8")


def read_place(folder: Path) -> RestartPlace | None:
    """Return the place as `write_place` left it."""
    if not (folder / PLACE).exists():
        return None
    content = json.loads((folder / PLACE).read_text("utf-8"))
    where = content["where"] | {"at_mm": tuple(content["where"]["at_mm"])}
    return RestartPlace(RequestedPlace(**where), content["overlap_mm"], content["height_mm"])


def write_restart(folder: Path, restart: Restart) -> None:
    """Write the restart program, and what it does."""
    from CNCStepper.recovery.restart.description import words_of

    told = {"program": restart.text, "words": list(words_of(restart))}
    (folder / RESTART).write_text(json.dumps(told), encoding="utf-8")


def read_restart(folder: Path) -> RestartText | None:
    """Return what `write_restart` wrote; None where the whole program was proven."""
    if not (folder / RESTART).exists():
        return None
    content = json.loads((folder / RESTART).read_text("utf-8"))
    return RestartText(content["program"], tuple(content["words"]))
