# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a clearing pattern is given and what it answers.

    Area ──► pattern(area) ──► [Run, Run, ...]

    Run   down at its place (an entry, made by the pocket), then passes, each of which begins where the one before
          ends: roughing passes and the links between them, at the level's floor or, lifted, just above it

After all runs the tool has been everywhere in `room`, walls of the room included, to within `tolerance_mm`: nothing
that it can reach stays, and it never leaves the room. A link runs only where this level is cut already, or is itself
a roughing pass. The tool is lifted out of the pocket only between runs.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.region import Region


@dataclass(frozen=True)
class Area:
    """Where the tool's centre may be at a level, and how it is to cut there.

    room: of the tool's centre. tool_mm: the tool's radius. stepover_mm: between neighbouring passes at most.
    tolerance_mm: how far passes may be off their place; never out of the room by more.
    climb: the material lies to the right.
    """

    room: Region
    tool_mm: float
    stepover_mm: float
    tolerance_mm: float
    climb: bool


@dataclass(frozen=True)
class Pass:
    """One stretch that is cut at the feed; name: as a span is called, "roughing 3" or "link".

    lifted: it is gone along by rapids a little above the floor. Then it has no arcs, and all that is near it is cut.
    """

    name: str
    curve: Curve
    lifted: bool = False


@dataclass(frozen=True)
class Opening:
    """A disc of the level's stock that the entry must have cut away: by a helix through the run's begin about it.

    radius_mm: of the disc, that is of the helix and the tool together.
    """

    centre_mm: tuple[float, float]
    radius_mm: float


@dataclass(frozen=True)
class Run:
    """What is cut without lifting the tool out; the entry is to reach the begin of the first pass.

    apart_mm: how far neighbouring passes are apart at most; 0 where none has a neighbour.
    opening: what the entry must have opened, where the passes rely on it; else any entry will do.
    back: a way over what is cut from the end of the last pass to the begin of the first, where no straight one leads.
    """

    passes: tuple[Pass, ...]
    apart_mm: float = 0.0
    opening: Opening | None = None
    back: Curve | None = None


Pattern = Callable[[Area], list[Run]]
